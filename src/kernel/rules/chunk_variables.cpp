// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/rules/chunk_variables.h"

#include <array>
#include <charconv>
#include <iterator>
#include <vector>

#include "kernel/base/characters.h"

namespace soarbox::kernel {

namespace {

class Renamer {
 public:
  Renamer(SymbolTable& symbols, const VariableIndex& variables) : symbols_(symbols), names_(variables.size()) {}

  void Rename(const DraftList<ConditionDraft>& conditions) {
    for (ConditionDraft& condition : conditions) {
      if (condition.kind == ConditionKind::kConjunctiveNegation) {
        Rename(condition.conditions);
        continue;
      }
      RenameField(condition.id, 's');
      RenameField(condition.attribute, 'a');
      RenameField(condition.value, LetterOf(EqualitySymbol(condition.attribute)));
    }
  }

  /// Visits the actions. A make action's attribute determines the name of its value's variable; variables that only
  /// functions use come last.
  void Rename(const DraftList<ActionDraft>& actions) {
    for (ActionDraft& action : actions) {
      if (!action.is_function_call) {
        RenamePlain(action.id, 's');
        RenamePlain(action.attribute, 'a');
        RenamePlain(action.value, LetterOf(action.attribute.symbol));
        RenamePlain(action.referent, 'r');
      }
    }
    for (ActionDraft& action : actions) {
      for (ValueDraft* value : {&action.attribute, &action.value, &action.referent}) {
        RenameArguments(*value);
      }
    }
  }

 private:
  void RenameField(TestDraft& test, char letter) {
    PutEqualityFirst(test);
    const std::uint32_t variable = EqualityVariable(test);
    if (variable != kNoVariable) {
      NewName(variable, letter);
    }
    Replace(test);
  }

  /// When Soar builds a condition from its network, the equality test comes first, after goal tests; but tests that
  /// compare a field with itself come before it.
  static void PutEqualityFirst(TestDraft& test) {
    const std::uint32_t variable = EqualityVariable(test);
    DraftList<TestDraft> goals, before, equality, others;
    for (TestDraft* part = test.parts.first; part != nullptr;) {
      TestDraft* const next = part->next;
      const bool goal = part->kind == TestKind::kState || part->kind == TestKind::kImpasse;
      if (part->kind == TestKind::kEqual) {
        equality.Add(part);
      } else {
        (goal && others.empty() ? goals : others).Add(part);
        if (!goal && variable != kNoVariable && part->variable == variable && part->referent.IsVariable()) {
          before.Append(others);
          others = {};
        }
      }
      part = next;
    }
    test.parts = goals;
    test.parts.Append(before);
    test.parts.Append(equality);
    test.parts.Append(others);
  }

  void Replace(TestDraft& test) {
    if (test.referent.IsVariable()) {
      test.referent = NewName(test.variable, 'v');
    }
    for (TestDraft& part : test.parts) {
      Replace(part);
    }
  }

  void RenamePlain(ValueDraft& value, char letter) {
    if (value.kind != RhsValueKind::kFunction && value.symbol.IsVariable()) {
      value.symbol = NewName(value.variable, letter);
    }
  }

  void RenameArguments(ValueDraft& value) {
    for (ValueDraft& argument : value.arguments) {
      RenamePlain(argument, 'v');
      RenameArguments(argument);
    }
  }

  Symbol NewName(std::uint32_t variable, char letter) {
    Symbol& name = names_[variable];
    if (!name) {
      char text[16] = {'<', letter};
      char* end = std::to_chars(text + 2, std::end(text) - 1, ++count_[static_cast<std::size_t>(letter - 'a')]).ptr;
      *end++ = '>';
      name = symbols_.Variable({text, static_cast<std::size_t>(end - text)});
    }
    return name;
  }

  char LetterOf(Symbol attribute) const {
    if (attribute.IsInteger() || attribute.IsFloat()) {
      return attribute.IsInteger() ? 'i' : 'f';
    }
    if (attribute.IsString() || attribute.IsVariable()) {
      const std::string_view text = symbols_.Text(attribute);
      const std::size_t at = attribute.IsVariable() ? 1 : 0;
      if (at < text.size() && IsLetter(text[at])) {
        return ToLower(text[at]);
      }
    }
    return 'v';
  }

  SymbolTable& symbols_;
  std::vector<Symbol> names_;  ///< By the variable's number.
  std::array<int, 26> count_{};
};

}  // namespace

void RenameVariables(RuleDraft& rule, const VariableIndex& variables, SymbolTable& symbols) {
  Renamer renamer(symbols, variables);
  renamer.Rename(rule.conditions);
  renamer.Rename(rule.actions);
}

}  // namespace soarbox::kernel
