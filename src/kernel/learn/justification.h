// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/decide/descriptions.h"
#include "kernel/decide/instantiation.h"
#include "kernel/learn/chunker.h"
#include "kernel/learn/explanation.h"
#include "kernel/learn/identity_plan.h"
#include "kernel/memory/preference.h"
#include "kernel/rules/draft.h"
#include "kernel/rules/rule_symbols.h"

namespace soarbox::kernel {

class Agent;
struct AgentCounters;
struct AgentSettings;
class Descriptions;
class Firing;
class GoalStack;
class InstantiationTable;
class Observers;
class PreferenceChanges;
class Rete;
class RuleChanges;
class WmeChanges;
class WorkingMemory;

/// Keeps the results of substates: a rule that fired in a substate and made a preference for an object of a higher
/// state gets a justification, an instantiation at the level of what the result rests on. It holds the result when the
/// substate goes, and lets go of it when one of those elements goes.
///
/// The elements are found by following each condition of the rule that fired back to the preference that made its
/// element, down to elements of higher states. Nothing like a rule is built: the matcher only keeps a fixed match of
/// the elements (Rete::AddFixedMatch), or, if negated conditions matter, matches the literal conditions.
class Justifier final : public JustificationNames {
 public:
  /// What it uses of the agent.
  struct Uses {
    Agent& agent;
    WorkingMemory& memory;
    const GoalStack& goals;
    InstantiationTable& instantiations;
    Rete& rete;
    WmeChanges& changes;
    PreferenceChanges& preferences;
    Firing& firing;
    Chunker& chunker;
    const Descriptions& descriptions;
    const AgentSettings& settings;
    AgentCounters& counters;
    const Observers& observers;
    RuleChanges& rule_changes;
  };
  explicit Justifier(const Uses& uses) : uses_(uses) {}

  /// What a justification has beside its contents while learning is on.
  struct Making {
    std::string name;  ///< Empty: justify<number>.
    Chunker::Origin origin;
    std::unique_ptr<IdentityPlan> plan;
    std::vector<IdentityPlan::KeptTest> tests;
    ProductionPtr functions;
    std::vector<std::vector<std::uint16_t>> negated_classes;
  };
  /// Makes the justification of results that have been traced; kNone if a live one says the same.
  InstantiationId Build(const Explanation& explanation, GoalLevel goal_level, Making making);
  /// The results at the level of an instantiation that now holds them.
  void MakeClones(const Explanation& explanation, InstantiationId holder, std::span<const std::uint16_t> actions,
                  bool o_support);
  /// Whether the actions of the rule that fired last propose an operator to a state.
  bool Proposes(InstantiationId base) const;
  /// True if `base`'s rule made so many duplicates in this decision that nothing more is learned from it in it.
  bool HasTooManyDuplicates(InstantiationId base, std::uint32_t most) const;
  void CountDuplicate(InstantiationId base);
  void ForgetDuplicates(ProductionId rule) { duplicates_.erase(rule); }
  /// The next number for a name. They go up by two, as in Soar 9.6.3.
  std::uint32_t TakeNumber() { return std::exchange(next_number_, next_number_ + 2); }
  [[gnu::noinline]] void InstantiationFreed(InstantiationId id);
  void Clear();
  /// Takes all justifications out of the network (init-soar).
  void ExciseAll();

  struct Record {
    bool live = false;
    bool quiescence = false;   ///< It rests on a test that nothing is left to do: so does what follows from it.
    bool excised = false;      ///< By name: its results go, or live on by o-support.
    std::uint32_t number = 0;  ///< justify<number>, unless it has a name.
    std::uint32_t order = 0;   ///< How many were made before it.
    std::string name;
    std::string base;                           ///< The rule that it was learned from.
    std::uint32_t depth = 0;                    ///< How often rules were learned from rules.
    std::unique_ptr<IdentityPlan> plan;         ///< If it was made while learning was on.
    std::vector<IdentityPlan::KeptTest> tests;  ///< The same.
    ProductionPtr functions;                    ///< Results that are computed, as actions; none if none is.
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
    /// Of each of them, if there is a plan: the classes of what its tests name, in the order of ForEachTest.
    std::vector<std::vector<std::uint16_t>> negated_classes;
  };
  const Record& record(std::uint32_t index) const { return records_[index]; }
  /// "justify1"; valid until the next justification is made.
  std::string_view Name(std::uint32_t index) const override;
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
      for (const IdentityPlan::KeptTest& test : record.tests) {
        mark(test.referent);
        for (const Symbol symbol : test.disjuncts) mark(symbol);
      }
      if (record.functions != nullptr) ForEachSymbol(*record.functions, mark);
      if (record.negations == nullptr) continue;
      for (const Condition& negation : record.negations->conditions) ForEachSymbol(negation, mark);
    }
  }
  /// The justification as a rule: literal conditions and actions; `shown`: with the word `state` where it belongs.
  ProductionPtr AsRule(std::uint32_t index, bool shown) const;

 private:
  std::uint32_t Digest(const Explanation& explanation) const;
  /// The live justification that says the same (equal grounds, negations and results, in the same order), or none.
  std::uint32_t OriginalOf(const Explanation& explanation, std::uint32_t digest) const;
  Record::Result ResultOf(PreferenceId result) const;
  void Excise(std::uint32_t index);
  bool SaysTheSame(const Record& record, const Explanation& explanation) const;
  void NoteAlike(std::uint32_t index);
  void ForgetAlike(std::uint32_t index);
  /// The same for all results of a justification.
  bool IsOSupported(const Explanation& explanation, InstantiationId made, GoalLevel goal_level);
  MatchId MatchOf(std::uint32_t index, InstantiationId id, GoalLevel goal_level);
  std::uint32_t NewRecord();

  Uses uses_;
  std::vector<Record> records_;
  mutable std::vector<std::string> names_;  ///< Of the records; empty until somebody asks.
  std::vector<std::uint32_t> free_records_;
  std::uint32_t next_number_ = 1;
  std::uint32_t next_order_ = 0;
  std::vector<std::uint32_t> alike_;  ///< Heads of buckets, by digest; a power of two, or none.
  std::uint32_t alike_count_ = 0;
  struct Duplicates {
    std::uint64_t cycle = 0;
    std::uint32_t count = 0;
  };
  /// Of each rule, in the last decision cycle that had some. As in Soar 9.6.3 init-soar keeps them.
  std::unordered_map<ProductionId, Duplicates> duplicates_;
};

}  // namespace soarbox::kernel
