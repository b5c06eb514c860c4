// SPDX-License-Identifier: BSD-2-Clause
#include "mission/check_keys.h"

#include <algorithm>

#include "mission/event_facts.h"

namespace soarbox::mission {
namespace {

constexpr KeyRow kKeys[] = {
    {"at", Key::kAt, Kind::kState, Source::kWorld, Names::kWaypoint, "is at this waypoint: within 1.5 m"},
    {"inside", Key::kInside, Kind::kState, Source::kWorld, Names::kRegion, "is inside this region"},
    {"near", Key::kNear, Kind::kState, Source::kWorld, Names::kPlace,
     "is near an agent, an item or a waypoint; range = { max = 2 } says how near"},
    {"alive", Key::kAlive, Kind::kState, Source::kWorld, Names::kTruth, "is alive, or is not"},
    {"team_down", Key::kTeamDown, Kind::kState, Source::kWorld, Names::kTeam, "no agent of this team is alive", true},
    {"team_wins", Key::kTeamWins, Kind::kState, Source::kWorld, Names::kTeam,
     "an agent of this team is alive, and none of any other team", true},
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
     "has an element at this path from the top state, or after \"substate.\" from any state below it; is = VALUE, "
     "support = "
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

/// The keys for numbers of agents: where each number is stored, and the words around it in sentences.
constexpr NumberRow kNumbers[] = {
    {Key::kHealth, [](const AgentFacts& agent) { return agent.health; }, "have a health of ", ""},
    {Key::kScore, [](const AgentFacts& agent) { return agent.score.value_or(0); }, "have a score of ", ""},
    {Key::kAmmunition, [](const AgentFacts& agent) { return agent.ammunition.value_or(0); }, "have ", " rounds"},
    {Key::kSpeed, [](const AgentFacts& agent) { return agent.speed; }, "go at ", " m/s"},
    {Key::kDistance, [](const AgentFacts& agent) { return agent.distance; }, "walk ", " m"},
    {Key::kRounds, [](const AgentFacts& agent) { return agent.rounds; }, "fire ", " rounds"},
    {Key::kDamage, [](const AgentFacts& agent) { return agent.damage; }, "lose ", " health"},
    {Key::kIdle, [](const AgentFacts& agent) { return agent.idle; }, "stand idle ", " s"},
    {Key::kAnswered, [](const AgentFacts& agent) { return agent.answered; }, "leave ",
     " answered commands on the output link"},
    {Key::kRepeats, [](const AgentFacts& agent) { return agent.repeats; },
     "repeat a command that is still being carried out ", " times"},
    {Key::kDecisions, [](const AgentFacts& agent) { return agent.decisions; }, "take ", " decisions"},
    {Key::kFirings, [](const AgentFacts& agent) { return agent.firings; }, "fire rules ", " times"},
    {Key::kElements, [](const AgentFacts& agent) { return agent.elements; }, "have ", " elements in working memory"},
    {Key::kDepth, [](const AgentFacts& agent) { return agent.depth; }, "have ", " states in the goal stack"},
    {Key::kLearned, [](const AgentFacts& agent) { return agent.learned; }, "learn ", " rules"},
    {Key::kReused, [](const AgentFacts& agent) { return agent.reused; }, "fire learned rules ", " times"},
    {Key::kReward, [](const AgentFacts& agent) { return agent.reward; }, "collect a reward of ", ""},
    {Key::kUpdates, [](const AgentFacts& agent) { return agent.updates; }, "update its numbers ", " times"},
    {Key::kValues, [](const AgentFacts& agent) { return agent.values; }, "have ", " rules whose values are learned"},
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

const NumberRow* FindNumber(Key key) {
  const auto* at = std::ranges::find(kNumbers, key, &NumberRow::key);
  return at == std::end(kNumbers) ? nullptr : at;
}

}  // namespace soarbox::mission
