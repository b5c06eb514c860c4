// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/shown.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace soarbox::debugger {
namespace {

/// The simulated time of a tick up to the shown one, in seconds.
double TimeOf(const ShownView& view, std::uint64_t tick) {
  return view.tick == 0 ? 0 : view.time_s * static_cast<double>(tick) / static_cast<double>(view.tick);
}

}  // namespace

ShownView LookAtShown(const world::SceneSnapshot& scene, std::string_view agent) {
  ShownView view;
  view.agent = agent;
  view.tick = scene.tick;
  view.time_s = scene.time_s;
  const auto found = std::ranges::find(scene.agents, agent, &world::AgentSnapshot::name);
  if (found != scene.agents.end()) view.rows = world::ReadShown(found->shown);
  return view;
}

std::string ToText(const ShownView& view) {
  std::string text;
  for (const world::ShownRow& row : view.rows) {
    const std::string value = row.value.empty() ? "" : " " + row.value;
    text += fmt::format("{}{}{}{}  (since {:.2f} s)\n", std::string(2 * static_cast<std::size_t>(row.depth), ' '),
                        row.active      ? "> "
                        : row.depth > 0 ? "  "
                                        : "",
                        row.name, value, TimeOf(view, row.since_tick));
  }
  return text;
}

Json ToJson(const ShownView& view) {
  Json json;
  json["agent"] = view.agent;
  json["rows"] = Json::array();
  for (const world::ShownRow& row : view.rows)
    json["rows"].push_back({{"depth", row.depth},
                            {"name", row.name},
                            {"value", row.value},
                            {"active", row.active},
                            {"since", TimeOf(view, row.since_tick)}});
  return json;
}

}  // namespace soarbox::debugger
