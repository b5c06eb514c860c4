// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/base/symbol_table.h"
#include "kernel/match/rete.h"
#include "kernel/rules/draft.h"

namespace soarbox::kernel {

/// The nth of a few instantiations that matches can refer to. The matcher never reads their contents.
InstantiationId SomeInstantiation(std::size_t n);

/// Working memory for tests: a table of elements, goals, and a Rete over them. Words: "S1" is an identifier, "<x>" a
/// variable, digits a number, anything else a string.
class MatchFixture {
 public:
  MatchFixture() : rete(symbols, wmes) {}

  Symbol Word(std::string_view text);
  /// Makes an identifier a goal of this level; with 0 it is no longer a goal.
  void SetGoal(std::string_view id, GoalLevel level);
  void SetLti(std::string_view id, std::uint64_t lti);
  GoalView Goals() const { return {levels_, ltis_}; }

  WmeId Add(std::string_view id, std::string_view attribute, std::string_view value, bool acceptable = false);
  WmeId Add(Symbol id, Symbol attribute, Symbol value, bool acceptable = false);
  void Remove(WmeId wme);
  ProductionId AddRule(ProductionPtr production);

  /// The elements of all matches of a rule that are not retractions, as time tags.
  std::multiset<std::vector<std::uint64_t>> MatchesOf(ProductionId production) const;
  /// Fires everything and drops all retractions; returns the names of the rules fired, in order.
  std::vector<std::string> FireAll();

  SymbolTable symbols;
  WmeTable wmes;
  Rete rete;
  std::vector<WmeId> live;  ///< In the order in which they were added.

 private:
  std::vector<GoalLevel> levels_;
  std::vector<std::uint64_t> ltis_;
  std::map<std::string, Symbol, std::less<>> identifiers_;
  std::vector<WmeId> free_;
  std::uint64_t next_timetag_ = 1;
};

// Building rules by hand.
TestDraft Equal(Symbol symbol);
TestDraft Relation(TestKind kind, Symbol symbol);
TestDraft Both(const TestDraft& a, const TestDraft& b);
TestDraft OneOf(const std::vector<Symbol>& constants);
ConditionDraft Positive(const TestDraft& id, const TestDraft& attribute, const TestDraft& value,
                        bool acceptable = false);
ConditionDraft Negative(const TestDraft& id, const TestDraft& attribute, const TestDraft& value,
                        bool acceptable = false);
ConditionDraft Conjunction(const std::vector<ConditionDraft>& conditions);
ProductionPtr Rule(std::string_view name, const std::vector<ConditionDraft>& conditions,
                   const std::vector<ActionDraft>& actions = {});

}  // namespace soarbox::kernel
