// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "language/document.h"
#include "language/visual_soar.h"

namespace soarbox::language {

/// The files that one agent's rules come from: the file that loads them all, and those that it sources.
struct Program {
  std::filesystem::path root;
  std::vector<std::shared_ptr<const Document>> documents;  ///< In the order of loading, the root first.
  std::filesystem::path project;                           ///< Of VisualSoar; empty if there is none.

  const Document* Find(const std::filesystem::path& path) const;
};

/// The files of a person who edits rules: open files hold what was typed, all others what is on disk.
///
/// Diagnostics come in two steps. What the kernel's reader says of one file costs what was edited, a few milliseconds.
/// What only all rules together show (slips, duplicates, gaps, crowds, the datamap) costs all rules.
class Workspace {
 public:
  /// Nothing but plain files below these folders is read; empty: any.
  explicit Workspace(std::vector<std::filesystem::path> folders = {}) : folders_(std::move(folders)) {}

  void Open(const std::filesystem::path& path, std::string text);
  void Close(const std::filesystem::path& path);
  bool IsOpen(const std::filesystem::path& path) const { return open_.contains(path); }
  std::vector<std::filesystem::path> OpenFiles() const;

  /// Null if there is no such file, or it may not be read.
  std::shared_ptr<const Document> Find(const std::filesystem::path& path);
  /// The program that a file belongs to: found through VisualSoar's project, else by following `source` from file to
  /// file upwards among the files of its folder (or of the scenario's folder that it lies in). A file that nobody
  /// sources is its own program.
  Program ProgramOf(const std::filesystem::path& path);

  /// What only all rules of a program together show, by file; of each some 500. What Document::problems has is not
  /// among it.
  std::map<std::filesystem::path, std::vector<Diagnostic>> Slips(const Program& program);
  /// Files that a document sources and that are not there.
  std::vector<Diagnostic> MissingFiles(const Document& document) const;

  const RuleReader& reader() const { return reader_; }

 private:
  struct OnDisk {
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    std::shared_ptr<const Document> document;
  };
  bool MayRead(const std::filesystem::path& path) const;
  std::vector<std::filesystem::path> RulesBelow(const std::filesystem::path& folder) const;
  const VisualSoarProject* ProjectOf(const std::filesystem::path& file);

  std::vector<std::filesystem::path> folders_;
  RuleReader reader_;
  WordCache words_;
  std::map<std::filesystem::path, std::shared_ptr<const Document>> open_;
  std::map<std::filesystem::path, OnDisk> disk_;
  struct ReadProject {
    std::filesystem::file_time_type time;
    std::optional<VisualSoarProject> project;
    std::vector<Diagnostic> problems;
  };
  std::map<std::filesystem::path, ReadProject> projects_;
};

/// The files of a program without an editor: what `soarbox check` and `soarbox datamap` ask. `file` is a file of rules
/// or a project.
std::vector<Diagnostic> CheckAgainstDatamap(const std::filesystem::path& file);

}  // namespace soarbox::language
