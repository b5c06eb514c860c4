// SPDX-License-Identifier: BSD-2-Clause
#include "mission/keys.h"

#include <algorithm>

namespace soarbox::mission {
namespace {

constexpr KeyRow kKeys[] = {
    {"at", Key::kAt, Kind::kState, Source::kWorld, Names::kWaypoint, "is at this waypoint: within 1.5 m"},
    {"inside", Key::kInside, Kind::kState, Source::kWorld, Names::kRegion, "is inside this region"},
    {"near", Key::kNear, Kind::kState, Source::kWorld, Names::kPlace,
     "is near an agent, an item or a waypoint; range = { max = 2 } says how near"},
    {"alive", Key::kAlive, Kind::kState, Source::kWorld, Names::kTruth, "is alive, or is not"},
    {"team_down", Key::kTeamDown, Kind::kState, Source::kWorld, Names::kTeam, "nobody of this team lives", true},
    {"team_wins", Key::kTeamWins, Kind::kState, Source::kWorld, Names::kTeam,
     "somebody of this team lives, and nobody of any other", true},
    {"ended", Key::kEnded, Kind::kState, Source::kWorld, Names::kEnd, "this [[end]] or [[goal]] has been reached",
     true},
    {"carries", Key::kCarries, Kind::kState, Source::kWorld, Names::kItem, "carries this item"},
    {"carried", Key::kCarried, Kind::kState, Source::kWorld, Names::kTruth, "of an item: somebody carries it"},
    {"health", Key::kHealth, Kind::kGauge, Source::kWorld, Names::kNothing, "its health"},
    {"score", Key::kScore, Kind::kGauge, Source::kWorld, Names::kNothing, "its score in a game"},
    {"ammunition", Key::kAmmunition, Kind::kGauge, Source::kWorld, Names::kNothing,
     "rounds that it has, in the weapon and in reserve"},
    {"speed", Key::kSpeed, Kind::kGauge, Source::kWorld, Names::kNothing, "m/s over the ground"},
    {"distance", Key::kDistance, Kind::kCounter, Source::kWorld, Names::kNothing, "metres walked"},
    {"rounds", Key::kRounds, Kind::kCounter, Source::kWorld, Names::kNothing, "rounds fired"},
    {"damage", Key::kDamage, Kind::kCounter, Source::kWorld, Names::kNothing, "health lost"},
    {"idle", Key::kIdle, Kind::kCounter, Source::kWorld, Names::kNothing, "seconds with no command under way"},
    {"sees", Key::kSees, Kind::kState, Source::kWorld, Names::kThing,
     "has this agent, item or thing in view, or \"any\", \"friend\", \"enemy\""},
    {"collides", Key::kCollides, Kind::kEvent, Source::kWorld, Names::kThing,
     "begins to touch an agent or a thing, or \"any\", \"friend\", \"enemy\""},
    {"hit_by", Key::kHitBy, Kind::kEvent, Source::kWorld, Names::kThing, "is hit by a shot of this agent"},
    {"hits", Key::kHits, Kind::kEvent, Source::kWorld, Names::kThing, "hits this agent with a shot"},
    {"message", Key::kMessage, Kind::kEvent, Source::kWorld, Names::kTopic, "sends a message about this"},
    {"prints", Key::kPrints, Kind::kEvent, Source::kWorld, Names::kText, "prints this; * matches any text"},
    {"operator", Key::kOperator, Kind::kState, Source::kNotes, Names::kOperator,
     "has an operator of this name selected; level = 2 for one in the first substate"},
    {"impasse", Key::kImpasse, Kind::kEvent, Source::kNotes, Names::kImpasse,
     "meets an impasse: tie, conflict, constraint-failure, state-no-change, operator-no-change, any"},
    {"command", Key::kCommand, Kind::kEvent, Source::kNotes, Names::kCommand,
     "gives this command; with status = \"complete\", \"error\" or \"interrupted\": gets this answer to it"},
    {"answered", Key::kAnswered, Kind::kGauge, Source::kInsight, Names::kNothing,
     "answered commands that are still on the output link"},
    {"repeats", Key::kRepeats, Kind::kCounter, Source::kNotes, Names::kNothing,
     "how often it repeated a command that was still being carried out"},
    {"decisions", Key::kDecisions, Kind::kCounter, Source::kInsight, Names::kNothing, "decisions taken"},
    {"firings", Key::kFirings, Kind::kCounter, Source::kInsight, Names::kNothing, "firings of rules"},
    {"elements", Key::kElements, Kind::kGauge, Source::kInsight, Names::kNothing, "elements in working memory"},
    {"depth", Key::kDepth, Kind::kGauge, Source::kInsight, Names::kNothing, "states of the goal stack; 1: no impasse"},
    {"rule", Key::kRule, Kind::kEvent, Source::kFirings, Names::kRule, "fires this rule; * matches any text"},
    {"element", Key::kElement, Kind::kState, Source::kInsight, Names::kAttribute,
     "has an element at this path from the top state, or behind \"substate.\" from any below it; is = VALUE, support = "
     "\"i\" or \"o\""},
    {"learned", Key::kLearned, Kind::kCounter, Source::kInsight, Names::kNothing, "rules learned"},
    {"reused", Key::kReused, Kind::kCounter, Source::kInsight, Names::kNothing, "firings of rules that it learned"},
    {"reward", Key::kReward, Kind::kCounter, Source::kInsight, Names::kNothing, "reward collected: the sum of all"},
    {"updates", Key::kUpdates, Kind::kCounter, Source::kInsight, Names::kNothing,
     "how often the numbers of its rules were updated"},
    {"values", Key::kValues, Kind::kGauge, Source::kInsight, Names::kNothing,
     "rules whose value is learned from reward"},
    {"retrieval", Key::kRetrieval, Kind::kEvent, Source::kInsight, Names::kMemory,
     "gets an answer from its semantic or episodic memory; status = \"success\" or \"failure\""},
    {"problem", Key::kProblem, Kind::kEvent, Source::kWorld, Names::kSeverity,
     "the run reports a problem: \"error\", \"warning\" or \"any\"", true},
};

}  // namespace

std::span<const KeyRow> Keys() {
  return kKeys;
}

const KeyRow* FindKey(std::string_view name) {
  const auto* at =
      std::find_if(std::begin(kKeys), std::end(kKeys), [&](const KeyRow& row) { return row.name == name; });
  return at == std::end(kKeys) ? nullptr : at;
}

}  // namespace soarbox::mission
