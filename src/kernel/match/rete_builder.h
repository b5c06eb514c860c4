// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "kernel/match/network.h"
#include "kernel/match/rete.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

struct ReteState;

/// Adds rules to the network of an agent and removes them: turns the conditions of one rule into nodes, and shares
/// those that exist.
///
/// Depth counts conditions from the top; a negated condition or a conjunctive negation counts as one. Inside a
/// conjunctive negation it continues from the conditions before it. From a condition at depth d, a binding at depth b
/// is d - b levels up. A condition that tests a variable for equality binds it again, so that later conditions find it
/// as few levels up as possible.
class [[gnu::visibility("hidden")]] ReteBuilder {
 public:
  explicit ReteBuilder(ReteState & state) : state_(state) {}

  /// See Rete::AddProduction. The goals are those of the state.
  Rete::Added AddProduction(ProductionPtr production, const Rete::AddOptions& options);
  /// See Rete::ExciseProduction; the rule must exist.
  void ExciseProduction(std::uint32_t production);

 private:
  struct Binding {
    std::uint32_t depth = kNil;  ///< kNil: unbound.
    Field field = Field::kId;
  };
  struct Rebinding {
    std::uint32_t variable = 0;
    Binding before;
  };
  /// The tests of one condition, by the place where they are evaluated.
  struct Tests {
    std::uint32_t constants[3] = {0, 0, 0};
    std::uint32_t mask = 0;
    std::vector<NodeTest> tests;
    std::vector<std::uint32_t> disjuncts;
    NodeShape key;  ///< Only its key fields.
  };

  /// Returns the node that emits the rule's complete matches.
  std::uint32_t Build(std::span<const Condition> conditions);
  /// Returns the node that emits while none of a rule's negated conditions matches (rete_guard.cpp).
  std::uint32_t BuildGuard(std::span<const Condition> negations, std::uint32_t rule);
  bool CanBeGuarded(const RuleInfo& info, const Rete::AddOptions& options) const;
  bool AddGuarded(const std::shared_ptr<RuleInfo>& info, std::uint32_t number, const Rete::AddOptions& options);
  void EnterRule(const std::shared_ptr<RuleInfo>& info, std::uint32_t number, std::uint32_t node);
  void MatchNewRule(std::uint32_t node, const Rete::AddOptions& options);
  void RemoveUnused(std::uint32_t node);
  /// A join of this memory has been removed.
  void JoinRemoved(std::uint32_t memory) {
    MoveIfJoinsAre(1, memory);
  }

  std::uint32_t BuildAll(std::span<const Condition> conditions, std::uint32_t emitter, std::uint32_t depth);
  std::uint32_t BuildPositive(const Condition& condition, std::uint32_t emitter, std::uint32_t depth);
  std::uint32_t BuildNegative(const Condition& condition, std::uint32_t emitter, std::uint32_t depth);
  std::uint32_t BuildConjunctive(const Condition& condition, std::uint32_t emitter, std::uint32_t depth);
  bool CanBeShared(const Condition& condition, std::uint32_t emitter, std::uint32_t depth);
  static NodeShape ShapeOf(NodeKind kind, std::uint32_t depth, const Binding& binding);
  std::uint32_t BuildShared(const Condition& condition, std::uint32_t emitter, std::uint32_t depth);
  std::uint32_t MakeConjunctive(const NodePlan& conjunctive, std::uint32_t bottom, std::uint32_t length);
  std::uint32_t FindOrMakeShaped(std::uint32_t parent, NodeKind kind, const NodeShape& shape,
                                 std::span<const NodeTest> tests = {});
  std::uint32_t TwinOf(std::uint32_t index) const;
  std::uint32_t FindOrMakeMemory(std::uint32_t parent);
  void MoveIfJoinsAre(std::uint32_t count, std::uint32_t memory);
  std::uint32_t FindOrMake(std::uint32_t parent, NodeKind kind, const Condition& condition);
  std::uint32_t Make(const NodePlan& plan, std::uint32_t hash);
  std::uint32_t NearestAncestor(std::uint32_t node, std::uint32_t alpha) const;

  void TakeApart(const Condition& condition, std::uint32_t depth);
  void AddEquality(Symbol symbol, std::uint32_t place, std::uint32_t depth);
  void AddTest(const Test& test, Field field, std::uint32_t depth);
  void ChooseKey();
  Binding& BindingOf(Symbol variable) {
    if (variable.index() >= bindings_.size()) [[unlikely]] {
      bindings_.resize(variable.index() + 1u);
    }
    return bindings_[variable.index()];
  }
  /// Removes the bindings added since the trail had this length.
  void Unbind(std::size_t trail);

  ReteState& state_;
  /// A shared conjunction under construction. Its own conditions are tested in their nodes; comparisons with earlier
  /// bindings are evaluated when all of them have matched.
  struct Path {
    std::uint32_t first = kNil;  ///< Depth of its first condition; kNil: none is under construction.
    std::uint32_t last = 0;
    bool anchored = false;  ///< The identifier of the first condition has been seen.
    NodeShape anchor;       ///< Where the owner has this identifier; only its key fields are used.
    std::vector<NodeTest> tests;
    bool IsBuilt() const { return first != kNil; }
    bool Holds(std::uint32_t depth) const { return depth >= first; }
  };
  bool Defer(TestOp op, Field field, std::uint32_t depth, const Binding& binding);

  Tests tests_;
  Path path_;
  std::vector<Symbol> inside_;     ///< Scratch: variables of a conjunction.
  std::vector<Binding> bindings_;  ///< By variable.
  std::vector<Rebinding> trail_;   ///< Bound variables, in order, with their earlier bindings.
};

}  // namespace soarbox::kernel
