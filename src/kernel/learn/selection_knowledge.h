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

/// What decided the operators of substates: the preferences without which another one, or none, would have been
/// selected. Noted when the operator is selected; a rule that fires in the substate and tests it keeps them, so that
/// its results rest on them (operator selection knowledge).
class SelectionKnowledge {
 public:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

  /// What it uses of the agent.
  struct Uses {
    const WorkingMemory& memory;
    const GoalStack& goals;
    PreferenceChanges& preferences;
  };
  explicit SelectionKnowledge(const Uses& uses) : uses_(uses) {}

  /// The operator of a substate has been selected: notes what decided it. `forced`: by command, so nothing did.
  void OperatorSelected(GoalLevel level, Symbol winner, bool forced);
  void GoalRemoved(GoalLevel level);
  /// What decided the operator of the goal at this level, or kNone.
  std::uint32_t OfGoal(GoalLevel level) const { return level < of_goal_.size() ? of_goal_[level] : kNone; }

  std::span<const PreferenceId> preferences(std::uint32_t selection) const { return sets_[selection].preferences; }
  /// Adds the preferences that prohibit something in the slot of an element, the oldest first.
  void CollectProhibits(WmeId wme, std::vector<PreferenceId>& out) const;
  /// A set of these and what another set has, if there is one; with one reference.
  std::uint32_t With(std::vector<PreferenceId> preferences, std::uint32_t selection);
  void AddReference(std::uint32_t selection) { ++sets_[selection].references; }
  /// `later`: what nothing refers to any more goes with the next preference that is freed.
  [[gnu::noinline]] void DropReference(std::uint32_t selection, bool later);
  /// All that is held, once for each set that holds it.
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
  /// A set with one reference, which holds its preferences.
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
