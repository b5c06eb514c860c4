// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/match/naive_matcher_test_support.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace soarbox::kernel {

namespace {

class Search {
 public:
  Search(const SymbolTable& symbols, const WmeTable& wmes, std::span<const WmeId> live, const GoalView& goals)
      : symbols_(symbols), wmes_(wmes), live_(live), goals_(goals) {}

  /// Visits every way to satisfy the conditions from `at` on; stops if `visit` returns false.
  bool Run(std::span<const Condition> conditions, std::size_t at, const std::function<bool()>& visit) {
    if (at == conditions.size()) {
      return visit();
    }
    const Condition& condition = conditions[at];
    if (condition.kind == ConditionKind::kConjunctiveNegation) {
      const std::size_t bound = bindings_.size();
      const std::size_t tags = tags_.size();
      const bool none = Run(condition.conditions(), 0, [] { return false; });
      bindings_.resize(bound);
      tags_.resize(tags);
      return !none || Run(conditions, at + 1, visit);
    }
    bool blocked = false;
    for (const WmeId wme : live_) {
      const std::size_t bound = bindings_.size();
      if (Fits(condition, wmes_[Index(wme)])) {
        if (condition.kind == ConditionKind::kNegative) {
          blocked = true;
        } else {
          tags_.push_back(wmes_[Index(wme)].timetag);
          const bool go_on = Run(conditions, at + 1, visit);
          tags_.pop_back();
          if (!go_on) {
            return false;
          }
        }
      }
      bindings_.resize(bound);
    }
    return condition.kind == ConditionKind::kPositive || blocked || Run(conditions, at + 1, visit);
  }

  const std::vector<std::uint64_t>& tags() const { return tags_; }

 private:
  bool Fits(const Condition& condition, const Wme& wme) {
    if (wme.acceptable != condition.tests_acceptable) {
      return false;
    }
    return Bind(condition.id, wme.id) && Bind(condition.attribute, wme.attribute) && Bind(condition.value, wme.value) &&
           Holds(condition.id, wme.id) && Holds(condition.attribute, wme.attribute) &&
           Holds(condition.value, wme.value);
  }

  bool Bind(const Test& test, Symbol value) {
    if (test.kind == TestKind::kConjunction) {
      return std::ranges::all_of(test.parts(), [&](const Test& part) { return Bind(part, value); });
    }
    if (test.kind != TestKind::kEqual) {
      return true;
    }
    if (!test.referent().IsVariable()) {
      return test.referent() == value;
    }
    if (const Symbol* known = Find(test.referent())) {
      return *known == value;
    }
    bindings_.emplace_back(test.referent(), value);
    return true;
  }

  const Symbol* Find(Symbol variable) const {
    for (const auto& [name, value] : bindings_) {
      if (name == variable) {
        return &value;
      }
    }
    return nullptr;
  }

  std::uint64_t Lti(Symbol symbol) const { return symbol.IsIdentifier() ? goals_.lti_of[symbol.index()] : 0; }

  bool Holds(const Test& test, Symbol value) const {
    Symbol other = test.referent();
    if (test.kind == TestKind::kLiteral) {
      return true;
    }
    if (other.IsVariable() && test.kind != TestKind::kState) {
      const Symbol* known = Find(other);
      if (!known) {
        return false;
      }
      other = *known;
    }
    switch (test.kind) {
      case TestKind::kBlank:
      case TestKind::kEqual:
        return true;
      case TestKind::kNotEqual:
        return value != other;
      case TestKind::kLess:
        return symbols_.Compare(value, other) < 0;
      case TestKind::kGreater:
        return symbols_.Compare(value, other) > 0;
      case TestKind::kLessOrEqual:
        return symbols_.Compare(value, other) <= 0;
      case TestKind::kGreaterOrEqual:
        return symbols_.Compare(value, other) >= 0;
      case TestKind::kSameType:
        return value.kind() == other.kind();
      case TestKind::kDisjunction:
        return std::ranges::find(test.disjuncts(), value) != test.disjuncts().end();
      case TestKind::kConjunction:
        return std::ranges::all_of(test.parts(), [&](const Test& part) { return Holds(part, value); });
      case TestKind::kState:
        return value.IsIdentifier() && goals_.level_of_goal[value.index()] != 0;
      case TestKind::kImpasse:
        return false;
      case TestKind::kSameLti:
      case TestKind::kNotSameLti: {
        const std::uint64_t wanted =
            other.IsInteger() ? static_cast<std::uint64_t>(symbols_.IntegerValue(other)) : Lti(other);
        const bool same = Lti(value) != 0 && Lti(value) == wanted;
        return same == (test.kind == TestKind::kSameLti);
      }
      case TestKind::kIsLti:
        return Lti(value) != 0;
      case TestKind::kIsNotLti:
        return Lti(value) == 0;
      case TestKind::kLiteral:
        return true;
    }
    return false;
  }

  const SymbolTable& symbols_;
  const WmeTable& wmes_;
  std::span<const WmeId> live_;
  const GoalView& goals_;
  std::vector<std::pair<Symbol, Symbol>> bindings_;  ///< Variables and their values, as a stack.
  std::vector<std::uint64_t> tags_;
};

}  // namespace

std::multiset<std::vector<std::uint64_t>> MatchNaively(const Production& rule, const SymbolTable& symbols,
                                                       const WmeTable& wmes, std::span<const WmeId> live,
                                                       const GoalView& goals) {
  std::multiset<std::vector<std::uint64_t>> found;
  Search search(symbols, wmes, live, goals);
  search.Run(rule.conditions, 0, [&] {
    found.insert(search.tags());
    return true;
  });
  return found;
}

}  // namespace soarbox::kernel
