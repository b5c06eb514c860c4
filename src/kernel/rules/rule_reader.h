// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "kernel/rules/lexer.h"
#include "kernel/rules/parser.h"

namespace soarbox::kernel {

/// Makes the variables that a rule needs but does not write: <a*1>, <a*2>, ... per letter, none that the rule writes.
class VariableNames {
 public:
  VariableNames(SymbolTable& symbols, std::string_view body);
  /// A new variable whose name starts with `letter` in lower case.
  Symbol Make(char letter);
  /// The first letter for a variable that stands for the value of `attribute`.
  char LetterFor(Symbol attribute) const;

 private:
  SymbolTable& symbols_;
  std::unordered_set<std::string> written_;
  std::array<int, 26> count_{};
};

/// The variable or constant that a test equates its field with; none if it has no equality test.
Symbol EqualitySymbol(const Test& test);

/// Reads the text of one rule by recursive descent; for ParseProduction only. Reading stops at the first error: the
/// functions return false then, and the messages say why.
class RuleReader {
 public:
  RuleReader(std::string_view body, const SourcePlace& place, SymbolTable& symbols, ParseOutcome& out);

  /// Reads everything into `rule`; conditions and actions in text order, variables not yet bound.
  bool ReadRule(Production& rule);

 private:
  static constexpr int kMaxDepth = 200;  ///< Of brackets within brackets.

  // Tokens (parser.cpp)
  void Advance();
  bool Is(TokenKind kind) const { return token_.kind == kind; }
  bool Accept(TokenKind kind);
  bool Fail(std::string_view message, std::string_view hint = {});
  void Report(Severity severity, const Token& token, std::string message, std::string hint);
  void Say(std::string text, bool is_warning = false);
  Symbol ConstantOrVariable();
  bool ReadFlags(Production& rule);

  // Left-hand side (read_conditions.cpp)
  bool ReadConditions(std::vector<Condition>& out, int depth);
  bool ReadCondition(std::vector<Condition>& out, int depth);
  bool ReadPositiveCondition(std::vector<Condition>& out, int depth);
  bool ReadObject(std::vector<Condition>& out, bool may_be_goal, char id_letter, Symbol& id, int depth);
  bool ReadIdTest(Test& id);
  bool ReadAttributes(const Test& id, std::vector<Condition>& out, int depth);
  bool ReadAttribute(const Test& id, std::vector<Condition>& out, int depth);
  bool ReadTest(Test& test);
  bool ReadSimpleTest(Test& test);
  bool ReadDisjunction(Test& test);
  void AddToConjunction(std::vector<Test>& parts, Test test);
  void AddEquality(Test& test, char letter);

  // Right-hand side (read_actions.cpp)
  bool ReadActions(std::vector<Action>& out);
  bool ReadMakeActions(std::vector<Action>& out);
  bool ReadValues(const RhsValue& id, const RhsValue& attribute, std::vector<Action>& out);
  bool ReadRhsValue(RhsValue& value, int depth);
  bool ReadFunction(RhsValue& value, bool as_action, int depth);
  bool ReadOperatorPreferences(Action action, std::vector<Action>& out);
  bool ReadOtherPreferences(Action action, std::vector<Action>& out);
  bool ReadPreferenceType(PreferenceType& type);
  bool StartsReferent() const;
  void InsertExec(const Token& name);
  std::string DescribeAction(const Action& action) const;

  std::string_view body_;
  const SourcePlace& place_;
  SymbolTable& symbols_;
  ParseOutcome& out_;
  VariableNames names_;
  Lexer lexer_;
  Token token_;
  std::string edited_;          ///< The text with `exec` inserted; empty as long as none has been.
  std::size_t inserted_ = 0;    ///< How many characters were inserted.
};

}  // namespace soarbox::kernel
