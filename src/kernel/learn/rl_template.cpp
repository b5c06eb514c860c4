// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/learn/rl_template.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <utility>

#include "kernel/base/characters.h"
#include "kernel/base/symbol_table.h"
#include "kernel/decide/rule_changes.h"
#include "kernel/memory/working_memory.h"
#include "kernel/rules/expected_values.h"
#include "kernel/rules/finish_rule.h"

namespace soarbox::kernel {

namespace {

/// Replaces a template's variables by the symbols of a match.
class Substitution {
 public:
  Substitution(SymbolTable& symbols, const WorkingMemory& memory, Arena& arena)
      : symbols_(symbols), memory_(memory), arena_(arena) {}

  /// Binds variables in positive conditions to the values of the matched element.
  void Bind(const Condition& condition, const Wme& wme) {
    Bind(condition.id, wme.id);
    Bind(condition.attribute, wme.attribute);
    Bind(condition.value, wme.value);
  }

  ConditionDraft Positive(const Condition& condition, const Wme& wme) {
    ConditionDraft draft;
    draft.tests_acceptable = condition.tests_acceptable;
    draft.id = Field(condition.id, wme.id);
    if (memory_.identifier(wme.id).is_goal && std::ranges::find(goals_, wme.id) == goals_.end()) {
      goals_.push_back(wme.id);
      draft.id = And(MakeTest(TestKind::kState), draft.id);
    }
    draft.attribute = Field(condition.attribute, wme.attribute);
    draft.value = Field(condition.value, wme.value);
    return draft;
  }

  ConditionDraft Negative(const Condition& condition) {
    ConditionDraft draft = ToDraft(condition, arena_);
    Substitute(draft);
    return draft;
  }

  /// For constants, the constant, which the rule must keep; for identifiers, their variable.
  Symbol TermOf(Symbol symbol) {
    if (symbol.IsIdentifier()) {
      const auto known = std::ranges::find(variables_, symbol, &Pair::first);
      if (known != variables_.end()) return known->second;
      return variables_.emplace_back(symbol, NewVariable(ToLower(symbols_.Letter(symbol)))).second;
    }
    SymbolTable& symbols = symbols_;  // Interning pins symbols that only an element uses.
    if (symbol.IsFloat()) return symbols.Float(symbols.FloatValue(symbol));
    if (symbol.IsInteger()) return symbols.Integer(symbols.IntegerValue(symbol));
    return symbol.IsString() ? symbols.String(std::string(symbols.Text(symbol))) : symbol;
  }

 private:
  using Pair = std::pair<Symbol, Symbol>;

  void Bind(const Test& test, Symbol symbol) {
    const Symbol variable = EqualitySymbol(test);
    if (variable.IsVariable()) bindings_.emplace_back(variable, symbol);
  }

  Symbol NewVariable(char letter) {
    const int number = ++counts_[static_cast<std::size_t>(letter - 'a')];
    return symbols_.Variable("<" + std::string(1, letter) + std::to_string(number) + ">");
  }

  /// One conjunction of both tests, each of which may be a conjunction.
  TestDraft And(const TestDraft& first, const TestDraft& second) {
    TestDraft both = MakeTest(TestKind::kConjunction);
    for (const TestDraft* test : {&first, &second}) {
      if (test->kind != TestKind::kConjunction) {
        both.parts.Add(arena_.New(*test));
      } else {
        both.parts.Append(test->parts);
      }
    }
    return both;
  }

  TestDraft Field(const Test& test, Symbol symbol) {
    TestDraft made = MakeTest(TestKind::kEqual, TermOf(symbol));
    if (!symbol.IsIdentifier()) return made;
    for (const Test& part : test.parts()) {
      if (part.kind != TestKind::kNotEqual || !part.referent().IsVariable()) continue;
      const auto other = std::ranges::find(bindings_, part.referent(), &Pair::first);
      if (other == bindings_.end() || !other->second.IsIdentifier()) continue;
      made = And(made, MakeTest(TestKind::kNotEqual, TermOf(other->second)));
    }
    return made;
  }

  void Substitute(ConditionDraft& condition) {
    Substitute(condition.id);
    Substitute(condition.attribute);
    Substitute(condition.value);
    for (ConditionDraft& inner : condition.conditions) Substitute(inner);
  }

  void Substitute(TestDraft& test) {
    if (test.referent.IsVariable()) {
      auto bound = std::ranges::find(bindings_, test.referent, &Pair::first);
      if (bound != bindings_.end()) {
        test.referent = TermOf(bound->second);
      } else {
        // A variable of the negation itself: it gets an unused name.
        auto own = std::ranges::find(own_, test.referent, &Pair::first);
        test.referent = own != own_.end() ? own->second : own_.emplace_back(test.referent, NewVariable('v')).second;
      }
    }
    for (TestDraft& part : test.parts) Substitute(part);
  }

  SymbolTable& symbols_;
  const WorkingMemory& memory_;
  Arena& arena_;
  std::vector<Pair> bindings_;   ///< Variables of the template and their values.
  std::vector<Pair> variables_;  ///< Identifiers and their variables in the new rule.
  std::vector<Pair> own_;        ///< Variables of negations: in the template and in the new rule.
  std::vector<Symbol> goals_;    ///< States that have a state test already.
  std::array<int, 26> counts_{};
};

}  // namespace

RlTemplates::Pattern RlTemplates::PatternOf(ProductionId source, std::span<const WmeId> wmes) const {
  Pattern pattern{Index(source)};
  std::vector<Symbol> seen;
  const auto add = [&](Symbol symbol) {
    if (!symbol.IsIdentifier()) {
      pattern.push_back(std::uint64_t{1} << 32 | symbol.bits());
      return;
    }
    auto at = std::ranges::find(seen, symbol);
    if (at == seen.end()) at = seen.insert(at, symbol);
    const bool is_goal = uses_.memory.identifier(symbol).is_goal;
    pattern.push_back(static_cast<std::uint64_t>(is_goal ? 3 : 2) << 32 |
                      static_cast<std::uint64_t>(at - seen.begin()));
  };
  for (const WmeId id : wmes) {
    const Wme& wme = uses_.memory.wme(id);
    add(wme.id);
    add(wme.attribute);
    add(wme.value);
  }
  return pattern;
}

void RlTemplates::Instantiate(ProductionId source, const Production& rule, std::span<const WmeId> wmes, Symbol value) {
  if (!value.IsNumber()) return;
  Pattern pattern = PatternOf(source, wmes);
  if (made_.contains(pattern)) return;
  const std::uint64_t number = next_;
  std::string name;
  do {
    name = "rl*" + std::string(rule.name) + "*" + std::to_string(next_++);
  } while (uses_.rule_changes.Find(name) != ProductionId::kNone);
  const ProductionPtr made = Build(rule, wmes, value, name);
  if (made == nullptr) {
    next_ = number;
    return;
  }
  const RuleChanges::Outcome outcome = uses_.rule_changes.Add(made);
  if (!outcome.loaded) next_ = number;
  if (outcome.production != ProductionId::kNone) made_.emplace(std::move(pattern), outcome.production);
}

ProductionPtr RlTemplates::Build(const Production& rule, std::span<const WmeId> wmes, Symbol value,
                                 std::string_view name) const {
  if (rule.actions.size() != 1) return nullptr;
  const SymbolTable::PinScope pin(uses_.symbols);
  Arena arena;
  Substitution substitution(uses_.symbols, uses_.memory, arena);
  std::size_t place = 0;
  for (const Condition& condition : rule.conditions) {
    if (condition.kind == ConditionKind::kPositive) substitution.Bind(condition, uses_.memory.wme(wmes[place++]));
  }
  RuleDraft draft;
  draft.name = name;
  place = 0;
  for (const Condition& condition : rule.conditions) {
    draft.conditions.Add(arena.New(condition.kind == ConditionKind::kPositive
                                       ? substitution.Positive(condition, uses_.memory.wme(wmes[place++]))
                                       : substitution.Negative(condition)));
  }
  const Action& source = rule.actions.front();
  const auto term = [&](const RhsValue& written) {
    ValueDraft made;
    if (written.kind == RhsValueKind::kBound) {
      made.symbol =
          substitution.TermOf(FieldOf(uses_.memory.wme(wmes[written.site().positive_condition]), written.site().field));
    } else if (written.kind == RhsValueKind::kConstant) {
      made.symbol = written.symbol();
    }
    return made;
  };
  ActionDraft* const action = arena.New<ActionDraft>();
  action->preference = PreferenceType::kNumericIndifferent;
  action->id = term(source.id);
  action->attribute = term(source.attribute);
  action->value = term(source.value);
  action->referent.symbol = substitution.TermOf(value);
  if (!action->id.symbol || !action->attribute.symbol || !action->value.symbol) return nullptr;
  draft.actions.Add(action);

  VariableIndex variables;
  variables.NumberAll(draft.conditions);
  variables.NumberAll(draft.actions);
  ParseOutcome out;
  if (!FinishRule(draft, variables, {}, uses_.symbols, uses_.expected_values, arena, out)) return nullptr;
  return Production::Make(draft);
}

void RlTemplates::RuleAdded(std::string_view name) {
  if (!name.starts_with("rl*")) return;
  const std::size_t star = name.rfind('*');
  if (star == 2) return;
  const std::string_view digits = name.substr(star + 1);
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (digits.empty() || error != std::errc() || end != digits.data() + digits.size()) return;
  if (number >= next_ && number + 1 != 0) next_ = number + 1;
}

void RlTemplates::RuleExcised(ProductionId rule) {
  std::erase_if(made_, [&](const auto& entry) { return entry.second == rule || entry.first.front() == Index(rule); });
}

}  // namespace soarbox::kernel
