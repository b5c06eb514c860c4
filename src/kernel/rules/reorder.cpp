// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/rules/reorder.h"

#include <limits>
#include <utility>

#include "kernel/rules/print_production.h"
#include "kernel/rules/rule_reader.h"

namespace soarbox::kernel {

namespace {

constexpr std::int64_t kInfinite = 10000005;
constexpr std::int64_t kUnboundCost = 8;

/// A test that was taken off its field, to be put back where both sides are bound.
struct SavedTest {
  Symbol field;  ///< What the field that the test stood on is equated with.
  Test test;
  bool placed = false;
};

bool IsStrippable(TestKind kind) {
  switch (kind) {
    case TestKind::kNotEqual: case TestKind::kLess: case TestKind::kGreater: case TestKind::kLessOrEqual:
    case TestKind::kGreaterOrEqual: case TestKind::kSameType: case TestKind::kDisjunction: case TestKind::kSameLti:
    case TestKind::kNotSameLti:
      return true;
    default:
      return false;
  }
}

TestKind TurnedRound(TestKind kind) {
  switch (kind) {
    case TestKind::kLess: return TestKind::kGreater;
    case TestKind::kGreater: return TestKind::kLess;
    case TestKind::kLessOrEqual: return TestKind::kGreaterOrEqual;
    case TestKind::kGreaterOrEqual: return TestKind::kLessOrEqual;
    default: return kind;
  }
}

/// The parts of a test as a list, whatever its form.
std::vector<Test> Parts(Test test) {
  if (test.kind == TestKind::kConjunction) {
    return std::move(test.parts);
  }
  std::vector<Test> parts;
  if (test.kind != TestKind::kBlank) {
    parts.push_back(std::move(test));
  }
  return parts;
}

Test Joined(std::vector<Test> parts) {
  if (parts.size() == 1) {
    return std::move(parts.front());
  }
  Test test;
  if (!parts.empty()) {
    test.kind = TestKind::kConjunction;
    test.parts = std::move(parts);
  }
  return test;
}

void RemoveGoalTests(Test& test) {
  std::vector<Test> parts = Parts(std::move(test));
  std::erase_if(parts, [](const Test& part) { return part.kind == TestKind::kState || part.kind == TestKind::kImpasse; });
  test = Joined(std::move(parts));
}

void CollectVariables(const Test& test, VariableSet& out) {
  out.Add(test.referent);
  for (const Test& part : test.parts) {
    CollectVariables(part, out);
  }
}

void CollectVariables(const Condition& condition, VariableSet& out) {
  CollectVariables(condition.id, out);
  CollectVariables(condition.attribute, out);
  CollectVariables(condition.value, out);
  for (const Condition& inner : condition.conditions) {
    CollectVariables(inner, out);
  }
}

/// Orders one list of conditions: those of a rule, or those inside a conjunctive negation.
class ListReorderer {
 public:
  ListReorderer(std::string_view rule_name, const SymbolTable& symbols, VariableSet& bound, VariableSet known_goals,
                ReorderOutcome& out)
      : rule_name_(rule_name), symbols_(symbols), bound_(bound), known_goals_(std::move(known_goals)), out_(out) {}

  /// `needs_goal`: the list must hang on something; for the top level of a rule.
  void Reorder(std::vector<Condition>& conditions, bool needs_goal) {
    Strip(conditions);
    if (!FindRoots(conditions) && needs_goal) {
      Warn("Error: production " + std::string(rule_name_) +
           " has no positive conditions that reference a goal state.\n"
           "Did you forget to add \"^type state\" or \"^superstate nil\"?\n");
      out_.ok = false;
      return;
    }
    NoteNeeds(conditions);
    std::vector<Condition> ordered;
    ordered.reserve(conditions.size());
    std::vector<std::size_t> remaining(conditions.size());
    for (std::size_t i = 0; i < remaining.size(); ++i) {
      remaining[i] = i;
    }
    while (!remaining.empty()) {
      const std::size_t at = Choose(conditions, remaining);
      Condition chosen = std::move(conditions[remaining[at]]);
      remaining.erase(remaining.begin() + static_cast<std::ptrdiff_t>(at));
      Place(chosen);
      ordered.push_back(std::move(chosen));
    }
    conditions = std::move(ordered);
    TidyGoalTests(conditions);
  }

 private:
  struct GoalTest {
    Symbol variable;
    TestKind kind;
    bool placed = false;
  };

  void Warn(std::string text) { out_.messages.push_back({std::move(text), false, true}); }

  /// Takes the tests that may have to move off the positive conditions, in text order.
  void Strip(std::vector<Condition>& conditions) {
    for (Condition& condition : conditions) {
      if (condition.kind != ConditionKind::kPositive) {
        continue;
      }
      StripField(condition.id);
      StripField(condition.attribute);
      StripField(condition.value);
      positive_values_.Add(EqualitySymbol(condition.value));
      positive_variables_.Add(EqualitySymbol(condition.id));
      positive_variables_.Add(EqualitySymbol(condition.attribute));
      positive_variables_.Add(EqualitySymbol(condition.value));
    }
  }

  void StripField(Test& test) {
    const Symbol field = EqualitySymbol(test);
    std::vector<Test> kept, equality;
    for (Test& part : Parts(std::move(test))) {
      if (part.kind == TestKind::kEqual) {
        equality.push_back(std::move(part));
      } else if (part.kind == TestKind::kState || part.kind == TestKind::kImpasse) {
        SaveGoalTest(field, part.kind);
      } else if (IsStrippable(part.kind)) {
        SaveTest({field, std::move(part)});
      } else {
        kept.push_back(std::move(part));
      }
    }
    kept.insert(kept.end(), equality.begin(), equality.end());
    test = Joined(std::move(kept));
  }

  void SaveGoalTest(Symbol variable, TestKind kind) {
    for (const GoalTest& known : goal_tests_) {
      if (known.variable == variable && known.kind == kind) {
        return;
      }
    }
    goal_tests_.push_back({variable, kind, known_goals_.Has(variable)});
  }

  /// A test that is written on several conditions with the same identifier is kept once.
  void SaveTest(SavedTest saved) {
    for (const SavedTest& known : saved_) {
      if (known.field == saved.field && known.test == saved.test) {
        return;
      }
    }
    saved_.push_back(std::move(saved));
  }

  bool IsGoalVariable(Symbol variable) const {
    for (const GoalTest& test : goal_tests_) {
      if (test.variable == variable) {
        return true;
      }
    }
    return false;
  }

  /// Roots are the identifiers that no condition has as its value; without any, the goals.
  bool FindRoots(const std::vector<Condition>& conditions) {
    for (const Condition& condition : conditions) {
      const Symbol id = EqualitySymbol(condition.id);
      if (condition.kind != ConditionKind::kPositive || bound_.Has(id) || positive_values_.Has(id) || roots_.Has(id)) {
        continue;
      }
      roots_.Add(id);
      if (!IsGoalVariable(id)) {
        out_.unconnected.push_back(id);
        // Soar repeats the earlier complaints with each new one.
        for (const Symbol root : roots_.members()) {
          if (!IsGoalVariable(root)) {
            Warn("\nWarning: On the LHS of production " + std::string(rule_name_) + ", identifier " +
                 std::string(symbols_.Text(root)) + " is not connected to any goal or impasse.\n");
          }
        }
      }
    }
    if (roots_.members().empty()) {
      for (const GoalTest& test : goal_tests_) {
        roots_.Add(test.variable);
      }
    }
    return !roots_.members().empty();
  }

  /// What a negated condition needs bound before it: its variables that positive conditions of this list bind.
  void NoteNeeds(const std::vector<Condition>& conditions) {
    needs_.resize(conditions.size());
    for (std::size_t i = 0; i < conditions.size(); ++i) {
      if (conditions[i].kind == ConditionKind::kPositive) {
        continue;
      }
      VariableSet all;
      CollectVariables(conditions[i], all);
      for (const Symbol variable : all.members()) {
        if (positive_variables_.Has(variable)) {
          needs_[i].push_back(variable);
        }
      }
    }
  }

  bool Known(Symbol symbol) const { return !symbol.IsVariable() || bound_.Has(symbol); }

  std::int64_t Cost(const Condition& condition, std::size_t index) const {
    if (condition.kind != ConditionKind::kPositive) {
      for (const Symbol variable : needs_[index]) {
        if (!bound_.Has(variable)) {
          return kInfinite;
        }
      }
      return 1;
    }
    const Symbol id = EqualitySymbol(condition.id);
    if (!Known(id) && !roots_.Has(id)) {
      return kInfinite;
    }
    std::int64_t cost = 1;
    if (!Known(EqualitySymbol(condition.attribute))) {
      cost *= kUnboundCost;
    }
    if (!Known(EqualitySymbol(condition.value))) {
      cost *= kUnboundCost;
    }
    return cost;
  }

  /// The cheapest cost among the others once `taken` has been chosen.
  std::int64_t LookAhead(const std::vector<Condition>& conditions, const std::vector<std::size_t>& remaining,
                         std::size_t taken) {
    std::vector<Symbol> added;
    const Condition& condition = conditions[taken];
    for (const Test* test : {&condition.id, &condition.attribute, &condition.value}) {
      const Symbol symbol = EqualitySymbol(*test);
      if (symbol.IsVariable() && !bound_.Has(symbol)) {
        bound_.Add(symbol);
        added.push_back(symbol);
      }
    }
    std::int64_t cheapest = std::numeric_limits<std::int64_t>::max();
    for (const std::size_t other : remaining) {
      if (other != taken) {
        cheapest = std::min(cheapest, Cost(conditions[other], other));
      }
    }
    for (const Symbol symbol : added) {
      bound_.Remove(symbol);
    }
    return cheapest;
  }

  std::uint32_t StampOf(const Test& test) const {
    const Symbol symbol = EqualitySymbol(test);
    return symbol.IsConstant() ? symbols_.Stamp(symbol) : 0;
  }

  /// True if `candidate` goes before `incumbent`, everything else being equal.
  bool NewerConstants(const Condition& incumbent, const Condition& candidate) const {
    const std::uint32_t a = StampOf(incumbent.attribute), b = StampOf(candidate.attribute);
    return a < b || (a == b && StampOf(incumbent.value) < StampOf(candidate.value));
  }

  /// The position in `remaining` of the condition to take next.
  std::size_t Choose(const std::vector<Condition>& conditions, const std::vector<std::size_t>& remaining) {
    std::int64_t cheapest = std::numeric_limits<std::int64_t>::max();
    std::vector<std::size_t> tied;  // Positions in `remaining`, last in the text first.
    for (std::size_t at = remaining.size(); at-- > 0;) {
      const std::int64_t cost = Cost(conditions[remaining[at]], remaining[at]);
      if (cost < cheapest) {
        cheapest = cost;
        tied.clear();
      }
      if (cost == cheapest) {
        tied.push_back(at);
      }
    }
    if (cheapest >= kInfinite) {
      if (!warned_) {
        Warn("Warning:  in production " + std::string(rule_name_) +
             ",\n     The LHS conditions are not all connected.\n");
        warned_ = true;
      }
      return tied.front();
    }
    std::size_t incumbent = tied.front();
    std::int64_t best = 0;
    const bool look_ahead = cheapest > 1 && tied.size() > 1;
    if (look_ahead) {
      best = LookAhead(conditions, remaining, remaining[incumbent]);
    }
    for (std::size_t i = 1; i < tied.size(); ++i) {
      const Condition& held = conditions[remaining[incumbent]];
      const Condition& candidate = conditions[remaining[tied[i]]];
      const bool held_positive = held.kind == ConditionKind::kPositive;
      const bool positive = candidate.kind == ConditionKind::kPositive;
      bool replace = false;
      if (look_ahead) {
        const std::int64_t ahead = LookAhead(conditions, remaining, remaining[tied[i]]);
        replace = ahead < best || (ahead == best && held_positive && positive && NewerConstants(held, candidate));
        best = replace ? ahead : best;
      } else {
        replace = held_positive && (!positive || NewerConstants(held, candidate));
      }
      if (replace) {
        incumbent = tied[i];
      }
    }
    return incumbent;
  }

  /// Binds the condition's variables and puts back the tests that can be decided here.
  void Place(Condition& condition) {
    switch (condition.kind) {
      case ConditionKind::kPositive:
        PlaceField(condition.id);
        PlaceField(condition.attribute);
        PlaceField(condition.value);
        return;
      case ConditionKind::kNegative:
        CheckNegated(condition);
        return;
      case ConditionKind::kConjunctiveNegation: {
        VariableSet inner_bound = bound_;
        VariableSet inner_goals = known_goals_;
        for (const GoalTest& goal : goal_tests_) {
          if (bound_.Has(goal.variable)) {
            inner_goals.Add(goal.variable);
          }
        }
        ListReorderer inner(rule_name_, symbols_, inner_bound, std::move(inner_goals), out_);
        inner.Reorder(condition.conditions, false);
        return;
      }
    }
  }

  void PlaceField(Test& test) {
    const Symbol symbol = EqualitySymbol(test);
    bound_.Add(symbol);
    std::vector<Test> placed;
    for (SavedTest& saved : saved_) {
      if (saved.placed) {
        continue;
      }
      const Symbol referent = saved.test.referent;
      if (saved.field == symbol && Known(referent)) {
        placed.push_back(std::move(saved.test));
        saved.placed = true;
      } else if (referent == symbol && referent.IsVariable() && Known(saved.field)) {
        Test turned = std::move(saved.test);
        turned.kind = TurnedRound(turned.kind);
        turned.referent = saved.field;
        placed.push_back(std::move(turned));
        saved.placed = true;
      }
    }
    if (placed.empty()) {
      return;
    }
    for (Test& part : Parts(std::move(test))) {
      placed.push_back(std::move(part));
    }
    test = Joined(std::move(placed));
  }

  void CheckNegated(const Condition& condition) {
    VariableSet local;
    for (const Test* test : {&condition.id, &condition.attribute, &condition.value}) {
      local.Add(EqualitySymbol(*test));
      CheckReferents(*test, local);
    }
  }

  void CheckReferents(const Test& test, const VariableSet& local) {
    for (const Test& part : test.parts) {
      CheckReferents(part, local);
    }
    if (!IsStrippable(test.kind) || Known(test.referent) || local.Has(test.referent)) {
      return;
    }
    std::string text;
    AppendTest(text, symbols_, test);
    out_.messages.push_back({"Error: production " + std::string(rule_name_) +
                                 " has an unbound referent in negated relational test " + text + ".\n",
                             false, false});
    Warn("\nAttempted to add an invalid rule:\n      Unbound relational test in negative condition of rule \n");
    out_.ok = false;
  }

  /// Each goal test once: on the first positive condition with its variable as identifier. A negated condition keeps
  /// one only for a variable that no positive condition has tested.
  void TidyGoalTests(std::vector<Condition>& conditions) {
    for (Condition& condition : conditions) {
      const Symbol id = EqualitySymbol(condition.id);
      if (condition.kind == ConditionKind::kPositive) {
        std::vector<Test> parts;
        for (GoalTest& goal : goal_tests_) {
          if (!goal.placed && goal.variable == id) {
            Test test;
            test.kind = goal.kind;
            parts.push_back(test);
            goal.placed = true;
          }
        }
        if (!parts.empty()) {
          for (Test& part : Parts(std::move(condition.id))) {
            parts.push_back(std::move(part));
          }
          condition.id = Joined(std::move(parts));
        }
      } else if (condition.kind == ConditionKind::kNegative) {
        bool known = known_goals_.Has(id);
        for (const GoalTest& goal : goal_tests_) {
          known = known || (goal.placed && goal.variable == id);
        }
        if (known) {
          RemoveGoalTests(condition.id);
        }
      }
    }
  }

  std::string_view rule_name_;
  const SymbolTable& symbols_;
  VariableSet& bound_;
  VariableSet known_goals_;  ///< Variables that conditions around this list test to be goals.
  ReorderOutcome& out_;
  VariableSet roots_, positive_values_, positive_variables_;
  std::vector<SavedTest> saved_;
  std::vector<GoalTest> goal_tests_;
  std::vector<std::vector<Symbol>> needs_;
  bool warned_ = false;
};

}  // namespace

ReorderOutcome ReorderConditions(std::string_view rule_name, std::vector<Condition>& conditions,
                                 const SymbolTable& symbols) {
  ReorderOutcome out;
  VariableSet bound;
  ListReorderer reorderer(rule_name, symbols, bound, {}, out);
  reorderer.Reorder(conditions, true);
  return out;
}

}  // namespace soarbox::kernel
