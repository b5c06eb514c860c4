// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/rules/print_production.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <vector>

#include "diagnostics/name_table.h"
#include "kernel/base/known_symbols.h"
#include "kernel/rules/functions/builtin_functions.h"

namespace soarbox::kernel {

namespace {

void AppendSymbol(std::string& out, const SymbolTable& symbols, Symbol symbol, bool all_digits) {
  if (!all_digits || !symbol.IsFloat()) return AppendTo(out, symbols, symbol);
  char digits[512];
  const char* const end =
      std::to_chars(digits, std::end(digits), symbols.FloatValue(symbol), std::chars_format::fixed).ptr;
  const std::string_view number(digits, static_cast<std::size_t>(end - digits));
  out.append(number).append(number.find('.') == std::string_view::npos ? ".0" : "");
}

bool PrintsAsGoal(const Test& test) {
  return test.kind == TestKind::kState || test.kind == TestKind::kImpasse;
}

std::size_t Column(const std::string& out) {
  const std::size_t line = out.rfind('\n');
  return line == std::string::npos ? out.size() : out.size() - line - 1;
}

/// Prints a list of conditions or actions: one object per line, or several lines if an object is too long.
class ObjectPrinter {
 public:
  ObjectPrinter(std::string& out, const SymbolTable& symbols, const RulePrintOptions& options)
      : out_(out), symbols_(symbols), internal_(options.internal), all_digits_(options.complete) {}

  /// `first_in_line`: the list continues in the current line.
  void Conditions(std::span<const Condition> conditions, std::size_t indent, bool first_in_line) {
    std::vector<bool> printed(conditions.size(), false);
    for (std::size_t i = 0; i < conditions.size(); ++i) {
      if (printed[i]) {
        continue;
      }
      const Condition& condition = conditions[i];
      const bool negation = condition.kind == ConditionKind::kConjunctiveNegation;
      if (!first_in_line) {
        out_ += '\n';
      }
      first_in_line = false;
      out_.append(indent - (negation ? 1 : 0) - std::min(Column(out_), indent - (negation ? 1 : 0)), ' ');
      if (negation) {
        out_ += "-{";
        Conditions(condition.conditions(), indent + 2, true);
        out_ += '}';
        continue;
      }
      out_ += '(';
      const Symbol id = EqualitySymbol(condition.id);
      AppendId(condition);
      for (std::size_t j = i; j < conditions.size(); ++j) {
        if (printed[j] || (j != i && !SameObject(conditions[j], id))) {
          continue;
        }
        Item(AttributeText(conditions[j]), indent + 6);
        printed[j] = true;
        if (internal_) {
          break;
        }
      }
      out_ += ')';
    }
  }

  void Actions(std::span<const Action> actions, std::size_t indent) {
    std::vector<bool> printed(actions.size(), false);
    bool first = true;
    for (std::size_t i = 0; i < actions.size(); ++i) {
      if (printed[i]) {
        continue;
      }
      if (!first) {
        out_ += '\n';
      }
      first = false;
      out_.append(indent, ' ');
      if (actions[i].is_function_call) {
        AppendRhsValue(out_, symbols_, actions[i].value, all_digits_);
        continue;
      }
      out_ += '(';
      AppendRhsValue(out_, symbols_, actions[i].id, all_digits_);
      for (std::size_t j = i; j < actions.size(); ++j) {
        if (printed[j] || actions[j].is_function_call || actions[j].id.symbol() != actions[i].id.symbol()) {
          continue;
        }
        Item(ActionText(actions[j], false), indent + 7);
        printed[j] = true;
        if (internal_) {
          break;
        }
      }
      out_ += ')';
    }
    if (actions.empty()) {
      out_.append(indent, ' ');
    }
  }

  /// " ^attribute value +"
  std::string AttributeText(const Condition& condition) const {
    std::string text = condition.kind == ConditionKind::kNegative ? " -^" : " ^";
    AppendTest(text, symbols_, condition.attribute, all_digits_);
    if (condition.value.kind != TestKind::kBlank) {
      text += ' ';
      AppendTest(text, symbols_, condition.value, all_digits_);
    }
    if (condition.tests_acceptable) {
      text += " +";
    }
    return text;
  }

  std::string ActionText(const Action& action, bool always_signed) const {
    std::string text = " ^";
    AppendRhsValue(text, symbols_, action.attribute, all_digits_);
    text += ' ';
    AppendRhsValue(text, symbols_, action.value, all_digits_);
    const bool is_operator =
        action.attribute.kind == RhsValueKind::kConstant && action.attribute.symbol() == words::kOperator;
    if (always_signed || is_operator || action.preference != PreferenceType::kAcceptable) {
      text += ' ';
      text += PreferenceSign(action.preference);
    }
    if (action.HasReferent()) {
      text += ' ';
      AppendRhsValue(text, symbols_, action.referent, all_digits_);
    }
    return text;
  }

  void AppendId(const Condition& condition) {
    std::vector<const Test*> rest;
    for (const Test& part : condition.id.parts()) {
      if (!PrintsAsGoal(part)) {
        rest.push_back(&part);
      } else {
        out_ += part.kind == TestKind::kState ? "state " : "impasse ";
      }
    }
    if (condition.id.kind != TestKind::kConjunction) {
      AppendTest(out_, symbols_, condition.id, all_digits_);
    } else if (rest.size() == 1) {
      AppendTest(out_, symbols_, *rest.front(), all_digits_);
    } else {
      AppendConjunction(rest);
    }
  }

 private:
  bool SameObject(const Condition& condition, Symbol id) const {
    return condition.kind != ConditionKind::kConjunctiveNegation && condition.id.kind == TestKind::kEqual &&
           condition.id.referent() == id;
  }

  void AppendConjunction(const std::vector<const Test*>& parts) {
    out_ += "{ ";
    for (const Test* part : parts) {
      AppendTest(out_, symbols_, *part, all_digits_);
      out_ += ' ';
    }
    out_ += '}';
  }

  /// Appends a text to the object; begins a new line if it does not fit.
  void Item(const std::string& text, std::size_t indent) {
    if (Column(out_) + text.size() + 1 >= kPrintColumns) {  // Leaves room for the bracket.
      out_ += '\n';
      out_.append(indent - 1, ' ');
    }
    out_ += text;
  }

  std::string& out_;
  const SymbolTable& symbols_;
  bool internal_, all_digits_;
};

void AppendQuoted(std::string& out, std::string_view text) {
  out += '"';
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += '\\';
    }
    out += c;
  }
  out += '"';
}

}  // namespace

std::string_view ComparisonSign(TestKind kind) {
  static constexpr const char* kNames[] = {"", "", "<> ", "< ", "> ",  "<= ", ">= ", "<=> ", "",
                                           "", "", "",    "@ ", "!@ ", "",    "",    "$$ "};
  return NameIn(kNames, kind);
}

std::string_view PreferenceSign(PreferenceType type) {
  static constexpr const char* kNames[] = {"+", "!", "-", "~", ">", "<", "=", "=", "=", ">", "<"};
  return NameIn(kNames, type);
}

/// The test `$$ <x>` of `{ <x> $$ <x> }`; null for other tests.
static const Test* OnlyLiteral(const Test& test) {
  const std::span<const Test> parts = test.parts();
  if (parts.size() != 2) {
    return nullptr;
  }
  const Test* const literal = parts[0].kind == TestKind::kLiteral ? &parts[0] : &parts[1];
  const Test* const other = literal == &parts[0] ? &parts[1] : &parts[0];
  const bool is_alone = literal->kind == TestKind::kLiteral && other->kind == TestKind::kEqual;
  return is_alone && literal->referent() == other->referent() ? literal : nullptr;
}

void AppendTest(std::string& out, const SymbolTable& symbols, const Test& test, bool all_digits) {
  switch (test.kind) {
    case TestKind::kBlank:
      return;
    case TestKind::kState:
      out += "state";
      return;
    case TestKind::kImpasse:
      out += "impasse";
      return;
    case TestKind::kIsLti:
      out += "@+";
      return;
    case TestKind::kIsNotLti:
      out += "@-";
      return;
    case TestKind::kDisjunction:
      out += "<< ";
      for (const Symbol symbol : test.disjuncts()) {
        AppendSymbol(out, symbols, symbol, all_digits);
        out += ' ';
      }
      out += ">>";
      return;
    case TestKind::kConjunction:
      if (const Test* const literal = OnlyLiteral(test); literal != nullptr) {
        out += "$ ";
        AppendSymbol(out, symbols, literal->referent(), all_digits);
        return;
      }
      out += "{ ";
      for (const Test& part : test.parts()) {
        AppendTest(out, symbols, part, all_digits);
        out += ' ';
      }
      out += '}';
      return;
    default:
      out += ComparisonSign(test.kind);
      AppendSymbol(out, symbols, test.referent(), all_digits);
      return;
  }
}

void AppendRhsValue(std::string& out, const SymbolTable& symbols, const RhsValue& value, bool all_digits) {
  if (value.kind != RhsValueKind::kFunction) {
    AppendSymbol(out, symbols, value.symbol(), all_digits);
    return;
  }
  const std::string_view function = BuiltinFunctions()[value.function_index()].name;
  out += '(';
  const bool sign = function.size() == 1 && std::string_view("+-*").find(function[0]) != std::string_view::npos;
  if (sign || ReadsAsPlainString(function)) {
    out += function;
  } else {
    out.append("|").append(function).append("|");
  }
  for (const RhsValue& argument : value.arguments()) {
    out += ' ';
    AppendRhsValue(out, symbols, argument, all_digits);
  }
  out += ')';
}

void AppendAction(std::string& out, const SymbolTable& symbols, const Action& action) {
  ObjectPrinter(out, symbols, {.internal = true}).Actions({&action, 1}, 0);
}

// Unfinished parts are rarely printed, so they are first converted to the only part of a rule.

void AppendTest(std::string& out, const SymbolTable& symbols, const TestDraft& test) {
  ConditionDraft condition;
  condition.value = test;
  RuleDraft rule;
  rule.conditions.Add(&condition);
  AppendTest(out, symbols, Production::Make(rule)->conditions[0].value);
}

void AppendRhsValue(std::string& out, const SymbolTable& symbols, const ValueDraft& value) {
  ActionDraft action;
  action.value = value;
  RuleDraft rule;
  rule.actions.Add(&action);
  AppendRhsValue(out, symbols, Production::Make(rule)->actions[0].value);
}

void AppendUngroundedAction(std::string& out, const SymbolTable& symbols, const ActionDraft& draft) {
  ActionDraft copy = draft;
  RuleDraft rule;
  rule.actions.Add(&copy);
  const ProductionPtr made = Production::Make(rule);
  const Action& action = made->actions[0];
  if (action.is_function_call) {
    AppendRhsValue(out, symbols, action.value);
    return;
  }
  out += '(';
  AppendRhsValue(out, symbols, action.id);
  out += ObjectPrinter(out, symbols, {.internal = true}).ActionText(action, true) + ")";
}

void AppendCondition(std::string& out, const SymbolTable& symbols, const Condition& condition) {
  if (condition.kind == ConditionKind::kConjunctiveNegation) {
    out += "-{";
    for (const Condition& inner : condition.conditions()) {
      out += ' ';
      AppendCondition(out, symbols, inner);
    }
    out += '}';
    return;
  }
  ObjectPrinter printer(out, symbols, {.internal = true});
  out += '(';
  printer.AppendId(condition);
  out += printer.AttributeText(condition) + ")";
}

std::string PrintProduction(const SymbolTable& symbols, const Production& production, const RulePrintOptions& options) {
  std::string out = "sp {";
  const Symbol name = symbols.FindString(production.name);
  if (name) {
    AppendTo(out, symbols, name);
  } else {
    out += production.name;
  }
  out += '\n';
  if (production.has_documentation || !production.documentation.empty()) {
    out += "    ";
    AppendQuoted(out, production.documentation);
    out += '\n';
  }
  switch (production.type) {
    case ProductionType::kDefault:
      out += "    :default\n";
      break;
    case ProductionType::kJustification:
      out += "    :justification ;# not reloadable\n";
      break;
    case ProductionType::kChunk:
      out += "    :chunk\n";
      break;
    case ProductionType::kTemplate:
      out += "   :template\n";
      break;
    default:
      break;
  }
  if (production.declared_support == DeclaredSupport::kOSupport) {
    out += "    :o-support\n";
  } else if (production.declared_support == DeclaredSupport::kISupport) {
    out += "    :i-support\n";
  }
  if (production.interrupt) {
    out += "    :interrupt\n";
  }
  if (options.complete && production.explain) out += "    :explain\n";
  ObjectPrinter printer(out, symbols, options);
  printer.Conditions(production.conditions, 4, true);
  out += "\n    -->\n";
  printer.Actions(production.actions, 4);
  out += "\n}\n";
  return out;
}

}  // namespace soarbox::kernel
