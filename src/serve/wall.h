// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace soarbox::serve {

/// What a process may do after RaiseWall.
struct WallSettings {
  std::vector<std::filesystem::path> writable;  ///< Folders that it may read and change.
  std::vector<std::filesystem::path> readable;  ///< Folders that it may read; system libraries are always readable.
  bool may_connect = false;                     ///< It may use the network.
};

/// Permanently restricts the calling process to what the world of a stranger needs. It loses access to files outside
/// its folders, other programs, the network, and signals to and memory of other processes. The interpreters of rules
/// and Lua allow none of that anyway; the wall protects if one of them has a bug. Call it while the process has only
/// one thread. Child processes inherit it. Returns a sentence for each restriction that this system does not support;
/// the others are in effect.
std::vector<std::string> RaiseWall(const WallSettings& settings);

/// Returns the same sentences without restricting this process; a child process tries.
std::vector<std::string> MissingOfWall();

}  // namespace soarbox::serve
