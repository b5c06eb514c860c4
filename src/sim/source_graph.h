// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox::sim {

/// A file of rules that another file sources.
struct SourcedFile {
  std::string name;            ///< As written in the command.
  std::filesystem::path file;  ///< Relative to the folder of the sourcing file, after the `pushd` and `cd` commands
                               ///< before it.
  int line = 1;                ///< Line of the command.
};
/// The files that a text sources, in order. It scans lines without parsing rules: a megabyte takes a few milliseconds.
std::vector<SourcedFile> SourcedIn(std::string_view text);

/// Which files of rules source which. Paths are absolute and normalized.
class SourceGraph {
 public:
  /// Adds a file, or replaces its entry.
  void Add(const std::filesystem::path& file, std::string_view text) { Add(file, SourcedIn(text)); }
  void Add(const std::filesystem::path& file, const std::vector<SourcedFile>& sourced);
  void Remove(const std::filesystem::path& file);
  bool Contains(const std::filesystem::path& file) const { return sources_.contains(file.native()); }

  /// The files that load `file`, directly or through others, and that no other file sources; in alphabetical order.
  /// Returns the file itself if no file sources it, or if the files that source it form a circle.
  std::vector<std::filesystem::path> RootsOf(const std::filesystem::path& file) const;
  /// A file and all files that it sources, directly or through others.
  std::set<std::filesystem::path> ReachedFrom(const std::filesystem::path& file) const;

 private:
  std::map<std::string, std::set<std::string>> sources_, sourced_by_;
};

/// The folder of the program that a file belongs to: the folder of its scenario or mission; else the highest folder
/// above it with a file that sources files below that folder; else its own folder.
std::filesystem::path FolderOfProgram(const std::filesystem::path& file);

/// The files of rules below a folder, as absolute paths in alphabetical order. Hidden folders and node_modules are
/// skipped.
struct FoundRules {
  std::vector<std::filesystem::path> files;
  bool is_cut = false;  ///< The list is incomplete: there are more than `most` files, or too many directory entries.
};
FoundRules FindRulesBelow(const std::filesystem::path& folder, std::size_t most);

/// The graph of all files of rules below a folder. Includes only plain files below the `readable` folders.
SourceGraph GraphBelow(const std::filesystem::path& folder, std::span<const std::filesystem::path> readable);

}  // namespace soarbox::sim
