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

/// Reads the firings of substates for learning: the rule, the classes of its fields, and where identities come from. A
/// firing may be of a rule, of a justification or of the architecture (what long-term memory recalled).
class FiringReader {
 public:
  /// What it uses of the agent.
  struct Uses {
    const WorkingMemory& memory;
    const GoalStack& goals;
    InstantiationTable& instantiations;
    const Rete& rete;
    const GoalChanges& goal_changes;
    const Justifier& justifier;
  };
  explicit FiringReader(const Uses& uses) : uses_(uses) {}

  /// The rule that fired, or null for justifications and the architecture. Readable also after it was excised.
  const Production* Rule(InstantiationId firing);
  const IdentityPlan& Plan(InstantiationId firing) {
    const Instantiation& instantiation = uses_.instantiations[firing];
    if (instantiation.production != ProductionId::kNone && !instantiation.copied) [[likely]]
      return *KnownOf(instantiation.production).plan;
    return UncommonPlan(firing);
  }
  /// A positive condition of the rule that fired.
  struct Tested {
    const Condition* condition = nullptr;
    std::uint8_t carried = 0;  ///< Bit n: field n asks for more than which value it is.
    std::uint8_t first = 0;    ///< Bit n: field n is the first place of its class.
    std::uint8_t follows = 0;  ///< Bit n: field n is the first place of its class, and no superstate link is another.

    bool Carries(Field field) const { return (carried >> static_cast<unsigned>(field) & 1u) != 0; }
  };
  /// Of what the firing copied there is no condition.
  const Tested& TestedBy(InstantiationId firing, std::size_t condition);
  /// False if no condition of the firing asks for more than which value something is.
  bool CarriesTests(InstantiationId firing);

  /// What the action that made a preference says in one of its fields.
  struct Term {
    enum class Kind : std::uint8_t {
      kUnknown,   ///< It was made before learning was on.
      kLiteral,   ///< A constant.
      kClass,     ///< Something that a condition binds, or a new identifier.
      kSymbol,    ///< An identifier that the architecture made.
      kFunction,  ///< The value of a function.
    };
    Kind kind = Kind::kLiteral;
    std::uint16_t identity_class = 0;
    Symbol symbol;
    const RhsValue* function = nullptr;
  };
  enum class Part : std::uint8_t { kId, kAttribute, kValue, kReferent };
  Term TermOf(PreferenceId preference, Part part);
  /// Soar numbers the identifiers that a firing makes from the last action to the first.
  std::uint32_t RankOfNew(InstantiationId firing, std::uint16_t new_index);
  /// The class of a bound or new term of a rule.
  std::uint16_t ClassOf(const RhsValue& value, InstantiationId firing) { return ClassOf(value, Plan(firing)); }

  /// The identity of a class of a firing: that of the preference that made the first element which has it, if the
  /// element is of the substate, or else one of its own. Leaves the firing where it was found in `firing`.
  IdentityGraph::Key Origin(InstantiationId& firing, std::uint16_t identity_class);
  /// The identities of the substate's own name and of its superstate's are given.
  static IdentityGraph::Key SuperstateLink(GoalLevel level, Part part) {
    return {kSuperstateKey, 2u * level + (part == Part::kId ? 0u : 1u)};
  }
  static bool IsSuperstateLink(IdentityGraph::Key key) { return key.firing == kSuperstateKey; }
  static IdentityGraph::Key Item(WmeId item) { return {kItemKey, Index(item)}; }
  static bool IsItem(IdentityGraph::Key key) { return key.firing == kItemKey; }
  static WmeId ItemOf(IdentityGraph::Key key) { return static_cast<WmeId>(key.place); }
  static IdentityGraph::Key OfSymbol(Symbol symbol) { return {kSymbolKey, symbol.bits()}; }
  bool IsSuperstateLink(WmeId wme, GoalLevel level) const;
  /// What they test there names the substate and its superstate, wherever else the class occurs: the key of these, if
  /// the class is one of them.
  bool IsOfSuperstateLink(InstantiationId firing, std::uint16_t identity_class, IdentityGraph::Key& key);

  /// Bit n: the class of field n of a condition has the identity that the element's maker gave it, if it gave it one.
  std::uint8_t FollowsMaker(InstantiationId firing, std::uint16_t condition) {
    const Instantiation& instantiation = uses_.instantiations[firing];
    if (instantiation.production == ProductionId::kNone || instantiation.copied) return 0;
    if (!uses_.instantiations.Trace(firing)[condition].inherits) return 0;
    return KnownOf(instantiation.production).positives[condition].follows;
  }

  /// How the first place of a class comes by its identity.
  enum class Source : std::uint8_t { kOwn, kMaker, kSuperstate, kItem };
  Source SourceOf(InstantiationId firing, std::uint16_t place);
  /// How many classes of conditions have an identity that is the firing's own. Of a firing that has copied nothing.
  std::uint32_t CountIdentities(InstantiationId firing);

  /// The firing copied objects. To learning, the copy is the original: what is said of it is said of that.
  void NoteCopied(InstantiationId firing, std::span<const RuleContext::Copied> copied);
  void ForgetCopied(InstantiationId firing);

  /// A comparison of a learned rule that was turned round when the rule was put in order.
  struct TurnedTest {
    std::uint16_t condition = 0;
    Field field = Field::kValue;
    TestKind kind = TestKind::kBlank;
    Symbol referent;  ///< A variable of the rule.
  };
  /// The firing is a learned rule's own instance. To what is learned from it in turn, such a comparison has kept the
  /// identity of its old referent, which is now the value tested: it compares that with itself. So it is in Soar 9.6.3.
  void NoteTurned(InstantiationId firing, const std::vector<TurnedTest>& tests);
  void ForgetTurned(InstantiationId firing);
  bool IsTurned(InstantiationId firing, std::uint16_t condition, Field field, const Test& test) const;

  /// Until the next call, what is known of a rule is not compared with the rule again: as long as a firing of it is
  /// looked at, no other rule takes its number.
  void BeginAnalysis() { ++analysis_; }
  /// Plans that are not a rule's are kept until then.
  void EndAnalysis() {
    ++analysis_;
    without_rule_.clear();
  }
  void Clear();

 private:
  static constexpr std::uint32_t kSuperstateKey = 0xFFFFFFF0u, kItemKey = 0xFFFFFFF1u, kSymbolKey = 0xFFFFFFF2u;
  IdentityPlan PlanOfArchitecture(InstantiationId firing) const;
  /// The rule's, and behind it what the firing copied.
  [[gnu::noinline]] IdentityPlan PlanWithCopied(InstantiationId firing);
  [[gnu::noinline]] Term TermOfCopier(const Preference& preference, Part part);
  [[gnu::noinline]] const IdentityPlan& UncommonPlan(InstantiationId firing);
  /// Whether IsOfSuperstateLink need be asked.
  bool MayBeOfLink(const Instantiation& instantiation, std::uint16_t identity_class);
  /// Which parts of the action that made a preference give an identity: bit n for part n.
  std::uint8_t GivenBy(PreferenceId preference);

  Uses uses_;
  struct Known {
    ProductionPtr rule;
    std::unique_ptr<IdentityPlan> plan;
    std::vector<Tested> positives;
    bool carries_tests = false;                      ///< One of them does.
    std::vector<std::uint16_t> may_test_superstate;  ///< Those that may match the superstate link.
    std::vector<std::uint16_t> link_classes;         ///< The classes of the identifiers and values of these.
    std::vector<Term> terms;                         ///< What its actions say, four for each.
    std::vector<std::uint8_t> given;                 ///< For each action: bit n if part n has a class.
    std::uint32_t analysis = 0;                      ///< The last one that looked at the rule.
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
  /// Of what no action of a rule made.
  [[gnu::noinline]] Term UncommonTermOf(const Preference& preference, std::size_t place, Part part);

  std::vector<Known> rules_;  ///< By ProductionId; of rules that learning has looked at.
  std::uint32_t analysis_ = 1;
  std::vector<std::pair<InstantiationId, std::unique_ptr<IdentityPlan>>> without_rule_;
  std::unordered_map<std::uint32_t, std::vector<std::pair<Symbol, Symbol>>> copied_;  ///< By serial: copy, original.
  std::unordered_map<std::uint32_t, std::vector<TurnedTest>> turned_;                 ///< By serial.
};

}  // namespace soarbox::kernel
