// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>

namespace soarbox::explain {

/// The first condition of a rule that does not match, and what there is instead.
struct RuleWait {
  enum class Kind : std::uint8_t {
    kOther,       ///< There is another value, or no rule can make the element now.
    kUnmade,      ///< No percept and no rule makes such an attribute.
    kOperator,    ///< No operator is selected, or another one.
    kAbsent,      ///< There is no such element now.
    kAbsentMade,  ///< There is no such element now; rule `maker` makes it whenever it fires.
    kElsewhere,   ///< There is such an element, but it does not fit the other conditions.
    kExists,      ///< There is an element that the rule excludes.
  };
  /// What there is, as part of a sentence.
  struct Found {
    std::string text;
    Kind kind = Kind::kOther;
    std::string maker = {};
  };

  std::string rule;
  std::string condition;     ///< "^next 3"
  std::string attribute;     ///< The last attribute of its path: "next"; empty if the path is not known.
  bool is_of_state = false;  ///< The condition tests the state itself, not an object below it.
  bool is_excluded = false;  ///< The rule requires that there is no such element.
  Found found;               ///< "it is 2"; empty if it is not known.

  /// "requires ^next 3, but it is 2"
  std::string Requires() const;
  /// "rule x requires ^next 3, but it is 2"
  std::string Text() const;
};

}  // namespace soarbox::explain
