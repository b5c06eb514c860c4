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

/// A file of rules that another one sources.
struct SourcedFile {
  std::string name;            ///< As it is written.
  std::filesystem::path file;  ///< From the folder of the file that sources it, after the `pushd` and `cd` before it.
  int line = 1;                ///< Of the command.
};
/// What a text sources, in its order. Reads lines, no rules: scanning a megabyte takes a few milliseconds.
std::vector<SourcedFile> SourcedIn(std::string_view text);

/// Who sources whom among files of rules. Paths are absolute and normalized.
class SourceGraph {
 public:
  /// Adds a file, or replaces what is known of it.
  void Add(const std::filesystem::path& file, std::string_view text) { Add(file, SourcedIn(text)); }
  void Add(const std::filesystem::path& file, const std::vector<SourcedFile>& sourced);
  void Remove(const std::filesystem::path& file);
  bool Contains(const std::filesystem::path& file) const { return sources_.contains(file.native()); }

  /// The files that load a file, directly or through others, and that no other file sources, in alphabetical order. The
  /// file itself if nobody sources it, or if its sourcers are a circle.
  std::vector<std::filesystem::path> RootsOf(const std::filesystem::path& file) const;
  /// A file and all that it sources, directly or through others.
  std::set<std::filesystem::path> ReachedFrom(const std::filesystem::path& file) const;

 private:
  std::map<std::string, std::set<std::string>> sources_, sourced_by_;
};

/// The folder that holds the program of a file: that of the scenario or mission in which it lies, else the highest of
/// the folders above it from which a file sources what lies below, else its own.
std::filesystem::path FolderOfProgram(const std::filesystem::path& file);

/// The files of rules below a folder, in alphabetical order, as absolute paths. Hidden folders are left out.
struct FoundRules {
  std::vector<std::filesystem::path> files;
  bool is_cut = false;  ///< There are more files than `most`, or too many entries to look at.
};
FoundRules FindRulesBelow(const std::filesystem::path& folder, std::size_t most);

/// The graph of all files of rules below a folder that are plain files below the `readable` folders.
SourceGraph GraphBelow(const std::filesystem::path& folder, std::span<const std::filesystem::path> readable);

}  // namespace soarbox::sim
