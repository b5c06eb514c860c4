// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace soarbox::explain {
struct RuleText;
}

namespace soarbox::mission {

/// A pattern for rules that show a known mistake: written = { tests = ["^status complete"], makes = ["^closed"] }. A
/// rule matches if it contains everything that is listed, and nothing that is listed in `without`. The pattern is
/// compared with the parsed rule: layout, the order of conditions and the names of variables do not matter.
///
/// A clause is "^path value". The path is the end of the path from the state, "^message.place"; "state ^operator" means
/// the entire path. Without a value, any value matches. <x> matches any variable, # any number, {*} an attribute that
/// is a list of tests, and * any text within an attribute or a value. "^operator <x> +" is a proposal that a rule
/// tests, "^operator <x> > <y>" a preference. A clause that begins with - is a condition that must be absent.
struct RulePattern {
  std::vector<std::string> tests;    ///< Conditions.
  std::vector<std::string> makes;    ///< Actions.
  std::vector<std::string> calls;    ///< Functions in actions, optionally with one argument: "write |*<x>*|".
  std::vector<std::string> without;  ///< Conditions and actions that must be absent.

  bool empty() const { return tests.empty() && makes.empty() && calls.empty() && without.empty(); }
  bool Fits(const explain::RuleText& rule) const;
};

/// The error in a clause of `tests`, `makes` or `without`; empty if it is valid.
std::string ProblemOfClause(std::string_view clause);

}  // namespace soarbox::mission
