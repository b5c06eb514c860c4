// SPDX-License-Identifier: BSD-2-Clause
#include "sim/scenario_build.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "sim/directions.h"

namespace soarbox::sim {
namespace {

world::Quat AboutUp(float degrees) {
  const float half = degrees * std::numbers::pi_v<float> / 360;
  return {std::cos(half), 0, std::sin(half), 0};
}

void BuildThing(const ScenarioFile::Thing& thing, ScenarioBuild& build) {
  const bool is_column = thing.shape == "column";
  const world::EntityId id = is_column ? build.world.CreateCapsule(thing.size.y, thing.size.x / 2)
                                       : build.world.CreateBox(thing.size.x, thing.size.y, thing.size.z);
  world::Object* object = build.world.FindObject(id);
  if (object == nullptr) return;
  world::Vec3 place = thing.position;
  place.y += thing.size.y / 2;
  object->SetMass(thing.mass_kg);
  object->SetPosition(place);
  object->SetOrientation(AboutUp(thing.heading_deg));
  build.world.scene().SetMaterial(object->node(), thing.material);
  if (!thing.name.empty()) build.arena.places().object_names[id] = thing.name;
  if (thing.is_item)
    build.arena.places().items[id] = {id,         thing.gives,  thing.amount, thing.shape, thing.material,
                                      thing.size, thing.mass_kg};
}

/// Places the agents of one entry side by side along x, in rows, beginning at the entry's position or the middle of the
/// world. Each row is behind the previous one.
void TakePlace(const ScenarioFile::Agent& agent, int number, Options& options) {
  constexpr double kApart_m = 1.5;
  if (!options.contains("position.1")) options["position.1"] = options["position.2"] = 0.0;
  const auto move = [&](const char* name, double by_m) {
    if (const auto at = options.find(name); at != options.end())
      if (double* value = std::get_if<double>(&at->second)) *value += by_m;
  };
  const auto heading = options.find("heading");
  const double* heading_deg = heading == options.end() ? nullptr : std::get_if<double>(&heading->second);
  const bool faces_south = heading_deg == nullptr || std::cos(*heading_deg * std::numbers::pi / 180) >= 0;
  const double behind_m = (faces_south ? -kApart_m : kApart_m) * (number / agent.across);
  move("position.1", kApart_m * (number % agent.across));
  move(options.contains("position.3") ? "position.3" : "position.2", behind_m);
}

Result<void> BuildAgent(const ScenarioFile::Agent& agent, int number, std::set<std::string>& names,
                        ScenarioBuild& build) {
  script::AgentCreationRequest request;
  request.kind = "soar";
  request.rules = agent.rules;
  request.options = agent.options;
  if (request.rules == kGivenRules) request.rules = build.scenario.rules.filename().string();
  std::string name = agent.name;
  if (name.empty()) name = request.rules.empty() ? "agent" : std::filesystem::path(request.rules).stem().string();
  const std::string stem = name;
  if (agent.count > 1) name += "-" + std::to_string(number + 1);
  for (int i = 2; !names.insert(name).second; ++i) name = stem + "-" + std::to_string(i);
  if (agent.count > 1) TakePlace(agent, number, request.options);
  world::AgentDef def;
  def.name = name;
  def.kind = "soar";
  const std::filesystem::path* other_rules = build.scenario.ReplacementFor(name);
  def.script = other_rules != nullptr ? other_rules->filename().string() : request.rules;
  const world::EntityId id = build.world.CreateAgent(def);
  Diagnostic problem;
  problem.file = build.scenario.definition.string();
  problem.line = agent.line;
  if (id == world::kNoEntity) {
    problem.message = "the world cannot hold another agent";
    return problem;
  }
  if (const Result<void> made = build.minds.MakeMind(id, request); !made) {
    problem.message = made.error().message;
    if (agent.line_of_rules > 0 && problem.message.find(request.rules) != std::string::npos)
      problem.line = agent.line_of_rules;
    problem.hint = made.error().hint;
    return problem;
  }
  return {};
}

constexpr world::Vec3 kAboveGround{0, 0.05f, 0};

/// Draws the border of a region on the ground.
void MarkRegion(const Region& region, world::Scene& scene) {
  const world::Vec3 middle = region.center + kAboveGround;
  if (region.half_x_m <= 0) {
    scene.SetPosition(scene.CreateCircle(world::NodeId::kRoot, region.radius_m), middle);
    return;
  }
  constexpr float kWide_m = 0.08f, kHigh_m = 0.01f;
  for (const float side : {-1.0f, 1.0f}) {
    const world::NodeId along_x =
        scene.CreateBox(world::NodeId::kRoot, 2 * region.half_x_m + kWide_m, kHigh_m, kWide_m);
    scene.SetPosition(along_x, middle + world::Vec3{0, 0, side * region.half_z_m});
    const world::NodeId along_z =
        scene.CreateBox(world::NodeId::kRoot, kWide_m, kHigh_m, 2 * region.half_z_m - kWide_m);
    scene.SetPosition(along_z, middle + world::Vec3{side * region.half_x_m, 0, 0});
  }
}

}  // namespace

Result<void> BuildScenario(const ScenarioFile& file, ScenarioBuild& build) {
  Places& places = build.arena.places();
  places.waypoints = file.waypoints;
  places.regions = file.regions;
  for (const Waypoint& waypoint : file.waypoints) {
    const world::NodeId ring = build.world.scene().CreateCircle(world::NodeId::kRoot, 0.75f);
    build.world.scene().SetPosition(ring, waypoint.position + kAboveGround);
  }
  for (const Region& region : file.regions) MarkRegion(region, build.world.scene());
  for (const ScenarioFile::Thing& thing : file.things) BuildThing(thing, build);
  if (!file.things.empty()) build.arena.BuildWays();
  build.minds.body_kinds().insert(build.minds.body_kinds().end(), file.bodies.begin(), file.bodies.end());
  std::set<std::string> names;
  for (const ScenarioFile::Agent& agent : file.agents) {
    for (int i = 0; i < agent.count; ++i) {
      if (Result<void> made = BuildAgent(agent, i, names, build); !made) return made;
    }
  }
  return {};
}

ScenarioEnd::ScenarioEnd(const ScenarioFile& file, const world::World& world, const Arena& arena)
    : waiting_(file.conditions), world_(world), arena_(arena) {}

bool ScenarioEnd::Holds(const ScenarioFile::Condition& condition) const {
  if (condition.after_s && world_.time_s() < *condition.after_s) return false;
  if (!condition.team_down.empty()) {
    for (const world::EntityId id : world_.AgentIds()) {
      const world::Agent& agent = *world_.FindAgent(id);
      if (agent.Team() == condition.team_down && agent.Health() > 0) return false;
    }
  }
  if (!condition.dead.empty()) {
    const world::Agent* agent = world_.FindAgent(arena_.FindAgentNamed(condition.dead));
    if (agent == nullptr || agent->Health() > 0) return false;
  }
  const Region* region = arena_.places().FindRegion(condition.region);
  if (!condition.agent.empty()) {
    const world::EntityId id = arena_.FindAgentNamed(condition.agent);
    const world::Agent* agent = world_.FindAgent(id);
    if (agent == nullptr) return false;
    if (!condition.region.empty() && (region == nullptr || !region->Contains(agent->Position()))) return false;
    if (!condition.carries.empty() && !Carries(id, condition.carries)) return false;
  }
  if (!condition.item.empty()) {
    const world::Object* item = world_.FindObject(arena_.FindObjectNamed(condition.item));
    if (item == nullptr || item->removal_requested() || region == nullptr || !region->Contains(item->Position()))
      return false;
  }
  return std::ranges::all_of(condition.all, [this](const auto& part) { return Holds(part); });
}

bool ScenarioEnd::Carries(world::EntityId agent, const std::string& thing) const {
  for (const auto& actor : arena_.actors())
    if (actor->id() == agent)
      return std::ranges::any_of(actor->carried(), [&](const CarriedThing& one) { return one.name == thing; });
  return false;
}

std::string ScenarioEnd::Check() {
  const auto reached = std::find_if(waiting_.begin(), waiting_.end(), [&](const auto& c) { return Holds(c); });
  if (reached == waiting_.end()) return {};
  std::string name = reached->name;
  over_ |= reached->ends;
  waiting_.erase(reached);
  return name;
}

}  // namespace soarbox::sim
