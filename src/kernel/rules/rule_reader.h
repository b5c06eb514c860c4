// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "kernel/rules/draft.h"
#include "kernel/rules/lexer.h"
#include "kernel/rules/parser.h"
#include "kernel/rules/variable_index.h"

namespace soarbox::kernel {

/// Generates variables that the reader needs but that are not in the text: <a*1>, <a*2>, ... per letter. Skips names
/// that are in the text.
class VariableNames {
 public:
  VariableNames(SymbolTable& symbols, std::string_view body) : symbols_(symbols), body_(body) {}
  /// A new variable whose name starts with `letter` in lower case.
  Symbol Make(char letter);
  /// The first letter of a variable for the value of `attribute`.
  char LetterFor(Symbol attribute) const;

 private:
  void CollectWritten();

  SymbolTable& symbols_;
  std::string_view body_;
  bool collected_ = false;
  std::unordered_set<std::string> written_;  ///< Names in the text that could clash; filled when needed.
  std::array<int, 26> count_{};
};

/// Reads the text of one rule by recursive descent; used only by ParseProduction. Reading stops at the first error: the
/// functions then return false, and the messages describe the error.
class RuleReader {
 public:
  RuleReader(std::string_view body, const SourcePlace& place, SymbolTable& symbols, VariableIndex& variables,
             Arena& arena, const RuleLanguage& language, ParseOutcome& out);

  /// Reads the rule into `rule`. Conditions and actions are in text order; variables are numbered but not bound.
  bool ReadRule(RuleDraft& rule);

 private:
  static constexpr int kMaxDepth = 200;  ///< Maximum nesting of brackets.

  using Conditions = DraftList<ConditionDraft>;
  using Actions = DraftList<ActionDraft>;

  // Tokens (parser.cpp)
  void Advance() {
    lexer_.Read(token_);
    if (token_.suspicious) {
      Complain();
    }
  }
  void Complain();
  bool Is(TokenKind kind) const { return token_.kind == kind; }
  bool Accept(TokenKind kind) {
    if (!Is(kind)) {
      return false;
    }
    Advance();
    return true;
  }
  bool Fail(std::string_view message, std::string_view hint = {});
  void Report(Severity severity, const RuleToken& token, std::string message, std::string hint,
              Topic topic = Topic::kOther);
  void Say(std::string text, bool is_warning = false);
  Term ConstantOrVariable();
  Term NewVariable(char letter);
  bool ReadFlags(RuleDraft& rule);

  // Left-hand side (read_conditions.cpp)
  bool ReadConditions(Conditions& out, int depth);
  bool ReadCondition(Conditions& out, int depth);
  bool ReadPositiveCondition(Conditions& out, int depth);
  bool ReadObject(Conditions& out, char id_letter, TestDraft& id, int depth);
  void FillIn(const Conditions& conditions, const TestDraft& id);
  bool ReadIdTest(TestDraft& id);
  bool ReadAttributes(const TestDraft& id, Conditions& out, int depth);
  bool ReadAttribute(const TestDraft& id, Conditions& out, int depth);
  bool ReadTest(TestDraft& test);
  bool ReadLiteral(DraftList<TestDraft>& parts);
  bool CheckLiterals(const DraftList<TestDraft>& parts);
  bool ReadSimpleTest(TestDraft& test);
  bool ReadDisjunction(TestDraft& test);
  void AddToConjunction(DraftList<TestDraft>& parts, const TestDraft& test);
  void AddEquality(TestDraft& test, char letter);
  void Negate(const Conditions& conditions, Conditions& out);

  // Right-hand side (read_actions.cpp)
  bool ReadActions(Actions& out);
  bool ReadMakeActions(Actions& out);
  bool ReadValues(const ValueDraft& id, const ValueDraft& attribute, Actions& out);
  bool ReadRhsValue(ValueDraft& value, int depth);
  bool ReadFunction(ValueDraft& value, bool as_action, int depth);
  bool ReadOperatorPreferences(const ActionDraft& action, Actions& out);
  bool ReadOtherPreferences(ActionDraft& action, Actions& out);
  bool ReadPreferenceType(PreferenceType& type);
  bool StartsReferent() const;
  std::string TextOf(const RuleToken& name) const;
  void SayUnknown(const RuleToken& name);
  bool FailUnknown(const RuleToken& name);
  void InsertExec(const RuleToken& name);
  std::string DescribeAction(const ActionDraft& action) const;
  ActionDraft CopyOf(const ActionDraft& action);

  std::string_view body_;
  const SourcePlace& place_;
  SymbolTable& symbols_;
  VariableIndex& variables_;
  Arena& arena_;
  const RuleLanguage& language_;
  ParseOutcome& out_;
  VariableNames names_;
  Lexer lexer_;
  PlaceFinder places_;
  RuleToken token_;
  std::vector<Symbol> disjuncts_;  ///< Scratch.
  std::string edited_;             ///< The text with `exec` inserted; empty until something is inserted.
  std::size_t inserted_ = 0;       ///< How many characters were inserted.
  bool is_refused_ = false;        ///< A message has already named an unknown function.
};

}  // namespace soarbox::kernel
