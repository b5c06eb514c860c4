// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/rules/finish_rule.h"

#include <utility>

#include "kernel/base/known_symbols.h"
#include "kernel/rules/chunk_variables.h"
#include "kernel/rules/print_production.h"
#include "kernel/rules/reorder.h"

namespace soarbox::kernel {

namespace {

void AddTrap(ParseOutcome& out, const SourcePlace& place, Severity severity, std::string message, std::string hint) {
  Diagnostic diagnostic;
  diagnostic.severity = severity;
  diagnostic.file = place.file.text();
  diagnostic.line = place.line;
  diagnostic.column = place.column;
  diagnostic.message = std::move(message);
  diagnostic.hint = std::move(hint);
  out.diagnostics.push_back(std::move(diagnostic));
}

/// The variables that are bound before an action.
class KnownVariables {
 public:
  KnownVariables(const RuleDraft& rule, const VariableIndex& variables, Arena& arena)
      : known_(arena.NewArray<bool>(variables.size())) {
    for (const ConditionDraft& condition : rule.conditions) {
      if (condition.kind == ConditionKind::kPositive) {
        Add(EqualityVariable(condition.id));
        Add(EqualityVariable(condition.attribute));
        Add(EqualityVariable(condition.value));
      }
    }
  }

  void Add(std::uint32_t variable) {
    if (variable != kNoVariable) {
      known_[variable] = true;
    }
  }
  bool Has(std::uint32_t variable) const { return variable != kNoVariable && known_[variable]; }

 private:
  bool* known_;
};

/// The variables in a function's arguments must be bound before it is called. A variable alone may be a new identifier.
bool FunctionIsReady(const ValueDraft& value, const KnownVariables& known) {
  for (const ValueDraft& argument : value.arguments) {
    if (argument.kind == RhsValueKind::kFunction ? !FunctionIsReady(argument, known)
                                                 : argument.variable != kNoVariable && !known.Has(argument.variable)) {
      return false;
    }
  }
  return true;
}

bool IsReady(const ValueDraft& value, const KnownVariables& known) {
  return value.kind != RhsValueKind::kFunction || FunctionIsReady(value, known);
}

bool IsReady(const ActionDraft& action, const KnownVariables& known) {
  if (action.is_function_call) {
    return FunctionIsReady(action.value, known);
  }
  return known.Has(action.id.variable) && IsReady(action.attribute, known) && IsReady(action.value, known) &&
         IsReady(action.referent, known);
}

/// Orders the actions so that each identifier is bound before its use. Returns false if some identifier is never bound.
bool OrderActions(RuleDraft& rule, const VariableIndex& variables, const SymbolTable& symbols, Arena& arena,
                  ParseOutcome& out, const SourcePlace& place) {
  KnownVariables known(rule, variables, arena);
  DraftList<ActionDraft> ordered;
  ActionDraft* waiting = rule.actions.first;
  for (bool progress = true; progress && waiting != nullptr;) {
    progress = false;
    for (ActionDraft** link = &waiting; *link != nullptr; link = &(*link)->next) {
      ActionDraft* const action = *link;
      if (!IsReady(*action, known)) {
        continue;
      }
      known.Add(action->attribute.variable);
      known.Add(action->value.variable);
      known.Add(action->referent.variable);
      *link = action->next;
      ordered.Add(action);
      progress = true;
      break;
    }
  }
  rule.actions = ordered;
  if (waiting == nullptr) {
    return true;
  }
  std::string text =
      "Attempted to add rule with ungrounded action(s).\n"
      "The following RHS actions contain variables that are not tested\n"
      "in a positive condition on the LHS: \n\n";
  for (const ActionDraft* action = waiting; action != nullptr; action = action->next) {
    std::string line;
    AppendUngroundedAction(line, symbols, *action);
    text += "        " + line + "\n";
    AddTrap(out, place, Severity::kError, "the action " + line + " uses a variable that no condition binds",
            "bind it in a positive condition, or link it to a state in another action");
  }
  out.late_messages.push_back({text + "\n", true, true});
  return false;
}

/// Determines for each variable of the actions where it is bound, or which new identifier it represents.
class Binder {
 public:
  Binder(RuleDraft& rule, const VariableIndex& variables, Arena& arena)
      : rule_(rule), places_(arena.NewArray<Place>(variables.size())) {
    std::uint16_t position = 0;
    for (const ConditionDraft& condition : rule.conditions) {
      if (condition.kind != ConditionKind::kPositive) {
        continue;
      }
      Note(condition.id, position, Field::kId);
      Note(condition.attribute, position, Field::kAttribute);
      Note(condition.value, position, Field::kValue);
      ++position;
    }
  }

  void Bind(ValueDraft& value) {
    if (value.kind == RhsValueKind::kFunction) {
      for (ValueDraft& argument : value.arguments) {
        Bind(argument);
      }
      return;
    }
    if (value.variable == kNoVariable) {
      return;
    }
    Place& place = places_[value.variable];
    if (place.kind == RhsValueKind::kConstant) {
      place.kind = RhsValueKind::kNew;
      place.index = static_cast<std::uint16_t>(rule_.new_identifiers.size());
      rule_.new_identifiers.push_back(value.symbol);
    }
    value.kind = place.kind;
    value.site = place.site;
    value.index = place.index;
  }

 private:
  /// The meaning of a variable; kConstant while it is unknown.
  struct Place {
    RhsValueKind kind = RhsValueKind::kConstant;
    BindingSite site;
    std::uint16_t index = 0;
  };

  void Note(const TestDraft& test, std::uint16_t position, Field field) {
    const std::uint32_t variable = EqualityVariable(test);
    if (variable == kNoVariable) {
      return;
    }
    Place& place = places_[variable];
    if (place.kind == RhsValueKind::kConstant) {
      place.kind = RhsValueKind::kBound;
      place.site = {position, field};
    }
  }

  RuleDraft& rule_;
  Place* places_;
};

bool TestsGoal(const TestDraft& test) {
  if (test.kind == TestKind::kState || test.kind == TestKind::kImpasse) {
    return true;
  }
  for (const TestDraft& part : test.parts) {
    if (TestsGoal(part)) {
      return true;
    }
  }
  return false;
}

/// Returns true if a positive condition tests that the variable is a state.
bool IsTestedGoal(const RuleDraft& rule, Symbol variable) {
  for (const ConditionDraft& condition : rule.conditions) {
    if (condition.kind == ConditionKind::kPositive && TestsGoal(condition.id) &&
        EqualitySymbol(condition.id) == variable) {
      return true;
    }
  }
  return false;
}

/// True for attributes of states that the architecture creates. A rule that creates another value for one is probably
/// wrong.
bool IsArchitectureLink(Symbol attribute) {
  for (const Symbol link :
       {words::kSuperstate, words::kType, words::kIo, words::kImpasse, words::kRewardLink, words::kEpmem, words::kSmem,
        words::kQuiescence, words::kChoices, words::kAttribute, words::kItem}) {
    if (link == attribute) {
      return true;
    }
  }
  return false;
}

void WarnOfArchitectureLinks(const RuleDraft& rule, const SymbolTable& symbols, const SourcePlace& place,
                             ParseOutcome& out) {
  for (const ActionDraft& action : rule.actions) {
    if (!action.is_function_call && action.preference == PreferenceType::kAcceptable &&
        action.attribute.kind == RhsValueKind::kConstant && IsArchitectureLink(action.attribute.symbol) &&
        IsTestedGoal(rule, action.id.symbol)) {
      AddTrap(out, place, Severity::kWarning,
              std::string(rule.name) + " creates ^" + ToString(symbols, action.attribute.symbol) +
                  " on a state, in addition to the one that the architecture creates",
              "use another attribute");
    }
  }
}

void BindVariables(RuleDraft& rule, const VariableIndex& variables, Arena& arena) {
  Binder binder(rule, variables, arena);
  for (ActionDraft& action : rule.actions) {
    for (ValueDraft* value : {&action.id, &action.attribute, &action.value, &action.referent}) {
      binder.Bind(*value);
    }
  }
}

/// A template has one action, a numeric preference, whose number may be a variable.
bool IsTemplate(const RuleDraft& rule) {
  const ActionDraft* const action = rule.actions.first;
  return action != nullptr && action == rule.actions.last && !action->is_function_call &&
         (action->preference == PreferenceType::kNumericIndifferent ||
          action->preference == PreferenceType::kBinaryIndifferent);
}

}  // namespace

bool FinishRule(RuleDraft& rule, const VariableIndex& variables, const SourcePlace& place, SymbolTable& symbols,
                const ExpectedValues& expected, Arena& arena, ParseOutcome& out) {
  if (!OrderActions(rule, variables, symbols, arena, out, place)) {
    return false;
  }
  ReorderOutcome order = ReorderConditions(rule, variables, expected, symbols, arena);
  for (RuleMessage& message : order.messages) {
    if (!order.ok && message.text.starts_with("Error: ")) {
      AddTrap(out, place, Severity::kError, message.text.substr(7, message.text.find('\n') - 7), "");
    }
    out.late_messages.push_back(std::move(message));
  }
  if (!order.ok) {
    return false;
  }
  for (const Symbol variable : order.unconnected) {
    const std::string text(symbols.Text(variable));
    AddTrap(out, place, Severity::kWarning,
            ToString(symbols, symbols.String(rule.name)) + ": " + text +
                " is not connected to a state; the rule will look at all of working memory",
            "link it to a state, as in (state <s> ^thing " + text + ")");
  }
  if (rule.type == ProductionType::kTemplate && !IsTemplate(rule)) {
    const std::string name = ToString(symbols, symbols.String(rule.name));
    out.late_messages.push_back({"Invalid Soar-RL template (" + name + ")\n\n", false, false});
    out.is_told = true;
    AddTrap(out, place, Severity::kError, name + " is a template, but has other actions than one numeric preference",
            "give it one action: (<s> ^operator <o> = 0.0)");
    return false;
  }
  if (rule.explain) {
    out.late_messages.push_back(
        {"Now watching any chunks formed by rule '" + std::string(rule.name) + "'\n", false, false});
  }
  if (rule.type == ProductionType::kChunk) RenameVariables(rule, variables, symbols);
  BindVariables(rule, variables, arena);
  rule.is_rl = rule.type != ProductionType::kTemplate && rule.actions.first != nullptr &&
               rule.actions.first == rule.actions.last &&
               rule.actions.first->preference == PreferenceType::kNumericIndifferent;
  WarnOfArchitectureLinks(rule, symbols, place, out);
  return true;
}

}  // namespace soarbox::kernel
