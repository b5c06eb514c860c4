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

/// The stages of the decision procedure that drop candidates, in their order.
enum class DecisionStage : std::uint8_t {
  kForced,     ///< A command (`decide select`) selected another candidate.
  kRequire,    ///< Another candidate is required.
  kProhibit,   ///< Prohibited (and perhaps also rejected).
  kReject,     ///< Rejected.
  kDominated,  ///< Another candidate is better. In a conflict the dominated candidates stay.
  kBest,       ///< Other candidates are best.
  kWorst,      ///< Worst, while others are not.
};

/// The record of one decision: which candidates were dropped, at which stage, and because of which preferences. Reused
/// as scratch memory: allocates nothing in the steady state.
struct DecisionTrace {
  struct Drop {
    Symbol value;
    DecisionStage stage = DecisionStage::kForced;
    std::uint32_t first = 0, count = 0;  ///< Range in `by`.
  };
  /// By stage; within a stage in the order of the candidates. Candidates without an entry were not dropped.
  std::vector<Drop> drops;
  /// Indices into the list of preferences. Each preference of a drop is sufficient for it: the candidate stays at that
  /// stage only if all of them are missing. Drops may share entries.
  std::vector<std::uint32_t> by;
  /// Indices of further preferences. These make several candidates indifferent and give them their numbers, require the
  /// selected candidate, or cause a constraint failure.
  std::vector<std::uint32_t> settling;

  std::span<const std::uint32_t> By(const Drop& drop) const { return std::span(by).subspan(drop.first, drop.count); }
  void Clear() {
    drops.clear();
    by.clear();
    settling.clear();
  }
};

/// A decision as reported to observers of kReason. Valid only during the call.
struct DecisionReport {
  Symbol goal;
  GoalLevel level = 0;
  ImpasseType impasse = ImpasseType::kNone;  ///< If kNone and `selected` is none: a no-change.
  /// None for an impasse. In Agent::ExplainDecision, the currently selected operator, even if it would lose now.
  Symbol selected;
  bool is_forced = false;
  std::span<const SlotPreference> preferences;  ///< All preferences in the slot.
  std::span<const Candidate> candidates;        ///< The remaining candidates.
  const DecisionTrace& trace;
};

/// True if a drop was decisive: without its preferences, the outcome would differ. False if the candidate would also
/// have lost at a later stage.
bool IsDecisive(std::span<const SlotPreference> preferences, const DecisionTrace& trace,
                const DecisionTrace::Drop& drop);

}  // namespace soarbox::kernel
