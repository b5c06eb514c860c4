// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/observer.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

/// One preference of an operator slot, as input of the decision procedure.
struct SlotPreference {
  PreferenceType type = PreferenceType::kAcceptable;
  Symbol value;
  Symbol referent;    ///< For better, worse and binary indifferent.
  double number = 0;  ///< For numeric indifferent.
  PreferenceId preference = PreferenceId::kNone;
};

struct DecisionTrace;
enum class DecisionStage : std::uint8_t;

/// A value that the procedure has not dropped.
struct Candidate {
  Symbol value;
  PreferenceId preference =
      PreferenceId::kNone;         ///< The first acceptable (or require) preference for it, in list order.
  bool is_numeric = false;         ///< It has a numeric-indifferent preference. (Others are listed as ^non-numeric.)
  double number_sum = 0;           ///< Sum of its numeric-indifferent preferences.
  std::uint32_t number_count = 0;  ///< Number of its numeric-indifferent and binary-indifferent preferences. In a mean,
                                   ///< a binary one counts as 0.
};

/// The procedure that decides an operator slot (Soar manual 2.4; docs/spec/kernel_features.md, section 11).
///
/// A pure function of the preferences, except for scratch memory: it is kept so that decisions do not allocate in the
/// steady state. Makes no random choice among indifferent candidates (see exploration.h). Therefore it can also be used
/// to check earlier decisions.
class PreferenceSemantics {
 public:
  struct Outcome {
    /// An impasse over `candidates`; kNone if there is a winner, a choice among indifferent candidates, or no
    /// candidate.
    ImpasseType impasse = ImpasseType::kNone;
    /// Without an impasse, one is the winner; several are mutually indifferent, and exploration selects one. Their
    /// order is the reverse of the slot's list: candidates of lower goals come first. Within a goal, they are in the
    /// order in which their preferences entered the slot. An elaboration adds the preferences of its newest firing
    /// first. Of one firing, it adds those of the last action first.
    std::span<const Candidate> candidates;
  };

  /// `preferences` are all preferences of the slot, in the order of its lists. `forced` is a value that is selected
  /// immediately if it has an acceptable preference (`decide select`), or none. With a `trace`, records which
  /// candidates are dropped and why; without one, recording costs nothing. The outcome is valid until the next call.
  Outcome Decide(std::span<const SlotPreference> preferences, Symbol forced = {}, DecisionTrace* trace = nullptr);

 private:
  static constexpr std::uint32_t kNowhere = 0xFFFFFFFFu;
  static constexpr std::size_t kFewPreferences = 16;

  void CollectCandidates(std::span<const SlotPreference> preferences);
  Outcome DecideRequired(std::span<const SlotPreference> preferences);
  /// Returns true if all candidates are dominated (a conflict). Else drops the dominated ones.
  bool DropDominated(std::span<const SlotPreference> preferences);
  void KeepBest(std::span<const SlotPreference> preferences);
  void DropWorst(std::span<const SlotPreference> preferences);
  bool AllIndifferent(std::span<const SlotPreference> preferences);
  void AddNumbers(std::span<const SlotPreference> preferences);
  void MarkValuesOf(std::span<const SlotPreference> preferences, PreferenceType type);
  /// The index of the candidate that this preference alone drops at a stage, or kNowhere.
  std::uint32_t Loser(const SlotPreference& preference, DecisionStage stage) const;
  /// Marks the candidates that a stage drops.
  void MarkLosers(std::span<const SlotPreference> preferences, DecisionStage stage);
  // Record in the trace which candidates will be dropped, or which preferences settle the decision.
  void NoteLosers(std::span<const SlotPreference> preferences, DecisionStage stage);
  void NoteBest(std::span<const SlotPreference> preferences);
  void NoteRequired(std::span<const SlotPreference> preferences);
  void NoteForced(Symbol forced);
  void NoteSettling(std::span<const SlotPreference> preferences);
  /// Keeps the candidates whose mark equals `marked`.
  void Keep(bool marked);
  void IndexCandidates();
  /// The index of a value among the candidates, or kNowhere.
  std::uint32_t Find(Symbol value) const;

  std::vector<Candidate> candidates_;
  std::vector<std::uint8_t> marks_;      ///< Parallel to candidates_.
  std::vector<std::uint64_t> pairs_;     ///< Scratch of AllIndifferent and NoteLosers.
  DecisionTrace* trace_ = nullptr;       ///< Of the current call; null if no trace is wanted.
  bool by_position_ = false;             ///< There are many preferences: candidates are found by position_.
  std::vector<std::uint32_t> position_;  ///< By identifier index; kNowhere if it is not a candidate.
  std::vector<std::uint32_t> indexed_;   ///< The identifier indices set in position_.
};

}  // namespace soarbox::kernel
