// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/rules/chunk_variables.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "kernel/base/characters.h"
#include "kernel/rules/rule_reader.h"

namespace soarbox::kernel {

namespace {

class Renamer {
 public:
  explicit Renamer(SymbolTable& symbols) : symbols_(symbols) {}

  void Rename(std::vector<Condition>& conditions) {
    for (Condition& condition : conditions) {
      if (condition.kind == ConditionKind::kConjunctiveNegation) {
        Rename(condition.conditions);
        continue;
      }
      RenameField(condition.id, 's');
      RenameField(condition.attribute, 'a');
      RenameField(condition.value, LetterOf(EqualitySymbol(condition.attribute)));
    }
  }

  /// The value of a make action names its variable; those that only functions use come last.
  void Rename(std::vector<Action>& actions) {
    for (Action& action : actions) {
      if (!action.is_function_call) {
        RenamePlain(action.id, 's');
        RenamePlain(action.attribute, 'a');
        RenamePlain(action.value, LetterOf(action.attribute.symbol));
        RenamePlain(action.referent, 'r');
      }
    }
    for (Action& action : actions) {
      for (RhsValue* value : {&action.attribute, &action.value, &action.referent}) {
        RenameArguments(*value);
      }
    }
  }

 private:
  void RenameField(Test& test, char letter) {
    // The equality test comes first when Soar makes a condition from its network.
    const auto equality = std::find_if(test.parts.begin(), test.parts.end(),
                                       [](const Test& part) { return part.kind == TestKind::kEqual; });
    if (equality != test.parts.end()) {
      const auto goal = [](const Test& part) { return part.kind == TestKind::kState || part.kind == TestKind::kImpasse; };
      std::rotate(std::find_if_not(test.parts.begin(), equality, goal), equality, equality + 1);
    }
    const Symbol symbol = EqualitySymbol(test);
    if (symbol.IsVariable()) {
      NewName(symbol, letter);
    }
    Replace(test);
  }

  void Replace(Test& test) {
    if (test.referent.IsVariable()) {
      test.referent = NewName(test.referent, 'v');
    }
    for (Test& part : test.parts) {
      Replace(part);
    }
  }

  void RenamePlain(RhsValue& value, char letter) {
    if (value.kind != RhsValueKind::kFunction && value.symbol.IsVariable()) {
      value.symbol = NewName(value.symbol, letter);
    }
  }

  void RenameArguments(RhsValue& value) {
    for (RhsValue& argument : value.arguments) {
      RenamePlain(argument, 'v');
      RenameArguments(argument);
    }
  }

  Symbol NewName(Symbol old, char letter) {
    for (const auto& [from, to] : names_) {
      if (from == old) {
        return to;
      }
    }
    const int number = ++count_[static_cast<std::size_t>(letter - 'a')];
    const Symbol fresh = symbols_.Variable("<" + std::string(1, letter) + std::to_string(number) + ">");
    names_.emplace_back(old, fresh);
    return fresh;
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
  std::vector<std::pair<Symbol, Symbol>> names_;
  std::array<int, 26> count_{};
};

}  // namespace

void RenameVariables(Production& rule, SymbolTable& symbols) {
  Renamer renamer(symbols);
  renamer.Rename(rule.conditions);
  renamer.Rename(rule.actions);
}

}  // namespace soarbox::kernel
