// SPDX-License-Identifier: BSD-2-Clause
#include "mission/rule_watch.h"

#include <algorithm>
#include <optional>

#include "explain/inspector.h"
#include "explain/rule_text.h"
#include "explain/why_node.h"
#include "mission/account.h"
#include "sim/simulation.h"

namespace soarbox::mission {
namespace {

/// Maximum number of unfired rules of an agent that are watched in a tick: the first in the order of loading.
constexpr std::size_t kMostWatched = 40;
constexpr std::size_t kMostElements = 1000;

/// Whether working memory contains an element with the attribute of a condition, and one with its value as well,
/// regardless of the other conditions.
struct Presence {
  bool has_attribute = false, has_value = false;
};
Presence PresenceOf(explain::Inspector& inspector, const RuleWatch::Asked& asked) {
  Presence presence;
  if (asked.attribute.empty()) return {true, true};
  std::string value = asked.value;
  if (value.size() > 1 && value.front() == '|' && value.back() == '|') value = value.substr(1, value.size() - 2);
  for (const explain::ElementFact& element : inspector.Search(asked.attribute, kMostElements)) {
    if (element.attribute != asked.attribute) continue;
    presence.has_attribute = true;
    presence.has_value |= asked.value.empty() || element.value == asked.value || element.value == value;
  }
  return presence;
}

/// The constants that the positive conditions of a rule test.
std::vector<RuleWatch::Asked> AskedBy(const explain::MatchFacts& match) {
  std::vector<RuleWatch::Asked> all;
  for (const explain::ConditionFact& condition : match.conditions) {
    if (condition.negated) continue;
    RuleWatch::Asked& asked = all.emplace_back();
    const std::vector<explain::RuleAttribute> read = explain::ReadConditions(condition.text);
    if (read.empty() || !explain::IsConstantAttribute(read.front().attribute)) continue;
    asked.attribute = read.front().attribute;
    if (read.front().value.find_first_of("<>{}= ") == std::string::npos) asked.value = read.front().value;
  }
  return all;
}

/// The rule that made the element that another rule excludes; empty if it is not known, or if there are several.
std::string MakerOfExcluded(explain::Inspector& inspector, const std::string& attribute) {
  std::set<std::string> makers;
  for (const explain::ElementFact& element : inspector.Search(attribute, kMostElements)) {
    if (element.attribute != attribute) continue;
    for (const explain::MakerFact& maker : inspector.MakersOf(element.timetag))
      if (maker.kind == explain::MakerFact::Kind::kRule) makers.insert(maker.rule);
  }
  return makers.size() == 1 ? *makers.begin() : std::string();
}

/// The first node of a tree that says why a rule does not match.
const explain::RuleWait* FindWait(const explain::WhyNode& node, const std::string& rule) {
  if (node.wait && node.wait->rule == rule) return &*node.wait;
  for (const explain::WhyNode& below : node.below)
    if (const explain::RuleWait* wait = FindWait(below, rule)) return wait;
  return nullptr;
}

}  // namespace

std::optional<explain::RuleWait> WhyRuleWaits(sim::Simulation& simulation, const std::string& agent,
                                              const std::string& rule) {
  const Result<std::vector<explain::WhyNode>> why = simulation.WhyTopic(agent, rule);
  if (!why) return std::nullopt;
  for (const explain::WhyNode& node : *why) {
    const explain::RuleWait* found = FindWait(node, rule);
    if (found == nullptr) continue;
    explain::RuleWait wait = *found;
    const auto inspector = simulation.Inspect(agent);
    if (wait.is_excluded && inspector != nullptr) {
      wait.found.maker = MakerOfExcluded(*inspector, wait.attribute);
      if (!wait.found.maker.empty()) wait.found.text += "; rule " + wait.found.maker + " made it";
    }
    return wait;
  }
  return std::nullopt;
}

RuleWatch::RuleWatch(sim::Simulation& simulation, const AccountSettings& settings)
    : simulation_(simulation), settings_(settings) {}

void RuleWatch::See() {
  for (std::size_t i = 0; i < simulation_.soar_agents(); ++i) {
    const std::string agent = simulation_.AgentOfMind(i);
    if (!settings_.IsAboutAgent(agent)) continue;
    const auto inspector = simulation_.Inspect(agent);
    if (inspector == nullptr || !inspector->TellsAll()) continue;
    std::size_t watched = 0;
    for (const explain::RuleFact& rule : inspector->Rules()) {
      if (rule.firings > 0 || settings_.given.contains(rule.name) || !settings_.IsAbout(rule.file)) continue;
      if (++watched > kMostWatched) break;
      Look(*inspector, agent, rule.name);
    }
  }
}

void RuleWatch::Look(explain::Inspector& inspector, const std::string& agent, const std::string& rule) {
  const std::optional<explain::MatchFacts> match = inspector.Match(rule);
  if (!match || !match->failing) return;
  Score score;
  score.matched = *match->failing;
  const auto [at, is_new] = best_.try_emplace({agent, rule});
  Best& best = at->second;
  if (is_new) {
    order_.push_back(at->first);
    best.asked = AskedBy(*match);
  }
  for (const Asked& asked : best.asked) {
    const Presence presence = PresenceOf(inspector, asked);
    score.values += presence.has_value ? 1 : 0;
    score.attributes += presence.has_attribute ? 1 : 0;
  }
  if (!is_new && score <= best.score) return;
  best.score = score;
  std::optional<explain::RuleWait> why = WhyRuleWaits(simulation_, agent, rule);
  if (!why) return;
  using Kind = explain::RuleWait::Kind;
  // An absent element, or an excluded one whose maker is not known, may be due to other rules. Other reasons show what
  // is wrong in this rule.
  const bool waits_for_others =
      why->found.kind == Kind::kAbsent || (why->found.kind == Kind::kExists && why->found.maker.empty());
  best.waiting = Waiting{.agent = agent,
                         .why = *std::move(why),
                         .time_s = simulation_.time_s(),
                         .was_there = false,
                         .waits_for_others = waits_for_others};
}

std::vector<RuleWatch::Waiting> RuleWatch::Finish() {
  std::set<Key> fired;
  std::set<std::string> agents;  // Agents whose minds can be inspected: they were not halted.
  for (std::size_t i = 0; i < simulation_.soar_agents(); ++i) {
    const std::string agent = simulation_.AgentOfMind(i);
    const auto inspector = simulation_.Inspect(agent);
    if (inspector == nullptr) continue;
    agents.insert(agent);
    for (const explain::RuleFact& rule : inspector->Rules())
      if (rule.firings > 0) fired.emplace(agent, rule.name);
  }
  std::vector<Waiting> waiting;
  for (const Key& key : order_) {
    const Best& best = best_.at(key);
    if (fired.contains(key) || !best.waiting || !agents.contains(key.first)) continue;
    Waiting& each = waiting.emplace_back(*best.waiting);
    if (each.why.found.kind != explain::RuleWait::Kind::kAbsentMade) continue;
    // If the maker never fired, that is nearer to the cause than this rule.
    each.was_there = fired.contains({each.agent, each.why.found.maker});
    each.waits_for_others = !each.was_there;
  }
  std::ranges::stable_sort(waiting, {}, [](const Waiting& each) { return each.WaitsForOperator(); });
  return waiting;
}

}  // namespace soarbox::mission
