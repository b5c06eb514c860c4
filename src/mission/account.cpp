// SPDX-License-Identifier: BSD-2-Clause
#include "mission/account.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <string_view>

#include "explain/inspector.h"
#include "explain/rule_text.h"
#include "mission/check_sentences.h"
#include "sim/simulation.h"
#include "wording/sentences.h"

namespace soarbox::mission {
namespace {

constexpr std::size_t kMostSlips = 3, kMostIdleReasons = 4, kMostRules = 3;

std::string FileName(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

/// "rule x never fired: it requires ^next 3, but it is 2. That was at 1.0 s, when it got furthest"
std::string NeverFired(const RuleWatch::Waiting& waiting) {
  const explain::RuleWait& why = waiting.why;
  if (waiting.was_there)
    return "rule " + why.rule + " never fired, although " + why.condition + " was there (rule " + why.found.maker +
           " made it): which of its other conditions was not met then?";
  std::string text = wording::Say(wording::Situation::kNeverFired, {{"rule", why.rule}, {"waits", why.Requires()}});
  if (waiting.time_s > 0) text += ". That was at " + SecondsText(waiting.time_s) + ", when it got furthest";
  return text;
}

/// Whether rules of the author that have fired are for a tie, a conflict or a constraint failure that the agent is in:
/// they test ^impasse with its kind.
bool HasAnswer(sim::Simulation& simulation, const AccountSettings& settings, const std::string& agent) {
  const auto inspector = simulation.Inspect(agent);
  if (inspector == nullptr) return false;
  std::set<std::string> impasses;
  for (const explain::StateFact& state : inspector->Stack())
    if (state.impasse != "no-change" && state.impasse != "none") impasses.insert(state.impasse);
  for (const explain::RuleFact& fact : inspector->Rules()) {
    if (!settings.IsAbout(fact.file) || settings.given.contains(fact.name) || fact.firings == 0) continue;
    for (const explain::RuleText& rule : explain::ReadRules(inspector->RuleSource(fact.name)))
      for (const explain::RuleAttribute& condition : rule.conditions)
        if (condition.attribute == "impasse" && impasses.contains(condition.value)) return true;
  }
  return false;
}

/// The cause that an unfired rule is ranked as. `is_torn`: operators were tied, so that none was applied, and no rule
/// of the author is for this impasse.
Cause CauseOf(const RuleWatch::Waiting& waiting, bool is_torn) {
  const explain::RuleWait& why = waiting.why;
  // A rule that waits for another kind of impasse may be the cause only if the agent stays in its impasse. Otherwise
  // the other impasse may still come.
  const bool is_about_kind =
      why.is_of_state && !why.is_excluded && (why.attribute == "impasse" || why.attribute == "attribute");
  if (is_about_kind) return is_torn ? Cause::kFurthest : Cause::kWaiting;
  // The element exists, but does not match the other conditions. This does not show which condition is the cause.
  const bool is_vague = why.found.kind == explain::RuleWait::Kind::kElsewhere;
  if (is_torn || waiting.WaitsForOperator() || is_vague) return Cause::kWaiting;
  return waiting.waits_for_others ? Cause::kAwaits : Cause::kFurthest;
}

/// Explains the rules that came with the lesson and never fired.
std::vector<std::string> GivenThatNeverFired(sim::Simulation& simulation, const AccountSettings& settings) {
  std::vector<std::string> told;
  for (std::size_t i = 0; i < simulation.soar_agents(); ++i) {
    const std::string agent = simulation.AgentOfMind(i);
    const auto inspector = simulation.Inspect(agent);
    if (inspector == nullptr || !settings.IsAboutAgent(agent)) continue;
    for (const explain::RuleFact& rule : inspector->Rules()) {
      if (!settings.IsAbout(rule.file) || rule.firings > 0 || !settings.given.contains(rule.name)) continue;
      if (told.size() >= kMostRules) return told;
      if (const std::optional<explain::RuleWait> why = WhyRuleWaits(simulation, agent, rule.name))
        told.push_back(
            wording::Say(wording::Situation::kNeverFired, {{"rule", rule.name}, {"waits", why->Requires()}}));
    }
  }
  return told;
}

}  // namespace

bool AccountSettings::IsAbout(const std::string& rule_file) const {
  return file.empty() ? !rule_file.empty() : FileName(rule_file) == file;
}

Account::Account(sim::Simulation& simulation, AccountSettings settings)
    : simulation_(simulation), settings_(std::move(settings)), watch_(simulation, settings_) {}

void Account::See(const sim::EventList& events) {
  if (!settings_.IsAsked()) return;
  watch_.See();
  events_.See(events);
}

/// The agents that run rules of the file.
std::set<std::string> Account::AgentsOfFile() {
  std::set<std::string> agents;
  for (std::size_t i = 0; i < simulation_.soar_agents(); ++i) {
    const std::string agent = simulation_.AgentOfMind(i);
    const auto inspector = simulation_.Inspect(agent);
    if (inspector != nullptr && settings_.IsAboutAgent(agent) &&
        std::ranges::any_of(inspector->Rules(),
                            [&](const explain::RuleFact& rule) { return settings_.IsAbout(rule.file); }))
      agents.insert(agent);
  }
  return agents;
}

std::vector<sim::Finding> Account::Slips(const std::vector<RuleWatch::Waiting>& waiting) const {
  std::vector<sim::Finding> slips;
  for (const sim::EventFindings::Reported& reported : events_.reported()) {
    const Diagnostic& problem = reported.diagnostic;
    if (slips.size() >= kMostSlips) break;
    if (!settings_.IsAbout(problem.file) || settings_.given.contains(problem.rule)) continue;
    // Leaves out a warning that a rule writes repeatedly if the rule never fired.
    const bool is_refuted = std::ranges::any_of(waiting, [&](const RuleWatch::Waiting& each) {
      return problem.topic == Topic::kRepeatedWrite && problem.rule == each.why.rule;
    });
    if (!is_refuted) slips.push_back(reported.finding);
  }
  return slips;
}

std::vector<sim::Finding> Account::Finish(double failed_s) {
  const std::set<std::string> agents = AgentsOfFile();
  const std::vector<RuleWatch::Waiting> waiting = watch_.Finish();
  std::vector<sim::Finding> found = Slips(waiting);
  const sim::Finding* refused = nullptr;
  for (const auto& [agent, finding] : events_.refused())
    if (agents.contains(agent) && finding.time_s <= failed_s && (refused == nullptr || finding.tick < refused->tick))
      refused = &finding;
  if (refused != nullptr) found.push_back(*refused);
  const sim::EventFindings::Idle* idle = nullptr;
  for (const auto& [agent, each] : events_.idle())
    if (agents.contains(agent) && each.time_s - sim::EventFindings::kToldAfter_s <= failed_s &&
        (idle == nullptr || each.tick < idle->tick))
      idle = &each;
  // Tied operators are not applied, so unfired rules are a consequence of the tie.
  const bool is_stuck = idle != nullptr && std::ranges::find(idle->reasons, explain::Reason::Kind::kTorn,
                                                             &explain::Reason::kind) != idle->reasons.end();
  const bool is_torn = is_stuck && std::ranges::none_of(agents, [&](const std::string& agent) {
                         return HasAnswer(simulation_, settings_, agent);
                       });
  for (std::size_t i = 0; i < waiting.size() && i < kMostRules; ++i)
    found.push_back({.cause = CauseOf(waiting[i], is_torn),
                     .text = NeverFired(waiting[i]),
                     .rule = waiting[i].why.rule,
                     .topic = Topic::kUnfired});
  if (idle != nullptr) {
    for (std::size_t i = 0; i < idle->reasons.size() && i < kMostIdleReasons; ++i) {
      const explain::Reason& reason = idle->reasons[i];
      // Other reasons are about unfired rules. The watch explains these better, from the tick in which they were
      // nearest to a match.
      const bool is_stall = reason.kind == explain::Reason::Kind::kStalled;
      found.push_back({is_stall ? Cause::kStalled : Cause::kSymptom, reason.text});
    }
    found.push_back({Cause::kSymptom, idle->symptom});
  }
  // An unfired rule of the lesson is often caused by the learner's rules.
  if (found.empty())
    for (std::string& line : GivenThatNeverFired(simulation_, settings_))
      found.push_back({Cause::kSymptom, std::move(line)});
  sim::RankByCause(found);
  return found;
}

}  // namespace soarbox::mission
