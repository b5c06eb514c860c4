// SPDX-License-Identifier: BSD-2-Clause
#include "diagnostics/diagnostic.h"
#include "kernel/base/known_symbols.h"
#include "kernel/rules/functions/builtin_functions.h"
#include "kernel/rules/print_production.h"
#include "kernel/rules/rule_reader.h"

namespace soarbox::kernel {

namespace {

constexpr const char* kIllegalValue = "Illegal value for RHS value";

ValueDraft Plain(Term term) {
  ValueDraft value;
  value.kind = term.variable != kNoVariable ? RhsValueKind::kNew : RhsValueKind::kConstant;
  value.symbol = term.symbol;
  value.variable = term.variable;
  return value;
}

}  // namespace

bool RuleReader::ReadActions(Actions& out) {
  while (!Is(TokenKind::kEnd)) {
    if (!Is(TokenKind::kLeftParen)) {
      return Fail("Expected ( to begin RHS action");
    }
    Advance();
    if (Is(TokenKind::kVariable) || Is(TokenKind::kIdentifier)) {
      if (!ReadMakeActions(out)) {
        return false;
      }
      continue;
    }
    ActionDraft* const call = arena_.New<ActionDraft>();
    call->is_function_call = true;
    if (!ReadFunction(call->value, true, 0)) {
      return false;
    }
    out.Add(call);
  }
  return true;
}

bool RuleReader::ReadMakeActions(Actions& out) {
  Term object;
  if (Is(TokenKind::kIdentifier)) {  // Identifiers are not allowed here: the rule is refused later, with this text.
    object.symbol = symbols_.Variable(body_.substr(token_.offset, token_.length));
    object.variable = variables_.Add(object.symbol);
    Advance();
  } else {
    object = ConstantOrVariable();
  }
  const ValueDraft first_id = Plain(object);
  if (Is(TokenKind::kRightParen)) {
    Report(Severity::kError, token_, "the action creates nothing", "write ^attribute value after the variable");
    return false;
  }
  while (!Is(TokenKind::kRightParen)) {
    if (!Is(TokenKind::kUpArrow)) {
      return Fail("Expected ^ in RHS make action");
    }
    Advance();
    ValueDraft id = first_id;
    ValueDraft attribute;
    if (!ReadRhsValue(attribute, 0)) {
      return false;
    }
    while (Accept(TokenKind::kPeriod)) {
      ActionDraft* const step = arena_.New<ActionDraft>();
      step->id = id;
      step->attribute = attribute;
      step->value = Plain(NewVariable(names_.LetterFor(attribute.symbol)));
      id = step->value;
      out.Add(step);
      if (!ReadRhsValue(attribute, 0)) {
        return false;
      }
    }
    if (!ReadValues(id, attribute, out)) {
      return false;
    }
  }
  Advance();
  return true;
}

bool RuleReader::ReadValues(const ValueDraft& id, const ValueDraft& attribute, Actions& out) {
  const bool is_operator = attribute.kind == RhsValueKind::kConstant && attribute.symbol == words::kOperator;
  // At the end of a dotted path, `operator` is an ordinary attribute. Only outside of paths is it the slot that takes
  // preferences.
  const bool in_path = is_operator && out.last != nullptr && !out.last->is_function_call &&
                       out.last->value.kind == RhsValueKind::kNew && out.last->value.symbol == id.symbol &&
                       symbols_.Text(id.symbol).find('*') != std::string::npos;
  do {
    ActionDraft action;
    action.id = id;
    action.attribute = Copy(attribute, arena_);
    if (!ReadRhsValue(action.value, 0)) {
      return false;
    }
    if (is_operator && !in_path ? !ReadOperatorPreferences(action, out) : !ReadOtherPreferences(action, out)) {
      return false;
    }
  } while (!Is(TokenKind::kRightParen) && !Is(TokenKind::kUpArrow));
  return true;
}

bool RuleReader::ReadRhsValue(ValueDraft& value, int depth) {
  if (Is(TokenKind::kLeftParen)) {
    Advance();
    return ReadFunction(value, false, depth + 1);
  }
  const Term term = ConstantOrVariable();
  if (!term.symbol) {
    return Fail(kIllegalValue);
  }
  value = Plain(term);
  return true;
}

bool RuleReader::ReadFunction(ValueDraft& value, bool as_action, int depth) {
  if (depth > kMaxDepth) {
    return Fail("Function calls are nested too deeply");
  }
  value = ValueDraft();
  value.kind = RhsValueKind::kFunction;
  const RuleToken name = token_;
  switch (name.kind) {
    case TokenKind::kEnd:
    case TokenKind::kLeftParen:
    case TokenKind::kLeftBrace:
    case TokenKind::kRightBrace:
    case TokenKind::kUnclosed:
      return Fail("Expected function name", "write the name of a function after the bracket: (write ...)");
    default:
      break;
  }
  std::string_view function = name.text;
  if (function == "succeeded" || function == "failed") {
    Say("WARNING: Replacing function named " + std::string(function) +
        " with halt since this is a unit test but running in a non-unit testing environment.\n");
    function = "halt";
  }
  value.index = FindBuiltinFunction(function);
  const bool unknown = value.index == RhsValue::kUserFunction;
  if (unknown) {
    const bool is_registered = language_.is_client_function && language_.is_client_function(TextOf(name));
    // (make <o> ^name go) and (1 + <n>) are not calls: the errors at ^ and + describe the problem.
    const std::size_t after = body_.find_first_of("()|\"^", name.offset + name.length);
    const bool is_word = name.kind == TokenKind::kString || name.kind == TokenKind::kIdentifier;
    const bool is_call = is_word && (after == std::string_view::npos || body_[after] != '^');
    if (language_.version == SoarVersion::k963 || is_registered) {
      InsertExec(name);
    } else if (is_call) {
      return FailUnknown(name);
    } else {
      SayUnknown(name);
    }
    value.index = FindBuiltinFunction("exec");
  } else {
    const BuiltinFunction& builtin = BuiltinFunctions()[value.index];
    if (as_action && !builtin.as_action) {
      return Fail("Function " + std::string(name.text) + " cannot be used as a stand-alone action",
                  "use it as a value: ^attribute (" + std::string(name.text) + " ...)");
    }
    if (!as_action && !builtin.as_value) {
      return Fail("Function " + std::string(name.text) + " can only be used as a stand-alone action");
    }
    Advance();
  }
  // The name of an unknown function becomes the first argument of exec, and is read as such.
  while (!Is(TokenKind::kRightParen)) {
    ValueDraft argument;
    if (!ReadRhsValue(argument, depth)) {
      return false;
    }
    value.arguments.Add(arena_.New(argument));
  }
  if (is_refused_) {
    return FailUnknown(name);
  }
  const BuiltinFunction& builtin = BuiltinFunctions()[value.index];
  if (builtin.arguments >= 0 && value.arguments.Count() != static_cast<std::uint32_t>(builtin.arguments)) {
    return Fail("Wrong number of arguments to function " + std::string(builtin.name) + " (expected " +
                std::to_string(builtin.arguments) + ")");
  }
  Advance();  // )
  return true;
}

/// A function's name without bars.
std::string RuleReader::TextOf(const RuleToken& name) const {
  return std::string(name.kind == TokenKind::kString ? name.text : body_.substr(name.offset, name.length));
}

/// Prints Soar's message about an unknown function. Later errors of the same rule are not printed.
void RuleReader::SayUnknown(const RuleToken& name) {
  if (!is_refused_) Say("There is no function named " + TextOf(name) + "\n");
  is_refused_ = true;
}

bool RuleReader::FailUnknown(const RuleToken& name) {
  const std::string text = TextOf(name);
  const std::string_view near = NearestFunction(text);
  std::string hint = "(exec " + text + " ...) calls a function that a client registers later";
  if (text == "tcl") hint = "Soar has no Tcl any more: (write ...) prints, (cmd ...) gives a command";
  if (!near.empty()) hint = "did you mean " + std::string(near) + "? " + hint;
  SayUnknown(name);
  Report(Severity::kError, name, "rule " + out_.name + " calls the function " + text + ", which does not exist", hint);
  return false;
}

void RuleReader::InsertExec(const RuleToken& name) {
  if (edited_.empty()) {
    edited_ = body_;
  }
  edited_.insert(name.offset + inserted_, "exec ");
  inserted_ += 5;
  const std::string text = TextOf(name);
  Say("Adding exec to RHS function: " + text + "\n" + edited_ + "\n");
  Report(Severity::kNote, name,
         "there is no built-in function " + text + ": the client's function of that name is called", "");
}

bool RuleReader::ReadPreferenceType(PreferenceType& type) {
  switch (token_.kind) {
    case TokenKind::kComma:
    case TokenKind::kPlus:
      type = PreferenceType::kAcceptable;
      break;
    case TokenKind::kMinus:
      type = PreferenceType::kReject;
      break;
    case TokenKind::kExclamation:
      type = PreferenceType::kRequire;
      break;
    case TokenKind::kTilde:
      type = PreferenceType::kProhibit;
      break;
    case TokenKind::kGreater:
      type = PreferenceType::kBest;
      break;
    case TokenKind::kLess:
      type = PreferenceType::kWorst;
      break;
    case TokenKind::kEqual:
      type = PreferenceType::kUnaryIndifferent;
      break;
    default:
      return false;
  }
  Advance();
  return true;
}

bool RuleReader::StartsReferent() const {
  switch (token_.kind) {
    case TokenKind::kVariable:
    case TokenKind::kString:
    case TokenKind::kIdentifier:
    case TokenKind::kInteger:
    case TokenKind::kFloat:
    case TokenKind::kLeftParen:
      return true;
    default:
      return false;
  }
}

ActionDraft RuleReader::CopyOf(const ActionDraft& action) {
  ActionDraft copy = action;
  copy.attribute = Copy(action.attribute, arena_);
  copy.value = Copy(action.value, arena_);
  return copy;
}

bool RuleReader::ReadOperatorPreferences(const ActionDraft& action, Actions& out) {
  bool any = false;
  PreferenceType type{};
  for (RuleToken sign = token_; ReadPreferenceType(type); sign = token_) {
    ActionDraft one = CopyOf(action);
    one.preference = type;
    const bool may_be_binary =
        type == PreferenceType::kBest || type == PreferenceType::kWorst || type == PreferenceType::kUnaryIndifferent;
    if (may_be_binary && StartsReferent()) {
      if (!ReadRhsValue(one.referent, 0)) {
        return false;
      }
      const bool number = one.referent.kind == RhsValueKind::kConstant && one.referent.symbol.IsNumber();
      one.preference = type == PreferenceType::kBest    ? PreferenceType::kBetter
                       : type == PreferenceType::kWorst ? PreferenceType::kWorse
                       : number                         ? PreferenceType::kNumericIndifferent
                                                        : PreferenceType::kBinaryIndifferent;
      const bool goes_on =
          Is(TokenKind::kPlus) || Is(TokenKind::kEqual) || Is(TokenKind::kGreater) || Is(TokenKind::kLess);
      if (goes_on && one.referent.symbol.IsVariable()) {
        const std::string referent = ToString(symbols_, one.referent.symbol);
        Report(Severity::kWarning, sign,
               "the preference " + std::string(sign.text) + " takes " + referent +
                   " as its referent, so the next sign is again for " + DescribeAction(action),
               "put a comma before " + referent + " or repeat ^operator if " + referent + " is another proposal");
      }
    }
    Accept(TokenKind::kComma);
    out.Add(arena_.New(one));
    any = true;
  }
  if (!any) {
    out.Add(arena_.New(action));
  }
  return true;
}

bool RuleReader::ReadOtherPreferences(ActionDraft& action, Actions& out) {
  PreferenceType type{};
  for (RuleToken sign = token_; ReadPreferenceType(type); sign = token_) {
    const bool may_be_binary =
        type == PreferenceType::kBest || type == PreferenceType::kWorst || type == PreferenceType::kUnaryIndifferent;
    if (may_be_binary && StartsReferent()) {
      Say("\nERROR: Binary preference illegal for non-operator." + DescribeAction(action) + "\n");
      const bool is_operator =
          action.attribute.kind == RhsValueKind::kConstant && action.attribute.symbol == words::kOperator;
      Report(Severity::kError, sign,
             is_operator
                 ? "a path in an action makes a new object, so the preference " + std::string(sign.text) +
                       " would not be for an operator of a state"
                 : "only the attribute operator takes the preference " + std::string(sign.text) + " with a referent",
             is_operator ? "bind the state in a condition, ^superstate <above>, and write (<above> ^operator ...)"
                         : "leave the preference out: values of other attributes need none");
      return false;
    }
    if (type == PreferenceType::kReject) {
      action.preference = type;
    } else if (type != PreferenceType::kAcceptable) {
      Say("\nWARNING: The only allowable non-operator preference \nis REJECT - .\nIgnoring specified preferences.\n" +
          DescribeAction(action) + "\n");
      Report(Severity::kWarning, sign,
             "the preference " + std::string(sign.text) + " has no meaning here: it is only for operators",
             "to make an element, leave it out; to remove one, write - after its value", Topic::kDroppedText);
    }
    Accept(TokenKind::kComma);
  }
  out.Add(arena_.New(action));
  return true;
}

std::string RuleReader::DescribeAction(const ActionDraft& action) const {
  const auto text = [&](const ValueDraft& value) {
    std::string out;
    AppendRhsValue(out, symbols_, value);
    return out;
  };
  std::string id = text(action.id);
  if (id.find('*') != std::string::npos) {
    id.insert(1, "#");  // Soar shows its internal name for variables that a path adds.
  }
  return "id = " + id + "\t attr = " + text(action.attribute) + "\t value = " + text(action.value);
}

}  // namespace soarbox::kernel
