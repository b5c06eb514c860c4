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
    int across = 1000;  ///< This many of them stand side by side; the next ones stand behind them.
    int line = 0, line_of_rules = 0;
  };
  /// Everything that is given must be true at the same time; reached once.
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
      1;  ///< Of a game: how many ticks a turn takes. A step goes on by one turn. Turns end at multiples of this.
  std::vector<Waypoint> waypoints;
  std::vector<Region> regions;
  std::vector<Thing> things;
  std::vector<BodyKind> bodies;  ///< Its own kinds.
  std::vector<Agent> agents;
  std::vector<Condition> conditions;
};

/// Reads a text; adds everything that is wrong to the problems.
ScenarioFile ParseScenarioFile(std::string_view text, const std::filesystem::path& file,
                               std::vector<Diagnostic>& problems);
/// Reads a file; gives the first problem if there is one, and adds the others to `further`.
Result<ScenarioFile> ReadScenarioFile(const std::filesystem::path& file, std::vector<Diagnostic>* further = nullptr);
/// The seed that was asked for, else that of the scenario's file, else 1 (also if the file cannot be read).
std::uint64_t SeedOf(const Scenario& scenario, std::optional<std::uint64_t> asked);
/// How many ticks a turn of the scenario's game has; 1 if it is no game, or cannot be read.
int TurnTicks(const Scenario& scenario);
/// For a scenario that is only rules: the file of its world has this word in place of an agent's rules.
inline constexpr std::string_view kGivenRules = "RULES";

}  // namespace soarbox::sim
