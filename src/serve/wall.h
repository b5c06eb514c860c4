// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace soarbox::serve {

/// What a process may still do when its wall is up.
struct WallSettings {
  std::vector<std::filesystem::path> writable;  ///< Folders it may read and change.
  std::vector<std::filesystem::path> readable;  ///< Folders it may read; the system's libraries are always readable.
  bool may_connect = false;                     ///< It may use the network.
};

/// Takes from the calling process, for good, what a world of a stranger does not need: files outside of its folders,
/// other programs, the network, the signals to and the memory of other processes. The interpreters of rules and Lua
/// allow none of that; the wall holds if one of them is broken. Call it while the process has one thread. Processes
/// that it starts have the same wall. Returns the sentences for what this system does not offer; the rest holds.
std::vector<std::string> RaiseWall(const WallSettings& settings);

/// The same sentences, without raising a wall: a child process tries.
std::vector<std::string> MissingOfWall();

}  // namespace soarbox::serve
