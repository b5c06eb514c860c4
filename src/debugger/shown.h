// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "debugger/json.h"
#include "world/scene_snapshot.h"
#include "world/shown_state.h"

namespace soarbox::debugger {

/// What an agent's script shows of its state (Agent.Show) at one moment.
struct ShownView {
  std::string agent;
  std::uint64_t tick = 0;
  double time_s = 0;
  std::vector<world::ShownRow> rows;
};

/// For the agent of this name. No rows if it shows nothing or does not exist.
ShownView LookAtShown(const world::SceneSnapshot& scene, std::string_view agent);

/// One line for each row, indented by depth. ">" marks the active path; the end of the line gives the time since when.
std::string ToText(const ShownView& view);
/// The agent, and a list of its rows: `depth`, `name`, `value`, `active`, `since` (s).
Json ToJson(const ShownView& view);

}  // namespace soarbox::debugger
