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

/// What the script of an agent shows of its state (Agent.Show), at one moment.
struct ShownView {
  std::string agent;
  std::uint64_t tick = 0;
  double time_s = 0;
  std::vector<world::ShownRow> rows;
};

/// Of the agent of this name; without rows if it shows nothing or is not there.
ShownView LookAtShown(const world::SceneSnapshot& scene, std::string_view agent);

/// One line for each row, deeper ones indented; ">" marks the active path, and the end says since when.
std::string ToText(const ShownView& view);
/// The agent, and a list of its rows: `depth`, `name`, `value`, `active`, `since` (s).
Json ToJson(const ShownView& view);

}  // namespace soarbox::debugger
