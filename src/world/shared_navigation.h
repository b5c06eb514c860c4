// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string_view>

namespace soarbox::world {

/// From now on, this process and its forks build each navigation mesh only once and share it. A thousand runs of one
/// world otherwise build its mesh a thousand times. The results do not depend on it.
void ShareNavigation();

/// From now on, this process and its forks store the meshes that they build as files in this folder, at most 64, and
/// load them from there. `program` identifies the program; files of other programs are ignored. Call it before there is
/// another thread. An empty folder turns it off.
void KeepNavigation(const std::filesystem::path& folder, std::string_view program);

}  // namespace soarbox::world
