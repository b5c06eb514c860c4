// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/match/wme.h"

namespace soarbox::kernel {

/// A complete match of a rule (a token that reached its production node), from its appearance until it is gone and its
/// instantiation has been retracted. After that its handle is used again.
enum class MatchId : std::uint32_t { kNone = 0xFFFFFFFFu };

enum class MatchState : std::uint8_t {
  kFree,
  kPendingAssertion,   ///< Matched, not fired yet. On a list.
  kTaken,              ///< Taken from its list by TakeAssertion; MarkFired or PutBack comes next.
  kFired,              ///< Has an instantiation.
  kPendingRetraction,  ///< No longer matches; its instantiation is to be retracted. On a list.
  kRetracting,         ///< Taken by TakeRetraction; Release comes next.
};

/// What you need to know of a match to fire or show it.
struct PendingMatch {
  MatchId match = MatchId::kNone;
  ProductionId production = ProductionId::kNone;
  Symbol goal;             ///< The lowest goal among the matched elements' identifiers; none if there is none.
  GoalLevel level = 0;     ///< Of that goal; 0 if there is none or it has gone.
  bool o_support = false;  ///< The support that its actions get.

  explicit operator bool() const { return match != MatchId::kNone; }
};

/// The conflict set: complete matches that wait to fire or to be retracted, by level of their goal.
///
/// Each level has a list of i-assertions, one of o-assertions and one of retractions; level 0 holds matches without a
/// goal, or whose goal has gone. New entries go to the head, and lists are consumed from the head. A match's elements
/// are kept here until it is released.
///
/// A new match that equals one that waits for its retraction (same rule, same elements) takes that one's place: nothing
/// fires and nothing is retracted. A hash table finds the retractions that can come back.
///
/// Filled by the Rete, consumed by the decision cycle. Single-threaded. No allocation in the steady state.
class MatchSet {
 public:
  enum class List : std::uint8_t { kIAssertions, kOAssertions, kRetractions };

  // For the decision cycle ------------------------------------------------------------------------------------------

  bool HasAssertions(GoalLevel level, bool o_support) const {
    return level < levels_.size() && levels_[level].head[o_support ? 1 : 0] != kNil;
  }
  bool HasRetractions(GoalLevel level) const { return level < levels_.size() && levels_[level].head[2] != kNil; }
  /// Retractions of matches that touch no goal, or whose goal has gone.
  bool HasNoGoalRetractions() const { return HasRetractions(0); }

  /// Takes the newest assertion of a level; an empty PendingMatch if there is none. Then mark the match as fired, put
  /// it back, or drop it (Release).
  PendingMatch TakeAssertion(GoalLevel level, bool o_support);
  /// Returns taken matches to the head of their lists. `taken` is in the order of taking; they will be taken again in
  /// this order.
  void PutBack(std::span<const MatchId> taken);
  void MarkFired(MatchId match, InstantiationId instantiation);
  InstantiationId InstantiationOf(MatchId match) const { return records_[Index(match)].instantiation; }

  /// Takes the newest retraction of a level (0: the no-goal list), or kNone. Its elements, rule and instantiation stay
  /// readable until Release.
  MatchId TakeRetraction(GoalLevel level);
  /// Forgets a taken match. You can also release a fired match whose instantiation ended otherwise; it stays matched
  /// and silent.
  void Release(MatchId match);

  /// How often GoalRemoved was called.
  std::uint32_t goals_removed() const { return goals_removed_; }
  /// The goal of this level is leaving: its retractions move to the no-goal list, and so do its assertions (they never
  /// fire, and vanish when the goal's elements leave the match).
  void GoalRemoved(GoalLevel level);

  PendingMatch Describe(MatchId match) const;
  MatchState StateOf(MatchId match) const { return records_[Index(match)].state; }
  /// The elements of a match in condition order, one per positive top-level condition. Valid until the next change.
  std::span<const WmeId> Wmes(MatchId match) const {
    const Record& record = records_[Index(match)];
    return {elements_.data() + record.elements, record.element_count};
  }

  /// For display: all entries of one kind over all levels, newest first.
  std::vector<PendingMatch> Pending(List list) const;

  std::size_t MemoryBytes() const;

  // For the Rete ----------------------------------------------------------------------------------------------------

  /// The data of a new match.
  struct Arrival {
    std::uint32_t production = 0;
    std::uint32_t token = 0;
    std::span<const WmeId> elements;
    Symbol goal;
    GoalLevel level = 0;
    bool o_support = false;
  };
  /// An equal match that waits for its retraction and that `arrival.token` matches again; kNone if there is none.
  MatchId Revive(const Arrival& arrival, const WmeTable& wmes);
  /// False if no waiting retraction of the rule can come back.
  bool MayReturn(std::uint32_t production) const { return rules_[production].returnable != 0; }
  /// Call before the first match of a rule.
  void RuleAdded(std::uint32_t production, std::size_t elements, bool interrupts) {
    if (production >= rules_.size()) rules_.resize(production + 1u);
    rules_[production].interrupts = interrupts;
    ExpectElements(elements);
  }
  /// Whether to note new assertions of a rule, see TakeInterrupting.
  void SetInterrupts(std::uint32_t production, bool on) { rules_[production].interrupts = on; }
  bool HasInterrupting() const { return !interrupting_.empty(); }
  /// The rules with interrupts that got a new assertion since the last call, each once.
  std::vector<std::uint32_t> TakeInterrupting() { return std::exchange(interrupting_, {}); }
  /// Frees the room for more rules.
  void ShrinkRules() { rules_.shrink_to_fit(); }
  /// A new pending assertion.
  MatchId Assert(const Arrival& arrival);
  /// A match that counts as fired from the start.
  MatchId AddFired(const Arrival& arrival, InstantiationId instantiation);
  /// The match's token is gone: a pending assertion vanishes, a fired match becomes a retraction. `can_return` is false
  /// when one of its own elements left (then no equal match can appear); `last_timetag` is the highest time tag so far.
  /// Returns false if the record is now free.
  bool TokenGone(MatchId match, bool can_return, std::uint64_t last_timetag);
  /// Frees the record of a fixed match.
  void Drop(MatchId match);
  std::uint32_t TokenOf(MatchId match) const { return records_[Index(match)].token; }
  std::uint32_t ProductionOf(MatchId match) const { return records_[Index(match)].production; }
  /// An instantiation refers to the rule, although its match may be released: the rule keeps its number until the hold
  /// ends.
  void HoldRule(ProductionId production) { ++rules_[Index(production)].live; }
  void LetGoOfRule(ProductionId production) { --rules_[Index(production)].live; }
  /// The records in use and the holds of a rule. At 0 its number is free.
  std::uint32_t LiveCount(std::uint32_t production) const { return rules_[production].live; }
  void Clear();
  /// Calls visit(match) for each record in use. For checks.
  template <typename Visit>
  void ForEachMatch(Visit&& visit) const {
    for (std::uint32_t match = 0; match < records_.size(); ++match) {
      if (records_[match].state != MatchState::kFree) visit(static_cast<MatchId>(match));
    }
  }
  std::uint32_t rule_limit() const { return static_cast<std::uint32_t>(rules_.size()); }

  static constexpr std::uint32_t kNil = 0xFFFFFFFFu;

 private:
  struct Record {
    union {
      std::uint32_t token = kNil;
      std::uint32_t hash_next;  ///< If `hashed`: then the match has no token.
    };
    std::uint32_t production = 0;
    std::uint32_t elements = 0;  ///< Where they begin in elements_.
    std::uint16_t element_count = 0;
    GoalLevel level = 0;
    MatchState state = MatchState::kFree;
    std::uint8_t list = 0;
    bool o_support = false;
    bool hashed = false;  ///< It is in the table of retractions that can come back.
    Symbol goal;
    InstantiationId instantiation = InstantiationId::kNone;
    std::uint32_t next = kNil, previous = kNil;  ///< In its list; `next` also in the free list.
    std::uint32_t generation = 0;  ///< That of its level when it appeared: shows whether the goal has gone since.
    std::uint32_t hash_previous = kNil;
    std::uint64_t stamp = 0;         ///< Running number of an assertion or retraction, for display order.
    std::uint64_t last_timetag = 0;  ///< The largest time tag when it became a retraction.
  };
  static_assert(sizeof(Record) == 64, "matches are addressed by a shift");
  struct RuleCounts {
    std::uint32_t returnable = 0;  ///< Retractions in the hash table.
    std::uint32_t live = 0;        ///< Records in use, and holds.
    bool interrupts = false;
  };
  struct Level {
    std::uint32_t head[3] = {kNil, kNil, kNil};
    std::uint32_t generation = 0;  ///< Grows when a goal of this level leaves.
  };

  void ExpectElements(std::size_t count) {
    if (count >= free_elements_.size()) free_elements_.resize(count + 1, kNil);
  }
  std::uint32_t& Bucket(const Record& record);
  std::uint32_t NewRecord(const Arrival& arrival);
  std::uint32_t TakeElements(std::size_t count);
  void FreeRecord(std::uint32_t match);
  void Push(std::uint32_t match, std::uint8_t list);
  void Unlink(std::uint32_t match);
  void Hash(std::uint32_t match);
  void Unhash(std::uint32_t match);
  void GrowHash();
  static std::uint32_t HashOf(std::uint32_t production, std::span<const WmeId> elements);

  std::vector<Record> records_;
  std::uint32_t free_records_ = kNil;
  std::vector<Level> levels_;
  std::vector<WmeId> elements_;
  std::vector<std::uint32_t> free_elements_;  ///< Heads of free lists, by number of elements.
  std::vector<std::uint32_t> hash_buckets_;
  std::uint32_t hash_count_ = 0;
  std::vector<RuleCounts> rules_;
  std::vector<std::uint32_t> interrupting_;  ///< Rules, for TakeInterrupting.
  std::uint64_t next_stamp_ = 0;
  std::uint32_t goals_removed_ = 0;
};

}  // namespace soarbox::kernel
