// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "kernel/base/bump_arena.h"
#include "kernel/learn/carried_tests.h"
#include "kernel/learn/explanation.h"
#include "kernel/learn/firing_reader.h"
#include "kernel/learn/identity_analysis.h"
#include "kernel/rules/draft.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

class ExpectedValues;
class GoalStack;
class InstantiationTable;
struct LearnStatistics;
class Observers;
class SymbolTable;
class VariableIndex;
class WorkingMemory;

/// The fourth to sixth stages of learning: conditions and actions of the learned rule, made from what was tested and
/// what it is known to mean.
class RuleBuilder {
 public:
  /// What it uses of the agent.
  struct Uses {
    SymbolTable& symbols;
    const WorkingMemory& memory;
    const GoalStack& goals;
    const InstantiationTable& instantiations;
    const ExpectedValues& expected_values;
    const Observers& observers;
    LearnStatistics& statistics;
  };
  RuleBuilder(const Uses& uses, FiringReader& reader, IdentityAnalysis& analysis, CarriedTests& carried)
      : uses_(uses), reader_(reader), analysis_(analysis), carried_(carried) {}

  enum class Outcome : std::uint8_t { kMade, kRepaired, kFailed };
  /// Makes the rule of an explanation that has been analysed.
  Outcome Build(Explanation& explanation, std::string_view name, GoalLevel results_level);

  // What was made; valid until the next call.
  const ProductionPtr& rule() const { return rule_; }
  /// The elements that the rule's positive conditions stand for, in its order.
  const std::vector<WmeId>& elements() const { return elements_; }
  /// Which action makes each result.
  const std::vector<std::uint16_t>& action_of_result() const { return action_of_result_; }
  /// Which ground each positive condition came from (its index in the explanation), or none if it was put in.
  const std::vector<std::uint32_t>& ground_of_condition() const { return ground_of_condition_; }
  /// Which negation of the explanation each negated condition came from.
  const std::vector<std::uint32_t>& negation_of_condition() const { return negation_of_condition_; }
  /// The comparisons of its positive conditions that were turned round when it was put in order.
  const std::vector<FiringReader::TurnedTest>& turned_tests() const { return turned_tests_; }
  const std::vector<CarriedTest>& constraints() const { return constraints_; }
  std::uint32_t merged_conditions() const { return merged_conditions_; }
  std::uint32_t merged_disjunctions() const { return merged_disjunctions_; }
  std::uint32_t operational_constraints() const { return operational_constraints_; }
  /// How the variable of an identity was called before the rule was finished; empty if it has none.
  std::string VariableNameOf(IdentityGraph::Node node) const;

 private:
  struct Made {
    ConditionDraft* draft = nullptr;
    WmeId wme = WmeId::kNone;
    std::uint32_t ground = 0xFFFFFFFFu;
    std::array<IdentityGraph::Node, 3> nodes{IdentityGraph::kNone, IdentityGraph::kNone, IdentityGraph::kNone};
  };
  void MakeConditions(const Explanation& explanation);
  /// The test of equality of a field: a variable, or the constant.
  Symbol Meaning(IdentityGraph::Node node, Symbol value);
  /// Some condition has the variable of the set already.
  bool HasVariable(IdentityGraph::Node node) const;
  void AddOwnTests(const Explanation::Ground& ground, Field field, TestDraft& out);
  void PlaceConstraints();
  bool PlaceConstraint(const CarriedTest& constraint);
  /// The first field of the conditions that has this identity, or null.
  TestDraft* PlaceOf(IdentityGraph::Node node);
  void SetDisjuncts(TestDraft& test, std::span<const Symbol> disjuncts);
  void MakeNegations(const Explanation& explanation);
  void VariablizeNegated(ConditionDraft& draft, InstantiationId firing);
  void VariablizeNegated(TestDraft& draft, InstantiationId firing);
  bool ComparesWithUnreached(const TestDraft& test, InstantiationId firing) const;
  void MergeConditions();
  void AddStateTests();
  void MakeActions(const Explanation& explanation);
  ValueDraft MakeTerm(PreferenceId result, FiringReader::Part part, Symbol symbol);
  ValueDraft MakeFunction(const RhsValue& function, InstantiationId firing);
  /// Conditions that lead from the state of the results' level to what hangs in the air.
  bool Repair(GoalLevel results_level);
  /// Variables that stand for identifiers which no state leads to.
  std::vector<Symbol> Unconnected(const DraftList<ConditionDraft>& conditions, const VariableIndex& variables) const;
  bool ActionsAreGrounded() const;
  /// What a variable was made for, or none.
  Symbol IdentifierOf(Symbol variable) const;
  bool Finish(std::string_view name);
  Symbol NewVariable(Symbol of);
  Symbol VariableOfIdentifier(Symbol identifier);
  void AddLink(WmeId wme, Symbol target, Symbol target_variable);
  bool FindPath(Symbol from, Symbol to, std::vector<WmeId>& path);
  void CountConstraints();

  Uses uses_;
  FiringReader& reader_;
  IdentityAnalysis& analysis_;
  CarriedTests& carried_;
  Arena arena_;
  std::vector<Made> made_;
  std::vector<ConditionDraft*> negated_;
  std::vector<CarriedTest> constraints_;
  std::vector<Symbol> variable_of_;                                ///< By root; none: it has none yet.
  std::unordered_map<std::uint32_t, Symbol> variable_of_symbol_;   ///< Of identifiers without an identity.
  std::vector<std::pair<Symbol, Symbol>> identifier_of_variable_;  ///< Variable, identifier.
  std::unordered_map<std::uint32_t, Symbol> own_variables_;        ///< Of the negation at hand.
  std::vector<Symbol> reached_;                                    ///< Objects that the grounds lead to.
  std::vector<Symbol> hanging_;  ///< Variables that the last attempt found in the air.
  std::vector<std::uint32_t> visited_;
  std::vector<ActionDraft*> actions_;
  std::array<std::uint32_t, 26> letters_{};
  std::uint32_t merged_conditions_ = 0, merged_disjunctions_ = 0, operational_constraints_ = 0;
  // What was made.
  ProductionPtr rule_;
  std::vector<WmeId> elements_;
  std::vector<FiringReader::TurnedTest> turned_tests_;
  std::vector<std::uint16_t> action_of_result_;
  std::vector<std::uint32_t> ground_of_condition_, negation_of_condition_;
};

}  // namespace soarbox::kernel
