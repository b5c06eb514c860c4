// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

/// A preference that an instantiation made. It lives while it stands in its slot or while a condition of a substate's
/// instantiation names it as its creator (learning follows these).
///
/// kNone ends the lists.
struct Preference {
  static constexpr std::uint16_t kNoAction = 0xFFFF;

  Symbol id, attribute, value;
  Symbol referent;  ///< Of binary and numeric preferences, else none.
  PreferenceType type = PreferenceType::kAcceptable;
  bool o_supported = false;
  bool in_slot = false;  ///< Counts for decisions; false before assertion and after retraction.
  bool on_goal_list = false;
  bool live = false;
  bool is_spent = false;         ///< A copy of an o-supported reject: never to be asserted.
  GoalLevel level = 0;           ///< Of the goal that its instantiation matched.
  std::uint16_t action = 0;      ///< Which action of its instantiation's rule made it; kNoAction: a function did.
  std::uint32_t stamp = 0;       ///< When it entered its slot: running number.
  std::uint32_t references = 0;  ///< One for the slot, one per condition that names it.
  InstantiationId instantiation = InstantiationId::kNone;
  SlotId slot = SlotId::kNone;
  std::uint32_t seen = 0;            ///< The last backtrace that took it for a result.
  LinkId value_link, referent_link;  ///< See links.h; none for constants.

  PreferenceId next_in_slot = PreferenceId::kNone, previous_in_slot = PreferenceId::kNone;
  PreferenceId next_of_instantiation = PreferenceId::kNone, previous_of_instantiation = PreferenceId::kNone;
  /// The same result at other levels: each justification on the way up makes one.
  PreferenceId next_clone = PreferenceId::kNone, previous_clone = PreferenceId::kNone;
  /// All preferences that matches of one goal made, and that live: they go when the goal goes.
  PreferenceId next_of_goal = PreferenceId::kNone, previous_of_goal = PreferenceId::kNone;
};

}  // namespace soarbox::kernel
