// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/rules/finish_rule.h"

#include <algorithm>
#include <utility>

#include "kernel/base/words.h"
#include "kernel/rules/chunk_variables.h"
#include "kernel/rules/print_production.h"
#include "kernel/rules/reorder.h"
#include "kernel/rules/rule_reader.h"

namespace soarbox::kernel {

namespace {

void AddTrap(ParseOutcome& out, const SourcePlace& place, Severity severity, std::string message, std::string hint) {
  Diagnostic diagnostic;
  diagnostic.severity = severity;
  diagnostic.file = place.file;
  diagnostic.line = place.line;
  diagnostic.column = place.column;
  diagnostic.message = std::move(message);
  diagnostic.hint = std::move(hint);
  out.diagnostics.push_back(std::move(diagnostic));
}

VariableSet VariablesOfPositiveConditions(const std::vector<Condition>& conditions) {
  VariableSet out;
  for (const Condition& condition : conditions) {
    if (condition.kind == ConditionKind::kPositive) {
      out.Add(EqualitySymbol(condition.id));
      out.Add(EqualitySymbol(condition.attribute));
      out.Add(EqualitySymbol(condition.value));
    }
  }
  return out;
}

/// The arguments of a function must be known before it is called; a plain variable may stand for a new identifier.
bool FunctionIsReady(const RhsValue& value, const VariableSet& known) {
  for (const RhsValue& argument : value.arguments) {
    if (argument.kind == RhsValueKind::kFunction ? !FunctionIsReady(argument, known)
                                                 : argument.symbol.IsVariable() && !known.Has(argument.symbol)) {
      return false;
    }
  }
  return true;
}

bool IsReady(const RhsValue& value, const VariableSet& known) {
  return value.kind != RhsValueKind::kFunction || FunctionIsReady(value, known);
}

bool IsReady(const Action& action, const VariableSet& known) {
  if (action.is_function_call) {
    return FunctionIsReady(action.value, known);
  }
  return known.Has(action.id.symbol) && IsReady(action.attribute, known) && IsReady(action.value, known) &&
         IsReady(action.referent, known);
}

/// Puts each action behind those that make its identifier known. False if some hang on nothing.
bool OrderActions(Production& rule, const SymbolTable& symbols, ParseOutcome& out, const SourcePlace& place) {
  VariableSet known = VariablesOfPositiveConditions(rule.conditions);
  std::vector<Action> ordered;
  ordered.reserve(rule.actions.size());
  std::vector<Action> waiting = std::move(rule.actions);
  for (bool progress = true; progress && !waiting.empty();) {
    progress = false;
    for (std::size_t i = 0; i < waiting.size(); ++i) {
      if (!IsReady(waiting[i], known)) {
        continue;
      }
      for (const RhsValue* value : {&waiting[i].attribute, &waiting[i].value, &waiting[i].referent}) {
        known.Add(value->symbol);
      }
      ordered.push_back(std::move(waiting[i]));
      waiting.erase(waiting.begin() + static_cast<std::ptrdiff_t>(i));
      progress = true;
      break;
    }
  }
  rule.actions = std::move(ordered);
  if (waiting.empty()) {
    return true;
  }
  std::string text =
      "Attempted to add rule with ungrounded action(s).\n"
      "The following RHS actions contain variables that are not tested\n"
      "in a positive condition on the LHS: \n\n";
  for (const Action& action : waiting) {
    std::string line;
    AppendUngroundedAction(line, symbols, action);
    text += "        " + line + "\n";
    AddTrap(out, place, Severity::kError, "the action " + line + " uses a variable that no condition binds",
            "bind it in a positive condition, or link it to a state in another action");
  }
  out.late_messages.push_back({text + "\n", true, true});
  return false;
}

/// Says for each variable of the actions where it is bound, or which new identifier it stands for.
class Binder {
 public:
  explicit Binder(Production& rule) : rule_(rule) {
    std::uint16_t position = 0;
    for (const Condition& condition : rule.conditions) {
      if (condition.kind != ConditionKind::kPositive) {
        continue;
      }
      Note(condition.id, position, Field::kId);
      Note(condition.attribute, position, Field::kAttribute);
      Note(condition.value, position, Field::kValue);
      ++position;
    }
  }

  void Bind(RhsValue& value) {
    if (value.kind == RhsValueKind::kFunction) {
      for (RhsValue& argument : value.arguments) {
        Bind(argument);
      }
      return;
    }
    if (!value.symbol.IsVariable()) {
      return;
    }
    for (const auto& [variable, site] : sites_) {
      if (variable == value.symbol) {
        value.kind = RhsValueKind::kBound;
        value.site = site;
        return;
      }
    }
    std::vector<Symbol>& fresh = rule_.new_identifiers;
    const auto found = std::find(fresh.begin(), fresh.end(), value.symbol);
    value.kind = RhsValueKind::kNew;
    value.new_index = static_cast<std::uint16_t>(found - fresh.begin());
    if (found == fresh.end()) {
      fresh.push_back(value.symbol);
    }
  }

 private:
  void Note(const Test& test, std::uint16_t position, Field field) {
    const Symbol symbol = EqualitySymbol(test);
    if (!symbol.IsVariable()) {
      return;
    }
    for (const auto& [variable, site] : sites_) {
      if (variable == symbol) {
        return;
      }
    }
    sites_.push_back({symbol, {position, field}});
  }

  Production& rule_;
  std::vector<std::pair<Symbol, BindingSite>> sites_;
};

bool TestsGoal(const Test& test) {
  if (test.kind == TestKind::kState || test.kind == TestKind::kImpasse) {
    return true;
  }
  return std::any_of(test.parts.begin(), test.parts.end(), TestsGoal);
}

/// The attributes of states that the architecture makes: a rule that makes another value under one is probably wrong.
bool IsArchitectureLink(Symbol attribute) {
  for (const Symbol link : {words::kSuperstate, words::kType, words::kIo, words::kImpasse, words::kRewardLink, words::kEpmem,
                            words::kSmem, words::kQuiescence, words::kChoices, words::kAttribute, words::kItem}) {
    if (link == attribute) {
      return true;
    }
  }
  return false;
}

void WarnOfArchitectureLinks(const Production& rule, const SymbolTable& symbols, const SourcePlace& place, ParseOutcome& out) {
  VariableSet goals;
  for (const Condition& condition : rule.conditions) {
    if (condition.kind == ConditionKind::kPositive && TestsGoal(condition.id)) {
      goals.Add(EqualitySymbol(condition.id));
    }
  }
  for (const Action& action : rule.actions) {
    if (!action.is_function_call && action.preference == PreferenceType::kAcceptable && goals.Has(action.id.symbol) &&
        action.attribute.kind == RhsValueKind::kConstant && IsArchitectureLink(action.attribute.symbol)) {
      AddTrap(out, place, Severity::kWarning,
              rule.name + " makes ^" + ToString(symbols, action.attribute.symbol) +
                  " on a state, beside the one that the architecture makes",
              "use another attribute");
    }
  }
}

}  // namespace

bool FinishRule(Production& rule, const SourcePlace& place, SymbolTable& symbols, ParseOutcome& out) {
  if (!OrderActions(rule, symbols, out, place)) {
    return false;
  }
  const std::string name = ToString(symbols, symbols.String(rule.name));
  ReorderOutcome order = ReorderConditions(name, rule.conditions, symbols);
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
    AddTrap(out, place, Severity::kWarning,
            name + ": " + std::string(symbols.Text(variable)) + " is not connected to a state; the rule will look at all of working memory",
            "link it to a state, as in (state <s> ^thing " + std::string(symbols.Text(variable)) + ")");
  }
  if (rule.explain) {
    out.late_messages.push_back({"Now watching any chunks formed by rule '" + rule.name + "'\n", false, false});
  }
  if (rule.type == ProductionType::kChunk) {
    RenameVariables(rule, symbols);
  }
  Binder binder(rule);
  for (Action& action : rule.actions) {
    for (RhsValue* value : {&action.id, &action.attribute, &action.value, &action.referent}) {
      binder.Bind(*value);
    }
  }
  rule.is_rl = rule.type != ProductionType::kTemplate && rule.actions.size() == 1 &&
               rule.actions[0].preference == PreferenceType::kNumericIndifferent;
  WarnOfArchitectureLinks(rule, symbols, place, out);
  return true;
}

}  // namespace soarbox::kernel
