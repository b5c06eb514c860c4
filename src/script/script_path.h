// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/result.h"

namespace soarbox::script {

/// One script file as it was read: bytes, not text in any encoding.
struct ScriptSource {
  std::string name;  ///< As the script that wanted it called it, with the case that the file has.
  std::string path;  ///< Where it was found; for messages.
  std::string content;
  bool has_tick = false;  ///< It mentions Agent_Tick.
  /// What the first machine that ran it made of it, so that no other machine needs to parse it; empty before.
  mutable std::string compiled = {};
};

/// Where scripts are looked for: a list of folders, the first that has the file wins. The scenario's own folder comes
/// before the library's, so that a scenario can replace a library module. Names are exact first, then without regard to
/// case. Files are read once and kept, so that a run sees one version of each.
class ScriptPath {
 public:
  explicit ScriptPath(std::vector<std::filesystem::path> folders) : folders_(std::move(folders)) {}

  /// Reads `name` ("SeekingAgent.lua"). Fails if no folder has it (naming the folders, and a near-miss if there is
  /// one), if it cannot be read, or if the name leads out of the folders. The pointer stays valid.
  Result<const ScriptSource*> Load(std::string_view name);

  /// Reads a file that is no script, with the same bounds: an image, a model, a sound. `kind` names it in messages.
  /// Nothing is kept.
  Result<std::string> ReadBytes(std::string_view name, const std::string& kind, std::uintmax_t largest) const;

  /// Whether a file that was loaded mentions Agent_Tick.
  bool HasTick(std::string_view name) const;

  /// The line (from 1) of a file that was loaded before; empty if unknown. For excerpts in messages.
  std::string LineOf(std::string_view name, int line) const;

  /// The path at which a loaded file was found, or the name itself.
  std::string PathOf(std::string_view name) const;

  /// From now on a file has this content, also for machines that load it later and in messages about it.
  void Replace(std::string_view name, std::string_view content);

  const std::vector<std::filesystem::path>& folders() const { return folders_; }

 private:
  /// Where the file of this name is; fails as Load does.
  Result<std::filesystem::path> Locate(std::string_view name, const std::string& kind, std::uintmax_t largest) const;
  /// True if the file, all links followed, lies below none of the folders.
  bool LinksOutside(const std::filesystem::path& file) const;

  std::vector<std::filesystem::path> folders_;
  std::map<std::string, ScriptSource, std::less<>> cache_;
};

}  // namespace soarbox::script
