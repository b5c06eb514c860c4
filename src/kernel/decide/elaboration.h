// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/match/match_set.h"
#include "kernel/observer.h"

namespace soarbox::kernel {

struct AgentCore;

/// The elaboration loop of the propose and apply phases. Determines the active level and which rules fire, and runs the
/// working memory phase. Higher goals go first (the waterfall). Rules of a lower goal fire in the same elaboration only
/// if their actions affect only levels below the one that is changing.
class Elaboration {
 public:
  explicit Elaboration(AgentCore& core) : core_(core) {
    put_back_.reserve(8);
    garbage_.reserve(8);
  }

  enum class Next : std::uint8_t { kElaborate, kPhaseEnds, kInconsistent };

  /// Call at the beginning of a propose or apply phase.
  void BeginPhase();
  /// The next step of the phase: another elaboration at the active level, or the end of the phase.
  Next Determine(bool apply);
  /// Runs one elaboration: the preference phase at the active level, then the working memory phase.
  void Run(bool apply);

  /// Decides changed slots, updates levels of identifiers and passes the changes to the match.
  void ApplyWorkingMemoryChanges();
  /// Like ApplyWorkingMemoryChanges, but decides no ordinary slots: those that changed outside an elaboration are
  /// decided in the next one.
  void ApplyBufferedChanges();
  /// Frees removed elements, unless a match is still waiting for its retraction.
  void BuryDead();
  std::uint32_t count() const { return count_; }
  FiringType firing_type() const { return firing_; }
  GoalLevel active_level() const { return active_; }
  void Clear();

 private:
  bool HasWork(GoalLevel level, bool apply) const;
  bool HasIeWork(GoalLevel level) const;
  /// The highest goal, from `from` down, that has something to do; 0 if there is none.
  GoalLevel HighestActive(GoalLevel from, bool apply) const;
  Next DetermineApply(GoalLevel previous);
  FiringType TypeAt(GoalLevel level) const;
  void PreferencePhase(bool apply);
  void FireLevel(GoalLevel level, bool first_pass, GoalLevel& change_level);
  [[gnu::flatten]] void AssertNew();
  void RetractLevel(GoalLevel level);
  [[gnu::flatten]] void Retract(MatchId match);

  AgentCore& core_;
  GoalLevel active_ = 0;
  FiringType firing_ = FiringType::kIe;
  std::uint32_t count_ = 0;  ///< Number of elaborations in this phase.
  std::vector<MatchId> put_back_;
  std::vector<PreferenceId> o_rejects_;
  std::vector<Symbol> garbage_;
};

}  // namespace soarbox::kernel
