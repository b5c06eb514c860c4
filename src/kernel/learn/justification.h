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

/// Keeps the results of substates alive. If a rule in a substate created a preference for an object of a higher state,
/// the result gets a justification: an instantiation at the level of the elements on which the result depends. It
/// supports the result after the substate was removed, until one of these elements is removed.
///
/// To find the elements, each condition of the fired rule is followed to the preference that created its element. This
/// is repeated until elements of higher states are reached. No rule is built: the matcher only has a fixed match of the
/// elements (Rete::AddFixedMatch), or, if negated conditions matter, it matches literal conditions.
class Justifier final : public JustificationNames {
 public:
  /// The parts of the agent that it uses.
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

  /// Additional data of a justification while learning is on.
  struct Making {
    std::string name;  ///< If empty, the name is justify<number>.
    Chunker::Origin origin;
    std::unique_ptr<IdentityPlan> plan;
    std::vector<IdentityPlan::KeptTest> tests;
    ProductionPtr functions;
    std::vector<std::vector<std::uint16_t>> negated_classes;
  };
  /// Creates the justification of traced results. Returns kNone if it duplicates a live one.
  InstantiationId Build(const Explanation& explanation, GoalLevel goal_level, Making making);
  /// Creates the clones of the results at the level of `holder`, the instantiation that supports them now.
  void MakeClones(const Explanation& explanation, InstantiationId holder, std::span<const std::uint16_t> actions,
                  bool o_support);
  /// Whether the actions of the rule that fired as `base` propose an operator for a state.
  bool Proposes(InstantiationId base) const;
  /// Returns true if `base`'s rule produced too many duplicates in this decision. Nothing more is learned from it until
  /// the next decision.
  bool HasTooManyDuplicates(InstantiationId base, std::uint32_t most) const;
  void CountDuplicate(InstantiationId base);
  void ForgetDuplicates(ProductionId rule) { duplicates_.erase(rule); }
  /// The next number for a name. Numbers increase by two, as in Soar 9.6.3.
  std::uint32_t TakeNumber() { return std::exchange(next_number_, next_number_ + 2); }
  [[gnu::noinline]] void InstantiationFreed(InstantiationId id);
  void Clear();
  /// Removes all justifications from the network (init-soar).
  void ExciseAll();

  struct Record {
    bool live = false;
    bool quiescence = false;   ///< It depends on a test of ^quiescence, and so do its consequences.
    bool excised = false;      ///< Excised by name: its results are retracted or, if o-supported, remain.
    std::uint32_t number = 0;  ///< For justify<number>; 0 if it has a name.
    std::uint32_t order = 0;   ///< The number of justifications created before it.
    std::string name;
    std::string base;                           ///< The rule that it was learned from.
    std::uint32_t depth = 0;                    ///< The number of generations of learned rules before it.
    std::unique_ptr<IdentityPlan> plan;         ///< Only if it was created while learning was on.
    std::vector<IdentityPlan::KeptTest> tests;  ///< Likewise.
    ProductionPtr functions;                    ///< Actions for results that functions compute; none if there are none.
    InstantiationId instantiation = InstantiationId::kNone;
    ProductionId production = ProductionId::kNone;  ///< Set if it is in the network.
    std::vector<WmeId> grounds;  ///< References are held: they can be shown as long as the record exists.
    struct Result {
      Symbol id, attribute, value, referent;
      PreferenceType type = PreferenceType::kAcceptable;
      friend bool operator==(const Result&, const Result&) = default;
    };
    std::vector<Result> results;
    std::uint32_t digest = 0;                ///< Digest of its contents.
    std::uint32_t next_alike = 0xFFFFFFFFu;  ///< The next record in its bucket.
    ProductionPtr negations;                 ///< A rule with the negated conditions; none if there are none.
    /// Per negated condition, if there is a plan: the classes of its referents, in the order of ForEachTest.
    std::vector<std::vector<std::uint16_t>> negated_classes;
  };
  const Record& record(std::uint32_t index) const { return records_[index]; }
  /// "justify1"; valid until the next justification is created.
  std::string_view Name(std::uint32_t index) const override;
  /// Indices of the live records, oldest first.
  std::vector<std::uint32_t> Live() const;
  /// Removes one from the match, so that its results are retracted. Returns false if there is none of this name.
  bool Excise(std::string_view name);
  /// Calls mark(symbol) for the literals in negated conditions and results, which may have no other reference. (The
  /// grounds are held.)
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
  /// The justification as a rule with literal conditions and actions. `shown`: include the word `state` where `print`
  /// shows it.
  ProductionPtr AsRule(std::uint32_t index, bool shown) const;

 private:
  std::uint32_t Digest(const Explanation& explanation) const;
  /// The live justification with equal grounds, negations and results in the same order, or none.
  std::uint32_t OriginalOf(const Explanation& explanation, std::uint32_t digest) const;
  Record::Result ResultOf(PreferenceId result) const;
  void Excise(std::uint32_t index);
  bool SaysTheSame(const Record& record, const Explanation& explanation) const;
  void NoteAlike(std::uint32_t index);
  void ForgetAlike(std::uint32_t index);
  /// Whether the results of a justification are o-supported.
  bool IsOSupported(const Explanation& explanation, InstantiationId made, GoalLevel goal_level);
  MatchId MatchOf(std::uint32_t index, InstantiationId id, GoalLevel goal_level);
  std::uint32_t NewRecord();

  Uses uses_;
  std::vector<Record> records_;
  mutable std::vector<std::string> names_;  ///< By record; empty until it is first needed.
  std::vector<std::uint32_t> free_records_;
  std::uint32_t next_number_ = 1;
  std::uint32_t next_order_ = 0;
  std::vector<std::uint32_t> alike_;  ///< Heads of buckets, by digest; the size is a power of two, or 0.
  std::uint32_t alike_count_ = 0;
  struct Duplicates {
    std::uint64_t cycle = 0;
    std::uint32_t count = 0;
  };
  /// By rule, for the last decision cycle that had duplicates. As in Soar 9.6.3, init-soar does not reset it.
  std::unordered_map<ProductionId, Duplicates> duplicates_;
};

}  // namespace soarbox::kernel
