// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace soarbox::explain {
struct RuleText;
}

namespace soarbox::mission {

/// What a rule looks like that shows a known mistake: written = { tests = ["^status complete"], makes = ["^closed"] }.
/// A rule fits if it has everything that is listed, and nothing of what is listed in `without`. The pattern is compared
/// with the rule as it was read: layout, the order of conditions and the names of variables do not matter.
///
/// A clause is "^path value". The path is the end of the path from the state, "^message.place"; "state ^operator" means
/// the whole path. Without a value any will do. <x> stands for any variable, # for
/// any number, {*} for an attribute that is a list of tests, * for any text within an attribute or a value: "^operator
/// <x> +" is a proposal that a rule tests,
/// "^operator <x> > <y>" a preference. A clause that begins with -
/// is a condition that must be absent.
struct RulePattern {
  std::vector<std::string> tests;    ///< Conditions.
  std::vector<std::string> makes;    ///< Actions.
  std::vector<std::string> calls;    ///< Functions in actions, perhaps with one argument: "write |*<x>*|".
  std::vector<std::string> without;  ///< Conditions and actions that it lacks.

  bool empty() const { return tests.empty() && makes.empty() && calls.empty() && without.empty(); }
  bool Fits(const explain::RuleText& rule) const;
};

/// What is wrong with a clause of `tests`, `makes` or `without`; empty: nothing.
std::string ProblemOfClause(std::string_view clause);

}  // namespace soarbox::mission
