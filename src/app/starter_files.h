// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace soarbox::app {

/// One file of a starter scenario. NAME stands for the scenario's name.
struct StarterFile {
  std::string_view name;
  std::string_view meaning;
  std::string text;
};

std::vector<StarterFile> SoarStarter();
std::vector<StarterFile> LuaStarter();
std::vector<StarterFile> TeamStarter();

}  // namespace soarbox::app
