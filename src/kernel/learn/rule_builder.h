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

/// The fourth to sixth stages of learning: builds the conditions and actions of the learned rule from the grounds and
/// their identities.
class RuleBuilder {
 public:
  /// The parts of the agent that it uses.
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
  /// Builds the rule of an analysed explanation.
  Outcome Build(Explanation& explanation, std::string_view name, GoalLevel results_level);

  // The result of Build; valid until the next call.
  const ProductionPtr& rule() const { return rule_; }
  /// The elements that the rule's positive conditions matched, in the order of the conditions.
  const std::vector<WmeId>& elements() const { return elements_; }
  /// The index of the action of each result.
  const std::vector<std::uint16_t>& action_of_result() const { return action_of_result_; }
  /// The index of the ground of each positive condition in the explanation; none for added conditions.
  const std::vector<std::uint32_t>& ground_of_condition() const { return ground_of_condition_; }
  /// The index of the negation of each negated condition in the explanation.
  const std::vector<std::uint32_t>& negation_of_condition() const { return negation_of_condition_; }
  /// The comparisons in its positive conditions whose sides were swapped by reordering.
  const std::vector<FiringReader::TurnedTest>& turned_tests() const { return turned_tests_; }
  const std::vector<CarriedTest>& constraints() const { return constraints_; }
  std::uint32_t merged_conditions() const { return merged_conditions_; }
  std::uint32_t merged_disjunctions() const { return merged_disjunctions_; }
  std::uint32_t operational_constraints() const { return operational_constraints_; }
  /// The name of an identity's variable before the rule was finished; empty if it has none.
  std::string VariableNameOf(IdentityGraph::Node node) const;

 private:
  struct Made {
    ConditionDraft* draft = nullptr;
    WmeId wme = WmeId::kNone;
    std::uint32_t ground = 0xFFFFFFFFu;
    std::array<IdentityGraph::Node, 3> nodes{IdentityGraph::kNone, IdentityGraph::kNone, IdentityGraph::kNone};
  };
  void MakeConditions(const Explanation& explanation);
  /// The symbol of a field's equality test: a variable or the constant.
  Symbol Meaning(IdentityGraph::Node node, Symbol value);
  /// Returns true if a condition contains the variable of the set.
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
  /// Adds conditions that connect unconnected objects with the state of the results' level.
  bool Repair(GoalLevel results_level);
  /// Variables of identifiers that are not connected with a state.
  std::vector<Symbol> Unconnected(const DraftList<ConditionDraft>& conditions, const VariableIndex& variables) const;
  bool ActionsAreGrounded() const;
  /// The identifier that a variable was created for, or none.
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
  std::vector<Symbol> variable_of_;                                ///< By representative; none: it has no variable yet.
  std::unordered_map<std::uint32_t, Symbol> variable_of_symbol_;   ///< For identifiers without an identity.
  std::vector<std::pair<Symbol, Symbol>> identifier_of_variable_;  ///< Variable, identifier.
  std::unordered_map<std::uint32_t, Symbol> own_variables_;        ///< For the current negation.
  std::vector<Symbol> reached_;                                    ///< Objects reachable from the grounds.
  std::vector<Symbol> hanging_;                                    ///< Unconnected variables of the last attempt.
  std::vector<std::uint32_t> visited_;
  std::vector<ActionDraft*> actions_;
  std::array<std::uint32_t, 26> letters_{};
  std::uint32_t merged_conditions_ = 0, merged_disjunctions_ = 0, operational_constraints_ = 0;
  // The result of Build.
  ProductionPtr rule_;
  std::vector<WmeId> elements_;
  std::vector<FiringReader::TurnedTest> turned_tests_;
  std::vector<std::uint16_t> action_of_result_;
  std::vector<std::uint32_t> ground_of_condition_, negation_of_condition_;
};

}  // namespace soarbox::kernel
