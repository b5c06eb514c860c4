// SPDX-License-Identifier: BSD-2-Clause
#include "sim/body_kind.h"

#include <algorithm>
#include <utility>

namespace soarbox::sim {

std::span<const BodyKind> BodyKinds() {
  static const std::vector<BodyKind> kinds = [] {
    std::vector<BodyKind> made(4);
    BodyKind& walker = made[0];
    walker.name = "walker";
    walker.meaning = "a person without a weapon";

    BodyKind& soldier = made[1];
    soldier.name = "soldier";
    soldier.meaning = "a person with a rifle";
    soldier.armed = true;

    BodyKind& runner = made[2];
    runner.name = "runner";
    runner.meaning = "a fast person without a weapon";
    runner.max_speed_mps = 8;
    runner.walk_mps = 5;

    BodyKind& sentry = made[3];
    sentry.name = "sentry";
    sentry.meaning = "a slow person with a weapon that reaches far, and good eyes";
    sentry.armed = true;
    sentry.max_speed_mps = 2;
    sentry.walk_mps = 1.5f;
    sentry.weapon.range_m = 80;
    sentry.weapon.spread_deg = 0.7f;
    sentry.senses.sight_m = 80;
    return made;
  }();
  return kinds;
}

std::string_view MaterialOfLooks(std::string_view looks) {
  constexpr std::pair<std::string_view, std::string_view> kMaterials[] = {
      {"sheep", "Soarbox/Sheep"}, {"bear", "Soarbox/Bear"}, {"hare", "Soarbox/Hare"},
      {"cook", "Soarbox/Cook"},   {"wolf", "Soarbox/Wolf"}, {"villager", "Soarbox/Villager"},
      {"robot", "Soarbox/Robot"}, {"cart", "Soarbox/Cart"}, {"bee", "Soarbox/Bee"},
      {"bell", "Soarbox/Bell"}};
  for (const auto& [name, material] : kMaterials)
    if (name == looks) return material;
  return {};
}

std::string_view MaterialOfThing(std::string_view name, std::string_view gives, bool is_item) {
  const auto has = [name](std::string_view part) { return name.find(part) != std::string_view::npos; };
  if (gives == "health" || has("medkit")) return "Soarbox/Medkit";
  if (gives == "ammunition" || has("ammo")) return "Soarbox/Ammunition";
  if (has("rock") || has("stone") || has("boulder")) return "Soarbox/Rock";
  if (has("crate") || has("box") || has("chest")) return "Soarbox/Crate";
  if (has("sack") || has("bag") || has("flour")) return "Soarbox/Sack";
  if (is_item && has("gold")) return "Soarbox/Gold";
  if (is_item && has("silver")) return "Soarbox/Silver";
  if (is_item && has("bronze")) return "Soarbox/Bronze";
  if (is_item && has("flower"))
    return has("red") ? "Soarbox/RedFlower" : has("blue") ? "Soarbox/BlueFlower" : "Soarbox/WhiteFlower";
  if (is_item) return "Soarbox/Sack";
  if (has("hedge") || has("bush")) return "Soarbox/Hedge";
  if (has("table") || has("barn") || has("bridge") || has("shelf")) return "Soarbox/Crate";
  if (has("well") || has("mill")) return "Soarbox/Rock";
  if (has("shed") || has("house") || has("hut") || has("wall")) return "Soarbox/Brick";
  return "Soarbox/Concrete";
}

const AgentKind* FindAgentKind(std::string_view name) {
  static constexpr AgentKind kKinds[] = {
      {"seeking", "seekingagent.soar"},
      {"follower", "followeragent.soar", true},
      {"waypoint", "waypointagent.soar"},
      {"soar", "", false, true, true},
  };
  const auto at =
      std::find_if(std::begin(kKinds), std::end(kKinds), [&](const AgentKind& k) { return k.name == name; });
  return at == std::end(kKinds) ? nullptr : at;
}

}  // namespace soarbox::sim
