// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/decide/instantiation.h"
#include "kernel/memory/preference.h"
#include "kernel/rules/draft.h"
#include "kernel/rules/rule_symbols.h"

namespace soarbox::kernel {

struct Engine;

/// Keeps the results of substates: a rule that fired in a substate and made a preference for an object of a higher
/// state gets a justification, an instantiation at the level of what the result rests on. It holds the result when the
/// substate goes, and lets go of it when one of those elements goes.
///
/// The elements are found by following each condition of the rule that fired back to the preference that made its
/// element, down to elements of higher states. Nothing like a rule is built: the matcher only keeps a fixed match of
/// the elements (Rete::AddFixedMatch), or, if negated conditions matter, matches the literal conditions.
class Justifier {
 public:
  explicit Justifier(Engine& engine) : engine_(engine) {}

  /// Called for each instantiation of a substate right after it fired; goes on upwards as long as there are results.
  [[gnu::noinline]] void Consider(InstantiationId id);
  [[gnu::noinline]] void InstantiationFreed(InstantiationId id);
  /// (dont-learn <s>) and (force-learn <s>): states that learning leaves out, or is limited to.
  void SetLearning(Symbol state, bool learn);
  void Clear();
  /// Takes all justifications out of the network (init-soar).
  void ExciseAll();

  struct Record {
    bool live = false;
    bool excised = false;      ///< By name: its results go, or live on by o-support.
    std::uint32_t number = 0;  ///< justify<number>
    InstantiationId instantiation = InstantiationId::kNone;
    ProductionId production = ProductionId::kNone;  ///< If it stands in the network.
    std::vector<WmeId> grounds;                     ///< Held: they can be shown as long as the record lives.
    struct Result {
      Symbol id, attribute, value, referent;
      PreferenceType type = PreferenceType::kAcceptable;
      friend bool operator==(const Result&, const Result&) = default;
    };
    std::vector<Result> results;
    std::uint32_t digest = 0;                ///< Of what it says.
    std::uint32_t next_alike = 0xFFFFFFFFu;  ///< The next record of its bucket.
    ProductionPtr negations;                 ///< A rule of the negated conditions; none if there are none.
  };
  const Record& record(std::uint32_t index) const { return records_[index]; }
  /// "justify1"; valid until the next justification is made.
  std::string_view Name(std::uint32_t index) const;
  /// Indices of the live records, oldest first.
  std::vector<std::uint32_t> Live() const;
  /// Takes one out of the match, so that its results are retracted; false if there is none of this name.
  bool Excise(std::string_view name);
  /// Calls mark(symbol) for the literals of negated conditions and results, which nothing else may hold. (The grounds
  /// are held.)
  template <typename Mark>
  void ForEachLiteral(Mark&& mark) const {
    for (const Record& record : records_) {
      if (!record.live) continue;
      for (const Record::Result& result : record.results) {
        for (const Symbol symbol : {result.id, result.attribute, result.value, result.referent}) mark(symbol);
      }
      if (record.negations == nullptr) continue;
      for (const Condition& negation : record.negations->conditions) ForEachSymbol(negation, mark);
    }
  }
  /// The justification as a rule: literal conditions and actions; `shown`: with the word `state` where it belongs.
  ProductionPtr AsRule(std::uint32_t index, bool shown) const;

 private:
  bool CollectResults(InstantiationId id);
  void AddResult(PreferenceId preference);
  void AddPartsOf(Symbol id, InstantiationId base);
  void CheckResults() const;
  void Backtrace(InstantiationId id);
  void VisitInstantiation(InstantiationId id);
  void VisitQueued();
  void VisitCondition(const ConditionTrace& trace);
  void VisitItem(WmeId item);
  void CollectNegations(InstantiationId id);
  /// Makes the justification of the results that `base` made; kNone if they rest on nothing above.
  InstantiationId Build(InstantiationId base);
  std::uint32_t DigestOfResults() const;
  /// The live justification that says the same (equal grounds, negations and results, in the same order), or none.
  std::uint32_t OriginalOf(std::uint32_t digest) const;
  Record::Result ResultOf(PreferenceId result) const;
  bool SaysTheSame(const Record& record) const;
  void NoteAlike(std::uint32_t index);
  void ForgetAlike(std::uint32_t index);
  /// True if `base`'s rule made so many duplicates in this decision that it may make no more justifications in it.
  bool HasTooManyDuplicates(InstantiationId base) const;
  void CountDuplicate(InstantiationId base);
  /// Notes an element of a higher state that the results rest on.
  void AddGround(WmeId wme);
  /// The same for all results of a justification.
  bool IsOSupported(InstantiationId base, InstantiationId made, GoalLevel goal_level);
  bool Proposes(InstantiationId base) const;
  MatchId MatchOf(std::uint32_t index, InstantiationId id, GoalLevel goal_level);
  std::uint32_t NewRecord();
  ConditionDraft Instantiate(const Condition& condition, InstantiationId id);
  bool RefersToHigherOnly(const ConditionDraft& condition) const;
  /// False if RefersToHigherOnly would be false of the literal condition, which need not be made then.
  bool MayReferToHigherOnly(const Condition& condition, InstantiationId id) const;

  Engine& engine_;
  std::vector<Record> records_;
  mutable std::vector<std::string> names_;  ///< Of the records; empty until somebody asks.
  std::vector<std::uint32_t> free_records_;
  std::vector<Symbol> dont_learn_, force_learn_;
  std::uint32_t next_number_ = 1;
  std::vector<std::uint32_t> alike_;  ///< Heads of buckets, by digest; a power of two, or none.
  std::uint32_t alike_count_ = 0;
  struct Duplicates {
    ProductionId production = ProductionId::kNone;
    std::uint32_t count = 0;
  };
  std::vector<Duplicates> duplicates_;  ///< In the decision cycle at hand.
  std::uint64_t duplicates_cycle_ = 0;
  // Scratch of one backtrace.
  GoalLevel level_ = 0;
  std::uint32_t trace_number_ = 0;
  std::vector<PreferenceId> results_;
  /// Still to be added to the results: a preference, or else all that is said of an object.
  struct Part {
    PreferenceId preference = PreferenceId::kNone;
    Symbol object;
  };
  std::vector<Part> parts_;
  std::vector<WmeId> grounds_;
  GoalLevel lowest_ground_ = 0;          ///< Of the states that grounds hang on; 0 if none hangs on a state.
  std::vector<WmeId> operator_grounds_;  ///< Those that are a state's selected operator.
  /// Still to be followed: an instantiation, or else an item of the impasse.
  struct Open {
    InstantiationId instantiation = InstantiationId::kNone;
    WmeId item = WmeId::kNone;
  };
  std::vector<Open> queue_;
  std::vector<ConditionDraft> negations_;
  Arena drafts_;  ///< Of the negations.
  std::vector<std::uint32_t> seen_identifiers_, seen_wmes_;
};

}  // namespace soarbox::kernel
