// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace soarbox::mission {

/// What a check can test.
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

/// How a value behaves over time.
enum class Kind : std::uint8_t {
  kState,    ///< True or false in each tick.
  kEvent,    ///< Occurs in a tick, possibly several times.
  kGauge,    ///< A number in each tick.
  kCounter,  ///< A number that only increases.
};

/// Where a value comes from. Sources are read only if a check needs them.
enum class Source : std::uint8_t {
  kWorld,
  kNotes,    ///< Recorded decisions of minds.
  kFirings,  ///< Recorded firings of rules.
  kInsight,  ///< The Inspector.
};

/// What the value of a key refers to.
enum class Names : std::uint8_t {
  kNothing,  ///< A number with bounds.
  kTruth,
  kWaypoint,
  kRegion,
  kPlace,  ///< An agent, an item or a waypoint.
  kTeam,
  kEnd,
  kItem,
  kAgent,
  kThing,  ///< An agent or an object; "any", "friend", "enemy".
  kTopic,  ///< Subject of a message.
  kText,   ///< Text; * matches any text.
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
  bool of_world = false;     ///< It needs no agent.
};

/// All keys, in the order of the documentation.
std::span<const KeyRow> Keys();
/// Null if there is no key of that name.
const KeyRow* FindKey(std::string_view name);

struct AgentFacts;
/// A key for a number of an agent.
struct NumberRow {
  Key key;
  double (*value)(const AgentFacts& agent);
  std::string_view verb, unit;  ///< Texts before and after the bounds: "walk ", " m".
};
/// Null for keys that are not numbers of agents.
const NumberRow* FindNumber(Key key);

}  // namespace soarbox::mission
