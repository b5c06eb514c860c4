// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "language/document.h"
#include "language/visual_soar.h"
#include "sim/source_graph.h"

namespace soarbox::language {

/// The files that a file is loaded together with: those of all programs that reach it. A program is a file that no
/// other one sources, its root, and all that it sources.
struct Program {
  std::filesystem::path root;  ///< Of several the first, in alphabetical order.
  std::vector<std::filesystem::path> roots;
  std::vector<std::shared_ptr<const Document>> documents;  ///< In the order of loading, each root before its files.
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

  /// The folders that an editor works in: programs are looked for in all of them. A file elsewhere has its own folder
  /// (sim::FolderOfProgram).
  void SetFolders(std::vector<std::filesystem::path> folders);
  const std::vector<std::filesystem::path>& folders() const { return editor_folders_; }
  /// Files may have come, gone or changed: the folders are looked through again when a program is asked for.
  void LookAgain() { regions_.clear(); }
  /// What should be said of folders that have too many files, each once. Empties the list.
  std::vector<std::string> TakeNotices() { return std::exchange(notices_, {}); }

  void Open(const std::filesystem::path& path, std::string text);
  void Close(const std::filesystem::path& path);
  bool IsOpen(const std::filesystem::path& path) const { return open_.contains(path); }
  std::vector<std::filesystem::path> OpenFiles() const;

  /// Null if there is no such file, or it may not be read.
  std::shared_ptr<const Document> Find(const std::filesystem::path& path);
  /// The programs that a file belongs to, by who sources whom among the files of its workspace folder, of VisualSoar's
  /// project or of the scenario. A file that nobody sources is its own program.
  Program ProgramOf(const std::filesystem::path& path);
  /// The roots of those programs.
  std::vector<std::filesystem::path> RootsOf(const std::filesystem::path& path) {
    return GraphOf(RegionOf(path)).RootsOf(path);
  }

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
  std::filesystem::path RegionOf(const std::filesystem::path& file);
  const sim::SourceGraph& GraphOf(const std::filesystem::path& region);
  void AddReached(const std::filesystem::path& root, Program& program, std::set<std::string>& taken);
  void AddDuplicates(const Program& program, std::map<std::filesystem::path, std::vector<Diagnostic>>& found);
  const VisualSoarProject* ProjectOf(const std::filesystem::path& file);

  std::vector<std::filesystem::path> folders_;
  RuleReader reader_;
  WordCache words_;
  std::map<std::filesystem::path, std::shared_ptr<const Document>> open_;
  std::map<std::filesystem::path, OnDisk> disk_;
  std::vector<std::filesystem::path> editor_folders_;
  std::map<std::filesystem::path, sim::SourceGraph> regions_;  ///< By the folder that was looked through.
  /// What a file on disk sources, as it was read last.
  struct Scanned {
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    std::vector<sim::SourcedFile> sources;
  };
  std::map<std::string, Scanned> scanned_;
  std::set<std::filesystem::path> told_cut_;
  std::vector<std::string> notices_;
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
