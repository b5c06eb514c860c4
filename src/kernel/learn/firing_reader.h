// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/decide/instantiation_table.h"
#include "kernel/decide/rule_context.h"
#include "kernel/learn/identity_graph.h"
#include "kernel/learn/identity_plan.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

class GoalChanges;
class GoalStack;
class InstantiationTable;
class Justifier;
class Rete;
class WorkingMemory;

/// Reads the firings of substates for learning: the rule, the classes of its fields, and the origins of identities. A
/// firing may be that of a rule, of a justification, or of the architecture (results of long-term memory).
class FiringReader {
 public:
  /// The parts of the agent that it uses.
  struct Uses {
    const WorkingMemory& memory;
    const GoalStack& goals;
    InstantiationTable& instantiations;
    const Rete& rete;
    const GoalChanges& goal_changes;
    const Justifier& justifier;
  };
  explicit FiringReader(const Uses& uses) : uses_(uses) {}

  /// The rule that fired; null for justifications and the architecture. Also available for excised rules.
  const Production* Rule(InstantiationId firing);
  const IdentityPlan& Plan(InstantiationId firing) {
    const Instantiation& instantiation = uses_.instantiations[firing];
    if (instantiation.production != ProductionId::kNone && !instantiation.copied) [[likely]]
      return *KnownOf(instantiation.production).plan;
    return UncommonPlan(firing);
  }
  /// Properties of a positive condition of the fired rule.
  struct Tested {
    const Condition* condition = nullptr;
    std::uint8_t carried = 0;  ///< Bit n: field n has tests other than equality.

    bool Carries(Field field) const { return (carried >> static_cast<unsigned>(field) & 1u) != 0; }
  };
  /// `condition` must not be one of the trace entries for copied elements.
  const Tested& TestedBy(InstantiationId firing, std::size_t condition);
  /// Returns false if no condition of the firing has tests other than equality.
  bool CarriesTests(InstantiationId firing);

  /// The term in one field of the action that created a preference.
  struct Term {
    enum class Kind : std::uint8_t {
      kUnknown,   ///< The preference was created before learning was on.
      kLiteral,   ///< A constant.
      kClass,     ///< A variable of a condition, or a new identifier.
      kSymbol,    ///< An identifier that the architecture created.
      kFunction,  ///< The result of a function.
    };
    Kind kind = Kind::kLiteral;
    std::uint16_t identity_class = 0;
    Symbol symbol;
    const RhsValue* function = nullptr;
  };
  enum class Part : std::uint8_t { kId, kAttribute, kValue, kReferent };
  Term TermOf(PreferenceId preference, Part part);
  /// The rank of a new identifier of a firing: Soar numbers them from the last action to the first.
  std::uint32_t RankOfNew(InstantiationId firing, std::uint16_t new_index);
  /// The class of a bound or new term of a rule.
  std::uint16_t ClassOf(const RhsValue& value, InstantiationId firing) { return ClassOf(value, Plan(firing)); }

  /// The origin of the identity of a class of a firing. If the first element with the class belongs to the substate,
  /// the identity is that of the preference that created it; this is followed from firing to firing. Else it is one of
  /// the firing's own. Sets `firing` to the firing where the search ended.
  IdentityGraph::Key Origin(InstantiationId& firing, std::uint16_t identity_class);
  /// The predefined identities of the substate's name and of its superstate.
  static IdentityGraph::Key SuperstateLink(GoalLevel level, Part part) {
    return {kSuperstateKey, 2u * level + (part == Part::kId ? 0u : 1u)};
  }
  static bool IsSuperstateLink(IdentityGraph::Key key) { return key.firing == kSuperstateKey; }
  static IdentityGraph::Key Item(WmeId item) { return {kItemKey, Index(item)}; }
  static bool IsItem(IdentityGraph::Key key) { return key.firing == kItemKey; }
  static WmeId ItemOf(IdentityGraph::Key key) { return static_cast<WmeId>(key.place); }
  static IdentityGraph::Key OfSymbol(Symbol symbol) { return {kSymbolKey, symbol.bits()}; }
  bool IsSuperstateLink(WmeId wme, GoalLevel level) const;
  /// Conditions that match the superstate link name the substate and its superstate. If the class is that of one of
  /// these names, sets `key` to its identity and returns true.
  bool IsOfSuperstateLink(InstantiationId firing, std::uint16_t identity_class, IdentityGraph::Key& key);

  /// How the first field of a class gets its identity.
  enum class Source : std::uint8_t { kOwn, kMaker, kSuperstate, kItem };
  Source SourceOf(InstantiationId firing, std::uint16_t place);
  /// The number of classes of conditions whose identity is the firing's own. The firing must not have copied objects.
  std::uint32_t CountIdentities(InstantiationId firing);

  /// The firing copied objects. Learning treats a copy like its original.
  void NoteCopied(InstantiationId firing, std::span<const RuleContext::Copied> copied);
  void ForgetCopied(InstantiationId firing);

  /// A comparison of a learned rule whose sides were swapped when its conditions were reordered.
  struct TurnedTest {
    std::uint16_t condition = 0;
    Field field = Field::kValue;
    TestKind kind = TestKind::kBlank;
    Symbol referent;  ///< A variable of the rule.
  };
  /// The firing is a learned rule's own instance. If another rule is learned from it, a swapped comparison still has
  /// the identity of its old referent, which is now the tested value. So it compares the value with itself. Soar 9.6.3
  /// has the same behaviour.
  void NoteTurned(InstantiationId firing, const std::vector<TurnedTest>& tests);
  void ForgetTurned(InstantiationId firing);
  bool IsTurned(InstantiationId firing, std::uint16_t condition, Field field, const Test& test) const;

  /// Until the next call, cached data of a rule are not compared with the rule again. This is correct because a rule's
  /// number is not given to another rule while one of its firings is analysed.
  void BeginAnalysis() { ++analysis_; }
  /// Frees the plans of this analysis, except those of rules.
  void EndAnalysis() {
    ++analysis_;
    without_rule_.clear();
  }
  void Clear();

 private:
  static constexpr std::uint32_t kSuperstateKey = 0xFFFFFFF0u, kItemKey = 0xFFFFFFF1u, kSymbolKey = 0xFFFFFFF2u;
  IdentityPlan PlanOfArchitecture(InstantiationId firing) const;
  /// The rule's plan, followed by the classes of what the firing copied.
  [[gnu::noinline]] IdentityPlan PlanWithCopied(InstantiationId firing);
  [[gnu::noinline]] Term TermOfCopier(const Preference& preference, Part part);
  [[gnu::noinline]] const IdentityPlan& UncommonPlan(InstantiationId firing);
  /// The term in the rule's action that created a preference; null if no action of a rule did.
  const RhsValue* WrittenBy(const Preference& preference, Part part);

  Uses uses_;
  struct Known {
    ProductionPtr rule;
    std::unique_ptr<IdentityPlan> plan;
    std::vector<Tested> positives;
    bool carries_tests = false;                      ///< At least one of them carries tests.
    std::vector<std::uint16_t> may_test_superstate;  ///< Conditions that may match the superstate link.
    std::uint32_t analysis = 0;                      ///< The last analysis that used this record.
  };
  const Known& KnownOf(ProductionId production) {
    const std::uint32_t index = Index(production);
    if (index < rules_.size() && rules_[index].analysis == analysis_) [[likely]]
      return rules_[index];
    return LookAt(production);
  }
  [[gnu::noinline]] const Known& LookAt(ProductionId production);
  static std::uint16_t ClassOf(const RhsValue& value, const IdentityPlan& plan);
  static Term TermOf(const RhsValue& value, const IdentityPlan& plan);
  /// The term of a preference that no action of a rule created.
  [[gnu::noinline]] Term UncommonTermOf(const Preference& preference, Part part);

  std::vector<Known> rules_;  ///< By ProductionId, for rules that learning has used.
  std::uint32_t analysis_ = 1;
  std::vector<std::pair<InstantiationId, std::unique_ptr<IdentityPlan>>> without_rule_;
  std::unordered_map<std::uint32_t, std::vector<std::pair<Symbol, Symbol>>> copied_;  ///< By serial: copy, original.
  std::unordered_map<std::uint32_t, std::vector<TurnedTest>> turned_;                 ///< By serial number.
};

}  // namespace soarbox::kernel
