// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/match/match_fixture.h"

#include <algorithm>
#include <cctype>

namespace soarbox::kernel {

Symbol MatchFixture::Word(std::string_view text) {
  if (text.front() == '<') {
    return symbols.Variable(text);
  }
  if (std::isdigit(static_cast<unsigned char>(text.front()))) {
    return text.find('.') == text.npos ? symbols.Integer(std::stoll(std::string(text)))
                                       : symbols.Float(std::stod(std::string(text)));
  }
  const bool identifier = text.size() > 1 && std::isupper(static_cast<unsigned char>(text.front())) &&
                          std::all_of(text.begin() + 1, text.end(), [](unsigned char c) { return std::isdigit(c); });
  if (!identifier) {
    return symbols.String(text);
  }
  const auto it = identifiers_.find(text);
  if (it != identifiers_.end()) {
    return it->second;
  }
  const Symbol made = symbols.NewIdentifier(text.front(), std::stoull(std::string(text.substr(1))));
  identifiers_.emplace(text, made);
  levels_.resize(symbols.IdentifierLimit(), 0);
  ltis_.resize(symbols.IdentifierLimit(), 0);
  return made;
}

void MatchFixture::SetGoal(std::string_view id, GoalLevel level) {
  const Symbol symbol = Word(id);
  levels_[symbol.index()] = level;
}

void MatchFixture::SetLti(std::string_view id, std::uint64_t lti) {
  const Symbol symbol = Word(id);
  ltis_[symbol.index()] = lti;
}

WmeId MatchFixture::Add(std::string_view id, std::string_view attribute, std::string_view value, bool acceptable) {
  return Add(Word(id), Word(attribute), Word(value), acceptable);
}

WmeId MatchFixture::Add(Symbol id, Symbol attribute, Symbol value, bool acceptable) {
  WmeId wme;
  if (free_.empty()) {
    wme = static_cast<WmeId>(wmes.size());
    wmes.emplace_back();
  } else {
    wme = free_.back();
    free_.pop_back();
  }
  wmes[Index(wme)] = {id, attribute, value, acceptable, true, next_timetag_++};
  live.push_back(wme);
  rete.AddWme(wme, Goals());
  return wme;
}

void MatchFixture::Remove(WmeId wme) {
  rete.RemoveWme(wme, Goals());
  wmes[Index(wme)].live = false;
  std::erase(live, wme);
  free_.push_back(wme);
}

ProductionId MatchFixture::AddRule(Production production) {
  return rete.AddProduction(std::make_shared<const Production>(std::move(production)), Goals()).production;
}

std::multiset<std::vector<std::uint64_t>> MatchFixture::MatchesOf(ProductionId production) const {
  std::multiset<std::vector<std::uint64_t>> found;
  const std::uint16_t last = static_cast<std::uint16_t>(rete.production(production)->conditions.size() - 1);
  for (const std::vector<WmeId>& match : rete.MatchesAfter(production, std::vector<std::uint16_t>{last})) {
    std::vector<std::uint64_t> tags;
    for (const WmeId wme : match) {
      tags.push_back(wmes[Index(wme)].timetag);
    }
    found.insert(std::move(tags));
  }
  return found;
}

std::vector<std::string> MatchFixture::FireAll() {
  std::vector<std::string> fired;
  MatchSet& set = rete.matches();
  for (GoalLevel level = 0; level < 8; ++level) {
    for (const bool o_support : {false, true}) {
      while (const PendingMatch taken = set.TakeAssertion(level, o_support)) {
        fired.push_back(rete.production(taken.production)->name);
        set.MarkFired(taken.match, static_cast<InstantiationId>(1));
      }
    }
    while (set.HasRetractions(level)) {
      set.Release(set.TakeRetraction(level));
    }
  }
  return fired;
}

Test Equal(Symbol symbol) {
  return Relation(TestKind::kEqual, symbol);
}

Test Relation(TestKind kind, Symbol symbol) {
  Test test;
  test.kind = kind;
  test.referent = symbol;
  return test;
}

Test Both(Test a, Test b) {
  Test test;
  test.kind = TestKind::kConjunction;
  test.parts = {std::move(a), std::move(b)};
  return test;
}

Condition Positive(Test id, Test attribute, Test value, bool acceptable) {
  Condition condition;
  condition.id = std::move(id);
  condition.attribute = std::move(attribute);
  condition.value = std::move(value);
  condition.tests_acceptable = acceptable;
  return condition;
}

Condition Negative(Test id, Test attribute, Test value, bool acceptable) {
  Condition condition = Positive(std::move(id), std::move(attribute), std::move(value), acceptable);
  condition.kind = ConditionKind::kNegative;
  return condition;
}

Condition Conjunction(std::vector<Condition> conditions) {
  Condition condition;
  condition.kind = ConditionKind::kConjunctiveNegation;
  condition.conditions = std::move(conditions);
  return condition;
}

Production Rule(std::string name, std::vector<Condition> conditions) {
  Production production;
  production.name = std::move(name);
  production.conditions = std::move(conditions);
  return production;
}

}  // namespace soarbox::kernel
