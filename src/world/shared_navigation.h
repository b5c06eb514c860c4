// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string_view>

namespace soarbox::world {

/// From here on, this process and those that it forks build each navigation mesh once for all of them: a thousand runs
/// of one world need its mesh a thousand times. Nobody can tell whether a mesh was built or found.
void ShareNavigation();

/// From here on, this process and those that it forks keep the meshes that they build as files in this folder, at most
/// 64, and find them there. `program` identifies the program; the files of other programs are built again. To be called
/// before there is another thread. An empty folder ends it.
void KeepNavigation(const std::filesystem::path& folder, std::string_view program);

}  // namespace soarbox::world
