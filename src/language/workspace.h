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
#include "language/text_document.h"
#include "language/visual_soar.h"
#include "sim/source_graph.h"

namespace soarbox::language {

/// The files that are loaded together with a file: those of all programs that include it. A program is a root, which is
/// a file that no other file sources, and all files that it sources directly or through others.
struct Program {
  std::filesystem::path root;  ///< The first of several, in alphabetical order.
  std::vector<std::filesystem::path> roots;
  std::vector<std::shared_ptr<const Document>> documents;  ///< In the order of loading; each root comes before its
                                                           ///< files.
  std::filesystem::path project;                           ///< The project of VisualSoar; empty if there is none.

  const Document* Find(const std::filesystem::path& path) const;
};

/// The files that a user edits. Open files have the text in the editor; all others have the text on the disk.
///
/// Diagnostics come in two steps. Those of the kernel's reader for one file cost a few milliseconds, depending on the
/// edited part. Those that need all rules (slips, duplicates, gaps, crowds, the datamap) cost time for all rules.
class Workspace {
 public:
  /// Reads only plain files below these folders; empty: all files.
  explicit Workspace(std::vector<std::filesystem::path> folders = {}) : folders_(std::move(folders)) {}

  /// Sets the editor's folders, in which programs are searched. For a file elsewhere, its own folder is searched
  /// (sim::FolderOfProgram).
  void SetFolders(std::vector<std::filesystem::path> folders);
  const std::vector<std::filesystem::path>& folders() const { return editor_folders_; }
  /// Call it when files may have been added, removed or changed. The next query searches the folders again.
  void LookAgain() { regions_.clear(); }
  /// Removes and returns notices about folders with too many files. Each folder is reported once.
  std::vector<std::string> TakeNotices() { return std::exchange(notices_, {}); }

  void Open(const std::filesystem::path& path, std::string text);
  void Close(const std::filesystem::path& path);
  bool IsOpen(const std::filesystem::path& path) const { return open_.contains(path); }
  std::vector<std::filesystem::path> OpenFiles() const;

  /// Null if the file does not exist or may not be read.
  std::shared_ptr<const Document> Find(const std::filesystem::path& path);
  /// The programs that contain a file, determined by the `source` commands in the files of its workspace folder, its
  /// VisualSoar project or its scenario. A file that no other file sources is its own program.
  Program ProgramOf(const std::filesystem::path& path);
  /// The roots of these programs.
  std::vector<std::filesystem::path> RootsOf(const std::filesystem::path& path) {
    return GraphOf(RegionOf(path)).RootsOf(path);
  }

  /// The programs in the editor's folders: one file of each, in alphabetical order. A folder with more than `most`
  /// files of rules is left out.
  std::vector<std::filesystem::path> FilesOfPrograms(std::size_t most);

  /// Diagnostics that need all rules of a program, by file; about 500 per file at most. Does not include
  /// Document::problems.
  std::map<std::filesystem::path, std::vector<Diagnostic>> Slips(const Program& program);
  /// Reports the files that a document sources and that do not exist.
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
  std::map<std::filesystem::path, sim::SourceGraph> regions_;  ///< By the folder that was searched.
  /// The files that a file on the disk sourced when it was last read.
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

/// The diagnostics of `soarbox check` and `soarbox datamap`, without an editor. `file` is a file of rules or a project.
std::vector<Diagnostic> CheckAgainstDatamap(const std::filesystem::path& file);

}  // namespace soarbox::language
