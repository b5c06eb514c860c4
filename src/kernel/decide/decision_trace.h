// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/base/symbol.h"
#include "kernel/decide/preference_semantics.h"
#include "kernel/observer.h"

namespace soarbox::kernel {

/// The steps of the decision procedure that drop candidates, in their order.
enum class DecisionStage : std::uint8_t {
  kForced,     ///< A command (`decide select`) chose another one.
  kRequire,    ///< Another one is required.
  kProhibit,   ///< Prohibited (and perhaps rejected, too).
  kReject,     ///< Rejected.
  kDominated,  ///< Another candidate is better. In a conflict all are, and stay.
  kBest,       ///< Others are best.
  kWorst,      ///< Worst, and not all are.
};

/// What the decision procedure noted of one decision: who was dropped at which stage, by which preferences. Scratch
/// that is used again: it allocates nothing in the steady state.
struct DecisionTrace {
  struct Drop {
    Symbol value;
    DecisionStage stage = DecisionStage::kForced;
    std::uint32_t first = 0, count = 0;  ///< Of `by`.
  };
  /// By stage; within a stage the newest candidate first. Who is in none of them is left.
  std::vector<Drop> drops;
  /// Places in the list of preferences. Each of a drop's alone suffices for it: without all of them, and only then, the
  /// candidate is not dropped at that stage. Drops may share them.
  std::vector<std::uint32_t> by;
  /// Places of the preferences that let several candidates be indifferent and give them their numbers, and of those
  /// that require what was decided or failed.
  std::vector<std::uint32_t> settling;

  std::span<const std::uint32_t> By(const Drop& drop) const { return std::span(by).subspan(drop.first, drop.count); }
  void Clear() {
    drops.clear();
    by.clear();
    settling.clear();
  }
};

/// A decision as an observer of kReason hears it. Valid during the call only.
struct DecisionReport {
  Symbol goal;
  GoalLevel level = 0;
  ImpasseType impasse = ImpasseType::kNone;  ///< kNone without a selected operator: nothing is left, a no-change.
  /// None for an impasse. In Agent::ExplainDecision: the operator that is selected now, even if it would now lose.
  Symbol selected;
  bool is_forced = false;
  std::span<const SlotPreference> preferences;  ///< All that stand in the slot.
  std::span<const Candidate> candidates;        ///< Those left.
  const DecisionTrace& trace;
};

/// True if a drop decided something: without the preferences that it rests on the outcome would be another one. False
/// where the candidate would have lost at a later stage all the same.
bool IsDecisive(std::span<const SlotPreference> preferences, const DecisionTrace& trace,
                const DecisionTrace::Drop& drop);

}  // namespace soarbox::kernel
