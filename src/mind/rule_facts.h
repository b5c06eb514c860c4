// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// The content of a rule as plain values: each field of a condition or action separately, written as in a rule.
/// Variables have their angle brackets, and words have bars if they need them. Paths with dots are expanded. Among
/// several tests in braces, the test for equality comes first.
namespace soarbox::mind {

struct RuleConditionFact {
  std::string id;           ///< The variable, "<s>", without the word `state`.
  std::string attribute;    ///< "name", "<a>", "{ << a b >> <way> }"
  std::string value;        ///< "<o>", "> 3", "{ > 3 <x> }"; empty if any value matches.
  bool acceptable = false;  ///< ^operator <o> +
  bool negated = false;     ///< The condition itself or its group is negated.
  bool on_state = false;    ///< The word `state` tests its object, in this or another condition.
  int group = 0;            ///< The negated group -{ ... } that contains it, counted from 1; 0: none.
  friend bool operator==(const RuleConditionFact&, const RuleConditionFact&) = default;
};

struct RuleActionFact {
  std::string id, attribute;
  std::string value;     ///< A constant, a variable, or a call, "(+ <n> 1)".
  std::string sign;      ///< Sign of the preference: "+", "-", ">". Also present if a printed rule omits +.
  std::string referent;  ///< The referent of a binary or numeric preference; else empty.
  friend bool operator==(const RuleActionFact&, const RuleActionFact&) = default;
};

/// A call of a function, with the kernel's name of the function. A nested call is listed separately, after the outer
/// one.
struct RuleCallFact {
  std::string function;
  std::vector<std::string> arguments;  ///< As they are written; "(+ <n> 1)" for a call.
  friend bool operator==(const RuleCallFact&, const RuleCallFact&) = default;
};

struct RuleFacts {
  enum class Support : std::uint8_t { kByConditions, kOSupport, kISupport };

  std::string name;
  std::string file;  ///< The file that contains the rule; empty if it is not known.
  int line = 0, column = 0;
  Support support = Support::kByConditions;
  std::vector<RuleConditionFact> conditions;  ///< In match order; the conditions of a group are at the position of the
                                              ///< group.
  std::vector<RuleActionFact> actions;        ///< In firing order. Calls that are actions by themselves are only in
                                              ///< `calls`.
  std::vector<RuleCallFact> calls;
  bool acts = false;         ///< It has at least one action or call.
  bool is_template = false;  ///< It has the flag :template.
};

}  // namespace soarbox::mind
