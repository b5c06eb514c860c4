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

/// The content of a scenario file (TOML) after parsing and checking, before a world is built. docs/scenarios.md
/// describes the file.
struct ScenarioFile {
  struct Thing {
    std::string name, shape = "box", material, gives;
    world::Vec3 position;
    world::Vec3 size{1, 1, 1};
    float heading_deg = 0;
    float mass_kg = 0;  ///< 0: it cannot move.
    float amount = 0;
    bool is_item = false;
  };
  struct Agent {
    std::string name, rules;
    Options options;
    int count = 1;
    int across = 1000;  ///< Number of agents side by side; the next ones are placed in further rows behind them.
    int line = 0, line_of_rules = 0;
  };
  /// All given parts must be true at the same time. A condition is reached once.
  struct Condition {
    std::string name;
    bool ends = true;
    std::optional<double> after_s;
    std::string team_down, dead;
    std::string agent, region, carries;  ///< The agent is in the region, or carries the item, or both.
    std::string item;                    ///< The item is in the region.
    std::vector<Condition> all;          ///< Further conditions that must also be true.
  };

  std::filesystem::path file;
  std::string description;
  std::string script;         ///< A Lua file that builds the world; empty: none.
  bool has_exercise = false;  ///< It joins other simulations ([dis]), whose agents may be the only ones.
  std::optional<std::uint64_t> seed;
  std::optional<double> seconds;
  int turn_ticks =
      1;  ///< For a game: number of ticks per turn. A step advances by one turn. Turns end at multiples of this number.
  std::vector<Waypoint> waypoints;
  std::vector<Region> regions;
  std::vector<Thing> things;
  std::vector<BodyKind> bodies;  ///< Kinds of bodies that the file defines.
  std::vector<Agent> agents;
  std::vector<Condition> conditions;
};

/// Parses a text. Adds all problems to `problems`.
ScenarioFile ParseScenarioFile(std::string_view text, const std::filesystem::path& file,
                               std::vector<Diagnostic>& problems);
/// Reads a file. Fails with the first problem if there is one; adds the others to `further`.
Result<ScenarioFile> ReadScenarioFile(const std::filesystem::path& file, std::vector<Diagnostic>* further = nullptr);
/// Returns `asked`, else the seed of the scenario's file, else 1 (also if the file cannot be read).
std::uint64_t SeedOf(const Scenario& scenario, std::optional<std::uint64_t> asked);
/// Number of ticks per turn of the scenario's game; 1 if it is not a game, or cannot be read.
int TurnTicks(const Scenario& scenario);
/// For a scenario that is a file of rules only: the world's definition contains this word in place of the rules.
inline constexpr std::string_view kGivenRules = "RULES";

}  // namespace soarbox::sim
