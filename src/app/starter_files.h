// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace soarbox::app {

/// A file of a starter scenario. NAME is replaced by the scenario's name.
struct StarterFile {
  std::string_view name;
  std::string_view meaning;
  std::string text;
};

std::vector<StarterFile> SoarStarter();
std::vector<StarterFile> LuaStarter();
std::vector<StarterFile> TeamStarter();

}  // namespace soarbox::app
