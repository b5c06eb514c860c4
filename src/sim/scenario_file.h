// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/result.h"
#include "sim/agent_options.h"
#include "sim/places.h"
#include "sim/scenario.h"

namespace soarbox::sim {

/// A scenario as its file (TOML) has it: plain data, checked, not yet in any world. docs/scenarios.md describes the
/// file.
struct ScenarioFile {
  struct Thing {
    std::string name, shape = "box", material, gives;
    world::Vec3 position;
    world::Vec3 size{1, 1, 1};
    float heading_deg = 0;
    float mass_kg = 0;  ///< 0: fixed.
    float amount = 0;
    bool is_item = false;
  };
  struct Agent {
    std::string name, rules;
    Options options;
    int count = 1;
    int across = 1000;  ///< So many of them stand side by side; the next ones stand behind these.
    int line = 0, line_of_rules = 0;
  };
  /// All that is given must hold at the same time; reached once.
  struct Condition {
    std::string name;
    bool ends = true;
    std::optional<double> after_s;
    std::string team_down, dead;
    std::string agent, region, carries;  ///< The agent is in the region, or carries the item, or both.
    std::string item;                    ///< It lies in the region.
    std::vector<Condition> all;          ///< Further ones.
  };

  std::filesystem::path file;
  std::string description;
  std::string script;         ///< A Lua file that makes the world; empty: none.
  bool has_exercise = false;  ///< It joins other simulations, whose agents may be all that there are ([dis]).
  std::optional<std::uint64_t> seed;
  std::optional<double> seconds;
  int turn_ticks =
      1;  ///< Of a game: so many ticks are a turn, which is what a step goes on by. Turns end at multiples.
  std::vector<Waypoint> waypoints;
  std::vector<Region> regions;
  std::vector<Thing> things;
  std::vector<BodyKind> bodies;  ///< Its own kinds.
  std::vector<Agent> agents;
  std::vector<Condition> conditions;
};

/// Reads a text; everything that is wrong is added to the problems.
ScenarioFile ParseScenarioFile(std::string_view text, const std::filesystem::path& file,
                               std::vector<Diagnostic>& problems);
/// Reads a file; the first problem if there is any. The others are added to `further`.
Result<ScenarioFile> ReadScenarioFile(const std::filesystem::path& file, std::vector<Diagnostic>* further = nullptr);
/// The seed that was asked for, else that of the scenario's file, else 1 (also if the file cannot be read).
std::uint64_t SeedOf(const Scenario& scenario, std::optional<std::uint64_t> asked);
/// How many ticks a turn of the scenario's game has; 1 if it is no game, or cannot be read.
int TurnTicks(const Scenario& scenario);
/// Where a scenario that is only rules gets its world from: this word stands in place of an agent's rules.
inline constexpr std::string_view kGivenRules = "RULES";

}  // namespace soarbox::sim
