// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/learn/rule_builder.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <new>
#include <string>
#include <tuple>
#include <utility>

#include "kernel/base/known_symbols.h"
#include "kernel/base/symbol_table.h"
#include "kernel/decide/instantiation_table.h"
#include "kernel/decide/observers.h"
#include "kernel/learn/draft_tests.h"
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
  variable_of_.clear();
  variable_of_symbol_.clear();
  identifier_of_variable_.clear();
  actions_.clear();
  letters_ = {};
  merged_conditions_ = merged_disjunctions_ = operational_constraints_ = 0;
  rule_ = nullptr;
  MakeConditions(explanation);
  carried_.Collect(explanation, constraints_);
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
  if (root >= variable_of_.size()) variable_of_.resize(analysis_.graph().size());
  Symbol& variable = variable_of_[root];
  if (!variable) variable = NewVariable(value);
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
  // The tests refer to variables of other fields, so they are added after all variables are known.
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

/// Adds the other tests of the fired rule for this field, except comparisons with objects that the learned rule cannot
/// access.
void RuleBuilder::AddOwnTests(const Explanation::Ground& ground, Field field, TestDraft& out) {
  if (ground.firing == InstantiationId::kNone) return;
  carried_.ForEach(ground.firing, ground.condition, field, [&](const CarriedTest& carried) {
    if (!carried_.MayRise(carried)) return;
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

void RuleBuilder::PlaceConstraints() {
  LearnStatistics& statistics = uses_.statistics;
  statistics.constraints_found += constraints_.size();
  for (CarriedTest& constraint : constraints_) {
    constraint.placed = PlaceConstraint(constraint);
    if (constraint.placed) ++statistics.constraints_placed;
  }
}

/// Adds the test to the first field of the tested identity. If that is not possible, adds it with swapped sides to the
/// first field of the other identity.
bool RuleBuilder::PlaceConstraint(const CarriedTest& constraint) {
  TestDraft* const here = PlaceOf(constraint.tested);
  TestDraft* const there = PlaceOf(constraint.referent_node);
  if (here == nullptr && (there == nullptr || constraint.kind == TestKind::kDisjunction)) return false;
  // An object of the substate has no meaning at higher levels. As in Soar, the test is counted nevertheless.
  if (here == nullptr || there == nullptr) {
    const Symbol other = here == nullptr ? constraint.value : constraint.referent;
    if (!carried_.IsKnownAbove(constraint.firing, other)) return true;
  }
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
  // A comparison with an object of the substate has no meaning at higher levels.
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
      // The variable occurs only in this condition.
      Symbol& own = own_variables_[draft.referent.bits()];
      if (!own) own = NewVariable(Symbol());
      draft.referent = own;
    } else {
      const Symbol value = ValueOfClass(plan, bound, uses_.instantiations.Trace(firing), uses_.memory);
      const IdentityGraph::Node node = analysis_.OfClass(firing, bound);
      // (A constant without a field comes from an element of the architecture in the substate. As in Soar, it matches
      // anything here.)
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
    // A constant in a justification may represent a variable that one of its conditions binds.
    std::vector<std::pair<TestDraft*, std::uint16_t>> bound;
    if (!negation.classes.empty()) {
      std::size_t number = 0;
      ForEachTest(*draft, [&](TestDraft& test) {
        const std::size_t here = number++;
        const bool is_constant = test.referent && !test.referent.IsIdentifier() && !test.referent.IsVariable();
        if (is_constant && here < negation.classes.size() && negation.classes[here] != IdentityPlan::kLiteral)
          bound.emplace_back(&test, negation.classes[here]);
      });
    }
    VariablizeNegated(*draft, negation.firing);
    for (const auto& [test, its_class] : bound) {
      test->referent = Meaning(analysis_.OfClass(negation.firing, its_class), test->referent);
    }
    negated_.push_back(draft);
  }
}

// Merging -------------------------------------------------------------------------------------------------------------

void RuleBuilder::MergeConditions() {
  LearnStatistics& statistics = uses_.statistics;
  // Most elements belong to one condition only.
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
      // (Other tests of the later condition's identifier are dropped, as in Soar 9.6.3.)
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

/// Adds a state test for each state whose elements the rule tests. (If one state is linked to the next, reordering
/// drops the test.)
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
      // A constant that no condition tests comes from an element of the architecture in the substate.
      const IdentityGraph::Node node = analysis_.OfTerm(term, firing);
      if (symbol.IsIdentifier() || PlaceOf(node) != nullptr) {
        out.symbol = Meaning(node, symbol);
      } else if (HasVariable(node)) {
        // The symbol is in a negated condition, whose variables are local: the action creates a new identifier, as in
        // Soar 9.6.3.
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
  // The list is newest first, so the last result is built first.
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

/// Pins the constants of a rule for the lifetime of the agent.
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
  std::array<Symbol, std::size_t{1} << kLatelyBits> lately_;  ///< Pinned recently.
};

}  // namespace

bool RuleBuilder::Finish(std::string_view name) {
  const SymbolTable::PinScope pinned(uses_.symbols);
  RuleDraft rule;
  rule.name = name;
  rule.type = ProductionType::kChunk;
  // Each attempt links copies of the conditions and actions into new lists.
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

}  // namespace soarbox::kernel
