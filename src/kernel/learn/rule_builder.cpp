// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/learn/rule_builder.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <new>
#include <string>
#include <tuple>

#include "kernel/base/known_symbols.h"
#include "kernel/base/symbol_table.h"
#include "kernel/decide/instantiation_table.h"
#include "kernel/decide/observers.h"
#include "kernel/learn/draft_tests.h"
#include "kernel/learn/justification.h"
#include "kernel/learn/learn_settings.h"
#include "kernel/memory/working_memory.h"
#include "kernel/rules/expected_values.h"
#include "kernel/rules/finish_rule.h"
#include "kernel/rules/variable_index.h"

namespace soarbox::kernel {

namespace {

using Part = FiringReader::Part;
using Said = FiringReader::Term;

TestDraft& FieldOf(ConditionDraft& draft, Field field) {
  return field == Field::kId ? draft.id : field == Field::kAttribute ? draft.attribute : draft.value;
}

}  // namespace

RuleBuilder::Outcome RuleBuilder::Build(Explanation& explanation, std::string_view name, GoalLevel results_level) {
  arena_.Clear();
  made_.clear();
  negated_.clear();
  constraints_.clear();
  variable_of_.clear();
  order_of_.clear();
  variables_made_ = 0;
  variable_of_symbol_.clear();
  identifier_of_variable_.clear();
  actions_.clear();
  letters_ = {};
  merged_conditions_ = merged_disjunctions_ = operational_constraints_ = 0;
  rule_ = nullptr;
  MakeConditions(explanation);
  CollectConstraints(explanation);
  PlaceConstraints();
  MakeNegations(explanation);
  MergeConditions();
  AddStateTests();
  MakeActions(explanation);
  if (Finish(name)) {
    CountConstraints();
    return Outcome::kMade;
  }
  if (Repair(results_level) && Finish(name)) {
    CountConstraints();
    return Outcome::kRepaired;
  }
  return Outcome::kFailed;
}

// Variables -----------------------------------------------------------------------------------------------------------

Symbol RuleBuilder::NewVariable(Symbol of) {
  char letter = 'c';
  if (of.IsIdentifier()) {
    letter = static_cast<char>(uses_.symbols.Letter(of) | 0x20);
    if (uses_.memory.identifier(of).is_goal) {
      letter = 's';
    } else if (letter == 's') {
      letter = 'c';
    }
  }
  ++variables_made_;
  const std::uint32_t number = ++letters_[static_cast<std::size_t>(letter - 'a')];
  char name[16] = {'<', letter};
  char* end = std::to_chars(name + 2, std::end(name) - 1, number).ptr;
  *end++ = '>';
  const Symbol variable = uses_.symbols.Variable({name, static_cast<std::size_t>(end - name)});
  if (of.IsIdentifier()) identifier_of_variable_.emplace_back(variable, of);
  return variable;
}

Symbol RuleBuilder::Meaning(IdentityGraph::Node node, Symbol value) {
  if (node == IdentityGraph::kNone || analysis_.graph().literal(node)) return value;
  const IdentityGraph::Node root = analysis_.graph().Root(node);
  if (root >= variable_of_.size()) {
    variable_of_.resize(analysis_.graph().size());
    order_of_.resize(analysis_.graph().size(), 0);
  }
  Symbol& variable = variable_of_[root];
  if (!variable) {
    variable = NewVariable(value);
    order_of_[root] = variables_made_;
  }
  return variable;
}

bool RuleBuilder::HasVariable(IdentityGraph::Node node) const {
  if (node == IdentityGraph::kNone) return false;
  const IdentityGraph::Node root = analysis_.graph().Root(node);
  return root < variable_of_.size() && variable_of_[root];
}

Symbol RuleBuilder::VariableOfIdentifier(Symbol identifier) {
  for (const Made& made : made_) {
    const Wme& wme = uses_.memory.wme(made.wme);
    for (const Field field : {Field::kId, Field::kAttribute, Field::kValue}) {
      if (kernel::FieldOf(wme, field) != identifier) continue;
      const Symbol symbol = EqualitySymbol(FieldOf(*made.draft, field));
      if (symbol.IsVariable()) return symbol;
    }
  }
  Symbol& variable = variable_of_symbol_[identifier.bits()];
  if (!variable) variable = NewVariable(identifier);
  return variable;
}

// Conditions ----------------------------------------------------------------------------------------------------------

void RuleBuilder::MakeConditions(const Explanation& explanation) {
  for (std::uint32_t n = 0; n < explanation.grounds.size(); ++n) {
    const Explanation::Ground& ground = explanation.grounds[n];
    const Wme& wme = uses_.memory.wme(ground.wme);
    Made made;
    made.draft = arena_.New<ConditionDraft>();
    made.wme = ground.wme;
    made.ground = n;
    made.draft->tests_acceptable = wme.acceptable;
    analysis_.OfCondition(ground, made.nodes);
    for (const Field field : {Field::kId, Field::kAttribute, Field::kValue}) {
      const IdentityGraph::Node node = made.nodes[static_cast<std::size_t>(field)];
      FieldOf(*made.draft, field) = MakeTest(TestKind::kEqual, Meaning(node, kernel::FieldOf(wme, field)));
    }
    made_.push_back(made);
  }
  // The tests refer to variables of other fields, so they come when all variables are known.
  for (const Made& made : made_) {
    const Explanation::Ground& ground = explanation.grounds[made.ground];
    if (ground.firing == InstantiationId::kNone) continue;
    if (reader_.Rule(ground.firing) != nullptr && reader_.TestedBy(ground.firing, ground.condition).carried == 0)
      continue;
    for (const Field field : {Field::kId, Field::kAttribute, Field::kValue}) {
      if (EqualitySymbol(FieldOf(*made.draft, field)).IsVariable()) {
        AddOwnTests(ground, field, FieldOf(*made.draft, field));
      }
    }
  }
}

/// Calls visit(CarriedTest) for what a condition of a firing asks of a field beside equality: of its rule, or, if it is
/// a justification, of the reasoning that it stands for.
template <typename Visit>
void RuleBuilder::ForEachCarried(InstantiationId firing, std::uint16_t condition, Field field, Visit&& visit) {
  const Instantiation& instantiation = uses_.instantiations[firing];
  if (!instantiation.has_identities) return;
  const bool is_rule = reader_.Rule(firing) != nullptr;
  if (is_rule && !reader_.TestedBy(firing, condition).Carries(field)) return;
  CarriedTest test;
  test.firing = firing;
  test.condition = condition;
  test.field = field;
  if (is_rule) {
    const Condition& tested = *reader_.TestedBy(firing, condition).condition;
    const IdentityPlan& plan = reader_.Plan(firing);
    const auto visit_part = [&](const Test& part) {
      if (!IsCarried(part.kind)) return;
      test.kind = part.kind;
      test.referent = part.referent();
      test.referent_node = IdentityGraph::kNone;
      test.disjuncts.assign(part.disjuncts().begin(), part.disjuncts().end());
      if (test.referent.IsVariable()) {
        const std::uint16_t referent = plan.ClassOf(test.referent);
        if (referent == IdentityPlan::kLiteral) return;
        test.referent = ValueOfClass(plan, referent, uses_.instantiations.Trace(firing), uses_.memory);
        test.referent_node = analysis_.OfClass(firing, referent);
        if (const std::uint16_t own = plan.ClassOf(condition, field);
            own != IdentityPlan::kLiteral && reader_.IsTurned(firing, condition, field, part)) {
          test.referent_node = analysis_.OfClass(firing, own);
        }
      }
      visit(test);
    };
    ForEachTest(field == Field::kId          ? tested.id
                : field == Field::kAttribute ? tested.attribute
                                             : tested.value,
                visit_part);
    return;
  }
  if (instantiation.justification == Instantiation::kNoJustification) return;
  for (const IdentityPlan::KeptTest& kept : uses_.justifier.record(instantiation.justification).tests) {
    if (kept.condition != condition || kept.field != field || kept.of_literal) continue;
    test.kind = kept.kind;
    test.referent = kept.referent;
    test.referent_node = analysis_.OfClass(firing, kept.referent_class);
    test.disjuncts = kept.disjuncts;
    visit(test);
  }
}

/// False if the test compares with an object of the firing's own state, which the rule above cannot know.
bool RuleBuilder::MayCarryUp(const CarriedTest& test) const {
  return !test.referent.IsIdentifier() || uses_.memory.level(test.referent) < uses_.instantiations[test.firing].level;
}

/// What else the rule that fired asked of the element, unless it has become a constant.
void RuleBuilder::AddOwnTests(const Explanation::Ground& ground, Field field, TestDraft& out) {
  if (ground.firing == InstantiationId::kNone) return;
  ForEachCarried(ground.firing, ground.condition, field, [&](const CarriedTest& carried) {
    if (!MayCarryUp(carried)) return;
    TestDraft* const test = arena_.New<TestDraft>();
    test->kind = carried.kind;
    test->referent =
        PlaceOf(carried.referent_node) != nullptr ? Meaning(carried.referent_node, carried.referent) : carried.referent;
    SetDisjuncts(*test, carried.disjuncts);
    AppendPart(out, test, arena_);
  });
}

void RuleBuilder::SetDisjuncts(TestDraft& test, std::span<const Symbol> disjuncts) {
  if (test.kind != TestKind::kDisjunction) return;
  Symbol* const copy = arena_.NewArray<Symbol>(disjuncts.size());
  std::ranges::copy(disjuncts, copy);
  test.disjuncts = copy;
  test.disjunct_count = static_cast<std::uint32_t>(disjuncts.size());
}

std::vector<IdentityPlan::KeptTest> RuleBuilder::TestsOfJustification(const Explanation& explanation, bool counts) {
  std::vector<IdentityPlan::KeptTest> kept;
  const auto keep = [&](std::size_t number, Field field, TestKind kind, Symbol referent, IdentityGraph::Node node,
                        std::span<const Symbol> disjuncts, bool of_literal) {
    IdentityPlan::KeptTest test;
    test.of_literal = of_literal;
    test.condition = static_cast<std::uint16_t>(number);
    test.field = field;
    test.kind = kind;
    test.referent = referent;
    if (node != IdentityGraph::kNone && !analysis_.graph().literal(node)) {
      const auto found = class_of_.find(analysis_.graph().Root(node));
      if (found != class_of_.end()) test.referent_class = found->second;
    }
    // An object that no condition names may go before the justification does.
    if (referent.IsIdentifier() && test.referent_class == IdentityPlan::kLiteral) return;
    test.disjuncts.assign(disjuncts.begin(), disjuncts.end());
    kept.push_back(std::move(test));
  };
  for (std::size_t n = 0; n < explanation.grounds.size(); ++n) {
    const Explanation::Ground& ground = explanation.grounds[n];
    if (ground.firing == InstantiationId::kNone) continue;
    for (const Field field : {Field::kId, Field::kAttribute, Field::kValue}) {
      const IdentityGraph::Node tested = analysis_.OfGround(ground, field);
      const bool literal = tested == IdentityGraph::kNone || analysis_.graph().literal(tested);
      ForEachCarried(ground.firing, ground.condition, field, [&](const CarriedTest& test) {
        if (MayCarryUp(test)) keep(n, field, test.kind, test.referent, test.referent_node, test.disjuncts, literal);
      });
    }
  }
  // Tests of local conditions go where the identity has its place.
  CollectConstraints(explanation);
  const auto place_of = [&](IdentityGraph::Node node) -> std::pair<std::size_t, Field> {
    if (node == IdentityGraph::kNone || analysis_.graph().literal(node)) return {explanation.grounds.size(), {}};
    for (std::size_t n = 0; n < explanation.grounds.size(); ++n) {
      for (const Field field : {Field::kId, Field::kAttribute, Field::kValue}) {
        const IdentityGraph::Node here = analysis_.OfGround(explanation.grounds[n], field);
        if (here != IdentityGraph::kNone && analysis_.graph().Root(here) == analysis_.graph().Root(node)) {
          return {n, field};
        }
      }
    }
    return {explanation.grounds.size(), {}};
  };
  const auto of_conditions = static_cast<std::ptrdiff_t>(kept.size());
  std::uint64_t placed = 0;
  for (const CarriedTest& test : constraints_) {
    const auto here = place_of(test.tested);
    if (here.first < explanation.grounds.size()) {
      keep(here.first, here.second, test.kind, test.referent, test.referent_node, test.disjuncts, false);
      ++placed;
      continue;
    }
    const auto there = place_of(test.referent_node);
    if (there.first < explanation.grounds.size() && test.kind != TestKind::kDisjunction) {
      keep(there.first, there.second, TurnedRound(test.kind), test.value, IdentityGraph::kNone, {}, false);
      ++placed;
    }
  }
  // As in a learned rule, they stand before what the conditions ask themselves, the last one first.
  std::rotate(kept.begin(), kept.begin() + of_conditions, kept.end());
  std::reverse(kept.begin(), kept.end() - of_conditions);
  if (counts) {
    uses_.statistics.constraints_found += constraints_.size();
    uses_.statistics.constraints_placed += placed;
  }
  return kept;
}

TestDraft* RuleBuilder::PlaceOf(IdentityGraph::Node node) {
  if (node == IdentityGraph::kNone || analysis_.graph().literal(node)) return nullptr;
  const IdentityGraph::Node root = analysis_.graph().Root(node);
  for (Made& made : made_) {
    for (const Field field : {Field::kValue, Field::kAttribute, Field::kId}) {
      const IdentityGraph::Node here = made.nodes[static_cast<std::size_t>(field)];
      if (here != IdentityGraph::kNone && analysis_.graph().Root(here) == root) return &FieldOf(*made.draft, field);
    }
  }
  return nullptr;
}

// Tests of local conditions -------------------------------------------------------------------------------------------

/// Of all conditions that tested elements of the substate, in the order in which they were visited.
void RuleBuilder::CollectConstraints(const Explanation& explanation) {
  constraints_.clear();
  const WorkingMemory& memory = uses_.memory;
  for (const InstantiationId firing : explanation.firings) {
    if (!reader_.CarriesTests(firing)) continue;
    const std::span<const ConditionTrace> traces = uses_.instantiations.Trace(firing);
    for (std::size_t n = 0; n < traces.size(); ++n) {
      const Wme& wme = memory.wme(traces[n].wme);
      if (memory.known_identifier(wme.id).level < explanation.level) continue;
      const auto condition = static_cast<std::uint16_t>(n);
      for (const Field field : {Field::kId, Field::kAttribute, Field::kValue}) {
        ForEachCarried(firing, condition, field, [&](const CarriedTest& carried) {
          CarriedTest& test = constraints_.emplace_back(carried);
          test.tested = analysis_.OfField(firing, condition, field);
          test.value = kernel::FieldOf(wme, field);
        });
      }
    }
  }
}

void RuleBuilder::PlaceConstraints() {
  LearnStatistics& statistics = uses_.statistics;
  statistics.constraints_found += constraints_.size();
  for (CarriedTest& constraint : constraints_) {
    constraint.placed = PlaceConstraint(constraint);
    if (constraint.placed) ++statistics.constraints_placed;
  }
}

/// Where the tested value has its place in the learned rule, or else turned round where the other one has it.
bool RuleBuilder::PlaceConstraint(const CarriedTest& constraint) {
  TestDraft* const here = PlaceOf(constraint.tested);
  TestDraft* const there = PlaceOf(constraint.referent_node);
  if (here == nullptr && (there == nullptr || constraint.kind == TestKind::kDisjunction)) return false;
  TestDraft* const test = arena_.New<TestDraft>();
  if (here != nullptr) {
    test->kind = constraint.kind;
    test->referent = there != nullptr ? Meaning(constraint.referent_node, constraint.referent) : constraint.referent;
    SetDisjuncts(*test, constraint.disjuncts);
    if (UniteDisjunctions(*here, *test, arena_)) {
      ++merged_disjunctions_;
    } else {
      PrependPart(*here, test, arena_);
    }
    return true;
  }
  test->kind = TurnedRound(constraint.kind);
  test->referent = constraint.value;
  PrependPart(*there, test, arena_);
  return true;
}

// Negated conditions --------------------------------------------------------------------------------------------------

bool RuleBuilder::ComparesWithUnreached(const TestDraft& test, InstantiationId firing) const {
  if (!IsCarried(test.kind)) return false;
  Symbol other = test.referent;
  if (other.IsVariable()) {
    const IdentityPlan& plan = reader_.Plan(firing);
    const std::uint16_t bound = plan.ClassOf(other);
    if (bound == IdentityPlan::kLiteral) return false;
    other = ValueOfClass(plan, bound, uses_.instantiations.Trace(firing), uses_.memory);
  }
  return other.IsIdentifier() && !Contains(reached_, other);
}

void RuleBuilder::VariablizeNegated(TestDraft& draft, InstantiationId firing) {
  // A comparison with an object of the substate says nothing above.
  if (ComparesWithUnreached(draft, firing)) {
    draft = MakeTest(TestKind::kBlank);
    return;
  }
  if (draft.kind == TestKind::kConjunction) {
    DraftList<TestDraft> kept;
    for (TestDraft* part = draft.parts.first; part != nullptr;) {
      TestDraft* const next = part->next;
      if (!ComparesWithUnreached(*part, firing)) kept.Add(part);
      part = next;
    }
    draft.parts = kept;
  }
  if (draft.referent.IsVariable()) {
    const IdentityPlan& plan = reader_.Plan(firing);
    const std::uint16_t bound = plan.ClassOf(draft.referent);
    if (bound == IdentityPlan::kLiteral) {
      // It is the condition's own.
      Symbol& own = own_variables_[draft.referent.bits()];
      if (!own) {
        own = NewVariable(Symbol());
        --variables_made_;  // It has no identity.
      }
      draft.referent = own;
    } else {
      const Symbol value = ValueOfClass(plan, bound, uses_.instantiations.Trace(firing), uses_.memory);
      const IdentityGraph::Node node = analysis_.OfClass(firing, bound);
      // (A constant without a place is what the architecture said of the substate. As in Soar it matches anything
      // here.)
      draft.referent =
          PlaceOf(node) == nullptr && value.IsIdentifier() ? VariableOfIdentifier(value) : Meaning(node, value);
    }
  } else if (draft.referent.IsIdentifier()) {
    draft.referent = VariableOfIdentifier(draft.referent);
  }
  for (TestDraft& part : draft.parts) VariablizeNegated(part, firing);
}

void RuleBuilder::VariablizeNegated(ConditionDraft& draft, InstantiationId firing) {
  for (TestDraft* test : {&draft.id, &draft.attribute, &draft.value}) VariablizeNegated(*test, firing);
  for (ConditionDraft& inner : draft.conditions) VariablizeNegated(inner, firing);
}

void RuleBuilder::MakeNegations(const Explanation& explanation) {
  if (explanation.negations.empty()) return;
  reached_.clear();
  for (const Explanation::Ground& ground : explanation.grounds) {
    const Wme& wme = uses_.memory.wme(ground.wme);
    for (const Symbol symbol : {wme.id, wme.attribute, wme.value}) {
      if (symbol.IsIdentifier()) reached_.push_back(symbol);
    }
  }
  for (const Explanation::Negation& negation : explanation.negations) {
    own_variables_.clear();
    ConditionDraft* const draft =
        arena_.New(negation.source != nullptr ? ToDraft(*negation.source, arena_) : Copy(negation.literal, arena_));
    VariablizeNegated(*draft, negation.firing);
    negated_.push_back(draft);
  }
}

// Merging -------------------------------------------------------------------------------------------------------------

void RuleBuilder::MergeConditions() {
  LearnStatistics& statistics = uses_.statistics;
  // Most elements stand for one condition only.
  std::array<std::uint8_t, 256> seen{};
  const auto place = [](WmeId wme) { return Index(wme) % 256u; };
  for (const Made& made : made_) {
    std::uint8_t& times = seen[place(made.wme)];
    times = std::min<std::uint8_t>(times, 1) + 1;
  }
  for (std::size_t n = 0; n < made_.size(); ++n) {
    if (seen[place(made_[n].wme)] == 1) continue;
    for (std::size_t m = n + 1; m < made_.size();) {
      const std::size_t candidate = m++;
      if (made_[n].wme != made_[candidate].wme) continue;
      ConditionDraft& kept = *made_[n].draft;
      const ConditionDraft& other = *made_[candidate].draft;
      if (kept.tests_acceptable != other.tests_acceptable || EqualitySymbol(kept.id) != EqualitySymbol(other.id) ||
          EqualitySymbol(kept.attribute) != EqualitySymbol(other.attribute) ||
          EqualitySymbol(kept.value) != EqualitySymbol(other.value)) {
        continue;
      }
      // (What else was asked of the object is not kept of the later one: so it is in Soar 9.6.3.)
      for (const Field field : {Field::kAttribute, Field::kValue}) {
        merged_disjunctions_ += UniteTests(FieldOf(kept, field), FieldOf(*made_[candidate].draft, field), arena_);
      }
      ++merged_conditions_;
      made_.erase(made_.begin() + static_cast<std::ptrdiff_t>(candidate));
      m = candidate;
    }
  }
  statistics.merged_conditions += merged_conditions_;
  statistics.merged_disjunctions += merged_disjunctions_;
}

/// Each state whose elements the rule tests must be one. (Where one leads to the next, reordering drops the test.)
void RuleBuilder::AddStateTests() {
  std::vector<Symbol> states;
  for (const Made& made : made_) {
    const Symbol state = EqualitySymbol(made.draft->id);
    if (!state.IsVariable() || !uses_.memory.identifier(uses_.memory.wme(made.wme).id).is_goal) continue;
    if (std::ranges::find(states, state) != states.end()) continue;
    states.push_back(state);
    PrependPart(made.draft->id, arena_.New(MakeTest(TestKind::kState)), arena_);
  }
}

// Actions -------------------------------------------------------------------------------------------------------------

ValueDraft RuleBuilder::MakeFunction(const RhsValue& function, InstantiationId firing) {
  ValueDraft out;
  out.kind = RhsValueKind::kFunction;
  out.index = function.function_index();
  for (const RhsValue& argument : function.arguments()) {
    ValueDraft copy;
    if (argument.kind == RhsValueKind::kFunction) {
      copy = MakeFunction(argument, firing);
    } else if (argument.kind == RhsValueKind::kBound) {
      const std::uint16_t bound = reader_.ClassOf(argument, firing);
      const Wme& wme = uses_.memory.wme(uses_.instantiations.Trace(firing)[argument.site().positive_condition].wme);
      const Symbol value = kernel::FieldOf(wme, argument.site().field);
      const IdentityGraph::Node node = analysis_.OfClass(firing, bound);
      copy.symbol = PlaceOf(node) != nullptr ? Meaning(node, value) : value;
    } else {
      copy.symbol = argument.symbol();
    }
    out.arguments.Add(arena_.New(copy));
  }
  return out;
}

ValueDraft RuleBuilder::MakeTerm(PreferenceId result, Part part, Symbol symbol) {
  ValueDraft out;
  out.symbol = symbol;
  if (!symbol) return out;
  const InstantiationId firing = uses_.memory.preference(result).instantiation;
  const Said term = reader_.TermOf(result, part);
  switch (term.kind) {
    case Said::Kind::kClass:
    case Said::Kind::kSymbol: {
      // A constant that no condition tests is what the architecture said of the substate.
      const IdentityGraph::Node node = analysis_.OfTerm(term, firing);
      if (symbol.IsIdentifier() || PlaceOf(node) != nullptr) {
        out.symbol = Meaning(node, symbol);
      } else if (HasVariable(node)) {
        // A negated condition has it, and its variables are its own: the action makes something new, as in Soar 9.6.3.
        Symbol& made = variable_of_symbol_[symbol.bits()];
        if (!made) made = NewVariable(symbol);
        out.symbol = made;
      }
      break;
    }
    case Said::Kind::kUnknown:
      if (symbol.IsIdentifier()) out.symbol = VariableOfIdentifier(symbol);
      break;
    case Said::Kind::kFunction:
      if (!symbol.IsIdentifier()) {
        out = MakeFunction(*term.function, firing);
      } else {
        out.symbol = VariableOfIdentifier(symbol);
      }
      break;
    case Said::Kind::kLiteral:
      break;
  }
  return out;
}

void RuleBuilder::MakeActions(const Explanation& explanation) {
  // The list is newest first, so the last result is made first.
  actions_.assign(explanation.results.size(), nullptr);
  for (std::size_t n = explanation.results.size(); n-- > 0;) {
    const PreferenceId result = explanation.results[n];
    const Preference& preference = uses_.memory.preference(result);
    ActionDraft* const action = arena_.New<ActionDraft>();
    action->preference = preference.type;
    action->id = MakeTerm(result, Part::kId, preference.id);
    action->attribute = MakeTerm(result, Part::kAttribute, preference.attribute);
    action->value = MakeTerm(result, Part::kValue, preference.value);
    if (action->HasReferent()) action->referent = MakeTerm(result, Part::kReferent, preference.referent);
    actions_[n] = action;
  }
}

// Finishing -----------------------------------------------------------------------------------------------------------

namespace {

/// A rule's constants stay as long as the agent.
class Pinner {
 public:
  explicit Pinner(SymbolTable& symbols) : symbols_(symbols) {}

  void Pin(const DraftList<ConditionDraft>& conditions) {
    for (const ConditionDraft& condition : conditions) {
      for (const TestDraft* test : {&condition.id, &condition.attribute, &condition.value}) Pin(*test);
      Pin(condition.conditions);
    }
  }
  void Pin(const DraftList<ActionDraft>& actions) {
    for (const ActionDraft& action : actions) {
      for (const ValueDraft* value : {&action.id, &action.attribute, &action.value, &action.referent}) Pin(*value);
    }
  }

 private:
  void Pin(const TestDraft& test) {
    Pin(test.referent);
    for (std::uint32_t n = 0; n < test.disjunct_count; ++n) Pin(test.disjuncts[n]);
    for (const TestDraft& part : test.parts) Pin(part);
  }
  void Pin(const ValueDraft& value) {
    Pin(value.symbol);
    for (const ValueDraft& argument : value.arguments) Pin(argument);
  }
  void Pin(Symbol symbol) {
    if (!symbol.IsConstant()) return;
    Symbol& lately = lately_[symbol.bits() * 0x9E3779B1u >> (32 - kLatelyBits)];
    if (lately == symbol) return;
    lately = symbol;
    if (symbol.IsString()) {
      symbols_.String(std::string(symbols_.Text(symbol)));
    } else if (symbol.IsInteger()) {
      symbols_.Integer(symbols_.IntegerValue(symbol));
    } else if (symbol.IsFloat()) {
      symbols_.Float(symbols_.FloatValue(symbol));
    }
  }

  static constexpr unsigned kLatelyBits = 5;
  SymbolTable& symbols_;
  std::array<Symbol, std::size_t{1} << kLatelyBits> lately_;  ///< Pinned: rules name few constants, again and again.
};

}  // namespace

bool RuleBuilder::Finish(std::string_view name) {
  const SymbolTable::PinScope pinned(uses_.symbols);
  RuleDraft rule;
  rule.name = name;
  rule.type = ProductionType::kChunk;
  // Both lists are linked anew at each attempt, through copies of their items.
  ConditionDraft* const copies_of_made = arena_.NewRoom<ConditionDraft>(made_.size());
  for (std::size_t n = 0; n < made_.size(); ++n) {
    rule.conditions.Add(new (copies_of_made + n) ConditionDraft(Copy(*made_[n].draft, arena_)));
  }
  ConditionDraft* const copies_of_negated = arena_.NewRoom<ConditionDraft>(negated_.size());
  for (std::size_t n = 0; n < negated_.size(); ++n) {
    rule.conditions.Add(new (copies_of_negated + n) ConditionDraft(Copy(*negated_[n], arena_)));
  }
  std::vector<const ActionDraft*> copies(actions_.size());
  for (std::size_t n = actions_.size(); n-- > 0;) {
    ActionDraft* const copy = arena_.New<ActionDraft>(*actions_[n]);
    copies[n] = copy;
    rule.actions.Add(copy);
  }
  VariableIndex variables;
  variables.NumberAll(rule.conditions);
  variables.NumberAll(rule.actions);
  hanging_ = Unconnected(rule.conditions, variables);
  if (!hanging_.empty() && ActionsAreGrounded()) {
    std::string text = "Conditions on the LHS contain tests that are not connected \nto a goal: ";
    for (std::size_t n = 0; n < hanging_.size(); ++n) {
      text.append(n == 0 ? "" : ", ").append(uses_.symbols.Text(hanging_[n]));
    }
    uses_.observers.Warn(WarningKind::kLearnedRule, text + "\n\n");
    return false;
  }
  Pinner pinner(uses_.symbols);
  pinner.Pin(rule.conditions);
  pinner.Pin(rule.actions);
  ParseOutcome out;
  if (!FinishRule(rule, variables, SourcePlace{}, uses_.symbols, uses_.expected_values, arena_, out)) {
    for (const RuleMessage& message : out.late_messages) uses_.observers.Warn(WarningKind::kLearnedRule, message.text);
    return false;
  }
  elements_.clear();
  turned_tests_.clear();
  ground_of_condition_.clear();
  negation_of_condition_.clear();
  for (ConditionDraft& condition : rule.conditions) {
    if (condition.kind != ConditionKind::kPositive) {
      negation_of_condition_.push_back(static_cast<std::uint32_t>(&condition - copies_of_negated));
      continue;
    }
    const Made& made = made_[static_cast<std::size_t>(&condition - copies_of_made)];
    for (const Field field : {Field::kId, Field::kAttribute, Field::kValue}) {
      for (const TestDraft& part : FieldOf(condition, field).parts) {
        if (part.is_turned)
          turned_tests_.push_back({static_cast<std::uint16_t>(elements_.size()), field, part.kind, part.referent});
      }
    }
    elements_.push_back(made.wme);
    ground_of_condition_.push_back(made.ground);
  }
  action_of_result_.assign(actions_.size(), 0);
  std::uint16_t number = 0;
  for (const ActionDraft& action : rule.actions) {
    const auto found = std::ranges::find(copies, &action);
    action_of_result_[static_cast<std::size_t>(found - copies.begin())] = number++;
  }
  rule_ = Production::Make(rule);
  return true;
}

std::uint32_t RuleBuilder::OrderOf(IdentityGraph::Node node) const {
  const IdentityGraph::Node root = analysis_.graph().Root(node);
  return root < order_of_.size() ? order_of_[root] : 0;
}

std::string RuleBuilder::VariableNameOf(IdentityGraph::Node node) const {
  const IdentityGraph::Node root = analysis_.graph().Root(node);
  const Symbol variable = root < variable_of_.size() ? variable_of_[root] : Symbol();
  return variable ? std::string(uses_.symbols.Text(variable)) : std::string();
}

void RuleBuilder::CountConstraints() {
  for (const Condition& condition : rule_->conditions) {
    if (condition.kind != ConditionKind::kPositive) continue;
    for (const Test* test : {&condition.id, &condition.attribute, &condition.value}) {
      ForEachTest(*test, [&](const Test& part) {
        if (part.kind != TestKind::kEqual && part.kind != TestKind::kBlank) ++operational_constraints_;
      });
    }
  }
  uses_.statistics.operational_constraints += operational_constraints_;
}

/// Identity sets of a justification as classes: what learns above it generalises through it.
IdentityPlan RuleBuilder::PlanOfJustification(const Explanation& explanation) {
  IdentityPlan plan;
  class_of_.clear();
  IdentityGraph& graph = analysis_.graph();
  for (const Explanation::Ground& ground : explanation.grounds) {
    for (const Field field : {Field::kId, Field::kAttribute, Field::kValue}) {
      const IdentityGraph::Node node = analysis_.OfGround(ground, field);
      std::uint16_t known = IdentityPlan::kLiteral;
      if (node != IdentityGraph::kNone && !graph.literal(node)) {
        const auto [place, is_new] = class_of_.try_emplace(graph.Root(node), plan.bound());
        known = place->second;
        if (is_new) {
          plan.first.push_back(static_cast<std::uint16_t>(plan.of_field.size()));
          plan.variables.emplace_back();
        }
      }
      plan.of_field.push_back(known);
    }
  }
  std::uint16_t next = plan.bound();
  for (const PreferenceId result : explanation.results) {
    const Preference& preference = uses_.memory.preference(result);
    for (const Part part : {Part::kId, Part::kAttribute, Part::kValue, Part::kReferent}) {
      const Said term = reader_.TermOf(result, part);
      const IdentityGraph::Node node = analysis_.OfTerm(term, preference.instantiation);
      std::uint16_t known = IdentityPlan::kLiteral;
      if (node != IdentityGraph::kNone && !graph.literal(node)) {
        const auto [place, is_new] = class_of_.try_emplace(graph.Root(node), next);
        if (is_new) ++next;
        known = place->second;
      }
      plan.of_action.push_back(known);
    }
  }
  return plan;
}

ValueDraft RuleBuilder::MoveFunction(const RhsValue& function, InstantiationId firing, const IdentityPlan& plan) {
  ValueDraft out;
  out.kind = RhsValueKind::kFunction;
  out.index = function.function_index();
  for (const RhsValue& argument : function.arguments()) {
    ValueDraft copy;
    if (argument.kind == RhsValueKind::kFunction) {
      copy = MoveFunction(argument, firing, plan);
    } else if (argument.kind == RhsValueKind::kBound) {
      const Wme& wme = uses_.memory.wme(uses_.instantiations.Trace(firing)[argument.site().positive_condition].wme);
      copy.symbol = kernel::FieldOf(wme, argument.site().field);
      const IdentityGraph::Node node = analysis_.OfClass(firing, reader_.ClassOf(argument, firing));
      const auto known = node == IdentityGraph::kNone || analysis_.graph().literal(node)
                             ? class_of_.end()
                             : class_of_.find(analysis_.graph().Root(node));
      if (known != class_of_.end() && known->second < plan.bound()) {
        const std::uint16_t place = plan.first[known->second];
        copy.kind = RhsValueKind::kBound;
        copy.site = {static_cast<std::uint16_t>(place / 3u), static_cast<Field>(place % 3u)};
      }
    } else {
      copy.symbol = argument.symbol();
    }
    out.arguments.Add(arena_.New(copy));
  }
  return out;
}

ProductionPtr RuleBuilder::FunctionsOfJustification(const Explanation& explanation, const IdentityPlan& plan) {
  arena_.Clear();
  RuleDraft rule;
  bool any = false;
  for (const PreferenceId result : explanation.results) {
    const Preference& preference = uses_.memory.preference(result);
    ActionDraft* const action = arena_.New<ActionDraft>();
    action->preference = PreferenceType::kAcceptable;
    action->id.symbol = preference.id;
    action->attribute.symbol = preference.attribute;
    action->value.symbol = preference.value;
    for (const auto& [part, value, symbol] : {std::tuple{Part::kAttribute, &action->attribute, preference.attribute},
                                              std::tuple{Part::kValue, &action->value, preference.value}}) {
      const Said term = reader_.TermOf(result, part);
      if (term.kind != Said::Kind::kFunction || symbol.IsIdentifier()) continue;
      *value = MoveFunction(*term.function, preference.instantiation, plan);
      any = true;
    }
    rule.actions.Add(action);
  }
  return any ? Production::Make(rule) : ProductionPtr();
}

}  // namespace soarbox::kernel
