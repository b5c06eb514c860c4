// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/match/match_test_support.h"

#include <algorithm>
#include <cctype>

namespace soarbox::kernel {

namespace {

/// The drafts of tests are never freed.
Arena& Drafts() {
  static Arena arena;
  return arena;
}

}  // namespace

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

ProductionId MatchFixture::AddRule(ProductionPtr production) {
  return rete.AddProduction(std::move(production), Goals()).production;
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
        fired.emplace_back(rete.production(taken.production)->name);
        set.MarkFired(taken.match, SomeInstantiation(0));
      }
    }
    while (set.HasRetractions(level)) {
      set.Release(set.TakeRetraction(level));
    }
  }
  return fired;
}

TestDraft Equal(Symbol symbol) {
  return Relation(TestKind::kEqual, symbol);
}

TestDraft Relation(TestKind kind, Symbol symbol) {
  return MakeTest(kind, symbol);
}

TestDraft Both(const TestDraft& a, const TestDraft& b) {
  TestDraft test = MakeTest(TestKind::kConjunction);
  test.parts.Add(Drafts().New(a));
  test.parts.Add(Drafts().New(b));
  return test;
}

TestDraft OneOf(const std::vector<Symbol>& constants) {
  TestDraft test = MakeTest(TestKind::kDisjunction);
  Symbol* const stored = Drafts().NewArray<Symbol>(constants.size());
  std::ranges::copy(constants, stored);
  test.disjuncts = stored;
  test.disjunct_count = static_cast<std::uint32_t>(constants.size());
  return test;
}

ConditionDraft Positive(const TestDraft& id, const TestDraft& attribute, const TestDraft& value, bool acceptable) {
  ConditionDraft condition;
  condition.id = id;
  condition.attribute = attribute;
  condition.value = value;
  condition.tests_acceptable = acceptable;
  return condition;
}

InstantiationId SomeInstantiation(std::size_t n) {
  // Only the address is used.
  static std::byte places[128];
  return {reinterpret_cast<Instantiation*>(&places[n])};
}

ConditionDraft Negative(const TestDraft& id, const TestDraft& attribute, const TestDraft& value, bool acceptable) {
  ConditionDraft condition = Positive(id, attribute, value, acceptable);
  condition.kind = ConditionKind::kNegative;
  return condition;
}

ConditionDraft Conjunction(const std::vector<ConditionDraft>& conditions) {
  ConditionDraft condition;
  condition.kind = ConditionKind::kConjunctiveNegation;
  for (const ConditionDraft& inner : conditions) {
    condition.conditions.Add(Drafts().New(inner));
  }
  return condition;
}

ProductionPtr Rule(std::string_view name, const std::vector<ConditionDraft>& conditions,
                   const std::vector<ActionDraft>& actions) {
  Arena arena;
  RuleDraft rule;
  rule.name = name;
  for (const ConditionDraft& condition : conditions) {
    rule.conditions.Add(arena.New(condition));
  }
  for (const ActionDraft& action : actions) {
    rule.actions.Add(arena.New(action));
  }
  return Production::Make(rule);
}

}  // namespace soarbox::kernel
