// SPDX-License-Identifier: BSD-2-Clause
#include "sml/client/inspection_match.h"

#include <algorithm>
#include <array>

#include "cli/object_printer.h"
#include "cli/printed_rule.h"

namespace soarbox {
namespace {

using kernel::Agent;
using kernel::Condition;
using kernel::ConditionKind;
using kernel::Field;
using kernel::Production;
using kernel::ProductionId;
using kernel::Symbol;
using kernel::Test;
using kernel::TestKind;
using kernel::WmeId;

constexpr std::size_t kMostMatches = 20;
constexpr std::size_t kMostElements = 20;
/// Above this number, partial matches are only counted, because listing them takes memory for each.
constexpr std::size_t kMostListed = 20'000;

/// The constant or variable that a field must equal; none if there is no equality test.
Symbol Equal(const Test& test) {
  if (test.kind == TestKind::kEqual) return test.referent();
  for (const Test& part : test.parts())
    if (part.kind == TestKind::kEqual) return part.referent();
  return {};
}

std::array<std::uint16_t, 1> Path(std::size_t condition) {
  return {static_cast<std::uint16_t>(condition)};
}

void AddOnce(const Agent& agent, WmeId wme, std::vector<mind::ElementFact>& list) {
  const std::uint64_t timetag = agent.memory().wme(wme).timetag;
  const auto same = [&](const mind::ElementFact& element) { return element.timetag == timetag; };
  if (list.size() < kMostElements && std::ranges::none_of(list, same)) list.push_back(InspectElement(agent, wme));
}

std::vector<std::vector<mind::ElementFact>> Describe(const Agent& agent, const kernel::Rete::PartialMatches& matches) {
  std::vector<std::vector<mind::ElementFact>> list;
  for (std::size_t i = 0; i < matches.size() && i < kMostMatches; ++i) {
    std::vector<mind::ElementFact>& one = list.emplace_back();
    for (const WmeId wme : matches[i]) one.push_back(InspectElement(agent, wme));
  }
  return list;
}

/// The value of a variable in a partial match, if an earlier condition binds it.
Symbol Bound(const Agent& agent, const Production& rule, std::size_t before, Symbol variable,
             const std::vector<WmeId>& match) {
  std::size_t place = 0;
  for (std::size_t i = 0; i < before; ++i) {
    const Condition& condition = rule.conditions[i];
    if (condition.kind != ConditionKind::kPositive) continue;
    if (place >= match.size()) return {};
    const kernel::Wme& wme = agent.memory().wme(match[place++]);
    if (Equal(condition.id) == variable) return wme.id;
    if (Equal(condition.attribute) == variable) return wme.attribute;
    if (Equal(condition.value) == variable) return wme.value;
  }
  return {};
}

/// Finds the elements that a condition examines: those of its identifier with its attribute, regardless of their value.
void FindSeen(const Agent& agent, const Production& rule, std::size_t place, const kernel::Rete::PartialMatches& before,
              mind::MatchFacts& match) {
  const Condition& condition = rule.conditions[place];
  if (condition.kind == ConditionKind::kConjunctiveNegation) return;
  const Symbol variable = Equal(condition.id);
  const Symbol attribute = Equal(condition.attribute);
  const bool any_attribute = !attribute || attribute.IsVariable();
  const auto fits = [&](const kernel::Wme& wme) { return any_attribute || wme.attribute == attribute; };
  bool is_bound = false;
  for (std::size_t i = 0; i < before.size() && i < kMostMatches; ++i) {
    const Symbol id = variable.IsVariable() ? Bound(agent, rule, place, variable, before[i]) : variable;
    if (!id.IsIdentifier()) continue;
    is_bound = true;
    for (const WmeId wme : agent.memory().WmesOf(id))
      if (fits(agent.memory().wme(wme))) AddOnce(agent, wme, match.seen);
  }
  if (is_bound || any_attribute) return;
  // For the first condition of a rule, and for unconnected conditions: any element with the attribute.
  const kernel::WmeTable& wmes = agent.memory().wmes();
  for (std::uint32_t i = 0; i < wmes.size() && match.seen.size() < kMostElements; ++i)
    if (wmes[i].live && wmes[i].attribute == attribute) AddOnce(agent, static_cast<WmeId>(i), match.seen);
}

}  // namespace

mind::ElementFact InspectElement(const Agent& agent, WmeId id) {
  const kernel::Wme& wme = agent.memory().wme(id);
  return {wme.timetag,
          cli::SymbolText(agent, wme.id),
          cli::SymbolText(agent, wme.attribute),
          cli::SymbolText(agent, wme.value),
          wme.acceptable,
          wme.value.IsIdentifier()};
}

std::size_t CountMatches(const Agent& agent, ProductionId id) {
  const std::size_t conditions = agent.production(id).conditions.size();
  for (std::size_t i = 0; i < conditions; ++i)
    if (agent.rete().CountAfter(id, Path(i)) == 0) return 0;
  return conditions == 0 ? 0 : agent.rete().CountAfter(id, Path(conditions - 1));
}

mind::MatchFacts InspectMatch(const Agent& agent, ProductionId id) {
  const Production& rule = agent.production(id);
  const kernel::Rete& rete = agent.rete();
  mind::MatchFacts match;
  match.rule = cli::RuleName(agent, rule);
  for (std::size_t i = 0; i < rule.conditions.size(); ++i) {
    mind::ConditionFact& condition = match.conditions.emplace_back();
    condition.text = cli::ConditionText(agent, rule.conditions[i]);
    condition.negated = rule.conditions[i].kind != ConditionKind::kPositive;
    if (match.failing) continue;
    condition.partial_matches = rete.CountAfter(id, Path(i));
    if (condition.partial_matches == 0) match.failing = i;
  }
  if (match.conditions.empty() || agent.out_of_memory()) return match;
  if (!match.failing) {
    match.complete = match.conditions.back().partial_matches;
    if (match.complete <= kMostListed)
      match.matches = Describe(agent, rete.MatchesAfter(id, Path(match.conditions.size() - 1)));
    return match;
  }
  const std::size_t place = *match.failing;
  kernel::Rete::PartialMatches before;
  if (place > 0 && match.conditions[place - 1].partial_matches <= kMostListed)
    before = rete.MatchesBefore(id, Path(place));
  match.before = Describe(agent, before);
  for (const WmeId wme : rete.RightMatches(id, Path(place))) {
    if (match.candidates.size() >= kMostElements) break;
    match.candidates.push_back(InspectElement(agent, wme));
  }
  FindSeen(agent, rule, place, before, match);
  return match;
}

std::vector<mind::TesterFact> InspectTesters(const Agent& agent, WmeId wme) {
  std::vector<mind::TesterFact> testers;
  if (agent.out_of_memory()) return testers;
  for (const ProductionId id : agent.Productions()) {
    const Production& rule = agent.production(id);
    std::size_t positive = 0;  // Index of the condition's element in a match.
    for (std::size_t i = 0; i < rule.conditions.size(); ++i) {
      const ConditionKind kind = rule.conditions[i].kind;
      const std::size_t place = kind == ConditionKind::kPositive ? positive++ : 0;
      if (kind == ConditionKind::kConjunctiveNegation) continue;
      const std::vector<WmeId> passing = agent.rete().RightMatches(id, Path(i));
      if (std::ranges::find(passing, wme) == passing.end()) continue;
      mind::TesterFact& tester = testers.emplace_back();
      tester.rule = cli::RuleName(agent, rule);
      tester.condition = i;
      tester.negated = kind == ConditionKind::kNegative;
      const std::size_t whole = tester.negated ? 0 : CountMatches(agent, id);
      if (whole == 0 || whole > kMostListed) continue;
      for (const auto& match : agent.rete().MatchesAfter(id, Path(rule.conditions.size() - 1)))
        tester.matches = tester.matches || (place < match.size() && match[place] == wme);
    }
  }
  return testers;
}

}  // namespace soarbox
