// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

/// A preference that an instantiation created. It lives while it is in its slot. It also lives while a condition of a
/// substate's instantiation refers to it as the creator of the matched element; learning follows these references.
///
/// kNone ends the lists.
struct Preference {
  static constexpr std::uint16_t kNoAction = 0xFFFF;

  Symbol id, attribute, value;
  Symbol referent;  ///< Of binary and numeric preferences; else none.
  PreferenceType type = PreferenceType::kAcceptable;
  bool o_supported = false;
  bool in_slot = false;  ///< It counts in decisions. False before assertion and after retraction.
  bool on_goal_list = false;
  bool live = false;
  bool is_spent = false;         ///< A clone of an o-supported reject that must never be asserted.
  GoalLevel level = 0;           ///< Of the goal that its instantiation matched.
  std::uint16_t action = 0;      ///< Index of the action that created it; kNoAction: a function created it.
  std::uint32_t stamp = 0;       ///< Running number of its entry into the slot.
  std::uint32_t references = 0;  ///< One for the slot, and one per condition, selection or module that refers to it.
  InstantiationId instantiation = InstantiationId::kNone;
  SlotId slot = SlotId::kNone;
  std::uint32_t seen = 0;            ///< The last backtrace that treated it as a result.
  LinkId value_link, referent_link;  ///< See links.h; none for constants.

  PreferenceId next_in_slot = PreferenceId::kNone, previous_in_slot = PreferenceId::kNone;
  PreferenceId next_of_instantiation = PreferenceId::kNone, previous_of_instantiation = PreferenceId::kNone;
  /// Clones: the same result at other levels. Each justification that passes the result to a higher level creates one.
  PreferenceId next_clone = PreferenceId::kNone, previous_clone = PreferenceId::kNone;
  /// All live preferences that instantiations of one goal created. They are removed with the goal.
  PreferenceId next_of_goal = PreferenceId::kNone, previous_of_goal = PreferenceId::kNone;
};

}  // namespace soarbox::kernel
