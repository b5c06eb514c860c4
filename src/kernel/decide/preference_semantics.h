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

/// One preference of an operator slot, as the decision procedure sees it.
struct SlotPreference {
  PreferenceType type = PreferenceType::kAcceptable;
  Symbol value;
  Symbol referent;    ///< Better, worse, binary indifferent.
  double number = 0;  ///< Numeric indifferent.
  PreferenceId preference = PreferenceId::kNone;
};

struct DecisionTrace;
enum class DecisionStage : std::uint8_t;

/// One value that the procedure has left in the running.
struct Candidate {
  Symbol value;
  PreferenceId preference =
      PreferenceId::kNone;         ///< The first acceptable (or require) preference for it, in list order.
  bool is_numeric = false;         ///< Has a numeric-indifferent preference (the others are listed as ^non-numeric).
  double number_sum = 0;           ///< Of its numeric-indifferent preferences.
  std::uint32_t number_count = 0;  ///< And of its binary indifferent ones: in an average each of them counts as 0.
};

/// The procedure that decides an operator slot (Soar manual 2.4; kernel_features section 11).
///
/// A pure function of the preferences but for scratch memory, which is kept so that deciding allocates nothing in the
/// steady state. The random choice among indifferent candidates is not made here (exploration.h), so the same call
/// serves for deciding and for checking that a decision still stands.
class PreferenceSemantics {
 public:
  struct Outcome {
    /// kNone: a winner, a choice among equals or nothing at all; else an impasse over `candidates`.
    ImpasseType impasse = ImpasseType::kNone;
    /// None, one (the winner) or more. More than one and no impasse: mutually indifferent, exploration chooses.
    /// Newest first: the last action of the instantiation that fired last stands at the front.
    std::span<const Candidate> candidates;
  };

  /// `preferences` are all that stand in the slot, in list order (newest last). `forced` is a value that wins at once
  /// if it has an acceptable preference (`decide select`), or none. The outcome is valid until the next call. With a
  /// `trace` it also says who was dropped and why; without one that costs nothing.
  Outcome Decide(std::span<const SlotPreference> preferences, Symbol forced = {}, DecisionTrace* trace = nullptr);

 private:
  static constexpr std::uint32_t kNowhere = 0xFFFFFFFFu;
  static constexpr std::size_t kFewPreferences = 16;

  void CollectCandidates(std::span<const SlotPreference> preferences);
  Outcome DecideRequired(std::span<const SlotPreference> preferences);
  /// True if every candidate was marked (a conflict); else the marked ones have been dropped.
  bool DropDominated(std::span<const SlotPreference> preferences);
  void KeepBest(std::span<const SlotPreference> preferences);
  void DropWorst(std::span<const SlotPreference> preferences);
  bool AllIndifferent(std::span<const SlotPreference> preferences);
  void AddNumbers(std::span<const SlotPreference> preferences);
  void MarkValuesOf(std::span<const SlotPreference> preferences, PreferenceType type);
  /// The candidate that this preference alone drops at a stage, as the candidates stand, or kNowhere.
  std::uint32_t Loser(const SlotPreference& preference, DecisionStage stage) const;
  /// Marks the losers of a stage.
  void MarkLosers(std::span<const SlotPreference> preferences, DecisionStage stage);
  // Into the trace, before candidates go.
  void NoteLosers(std::span<const SlotPreference> preferences, DecisionStage stage);
  void NoteBest(std::span<const SlotPreference> preferences);
  void NoteRequired(std::span<const SlotPreference> preferences);
  void NoteForced(Symbol forced);
  void NoteSettling(std::span<const SlotPreference> preferences);
  /// Keeps the candidates whose mark is `marked`.
  void Keep(bool marked);
  void IndexCandidates();
  /// Where a value stands among the candidates, or kNowhere.
  std::uint32_t Find(Symbol value) const;

  std::vector<Candidate> candidates_;
  std::vector<std::uint8_t> marks_;      ///< Beside candidates_.
  std::vector<std::uint64_t> pairs_;     ///< Scratch of AllIndifferent and NoteLosers.
  DecisionTrace* trace_ = nullptr;       ///< Of the call under way, if one is wanted.
  bool by_position_ = false;             ///< Many preferences: candidates are found by position_.
  std::vector<std::uint32_t> position_;  ///< By identifier index; kNowhere for those that are no candidates.
  std::vector<std::uint32_t> indexed_;   ///< The identifier indices set in position_.
};

}  // namespace soarbox::kernel
