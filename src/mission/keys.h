// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace soarbox::mission {

/// What a check may speak of.
enum class Key : std::uint8_t {
  // The world.
  kAt,
  kInside,
  kNear,
  kAlive,
  kTeamDown,
  kTeamWins,
  kEnded,
  kCarries,
  kCarried,
  kHealth,
  kScore,
  kAmmunition,
  kSpeed,
  kDistance,
  kRounds,
  kDamage,
  kIdle,
  kSees,
  kCollides,
  kHitBy,
  kHits,
  // What minds say and decide.
  kMessage,
  kPrints,
  kOperator,
  kImpasse,
  kCommand,
  kAnswered,
  kRepeats,
  kDecisions,
  kFirings,
  kElements,
  kDepth,
  kRule,
  kElement,
  kLearned,
  kReused,
  kReward,
  kUpdates,
  kValues,
  kRetrieval,
  kProblem,
};

/// How a fact stands in time.
enum class Kind : std::uint8_t {
  kState,    ///< Holds or does not, in each tick.
  kEvent,    ///< Happens in a tick, perhaps several times.
  kGauge,    ///< A number in each tick.
  kCounter,  ///< A number that only grows.
};

/// Where a fact comes from; what no check asks for is not looked at.
enum class Source : std::uint8_t {
  kWorld,
  kNotes,    ///< What minds note of their decisions.
  kFirings,  ///< What minds note of each rule.
  kInsight,  ///< What the inspector tells.
};

/// What a key's value names.
enum class Names : std::uint8_t {
  kNothing,  ///< A number with bounds, or true and false.
  kTruth,
  kWaypoint,
  kRegion,
  kPlace,  ///< An agent, an item, a waypoint.
  kTeam,
  kEnd,
  kItem,
  kAgent,
  kThing,  ///< An agent or an object; "any", "friend", "enemy".
  kTopic,  ///< What messages are about.
  kText,   ///< Text; * stands for any.
  kOperator,
  kImpasse,
  kCommand,
  kRule,
  kAttribute,
  kSeverity,
  kMemory,
};

struct KeyRow {
  std::string_view name;
  Key key;
  Kind kind;
  Source source;
  Names names;
  std::string_view meaning;  ///< For docs/missions.md and messages.
  bool of_world = false;     ///< No agent is needed.
};

/// All keys, in the order of the manual.
std::span<const KeyRow> Keys();
/// Null if there is none of that name.
const KeyRow* FindKey(std::string_view name);

struct AgentFacts;
/// A key that is a number of an agent.
struct NumberRow {
  Key key;
  double (*value)(const AgentFacts& agent);
  std::string_view verb, unit;  ///< "walk " and " m", around the bounds.
};
/// Null for keys that are no numbers of agents.
const NumberRow* FindNumber(Key key);

}  // namespace soarbox::mission
