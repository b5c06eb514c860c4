// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernel/learn/explanation.h"
#include "kernel/observer.h"

namespace soarbox::kernel {

class Agent;
struct ConditionTrace;
class Descriptions;
class Firing;
class GoalChanges;
class GoalStack;
class InstantiationTable;
class Justifier;
struct LearnSettings;
struct LearnStatistics;
class Observers;
class ProductionRecord;
class Rete;
class SelectionKnowledge;
struct Wme;
class WorkingMemory;

/// The second stage of learning: finds the elements on which the results depend. Follows the conditions of the firings
/// that created the results, one by one, to elements of higher states.
class Backtracer {
 public:
  /// The parts of the agent that it uses.
  struct Uses {
    Agent& agent;
    const WorkingMemory& memory;
    const GoalStack& goals;
    InstantiationTable& instantiations;
    const Rete& rete;
    const std::vector<ProductionRecord>& productions;
    const GoalChanges& goal_changes;
    Firing& firing;
    const SelectionKnowledge& selections;
    const Justifier& justifier;
    const Observers& observers;
    const Descriptions& descriptions;
    const LearnSettings& learn;
    LearnStatistics& statistics;
  };
  explicit Backtracer(const Uses& uses) : uses_(uses) {}

  /// Adds what the results depend on to their explanation. With `every_condition`, each condition is a separate ground;
  /// else there is one ground per element.
  void Trace(Explanation& out, bool every_condition);
  void Clear() { seen_wmes_.clear(); }

 private:
  void VisitFiring(InstantiationId firing);
  /// Reports a step to observers, if there are any.
  void Tell(const BacktraceStep& step) const;
  /// Reports a firing, with everything that it tested.
  void TellOfFiring(InstantiationId firing);
  void VisitCondition(InstantiationId firing, std::uint16_t condition, const ConditionTrace& trace);
  /// Follows the preferences that made the local operator, which a firing tests or proposed, better than others.
  void VisitSelection(std::uint32_t selection);
  void VisitItem(WmeId item);
  /// The firing that proposed the substate's selected operator, if the reason of the selection is recorded. This firing
  /// keeps the reason while the operator is selected.
  InstantiationId SelectedProposal() const;
  void AddGround(const Explanation::Ground& ground, const Wme& wme);
  void CollectNegations(InstantiationId firing);
  void AddNegation(InstantiationId firing, const Condition* source, const ConditionDraft& literal,
                   std::span<const std::uint16_t> classes = {});
  bool MayReferToHigherOnly(const Condition& condition, InstantiationId firing) const;
  /// Removes negated conditions about objects of the substate. Keeps those whose objects are reachable from the
  /// grounds.
  void SortNegations();
  bool IsReached(const ConditionDraft& condition);
  void Reach(Symbol symbol) {
    if (symbol.IsIdentifier() || symbol.IsVariable()) reached_.push_back(symbol);
  }
  bool Mark(WmeId wme);

  Uses uses_;
  Explanation* out_ = nullptr;
  bool every_condition_ = false;
  bool is_told_ = false;  ///< An observer receives the steps.
  /// An entry of the queue: a firing to visit, or else an item of the impasse.
  struct Open {
    InstantiationId firing = InstantiationId::kNone;
    WmeId item = WmeId::kNone;
    Explanation::Link link;      ///< The link that leads to the firing, if links are wanted.
    WmeId local = WmeId::kNone;  ///< The element that leads here, for observers.
  };
  std::vector<Open> queue_;
  InstantiationId selected_proposal_ = InstantiationId::kNone;
  std::vector<std::uint32_t> seen_wmes_;
  std::vector<Symbol> reached_;  ///< Objects in the grounds; variables of the current conjunction.
};

/// Replaces the variables of a negated condition by the values that the positive conditions of the firing matched.
ConditionDraft InstantiateNegation(const Condition& condition, const Production& rule,
                                   std::span<const ConditionTrace> matched, const WorkingMemory& memory, Arena& arena);

}  // namespace soarbox::kernel
