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
  kValue,      ///< A constant that an attribute has, or is compared with.
  kFunction,   ///< Called in the actions.
};

/// A word of a rule, and where its object stands in working memory.
struct Word {
  WordKind kind = WordKind::kValue;
  Span span;         ///< In the text of the rule.
  std::string text;  ///< Without bars.
  /// Attributes from the state on: of an attribute, itself included ("io.input-link.self"); of a value, those that lead
  /// to it; of a variable, those that lead to its object, "" for the state. Above a state: "superstate.io". Where
  /// nothing leads from the state to the object it begins with the variable: "<x>.color".
  std::string path;
  bool in_actions = false;
  bool negated = false;  ///< An attribute behind -.
};

/// A value that is the name of an operator, or of the state in which one is worked on.
bool IsOperatorName(const Word& word);

/// The words of one rule, from its "sp {" on.
struct RuleWords {
  std::string name;  ///< Empty if there is none.
  Span name_span;
  std::vector<Word> words;                   ///< In the order of the text.
  std::map<std::string, std::string> paths;  ///< Of the variables, see Word.
  std::set<std::size_t> heads;               ///< Where the variables stand that clauses begin with.
  std::size_t arrow = std::string::npos;     ///< Where --> begins.
};

/// Finds the words of a rule in its text. For places and names only: whether the text is a rule is for the kernel's
/// reader to say. Any text gives words, also one that is being typed.
RuleWords ReadWords(std::string_view rule);

/// The parts of a text that begin with a rule (`sp`, `gp`) at the beginning of a line, up to the next one; what comes
/// before the first is not among them.
std::vector<Span> SplitAtRules(std::string_view text);

}  // namespace soarbox::language
