// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"

namespace soarbox::kernel {

/// The data on identifiers and goals for the match; working memory owns and maintains it. Indexed by Symbol::index() of
/// identifiers; entries beyond the end count as 0.
struct GoalView {
  std::span<const GoalLevel> level_of_goal;  ///< The level of an identifier that is a goal, else 0.
  std::span<const std::uint64_t> lti_of;     ///< The long-term identifier that it is linked to, else 0.

  /// The level of the goal `id`; 0 if the symbol is not a goal.
  GoalLevel LevelOf(Symbol id) const {
    return id.IsIdentifier() && id.index() < level_of_goal.size() ? level_of_goal[id.index()] : GoalLevel{0};
  }
  std::uint64_t LtiOf(Symbol id) const {
    return id.IsIdentifier() && id.index() < lti_of.size() ? lti_of[id.index()] : 0;
  }
};

}  // namespace soarbox::kernel
