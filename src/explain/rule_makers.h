// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "explain/mind_view.h"
#include "explain/rule_text.h"

namespace soarbox::explain {

/// Whether a rule makes the element that a condition of another rule requires. Only kNo and kYes are certain.
enum class Makes : std::uint8_t {
  kNo,  ///< It makes another attribute, a value that fails the test, or an element of another kind of object: the
        ///< condition tests a state and the action changes no state, or the reverse.
  kElsewhere,  ///< It makes such an element at another path. That is the same object only if two paths lead to it.
  kMaybe,      ///< It makes the element at this path, with a value that is known only when it fires.
  kYes,        ///< It makes the element at this path, and each value that it makes passes the test.
};
Makes WhetherMakes(const RuleText& maker, const RuleText& rule, const ConditionText& condition);

/// Returns a constant that `maker` gives the attribute at the condition's path and that fails the condition's test.
/// Empty if there is none.
std::string OtherValueBy(const RuleText& maker, const RuleText& rule, const ConditionText& condition);

/// Whether a rule itself requires what the condition requires. Then it cannot be the first to make it.
bool WaitsForTheSame(const RuleText& rule, const ConditionText& condition);

/// Whether a rule makes attributes whose names are known only when it fires.
bool MakesAnyAttribute(const RuleText& rule);

/// Whether a rule works in a substate, that is, tests a superstate.
bool IsForSubstate(const RuleText& rule);

/// Paths of the variables in a rule's actions, including those of objects that it creates.
PathMap MadePaths(const RuleText& rule);

/// Removes the leading ^superstate attributes, so that the path begins at the state that they reach.
std::vector<std::string> FromTop(const std::vector<std::string>& path);

/// Returns whether the condition is about an operator that is selected, because its path begins with such an operator.
/// False if it is about a proposal or anything else.
bool AsksForSelected(const RuleText& rule, const ConditionText& condition);

/// Whether a firing of this rule applies an operator: it changes something other than the operator itself and the
/// substate in which other rules work on it.
bool Changes(const RuleText& rule);

}  // namespace soarbox::explain
