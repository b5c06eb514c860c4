// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/memory/preference.h"

namespace soarbox::kernel {

class Decision;
class GoalDependencySets;
struct LargeSlot;
class PreferenceChanges;
class WmeChanges;
class WorkingMemory;

/// Converts preferences to elements once per working memory phase. An ordinary slot gets an element for every
/// acceptable value that is not rejected. An operator slot gets the elements of its acceptable and required values (the
/// operator is decided later).
class SlotDecision {
 public:
  /// The parts of the agent that it uses.
  struct Uses {
    WorkingMemory& memory;
    WmeChanges& changes;
    PreferenceChanges& preferences;
    GoalDependencySets& gds;
    Decision& decision;
  };
  explicit SlotDecision(const Uses& uses) : uses_(uses) { values_.reserve(8); }

  /// Decides all changed ordinary slots, the one changed last first.
  [[gnu::flatten]] void DecideChangedSlots();
  /// Updates the acceptable elements of all operator slots that changed. Removes a selected operator whose acceptable
  /// element was removed.
  [[gnu::flatten]] void UpdateAcceptables();
  void Clear() {}

 private:
  struct Value {
    Symbol value;
    PreferenceId preference = PreferenceId::kNone;
    bool present = false;  ///< It has an element.
  };

  [[gnu::noinline]] void Decide(SlotId slot);
  /// The fast path for slots with no preference, or with one that is acceptable. Without it, rl-grid, column-sums and
  /// decide-loop take 3 % more instructions. CheckSlot (invariants.cpp) compares the elements of all paths with the
  /// preferences, after each phase of random agents (random_agents_test.cpp).
  void DecideSingle(SlotId slot, PreferenceId only);
  /// The fast path for slots with very many preferences of which only acceptable ones changed. Without it, adding
  /// 1,600 values to an attribute, one in each decision, takes eight times as many instructions.
  [[gnu::noinline]] void DecideLarge(SlotId slot, const LargeSlot& large);
  void MakeElement(SlotId slot, const Value& value);
  void UpdateAcceptables(SlotId slot);
  /// Adds the value unless it is in values_ already or is excluded.
  void AddValue(Symbol value, PreferenceId preference);
  /// The index of a value in values_, or kNowhere.
  std::uint32_t FindValue(Symbol value) const;
  void IndexValue(std::uint32_t place);
  void ResetValues();

  static constexpr std::uint32_t kNowhere = 0xFFFFFFFFu;
  static constexpr std::size_t kLinearLimit = 8;

  Uses uses_;
  std::vector<Value> values_;
  std::vector<Symbol> excluded_;
  std::vector<Symbol> changed_;       ///< Scratch of DecideLarge.
  std::vector<WmeId> lost_;           ///< Likewise.
  std::vector<std::uint32_t> table_;  ///< Open addressing over values_ when there are many.
  std::size_t indexed_ = 0;           ///< Number of values that are in the table.
};

}  // namespace soarbox::kernel
