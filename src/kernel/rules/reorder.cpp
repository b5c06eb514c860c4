// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/rules/reorder.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "kernel/rules/condition_queue.h"
#include "kernel/rules/print_production.h"
#include "kernel/rules/waiting_tests.h"

namespace soarbox::kernel {

namespace {

constexpr std::int64_t kInfinite = kInfiniteCost;
/// Maximum number of earlier complaints that a complaint about unconnected identifiers repeats.
constexpr std::size_t kMostRepeated = 50;

struct GoalTest {
  std::uint32_t variable = kNoVariable;
  TestKind kind = TestKind::kState;
  bool of_id = false;     ///< Written before the identifier of a condition.
  bool of_value = false;  ///< Written before the identifier of an object that is a value: ^superstate (state <ss> ...).
  bool placed = false;
  GoalTest* next = nullptr;
};

bool IsStrippable(TestKind kind) {
  switch (kind) {
    case TestKind::kNotEqual:
    case TestKind::kLess:
    case TestKind::kGreater:
    case TestKind::kLessOrEqual:
    case TestKind::kGreaterOrEqual:
    case TestKind::kSameType:
    case TestKind::kDisjunction:
    case TestKind::kSameLti:
    case TestKind::kNotSameLti:
      return true;
    default:
      return false;
  }
}

bool IsGoalTest(const TestDraft& test) {
  return test.kind == TestKind::kState || test.kind == TestKind::kImpasse;
}

/// Moves the equality test after all other tests.
void PutEqualityLast(TestDraft& test) {
  DraftList<TestDraft> kept, equality;
  for (TestDraft* part = test.parts.first; part != nullptr;) {
    TestDraft* const next = part->next;
    (part->kind == TestKind::kEqual ? equality : kept).Add(part);
    part = next;
  }
  kept.Append(equality);
  test.parts = kept;
}

/// Orders one list of conditions: those of a rule, or those of a conjunctive negation. `Set` is a set of variables.
template <typename Set>
class ListReorderer {
 public:
  /// `bound` must contain kNoVariable, because constants count as bound.
  ListReorderer(const RuleDraft& rule, const SymbolTable& symbols, const VariableIndex& variables,
                const ExpectedValues& expected, Arena& arena, const Set& bound, ReorderOutcome& out)
      : rule_(rule),
        symbols_(symbols),
        variables_(variables),
        expected_(expected),
        arena_(arena),
        bound_(bound),
        out_(out),
        roots_(variables, arena),
        positive_values_(variables, arena),
        positive_variables_(variables, arena),
        fresh_(variables, arena),
        ahead_(variables, arena),
        waiting_tests_(arena) {}

  /// `is_top`: these are the conditions of a rule, which must be connected with a state.
  void Reorder(DraftList<ConditionDraft>& conditions, bool is_top) {
    Strip(conditions);
    const bool has_roots = FindRoots();
    if (is_top) {
      DropGoalTests();
    }
    if (!has_roots && is_top) {
      Warn("Error: production " + std::string(rule_.name) +
           " has no positive conditions that reference a goal state.\n"
           "Did you forget to add \"^type state\" or \"^superstate nil\"?\n");
      out_.ok = false;
      return;
    }
    conditions = {};
    if (rule_.keeps_order) {
      PlaceInOrder(conditions);
    } else if (is_long_) {
      PlaceByQueue(conditions);
    } else {
      PlaceByScan(conditions);
    }
    if (!goal_tests_.empty()) {
      PlaceGoalTests(conditions);
    }
  }

 private:
  /// A condition that is not placed yet.
  struct Waiting {
    ConditionDraft* condition = nullptr;
    bool positive = false;
    bool placed = false;
    std::uint32_t fields[3] = {};  ///< The variables in the fields' equality tests.
    std::int64_t expected = 1;     ///< For positive conditions: expected number of values of the attribute.
    std::int64_t cost = 0;         ///< Valid while no more of `needs` are bound.
    std::uint64_t age = 0;  ///< For positive conditions: the ages of their constants, that of the attribute first.
    Set* needs = nullptr;   ///< Its variables; for negated conditions only those bound by positive ones of this list.
                            ///< Null in long lists.
  };

  void Warn(std::string text) { out_.messages.push_back({std::move(text), false, true}); }

  template <typename Variables>
  static void AddVariable(Variables& set, std::uint32_t variable) {
    if (variable != kNoVariable) {
      set.Add(variable);
    }
  }

  void PlaceInOrder(DraftList<ConditionDraft>& conditions) {
    for (std::size_t n = 0; n < count_; ++n) {
      ConditionDraft* const next = waiting_[n]->condition;
      Place(*next);
      conditions.Add(next);
    }
  }

  void PlaceByScan(DraftList<ConditionDraft>& conditions) {
    NoteNeeds();
    while (count_ != 0) {
      std::size_t at = Choose();
      ConditionDraft* const chosen = waiting_[at]->condition;
      waiting_[at]->placed = true;
      for (--count_; at < count_; ++at) {
        waiting_[at] = waiting_[at + 1];
      }
      Place(*chosen);
      if (roots_wait_ && roots_unbound_ == 0) {
        roots_wait_ = false;
        roots_came_ = true;
      }
      conditions.Add(chosen);
    }
  }

  /// Like PlaceByScan, for a long list.
  void PlaceByQueue(DraftList<ConditionDraft>& conditions) {
    const std::vector<std::uint32_t> needs = AllNeeds();
    std::vector<QueuedCondition> queued(count_);
    std::size_t begin = 0;
    for (std::size_t n = 0; n < count_; ++n) {
      const Waiting& waiting = *waiting_[n];
      QueuedCondition& condition = queued[n];
      condition.positive = waiting.positive;
      if (waiting.positive) {
        std::copy_n(waiting.fields, 3, condition.fields.begin());
      }
      condition.expected = waiting.expected;
      condition.age = waiting.age;
      condition.needs = std::span(needs).subspan(begin, needs_end_[n] - begin);
      begin = needs_end_[n];
    }
    queue_.emplace(queued, variables_.size());
    for (std::uint32_t variable = 0; variable < variables_.size(); ++variable) {
      if (bound_.Has(variable)) queue_->SetBound(variable);
      if (roots_.Has(variable)) queue_->SetRoot(variable);
    }
    queue_->Start(roots_wait_);
    for (std::size_t left = count_; left != 0; --left) {
      const ConditionQueue::Choice choice = queue_->Choose();
      if (choice.cost >= kInfinite && left > 1) {
        WarnOfUnconnected();
      }
      ConditionDraft* const chosen = waiting_[choice.at]->condition;
      Place(*chosen);
      if (roots_wait_ && roots_unbound_ == 0) {
        roots_wait_ = false;
        queue_->EndRoots();
      }
      conditions.Add(chosen);
    }
    queue_.reset();
  }

  /// The needs of all waiting conditions, concatenated. Sets needs_end_ to the end of each.
  std::vector<std::uint32_t> AllNeeds() {
    ListedVariables needs(variables_.size());
    needs_end_.clear();
    for (std::size_t n = 0; n < count_; ++n) {
      needs.Begin();
      const Waiting& waiting = *waiting_[n];
      if (waiting.positive) {
        for (const std::uint32_t field : waiting.fields) {
          AddVariable(needs, field);
        }
      } else {
        AddVariables(*waiting.condition, needs);
        needs.KeepOnly(positive_variables_);
      }
      needs_end_.push_back(needs.all.size());
    }
    return std::move(needs.all);
  }

  /// Lists of variables; each list contains a variable once.
  struct ListedVariables {
    explicit ListedVariables(std::uint32_t variables) : last_in(variables) {}
    void Begin() {
      begin = all.size();
      ++list;
    }
    void Add(std::uint32_t variable) {
      if (last_in[variable] != list) {
        last_in[variable] = list;
        all.push_back(variable);
      }
    }
    void KeepOnly(const Set& kept) {
      const auto is_dropped = [&](std::uint32_t variable) { return !kept.Has(variable); };
      all.erase(std::remove_if(all.begin() + static_cast<std::ptrdiff_t>(begin), all.end(), is_dropped), all.end());
    }
    std::vector<std::uint32_t> all;
    std::vector<std::uint32_t> last_in;  ///< By variable: the last list that contains it.
    std::size_t begin = 0;
    std::uint32_t list = 0;
  };

  /// Removes the tests that may have to move from the positive conditions, in text order.
  void Strip(const DraftList<ConditionDraft>& conditions) {
    count_ = conditions.Count();
    is_long_ = count_ >= ConditionQueue::kFewest;
    waiting_ = arena_.NewRoom<Waiting*>(count_);
    tied_ = arena_.NewRoom<std::uint32_t>(count_);
    Waiting** next = waiting_;
    Waiting* made = arena_.NewRoom<Waiting>(count_);
    for (ConditionDraft& condition : conditions) {
      Waiting& waiting = *new (made++) Waiting;
      waiting.condition = &condition;
      if (!is_long_) {
        waiting.needs = new (arena_.NewRoom<Set>(1)) Set(variables_, arena_);
      }
      *next++ = &waiting;
      waiting.positive = condition.kind == ConditionKind::kPositive;
      if (waiting.positive) {
        StripField(condition.id, true);
        StripField(condition.attribute, false);
        StripField(condition.value, false);
      }
      waiting.fields[0] = EqualityVariable(condition.id);
      waiting.fields[1] = EqualityVariable(condition.attribute);
      waiting.fields[2] = EqualityVariable(condition.value);
      if (waiting.positive) {
        waiting.expected = ExpectedUnder(condition.attribute);
        waiting.age = std::uint64_t{StampOf(condition.attribute)} << 32 | StampOf(condition.value);
        AddVariable(positive_values_, waiting.fields[2]);
        for (const std::uint32_t field : waiting.fields) {
          AddVariable(positive_variables_, field);
          if (!is_long_) AddVariable(*waiting.needs, field);
        }
      }
    }
  }

  /// The expected number of values, limited so that no cost computed from it reaches kInfinite.
  std::int64_t ExpectedUnder(const TestDraft& attribute) const {
    if (expected_.all().empty()) {
      return 1;
    }
    return std::min(expected_.Of(EqualitySymbol(attribute)), (kInfinite - 1) / kUnboundCost);
  }

  void StripField(TestDraft& test, bool is_id) {
    if (test.kind == TestKind::kEqual) {
      return;
    }
    const Symbol field = EqualitySymbol(test);
    const std::uint32_t variable = EqualityVariable(test);
    DraftList<TestDraft> kept, equality;
    for (TestDraft* part = PartsOf(test, arena_).first; part != nullptr;) {
      TestDraft* const next = part->next;
      if (part->kind == TestKind::kEqual) {
        equality.Add(part);
      } else if (IsGoalTest(*part)) {
        SaveGoalTest(variable, part->kind, is_id);
      } else if (IsStrippable(part->kind)) {
        waiting_tests_.Save(field, variable, *part);
      } else {
        kept.Add(part);
      }
      part = next;
    }
    kept.Append(equality);
    test = JoinParts(kept);
  }

  void SaveGoalTest(std::uint32_t variable, TestKind kind, bool of_id) {
    GoalTest* test = goal_tests_.first;
    while (test != nullptr && (test->variable != variable || test->kind != kind)) {
      test = test->next;
    }
    if (test == nullptr) {
      test = arena_.New<GoalTest>();
      test->variable = variable;
      test->kind = kind;
      goal_tests_.Add(test);
    }
    (of_id ? test->of_id : test->of_value) = true;
  }

  /// Drops the state tests of identifiers that are not roots, because these are linked to a root. Keeps tests written
  /// at values.
  void DropGoalTests() {
    for (GoalTest& test : goal_tests_) {
      if (test.kind == TestKind::kState && !test.of_value && test.variable != kNoVariable &&
          !roots_.Has(test.variable)) {
        test.placed = true;
      }
    }
  }

  bool IsGoalVariable(std::uint32_t variable) const {
    for (const GoalTest& test : goal_tests_) {
      if (test.variable == variable && test.of_id) {
        return true;
      }
    }
    return false;
  }

  /// Finds the roots: identifiers of positive conditions that are unbound and the value of no positive condition. If
  /// there are none, the first state is the root.
  bool FindRoots() {
    bool any = false;
    for (std::size_t n = 0; n < count_; ++n) {
      const std::uint32_t id = waiting_[n]->fields[0];
      if (id == kNoVariable || !waiting_[n]->positive || bound_.Has(id) || positive_values_.Has(id) || roots_.Has(id)) {
        continue;
      }
      roots_.Add(id);
      ++roots_unbound_;
      any = true;
      if (!IsGoalVariable(id)) {
        NoteUnconnected(variables_.variable(id));
      }
    }
    for (const GoalTest& test : goal_tests_) {
      if (!any && test.variable != kNoVariable && test.kind == TestKind::kState && test.of_id) {
        roots_.Add(test.variable);
        bound_.Add(test.variable);  // As in Soar, its negated conditions may come first.
        any = true;
      }
    }
    roots_wait_ = any;
    return any;
  }

  /// Reports an unconnected root. Like Soar, repeats the earlier complaints with each new one.
  void NoteUnconnected(Symbol root) {
    out_.unconnected.push_back(root);
    if (out_.unconnected.size() > kMostRepeated) {
      unconnected_.clear();
    }
    unconnected_.push_back(root);
    for (const Symbol variable : unconnected_) {
      Warn("\nWarning: On the LHS of production " + std::string(rule_.name) + ", identifier " +
           std::string(symbols_.Text(variable)) + " is not connected to any goal or impasse.\n");
    }
  }

  void NoteNeeds() {
    for (std::size_t n = 0; n < count_; ++n) {
      Waiting& waiting = *waiting_[n];
      if (!waiting.positive) {
        AddVariables(*waiting.condition, *waiting.needs);
        waiting.needs->KeepOnly(positive_variables_);
      }
      waiting.cost = Cost(waiting);
    }
  }

  template <typename Variables>
  static void AddVariables(const TestDraft& test, Variables& out) {
    AddVariable(out, test.variable);
    for (const TestDraft& part : test.parts) {
      AddVariables(part, out);
    }
  }

  template <typename Variables>
  static void AddVariables(const ConditionDraft& condition, Variables& out) {
    AddVariables(condition.id, out);
    AddVariables(condition.attribute, out);
    AddVariables(condition.value, out);
    for (const ConditionDraft& inner : condition.conditions) {
      AddVariables(inner, out);
    }
  }

  /// Until every root is bound, roots count as bound in any field, and expected numbers of values are ignored.
  bool IsKnown(std::uint32_t variable) const { return bound_.Has(variable) || (roots_wait_ && roots_.Has(variable)); }

  std::int64_t Cost(const Waiting& waiting) const {
    if (!waiting.positive) {
      return bound_.Covers(*waiting.needs) ? 1 : kInfinite;
    }
    if (!IsKnown(waiting.fields[0])) {
      return kInfinite;
    }
    const std::int64_t values = roots_wait_ ? 1 : waiting.expected;
    return (IsKnown(waiting.fields[1]) ? values : kUnboundCost) * (IsKnown(waiting.fields[2]) ? 1 : kUnboundCost);
  }

  /// Determines the conditions that each variable makes cheaper.
  void FindUsers() {
    const std::uint32_t variables = variables_.size();
    users_end_ = arena_.NewArray<std::uint32_t>(variables + 1u);
    const auto for_each = [&](const auto& visit) {
      for (std::size_t n = 0; n < count_; ++n) {
        waiting_[n]->needs->ForEach([&](std::uint32_t variable) { visit(variable, waiting_[n]); });
      }
    };
    for_each([&](std::uint32_t variable, Waiting*) { ++users_end_[variable + 1]; });
    for (std::uint32_t n = 0; n < variables; ++n) {
      users_end_[n + 1] += users_end_[n];
    }
    users_ = arena_.NewRoom<Waiting*>(users_end_[variables]);
    for_each([&](std::uint32_t variable, Waiting* waiting) { users_[users_end_[variable]++] = waiting; });
  }

  /// The lowest cost among the other conditions after `taken` has been placed. `tied` is the number of conditions with
  /// the lowest cost, `cheapest`; `taken` is one of them.
  std::int64_t LookAhead(std::size_t taken, std::int64_t cheapest, std::size_t tied) {
    if (users_end_ == nullptr) {
      if (count_ < kManyConditions) {
        return LookAtAll(taken);
      }
      FindUsers();
    }
    // Only conditions that use the new variables of `taken` get cheaper. If a tied condition does not use them, it
    // still has the lowest cost.
    const Waiting* const chosen = waiting_[taken];
    std::uint32_t added[3];
    std::size_t added_count = 0;
    for (const std::uint32_t field : chosen->fields) {
      if (!bound_.Has(field)) {
        bound_.Add(field);
        added[added_count++] = field;
      }
    }
    std::int64_t least = cheapest;
    std::size_t others_tied = tied - 1;
    for (std::size_t n = 0; n < added_count; ++n) {
      const std::uint32_t variable = added[n];
      for (std::uint32_t at = variable == 0 ? 0 : users_end_[variable - 1]; at < users_end_[variable]; ++at) {
        const Waiting* const user = users_[at];
        if (user->placed || user == chosen) {
          continue;
        }
        least = std::min(least, Cost(*user));
        others_tied -= user->cost == cheapest && others_tied != 0 ? 1 : 0;
      }
    }
    while (added_count > 0) {
      bound_.Remove(added[--added_count]);
    }
    return others_tied != 0 ? least : LookAtAll(taken);
  }

  std::int64_t LookAtAll(std::size_t taken) {
    std::uint32_t added[3];
    std::size_t added_count = 0;
    ahead_.Clear();
    for (const std::uint32_t field : waiting_[taken]->fields) {
      if (!bound_.Has(field)) {
        bound_.Add(field);
        ahead_.Add(field);
        added[added_count++] = field;
      }
    }
    std::int64_t cheapest = std::numeric_limits<std::int64_t>::max();
    for (std::size_t other = 0; other < count_ && cheapest > 1; ++other) {
      const Waiting& waiting = *waiting_[other];
      if (other != taken) {
        cheapest = std::min(cheapest, waiting.needs->Meets(ahead_) ? Cost(waiting) : waiting.cost);
      }
    }
    while (added_count > 0) {
      bound_.Remove(added[--added_count]);
    }
    return cheapest;
  }

  std::uint32_t StampOf(const TestDraft& test) const {
    const Symbol symbol = EqualitySymbol(test);
    return symbol.IsConstant() ? symbols_.Stamp(symbol) : 0;
  }

  /// The index of the next condition to place.
  std::size_t Choose() {
    if (count_ == 1 && warned_) {
      return 0;
    }
    std::int64_t cheapest = std::numeric_limits<std::int64_t>::max();
    std::size_t tied = 0;  // The number of valid entries in tied_; the last in the text is first.
    for (std::size_t at = count_; at-- > 0;) {
      Waiting& waiting = *waiting_[at];
      if (roots_came_ || waiting.needs->Meets(fresh_)) {
        waiting.cost = Cost(waiting);
      }
      const std::int64_t cost = waiting.cost;
      if (cost < cheapest) {
        cheapest = cost;
        tied = 0;
      }
      if (cost == cheapest) {
        tied_[tied++] = static_cast<std::uint32_t>(at);
      }
    }
    fresh_.Clear();
    roots_came_ = false;
    if (cheapest >= kInfinite) {
      WarnOfUnconnected();
    }
    std::size_t incumbent = tied_[0];
    std::int64_t best = 0;
    const bool look_ahead = cheapest > 1 && tied > 1;
    if (look_ahead) {
      best = LookAhead(incumbent, cheapest, tied);
    }
    for (std::size_t i = 1; i < tied; ++i) {
      const Waiting& held = *waiting_[incumbent];
      const Waiting& candidate = *waiting_[tied_[i]];
      const bool newer = held.age < candidate.age;
      bool replace = false;
      if (look_ahead) {
        if (best == 1 && !newer) {
          continue;  // No other condition can be cheaper.
        }
        const std::int64_t ahead = LookAhead(tied_[i], cheapest, tied);
        replace = ahead < best || (ahead == best && held.positive && candidate.positive && newer);
        best = replace ? ahead : best;
      } else {
        replace = held.positive && (!candidate.positive || newer);
      }
      if (replace) {
        incumbent = tied_[i];
      }
    }
    return incumbent;
  }

  void WarnOfUnconnected() {
    if (!warned_) {
      Warn("Warning:  in production " + std::string(rule_.name) +
           ",\n     The LHS conditions are not all connected.\n");
      warned_ = true;
    }
  }

  /// Binds the condition's variables and puts back the tests that can be decided in it.
  void Place(ConditionDraft& condition) {
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
        Set inner_bound(variables_, arena_);
        inner_bound.Assign(bound_);
        ListReorderer inner(rule_, symbols_, variables_, expected_, arena_, inner_bound, out_);
        inner.Reorder(condition.conditions, false);
        return;
      }
    }
  }

  void PlaceField(TestDraft& test) {
    const std::uint32_t variable = EqualityVariable(test);
    if (!bound_.Has(variable)) {
      bound_.Add(variable);
      fresh_.Add(variable);
      roots_unbound_ -= roots_.Has(variable) ? 1 : 0;
      if (queue_) queue_->Bind(variable);
    }
    if (!waiting_tests_.empty()) {
      waiting_tests_.PutBack(test, bound_);
    }
  }

  void CheckNegated(ConditionDraft& condition) {
    Set local(variables_, arena_);
    for (TestDraft* test : {&condition.id, &condition.attribute, &condition.value}) {
      const std::uint32_t variable = EqualityVariable(*test);
      if (test->kind == TestKind::kConjunction && !bound_.Has(variable) && !local.Has(variable)) {
        PutEqualityLast(*test);
      }
      AddVariable(local, variable);
      CheckReferents(*test, local);
    }
  }

  void CheckReferents(const TestDraft& test, const Set& local) {
    for (const TestDraft& part : test.parts) {
      CheckReferents(part, local);
    }
    if (!IsStrippable(test.kind) || bound_.Has(test.variable) || local.Has(test.variable)) {
      return;
    }
    std::string text;
    AppendTest(text, symbols_, test);
    out_.messages.push_back({"Error: production " + std::string(rule_.name) +
                                 " has an unbound referent in negated relational test " + text + ".\n",
                             false, false});
    Warn("\nAttempted to add an invalid rule:\n      Unbound relational test in negative condition of rule \n");
    out_.ok = false;
  }

  /// Adds each goal test once: to the first positive condition with its variable as identifier.
  void PlaceGoalTests(const DraftList<ConditionDraft>& conditions) {
    for (ConditionDraft& condition : conditions) {
      if (condition.kind == ConditionKind::kPositive) {
        PlaceGoalTests(condition.id);
      }
    }
  }

  void PlaceGoalTests(TestDraft& id) {
    DraftList<TestDraft> parts;
    for (GoalTest& goal : goal_tests_) {
      if (!goal.placed && goal.variable == EqualityVariable(id)) {
        parts.Add(arena_.New(MakeTest(goal.kind)));
        goal.placed = true;
      }
    }
    if (!parts.empty()) {
      parts.Append(PartsOf(id, arena_));
      id = JoinParts(parts);
    }
  }

  const RuleDraft& rule_;
  const SymbolTable& symbols_;
  const VariableIndex& variables_;
  const ExpectedValues& expected_;
  Arena& arena_;
  Set bound_;
  ReorderOutcome& out_;
  Set roots_, positive_values_, positive_variables_;
  std::size_t roots_unbound_ = 0;
  bool roots_wait_ = false;  ///< Some root is not bound yet.
  bool roots_came_ = false;  ///< The last root was bound after the costs were computed.
  Set fresh_;                ///< Variables bound after the costs were computed.
  Set ahead_;                ///< Scratch of LookAtAll: variables that are bound temporarily.
  static constexpr std::size_t kManyConditions = 12;
  Waiting** users_ = nullptr;           ///< By variable: the conditions that need it.
  std::uint32_t* users_end_ = nullptr;  ///< By variable: the end of its conditions; null if not computed yet.
  std::vector<Symbol> unconnected_;     ///< Roots of this list without a goal test.
  WaitingTests waiting_tests_;
  DraftList<GoalTest> goal_tests_;
  Waiting** waiting_ = nullptr;  ///< Conditions that are not placed yet, in text order.
  std::size_t count_ = 0;
  std::uint32_t* tied_ = nullptr;  ///< Scratch of Choose.
  bool warned_ = false;
  bool is_long_ = false;  ///< A queue chooses, because there are many conditions.
  std::optional<ConditionQueue> queue_;
  std::vector<std::size_t> needs_end_;
};

template <typename Set>
void Reorder(RuleDraft& rule, const VariableIndex& variables, const ExpectedValues& expected,
             const SymbolTable& symbols, Arena& arena, ReorderOutcome& out) {
  Set bound(variables, arena);
  bound.Add(kNoVariable);
  ListReorderer<Set>(rule, symbols, variables, expected, arena, bound, out).Reorder(rule.conditions, true);
}

}  // namespace

ReorderOutcome ReorderConditions(RuleDraft& rule, const VariableIndex& variables, const ExpectedValues& expected,
                                 const SymbolTable& symbols, Arena& arena) {
  ReorderOutcome out;
  if (variables.size() <= FewVariables::kMost) {
    Reorder<FewVariables>(rule, variables, expected, symbols, arena, out);
  } else {
    Reorder<ManyVariables>(rule, variables, expected, symbols, arena, out);
  }
  return out;
}

}  // namespace soarbox::kernel
