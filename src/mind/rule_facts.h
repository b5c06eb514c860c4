// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// What a rule says, as plain values: each field of a condition or action by itself, as a rule would write it.
/// Variables have their brackets, words that need them their bars; dots of paths are expanded. Of several tests in
/// braces the one for equality comes first.
namespace soarbox::mind {

struct RuleConditionFact {
  std::string id;           ///< The variable, "<s>", without the word state.
  std::string attribute;    ///< "name", "<a>", "{ << a b >> <way> }"
  std::string value;        ///< "<o>", "> 3", "{ > 3 <x> }"; empty if any value will do.
  bool acceptable = false;  ///< ^operator <o> +
  bool negated = false;     ///< The condition itself, or a group that holds it.
  bool on_state = false;    ///< Its object is tested with the word state, here or in another condition.
  int group = 0;            ///< Which negated group -{ ... } holds it, counted from 1; 0: none.
  friend bool operator==(const RuleConditionFact&, const RuleConditionFact&) = default;
};

struct RuleActionFact {
  std::string id, attribute;
  std::string value;     ///< A constant, a variable, or a call, "(+ <n> 1)".
  std::string sign;      ///< Of the preference: "+", "-", ">"; also where a printed rule leaves + out.
  std::string referent;  ///< What a binary or numeric preference names; empty if it names nothing.
  friend bool operator==(const RuleActionFact&, const RuleActionFact&) = default;
};

/// A call of a function, with its name as the kernel knows it. One inside another is listed after it, too.
struct RuleCallFact {
  std::string function;
  std::vector<std::string> arguments;  ///< As they are written; "(+ <n> 1)" for a call.
  friend bool operator==(const RuleCallFact&, const RuleCallFact&) = default;
};

struct RuleFacts {
  enum class Support : std::uint8_t { kByConditions, kOSupport, kISupport };

  std::string name;
  std::string file;  ///< Where the rule was read from; empty if that is not known.
  int line = 0, column = 0;
  Support support = Support::kByConditions;
  std::vector<RuleConditionFact> conditions;  ///< In match order, those of groups where the group is.
  std::vector<RuleActionFact> actions;        ///< In firing order, without calls alone: those are among `calls`.
  std::vector<RuleCallFact> calls;
  bool acts = false;  ///< It has actions or calls.
};

}  // namespace soarbox::mind
