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

/// A complete match of a rule (a token that reached its production node). The handle is valid until the match has ended
/// and its instantiation has been retracted; then it is reused.
enum class MatchId : std::uint32_t { kNone = 0xFFFFFFFFu };

enum class MatchState : std::uint8_t {
  kFree,
  kPendingAssertion,   ///< Matched, but not fired yet. In a list.
  kTaken,              ///< Taken from its list by TakeAssertion; MarkFired or PutBack must follow.
  kFired,              ///< It has an instantiation.
  kPendingRetraction,  ///< No longer matches; its instantiation is to be retracted. In a list.
  kRetracting,         ///< Taken by TakeRetraction; Release must follow.
};

/// The data of a match for firing and display.
struct PendingMatch {
  MatchId match = MatchId::kNone;
  ProductionId production = ProductionId::kNone;
  Symbol goal;             ///< The lowest goal among the matched elements' identifiers; none if there is none.
  GoalLevel level = 0;     ///< Level of that goal; 0 if there is none or if it was removed.
  bool o_support = false;  ///< The support of its actions.

  explicit operator bool() const { return match != MatchId::kNone; }
};

/// The conflict set: complete matches that wait to fire or to be retracted, by level of their goal.
///
/// Each level has a list of i-assertions, one of o-assertions and one of retractions. Level 0 contains matches without
/// a goal, or whose goal was removed. New entries are added at the head, and taken from the head. The elements of a
/// match are stored here until it is released.
///
/// A new match that equals a match waiting for retraction (same rule, same elements) replaces it: nothing fires, and
/// nothing is retracted. A hash table finds the retractions that can return.
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
  /// Retractions of matches without a goal, or whose goal was removed.
  bool HasNoGoalRetractions() const { return HasRetractions(0); }

  /// Takes the newest assertion of a level; returns an empty PendingMatch if there is none. The caller must then mark
  /// the match as fired, put it back, or release it.
  PendingMatch TakeAssertion(GoalLevel level, bool o_support);
  /// Returns taken matches to the head of their lists. `taken` is in the order of taking; they will be taken in this
  /// order again.
  void PutBack(std::span<const MatchId> taken);
  void MarkFired(MatchId match, InstantiationId instantiation);
  InstantiationId InstantiationOf(MatchId match) const { return records_[Index(match)].instantiation; }

  /// Takes the newest retraction of a level (0: the no-goal list), or kNone. Its elements, rule and instantiation stay
  /// readable until Release.
  MatchId TakeRetraction(GoalLevel level);
  /// Releases a taken match. Also allowed for a fired match if its instantiation ended for another reason. The rule
  /// then still matches, but the match has no effect.
  void Release(MatchId match);

  /// Number of calls of GoalRemoved.
  std::uint32_t goals_removed() const { return goals_removed_; }
  /// The goal of this level is being removed: its retractions and assertions move to the no-goal lists. (These
  /// assertions never fire; they disappear when the goal's elements leave the match.)
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
  /// If an equal match waits for its retraction, makes it a fired match again, with the token of `arrival`, and returns
  /// it. Else returns kNone.
  MatchId Revive(const Arrival& arrival, const WmeTable& wmes);
  /// Returns false if no waiting retraction of the rule can return.
  bool MayReturn(std::uint32_t production) const { return rules_[production].returnable != 0; }
  /// Must be called before the first match of a rule.
  void RuleAdded(std::uint32_t production, std::size_t elements, bool interrupts) {
    if (production >= rules_.size()) rules_.resize(production + 1u);
    rules_[production].interrupts = interrupts;
    ExpectElements(elements);
  }
  /// Whether to record new assertions of a rule; see TakeInterrupting.
  void SetInterrupts(std::uint32_t production, bool on) { rules_[production].interrupts = on; }
  bool HasInterrupting() const { return !interrupting_.empty(); }
  /// Returns the rules with interrupts that got new assertions since the last call: a rule once for each assertion.
  std::vector<std::uint32_t> TakeInterrupting() { return std::exchange(interrupting_, {}); }
  /// Frees the memory reserved for more rules.
  void ShrinkRules() { rules_.shrink_to_fit(); }
  /// Adds a pending assertion.
  MatchId Assert(const Arrival& arrival);
  /// Adds a match that counts as fired from the start.
  MatchId AddFired(const Arrival& arrival, InstantiationId instantiation);
  /// The match's token was removed: a pending assertion disappears, a fired match becomes a retraction. `can_return` is
  /// false if one of its own elements left (then no equal match can appear). `last_timetag` is the highest time tag so
  /// far. Returns false if the record is now free.
  bool TokenGone(MatchId match, bool can_return, std::uint64_t last_timetag);
  /// Frees the record of a fixed match.
  void Drop(MatchId match);
  std::uint32_t TokenOf(MatchId match) const { return records_[Index(match)].token; }
  std::uint32_t ProductionOf(MatchId match) const { return records_[Index(match)].production; }
  /// An instantiation refers to the rule and may outlive its match. The rule keeps its number until LetGoOfRule.
  void HoldRule(ProductionId production) { ++rules_[Index(production)].live; }
  void LetGoOfRule(ProductionId production) { --rules_[Index(production)].live; }
  /// Number of records in use and holds of a rule. If it is 0, the rule's number is free.
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
      std::uint32_t hash_next;  ///< Valid if `hashed`: then the match has no token.
    };
    std::uint32_t production = 0;
    std::uint32_t elements = 0;  ///< Index of the first one in elements_.
    std::uint16_t element_count = 0;
    GoalLevel level = 0;
    MatchState state = MatchState::kFree;
    std::uint8_t list = 0;
    bool o_support = false;
    bool hashed = false;  ///< It is in the table of retractions that can return.
    Symbol goal;
    InstantiationId instantiation = InstantiationId::kNone;
    std::uint32_t next = kNil, previous = kNil;  ///< In its list; `next` also in the free list.
    std::uint32_t generation = 0;  ///< The level's generation at its creation; differs if the goal was removed since.
    std::uint32_t hash_previous = kNil;
    std::uint64_t stamp = 0;         ///< Running number of assertions and retractions, for the order of display.
    std::uint64_t last_timetag = 0;  ///< The highest time tag when it became a retraction.
  };
  static_assert(sizeof(Record) == 64, "matches are addressed by a shift");
  struct RuleCounts {
    std::uint32_t returnable = 0;  ///< Retractions in the hash table.
    std::uint32_t live = 0;        ///< Records in use, and holds.
    bool interrupts = false;
  };
  struct Level {
    std::uint32_t head[3] = {kNil, kNil, kNil};
    std::uint32_t generation = 0;  ///< Increased when a goal of this level is removed.
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
