// SPDX-License-Identifier: BSD-2-Clause
#include <utility>

#include "kernel/base/words.h"
#include "kernel/rules/functions/builtin_functions.h"
#include "kernel/rules/print_production.h"
#include "kernel/rules/rule_reader.h"

namespace soarbox::kernel {

namespace {

constexpr const char* kIllegalValue = "Illegal value for RHS value";

RhsValue Plain(Symbol symbol) {
  RhsValue value;
  value.kind = symbol.IsVariable() ? RhsValueKind::kNew : RhsValueKind::kConstant;
  value.symbol = symbol;
  return value;
}

}  // namespace

bool RuleReader::ReadActions(std::vector<Action>& out) {
  while (!Is(TokenKind::kEnd)) {
    if (!Is(TokenKind::kLeftParen)) {
      return Fail("Expected ( to begin RHS action");
    }
    Advance();
    if (Is(TokenKind::kVariable)) {
      if (!ReadMakeActions(out)) {
        return false;
      }
      continue;
    }
    Action call;
    call.is_function_call = true;
    if (!ReadFunction(call.value, true, 0)) {
      return false;
    }
    out.push_back(std::move(call));
  }
  return true;
}

bool RuleReader::ReadMakeActions(std::vector<Action>& out) {
  const RhsValue first_id = Plain(ConstantOrVariable());
  if (Is(TokenKind::kRightParen)) {
    Report(Severity::kError, token_, "the action makes nothing", "write ^attribute value after the variable");
    return false;
  }
  while (!Is(TokenKind::kRightParen)) {
    if (!Is(TokenKind::kUpArrow)) {
      return Fail("Expected ^ in RHS make action");
    }
    Advance();
    RhsValue id = first_id;
    RhsValue attribute;
    if (!ReadRhsValue(attribute, 0)) {
      return false;
    }
    while (Accept(TokenKind::kPeriod)) {
      Action step;
      step.id = std::move(id);
      step.value = Plain(names_.Make(names_.LetterFor(attribute.symbol)));
      step.attribute = std::move(attribute);
      id = step.value;
      out.push_back(std::move(step));
      attribute = RhsValue{};
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

bool RuleReader::ReadValues(const RhsValue& id, const RhsValue& attribute, std::vector<Action>& out) {
  const bool is_operator = attribute.kind == RhsValueKind::kConstant && attribute.symbol == words::kOperator;
  // A dotted path makes an object; only on its own, `operator` is the slot that takes preferences.
  const bool in_path = !out.empty() && !out.back().is_function_call && out.back().value.kind == RhsValueKind::kNew &&
                       out.back().value.symbol == id.symbol && symbols_.Text(id.symbol).find('*') != std::string::npos;
  do {
    Action action;
    action.id = id;
    action.attribute = attribute;
    if (!ReadRhsValue(action.value, 0)) {
      return false;
    }
    if (is_operator && !in_path ? !ReadOperatorPreferences(std::move(action), out)
                                : !ReadOtherPreferences(std::move(action), out)) {
      return false;
    }
  } while (!Is(TokenKind::kRightParen) && !Is(TokenKind::kUpArrow));
  return true;
}

bool RuleReader::ReadRhsValue(RhsValue& value, int depth) {
  if (Is(TokenKind::kLeftParen)) {
    Advance();
    return ReadFunction(value, false, depth + 1);
  }
  const Symbol symbol = ConstantOrVariable();
  if (!symbol) {
    return Fail(kIllegalValue);
  }
  value = Plain(symbol);
  return true;
}

bool RuleReader::ReadFunction(RhsValue& value, bool as_action, int depth) {
  if (depth > kMaxDepth) {
    return Fail("Function calls are nested too deeply");
  }
  value = RhsValue{};
  value.kind = RhsValueKind::kFunction;
  const Token name = token_;
  switch (name.kind) {
    case TokenKind::kEnd: case TokenKind::kLeftParen: case TokenKind::kRightParen: case TokenKind::kLeftBrace:
    case TokenKind::kRightBrace: case TokenKind::kUpArrow: case TokenKind::kUnclosed:
      return Fail("Expected function name", "write the name of a function after the bracket: (write ...)");
    default: break;
  }
  value.function = name.text;
  if (value.function == "succeeded" || value.function == "failed") {
    Say("WARNING: Replacing function named " + value.function +
        " with halt since this is a unit test but running in a non-unit testing environment.\n");
    value.function = "halt";
  }
  value.function_index = FindBuiltinFunction(value.function);
  const bool unknown = value.function_index == RhsValue::kUserFunction;
  if (unknown) {
    InsertExec(name);
    value.function = "exec";
    value.function_index = FindBuiltinFunction("exec");
  } else {
    const BuiltinFunction& builtin = BuiltinFunctions()[value.function_index];
    if (as_action && !builtin.as_action) {
      return Fail("Function " + name.text + " cannot be used as a stand-alone action",
                  "use it as a value: ^attribute (" + name.text + " ...)");
    }
    if (!as_action && !builtin.as_value) {
      return Fail("Function " + name.text + " can only be used as a stand-alone action");
    }
    Advance();
  }
  // The name of an unknown function is the first argument of exec, and is read as such.
  while (!Is(TokenKind::kRightParen)) {
    RhsValue argument;
    if (!ReadRhsValue(argument, depth)) {
      return false;
    }
    value.arguments.push_back(std::move(argument));
  }
  const int expected = BuiltinFunctions()[value.function_index].arguments;
  if (expected >= 0 && static_cast<int>(value.arguments.size()) != expected) {
    return Fail("Wrong number of arguments to function " + value.function + " (expected " + std::to_string(expected) + ")");
  }
  Advance();  // )
  return true;
}

void RuleReader::InsertExec(const Token& name) {
  if (edited_.empty()) {
    edited_ = body_;
  }
  edited_.insert(name.offset + inserted_, "exec ");
  inserted_ += 5;
  Say("Adding exec to RHS function: " + name.text + "\n" + edited_ + "\n");
  Report(Severity::kNote, name, "there is no built-in function " + name.text + ": the client's function of that name is called",
         "");
}

bool RuleReader::ReadPreferenceType(PreferenceType& type) {
  switch (token_.kind) {
    case TokenKind::kComma: type = PreferenceType::kAcceptable; break;
    case TokenKind::kPlus: type = PreferenceType::kAcceptable; break;
    case TokenKind::kMinus: type = PreferenceType::kReject; break;
    case TokenKind::kExclamation: type = PreferenceType::kRequire; break;
    case TokenKind::kTilde: type = PreferenceType::kProhibit; break;
    case TokenKind::kGreater: type = PreferenceType::kBest; break;
    case TokenKind::kLess: type = PreferenceType::kWorst; break;
    case TokenKind::kEqual: type = PreferenceType::kUnaryIndifferent; break;
    default: return false;
  }
  Advance();
  return true;
}

bool RuleReader::StartsReferent() const {
  switch (token_.kind) {
    case TokenKind::kVariable: case TokenKind::kString: case TokenKind::kIdentifier: case TokenKind::kInteger:
    case TokenKind::kFloat: case TokenKind::kLeftParen:
      return true;
    default:
      return false;
  }
}

bool RuleReader::ReadOperatorPreferences(Action action, std::vector<Action>& out) {
  bool any = false;
  PreferenceType type{};
  for (Token sign = token_; ReadPreferenceType(type); sign = token_) {
    Action one = action;
    one.preference = type;
    const bool may_be_binary = type == PreferenceType::kBest || type == PreferenceType::kWorst ||
                               type == PreferenceType::kUnaryIndifferent;
    if (may_be_binary && StartsReferent()) {
      if (!ReadRhsValue(one.referent, 0)) {
        return false;
      }
      const bool number = one.referent.kind == RhsValueKind::kConstant && one.referent.symbol.IsNumber();
      one.preference = type == PreferenceType::kBest    ? PreferenceType::kBetter
                       : type == PreferenceType::kWorst ? PreferenceType::kWorse
                       : number                         ? PreferenceType::kNumericIndifferent
                                                        : PreferenceType::kBinaryIndifferent;
      const bool goes_on = Is(TokenKind::kPlus) || Is(TokenKind::kEqual) || Is(TokenKind::kGreater) || Is(TokenKind::kLess);
      if (goes_on && one.referent.symbol.IsVariable()) {
        const std::string referent = ToString(symbols_, one.referent.symbol);
        Report(Severity::kWarning, sign, "the preference " + sign.text + " takes " + referent +
               " as its referent, and what follows is said of " + DescribeAction(action) + " again",
               "put a comma before " + referent + " or repeat ^operator if " + referent + " is another proposal");
      }
    }
    Accept(TokenKind::kComma);
    out.push_back(std::move(one));
    any = true;
  }
  if (!any) {
    out.push_back(std::move(action));
  }
  return true;
}

bool RuleReader::ReadOtherPreferences(Action action, std::vector<Action>& out) {
  PreferenceType type{};
  for (Token sign = token_; ReadPreferenceType(type); sign = token_) {
    const bool may_be_binary = type == PreferenceType::kBest || type == PreferenceType::kWorst ||
                               type == PreferenceType::kUnaryIndifferent;
    if (may_be_binary && StartsReferent()) {
      Say("\nERROR: Binary preference illegal for non-operator." + DescribeAction(action) + "\n");
      Report(Severity::kError, sign, "only the attribute operator takes the preference " + sign.text + " with a referent",
             "leave the preference out: values of other attributes need none");
      return false;
    }
    if (type == PreferenceType::kReject) {
      action.preference = type;
    } else if (type != PreferenceType::kAcceptable) {
      Say("\nWARNING: The only allowable non-operator preference \nis REJECT - .\nIgnoring specified preferences.\n" +
          DescribeAction(action) + "\n");
      Report(Severity::kWarning, sign, "the preference " + sign.text + " means nothing here: only operator takes it", "");
    }
    Accept(TokenKind::kComma);
  }
  out.push_back(std::move(action));
  return true;
}

std::string RuleReader::DescribeAction(const Action& action) const {
  const auto text = [&](const RhsValue& value) {
    std::string out;
    AppendRhsValue(out, symbols_, value);
    return out;
  };
  std::string id = text(action.id);
  if (id.find('*') != std::string::npos) {
    id.insert(1, "#");  // Soar shows its working name for the variables that a path adds.
  }
  return "id = " + id + "\t attr = " + text(action.attribute) + "\t value = " + text(action.value);
}

}  // namespace soarbox::kernel
