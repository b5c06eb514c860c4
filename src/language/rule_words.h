// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "language/lines.h"

namespace soarbox::language {

enum class WordKind : std::uint8_t {
  kRuleName,
  kVariable,
  kAttribute,  ///< One part of ^io.input-link.
  kValue,      ///< A constant value of an attribute, or a constant that it is compared with.
  kFunction,   ///< A function that is called in the actions.
};

/// A word of a rule, and the position of its object in working memory.
struct Word {
  WordKind kind = WordKind::kValue;
  Span span;         ///< In the text of the rule.
  std::string text;  ///< Without bars.
  /// Attributes from the state on. For an attribute, it includes the attribute ("io.input-link.self"); for a value, it
  /// leads to the value; for a variable, to its object, and is "" for the state. Paths through a superstate begin with
  /// "superstate": "superstate.io". If there is no path from the state to the object, it begins with the variable:
  /// "<x>.color".
  std::string path;
  bool in_actions = false;
  bool negated = false;  ///< An attribute after -.
};

/// Whether the value is the name of an operator, or of the state in which agents work on an operator.
bool IsOperatorName(const Word& word);

/// The words of one rule, beginning with its "sp {".
struct RuleWords {
  std::string name;  ///< Empty if there is none.
  Span name_span;
  std::vector<Word> words;                   ///< In the order of the text.
  std::map<std::string, std::string> paths;  ///< Paths of the variables, see Word.
  std::set<std::size_t> heads;               ///< Positions of the variables at the beginning of clauses.
  std::size_t arrow = std::string::npos;     ///< Position of -->.
};

/// Finds the words of a rule in its text, for positions and names only; the kernel's reader decides whether the rule is
/// valid. Accepts any text, also one that is being typed.
RuleWords ReadWords(std::string_view rule);

/// Splits a text into parts that begin with a rule (`sp`, `gp`) at the beginning of a line. The text before the first
/// rule is not included.
std::vector<Span> SplitAtRules(std::string_view text);

}  // namespace soarbox::language
