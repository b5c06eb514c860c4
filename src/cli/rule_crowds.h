// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "kernel/base/symbol_table.h"
#include "kernel/rules/production.h"

namespace soarbox::cli {

/// Conditions of a rule that match in too many ways before any test tells their values apart: the rule tests one
/// attribute of one object several times and only then asks which value is which. With as many values as conditions, n
/// conditions match in n to the n-th ways.
struct RuleCrowd {
  kernel::Symbol attribute;
  std::size_t values = 0;        ///< Conditions on the attribute, in a row; as many values are expected.
  std::size_t first = 0;         ///< The first of them, in match order,
  std::size_t settled = 0;       ///< and the condition that tells its value apart.
  std::vector<std::size_t> way;  ///< The conditions from one to the other, both included.

  /// The number of partial matches if there are as many values as conditions.
  double PartialMatches() const;
};

/// The worst crowd of a rule; none below six conditions (46,656 partial matches).
std::optional<RuleCrowd> FindCrowd(const kernel::Production& rule);
/// The order that would help, and what else would help: a sentence without a full stop.
std::string AdviceFor(const kernel::Production& rule, const RuleCrowd& crowd, const kernel::SymbolTable& symbols);
/// A warning for each of the last `fresh` rules that has a crowd.
std::vector<Diagnostic> FindRuleCrowds(std::span<const kernel::Production* const> rules, std::size_t fresh,
                                       const kernel::SymbolTable& symbols);

}  // namespace soarbox::cli
