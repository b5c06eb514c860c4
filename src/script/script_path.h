// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/result.h"

namespace soarbox::script {

/// A script file as it was read: bytes in an unknown encoding.
struct ScriptSource {
  std::string name;  ///< The name with which it was loaded; its case may differ from that of the file's name.
  std::string path;  ///< The path of the file, for messages.
  std::string content;
  bool has_tick = false;  ///< It contains the name Agent_Tick.
  /// Compiled by the first machine that ran it, so that other machines do not parse it; empty before.
  mutable std::string compiled = {};
};

/// The search path of scripts: a list of folders; the first one that has the file wins. The scenario's own folder
/// precedes the library's, so that a scenario can replace a library module. In each folder, names are compared exactly
/// first, then ignoring case. Files are read once and kept, so that a run uses one version of each.
class ScriptPath {
 public:
  explicit ScriptPath(std::vector<std::filesystem::path> folders) : folders_(std::move(folders)) {}

  /// Reads `name` ("SeekingAgent.lua"). Fails if no folder has it, if it cannot be read, is too large or is not plain
  /// text, or if the name leads out of the folders. If no folder has it, the hint is a similar name or, without one,
  /// the list of folders. The pointer stays valid.
  Result<const ScriptSource*> Load(std::string_view name);

  /// Reads a file that is not a script, with the same bounds: an image, a model, a sound. `kind` names it in messages.
  /// Nothing is kept.
  Result<std::string> ReadBytes(std::string_view name, const std::string& kind, std::uintmax_t largest) const;

  /// Whether a file that was loaded mentions Agent_Tick.
  bool HasTick(std::string_view name) const;

  /// Returns a line (from 1) of a loaded file, for excerpts in messages; empty if unknown.
  std::string LineOf(std::string_view name, int line) const;

  /// Returns the path of a loaded file, or the name itself.
  std::string PathOf(std::string_view name) const;

  /// From now on the file has this content, also for machines that load it later and in messages about it. Does nothing
  /// if the file was not loaded.
  void Replace(std::string_view name, std::string_view content);

  const std::vector<std::filesystem::path>& folders() const { return folders_; }

 private:
  /// Returns the path of the file with this name. Fails as Load does.
  Result<std::filesystem::path> Locate(std::string_view name, const std::string& kind, std::uintmax_t largest) const;
  /// Returns true if the file is outside of all folders after all links are resolved.
  bool LinksOutside(const std::filesystem::path& file) const;

  std::vector<std::filesystem::path> folders_;
  std::map<std::string, ScriptSource, std::less<>> cache_;
};

}  // namespace soarbox::script
