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

/// Conditions of a rule with too many partial matches. The rule tests one attribute of one object several times, and
/// only later conditions distinguish the values. With n values, n such conditions have n to the power of n partial
/// matches.
struct RuleCrowd {
  kernel::Symbol attribute;
  std::size_t values = 0;        ///< Maximum number of conditions on the attribute whose values are not distinguished
                                 ///< yet. It is also used as the number of values.
  std::size_t first = 0;         ///< The first condition on the attribute, in match order.
  std::size_t settled = 0;       ///< The condition that distinguishes its value.
  std::vector<std::size_t> way;  ///< The conditions from `first` to `settled`, both included.

  /// The number of partial matches if there are as many values as conditions.
  double PartialMatches() const;
};

/// The worst crowd of a rule; nothing if RuleCrowd::values would be below six (46,656 partial matches).
std::optional<RuleCrowd> FindCrowd(const kernel::Production& rule);
/// Suggests a better order of conditions, and other improvements: a sentence without a full stop.
std::string AdviceFor(const kernel::Production& rule, const RuleCrowd& crowd, const kernel::SymbolTable& symbols);
/// A warning for each of the last `fresh` rules that has a crowd.
std::vector<Diagnostic> FindRuleCrowds(std::span<const kernel::Production* const> rules, std::size_t fresh,
                                       const kernel::SymbolTable& symbols);

}  // namespace soarbox::cli
