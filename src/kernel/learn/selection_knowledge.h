// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"

namespace soarbox::kernel {

class GoalStack;
class PreferenceChanges;
class WorkingMemory;

/// The preferences that decided the selection of operators in substates: without them, another operator or none would
/// have been selected. They are recorded at the selection. A rule that fires in the substate and tests the operator
/// refers to them, so that its results depend on them (operator selection knowledge).
class SelectionKnowledge {
 public:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

  /// The parts of the agent that it uses.
  struct Uses {
    const WorkingMemory& memory;
    const GoalStack& goals;
    PreferenceChanges& preferences;
  };
  explicit SelectionKnowledge(const Uses& uses) : uses_(uses) {}

  /// The operator of a substate was selected: records the preferences that decided. `forced`: selected by command,
  /// without such preferences.
  void OperatorSelected(GoalLevel level, Symbol winner, bool forced);
  void GoalRemoved(GoalLevel level);
  /// The preferences that decided the operator of the goal at this level, or kNone.
  std::uint32_t OfGoal(GoalLevel level) const { return level < of_goal_.size() ? of_goal_[level] : kNone; }

  std::span<const PreferenceId> preferences(std::uint32_t selection) const { return sets_[selection].preferences; }
  /// Appends the prohibit preferences in the slot of an element, oldest first.
  void CollectProhibits(WmeId wme, std::vector<PreferenceId>& out) const;
  /// Returns a set of these preferences and those of the set `selection`, if given; with one reference.
  std::uint32_t With(std::vector<PreferenceId> preferences, std::uint32_t selection);
  void AddReference(std::uint32_t selection) { ++sets_[selection].references; }
  /// `later`: preferences without references are freed together with the next freed preference.
  [[gnu::noinline]] void DropReference(std::uint32_t selection, bool later);
  /// Visits all referenced preferences, once for each set that refers to them.
  template <typename Visit>
  void ForEachPreference(Visit&& visit) const {
    for (const Set& set : sets_) {
      for (const PreferenceId p : set.preferences) visit(p);
    }
  }
  void Clear();

 private:
  struct Set {
    std::uint32_t references = 0;
    std::vector<PreferenceId> preferences;
  };
  /// Creates a set with one reference; the set refers to its preferences.
  std::uint32_t Make(std::vector<PreferenceId> preferences);
  void Collect(SlotId slot, Symbol winner);
  void Add(PreferenceId preference);
  bool SaysTheSame(PreferenceId a, PreferenceId b) const;

  Uses uses_;
  std::vector<Set> sets_;
  std::vector<std::uint32_t> free_;
  std::vector<std::uint32_t> of_goal_;     ///< By level.
  std::vector<PreferenceId> collected_;    ///< Scratch.
  std::vector<Symbol> candidates_, left_;  ///< Scratch.
};

}  // namespace soarbox::kernel
