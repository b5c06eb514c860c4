// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "explain/mind_view.h"
#include "explain/rule_text.h"

namespace soarbox::explain {

/// Whether a rule makes what a condition of another one asks for. Only kNo and kYes are certain.
enum class Makes : std::uint8_t {
  kNo,         ///< Another attribute, a value that fails the test, or it is of a state and the other one is not.
  kElsewhere,  ///< Such an element at another path: of the same object only if two paths lead to it.
  kMaybe,      ///< There, with a value that is known when it fires.
  kYes,        ///< There, and every value that it makes passes the test.
};
Makes WhetherMakes(const RuleText& maker, const RuleText& rule, const ConditionText& condition);

/// A constant that a rule gives this attribute where the condition looks, and which fails the condition's test; empty
/// if it gives none.
std::string OtherValueBy(const RuleText& maker, const RuleText& rule, const ConditionText& condition);

/// Whether a rule itself waits for what the condition asks for: then it cannot be the first to make it.
bool WaitsForTheSame(const RuleText& rule, const ConditionText& condition);

/// True if a rule makes attributes whose names are known when it fires.
bool MakesAnyAttribute(const RuleText& rule);

/// Whether a rule works in a substate: it tests a superstate.
bool IsForSubstate(const RuleText& rule);

/// Where the variables of a rule's actions lie, those of objects that it makes included.
PathMap MadePaths(const RuleText& rule);

/// A path written from the state that it reaches: without ^superstate.
std::vector<std::string> FromTop(const std::vector<std::string>& path);

/// Names of the operators whose selection a rule tests, as this condition's path begins there; false if the condition
/// is not about an operator that is selected, but about a proposal or something else.
bool AsksForSelected(const RuleText& rule, const ConditionText& condition);

/// Whether a firing of this rule applies an operator: it changes something other than the operator and the substate in
/// which others work on the operator.
bool Changes(const RuleText& rule);

}  // namespace soarbox::explain
