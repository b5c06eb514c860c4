// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/match/rete_builder.h"

#include <algorithm>

#include "kernel/match/rete_state.h"

namespace soarbox::kernel {

namespace {

TestOp OpOf(TestKind kind) {
  switch (kind) {
    case TestKind::kEqual:
      return TestOp::kEqual;
    case TestKind::kNotEqual:
      return TestOp::kNotEqual;
    case TestKind::kLess:
      return TestOp::kLess;
    case TestKind::kGreater:
      return TestOp::kGreater;
    case TestKind::kLessOrEqual:
      return TestOp::kLessOrEqual;
    case TestKind::kGreaterOrEqual:
      return TestOp::kGreaterOrEqual;
    case TestKind::kSameType:
      return TestOp::kSameType;
    case TestKind::kDisjunction:
      return TestOp::kDisjunction;
    case TestKind::kState:
      return TestOp::kIsGoal;
    case TestKind::kSameLti:
      return TestOp::kSameLti;
    case TestKind::kNotSameLti:
      return TestOp::kNotSameLti;
    case TestKind::kIsLti:
      return TestOp::kIsLti;
    case TestKind::kIsNotLti:
      return TestOp::kIsNotLti;
    case TestKind::kImpasse:  // No identifier is an attribute impasse any more, so this test never succeeds.
    case TestKind::kBlank:
    case TestKind::kConjunction:
    case TestKind::kLiteral:  // AddTest skips it.
      break;
  }
  return TestOp::kNever;
}

}  // namespace

// Bindings ------------------------------------------------------------------------------------------------------------

void ReteBuilder::Unbind(std::size_t trail) {
  while (trail_.size() > trail) {
    bindings_[trail_.back().variable] = trail_.back().before;
    trail_.pop_back();
  }
}

// Tests ---------------------------------------------------------------------------------------------------------------

/// The shape of a node before the condition at a depth, indexed by an identifier that was bound earlier.
NodeShape ReteBuilder::ShapeOf(NodeKind kind, std::uint32_t depth, const Binding& binding) {
  NodeShape shape;
  shape.kind = kind;
  shape.key = KeyKind::kId;
  shape.key_id_levels = static_cast<std::uint16_t>(depth - binding.depth - 1u);
  shape.key_id_field = binding.field;
  return shape;
}

/// In a shared conjunction, a comparison with a binding outside of it is deferred to the meeting with its owners. The
/// identifier of its first condition is the anchor.
[[gnu::noinline, gnu::cold]] bool ReteBuilder::Defer(TestOp op, Field field, std::uint32_t depth,
                                                     const Binding& binding) {
  if (path_.Holds(binding.depth)) {
    return false;
  }
  const auto levels = static_cast<std::uint16_t>(path_.first - binding.depth);
  if (!path_.anchored) {
    path_.anchored = true;
    path_.anchor = ShapeOf(NodeKind::kAnchors, depth, binding);
    return true;
  }
  NodeTest test;
  test.op = op;
  test.field = field;
  test.against_binding = true;
  test.levels = levels;
  test.referent_field = binding.field;
  test.count = static_cast<std::uint16_t>(path_.last - depth);
  path_.tests.push_back(test);
  return true;
}

[[gnu::always_inline]] inline void ReteBuilder::AddEquality(Symbol symbol, std::uint32_t place, std::uint32_t depth) {
  if (!symbol.IsVariable() && tests_.constants[place] == 0) {
    tests_.constants[place] = symbol.bits();
    tests_.mask |= 1u << place;
    return;
  }
  const auto field = static_cast<Field>(place);
  NodeTest node_test;
  node_test.op = TestOp::kEqual;
  node_test.field = field;
  if (symbol.IsVariable()) {
    Binding& binding = BindingOf(symbol);
    const Binding before = binding;
    trail_.push_back({symbol.index(), before});
    binding = {depth, field};
    if (before.depth == kNil || (path_.IsBuilt() && Defer(TestOp::kEqual, field, depth, before))) {
      return;
    }
    node_test.against_binding = true;
    node_test.levels = static_cast<std::uint16_t>(depth - before.depth);
    node_test.referent_field = before.field;
  } else {
    node_test.referent = symbol.bits();
  }
  tests_.tests.push_back(node_test);
}

void ReteBuilder::AddTest(const Test& test, Field field, std::uint32_t depth) {
  if (test.kind == TestKind::kConjunction) {
    for (const Test& part : test.parts()) {
      AddTest(part, field, depth);
    }
    return;
  }
  if (test.kind == TestKind::kBlank || test.kind == TestKind::kEqual || test.kind == TestKind::kLiteral) {
    return;
  }
  NodeTest node_test;
  node_test.op = OpOf(test.kind);
  node_test.field = field;
  if (test.kind == TestKind::kDisjunction) {
    node_test.referent = static_cast<std::uint32_t>(tests_.disjuncts.size());
    node_test.count = static_cast<std::uint16_t>(test.disjuncts().size());
    for (const Symbol symbol : test.disjuncts()) {
      tests_.disjuncts.push_back(symbol.bits());
    }
  } else if (test.referent().IsVariable() && node_test.op != TestOp::kIsGoal && node_test.op != TestOp::kNever) {
    const Binding& binding = BindingOf(test.referent());
    if (binding.depth == kNil) {
      node_test.op = TestOp::kNever;  // Rules are checked before they are added; this test never succeeds.
    } else if (path_.IsBuilt() && Defer(node_test.op, field, depth, binding)) {
      return;
    } else {
      node_test.against_binding = true;
      node_test.levels = static_cast<std::uint16_t>(depth - binding.depth);
      node_test.referent_field = binding.field;
    }
  } else {
    node_test.referent = test.referent().bits();
  }
  tests_.tests.push_back(node_test);
}

// Processes all equality tests first, because the other tests may refer to variables that they bind.
void ReteBuilder::TakeApart(const Condition& condition, std::uint32_t depth) {
  tests_.tests.clear();
  tests_.disjuncts.clear();
  tests_.mask = 0;
  std::fill(tests_.constants, tests_.constants + 3, 0u);
  const Test* const fields[3] = {&condition.id, &condition.attribute, &condition.value};
  std::uint32_t more = 0;  // Bit n: field n has other tests.
  for (std::uint32_t place = 0; place < 3; ++place) {
    const Test& test = *fields[place];
    if (test.kind == TestKind::kEqual) {
      AddEquality(test.referent(), place, depth);
    } else if (test.kind != TestKind::kBlank) {
      more |= 1u << place;
      for (const Test& part : test.parts()) {
        if (part.kind == TestKind::kEqual) {
          AddEquality(part.referent(), place, depth);
        }
      }
    }
  }
  for (std::uint32_t place = 0; more >> place != 0; ++place) {
    if ((more >> place & 1u) != 0) {
      AddTest(*fields[place], static_cast<Field>(place), depth);
    }
  }
  tests_.key = NodeShape();
  if (!tests_.tests.empty()) {
    ChooseKey();
  }
}

// The key covers the first equality of the identifier with an earlier binding. If the attribute is a constant, the key
// also covers the first such equality of the value: an alpha memory then contains each pair at most once.
void ReteBuilder::ChooseKey() {
  const auto take = [this](Field field, std::uint16_t& levels, Field& referent_field) {
    for (auto test = tests_.tests.begin(); test != tests_.tests.end(); ++test) {
      if (test->op == TestOp::kEqual && test->against_binding && test->field == field && test->levels > 0) {
        levels = static_cast<std::uint16_t>(test->levels - 1u);
        referent_field = test->referent_field;
        tests_.tests.erase(test);
        return true;
      }
    }
    return false;
  };
  if (!take(Field::kId, tests_.key.key_id_levels, tests_.key.key_id_field)) {
    return;
  }
  tests_.key.key = KeyKind::kId;
  const bool constant_attribute = (tests_.mask & 2u) != 0;
  if (constant_attribute && take(Field::kValue, tests_.key.key_value_levels, tests_.key.key_value_field)) {
    tests_.key.key = KeyKind::kIdValue;
  }
}

// Nodes ---------------------------------------------------------------------------------------------------------------

// Searches through the conjunction of a conjunctive node: nodes after it must process an element before the conjunction
// does.
std::uint32_t ReteBuilder::NearestAncestor(std::uint32_t node, std::uint32_t alpha) const {
  const Network& network = *state_.network;
  while (node != kNil) {
    const Node& n = network.node(node);
    if (n.alpha == alpha) {
      return node;
    }
    node = n.kind == NodeKind::kConjunctive ? network.node(n.partner()).parent : n.parent;
  }
  return kNil;
}

std::uint32_t ReteBuilder::Make(const NodePlan& plan, std::uint32_t hash) {
  const std::uint32_t made = state_.network->AddNode(plan, hash);
  state_.NodeAdded(made);
  state_.Prime(made);
  return made;
}

/// Finds or creates a memory at an end of a shared conjunction. `tests` distinguish it from others.
std::uint32_t ReteBuilder::FindOrMakeShaped(std::uint32_t parent, NodeKind kind, const NodeShape& shape,
                                            std::span<const NodeTest> tests) {
  NodePlan plan;
  plan.parent = parent;
  plan.shape = shape;
  plan.shape.kind = kind;
  plan.tests = tests;
  const std::uint32_t hash = plan.Hash();
  const std::uint32_t shared = state_.network->FindShared(plan, hash);
  return shared != kNil ? shared : Make(plan, hash);
}

/// Returns the anchors node with the same key and parent as a memory, or such a memory for an anchors node; kNil if
/// there is none. Without sharing, the two would be one node, so they must be adjacent.
std::uint32_t ReteBuilder::TwinOf(std::uint32_t index) const {
  const Node& node = state_.network->node(index);
  if (!state_.shared.exist || (node.kind != NodeKind::kAnchors && node.kind != NodeKind::kMemory)) {
    return kNil;
  }
  NodePlan twin;
  twin.parent = node.parent;
  twin.shape = node;
  twin.shape.kind = node.kind == NodeKind::kAnchors ? NodeKind::kMemory : NodeKind::kAnchors;
  return state_.network->FindShared(twin, twin.Hash());
}

/// Finds or creates the memory for joins with the key of the current condition. Most nodes have at most one memory.
std::uint32_t ReteBuilder::FindOrMakeMemory(std::uint32_t parent) {
  const Network& network = *state_.network;
  NodePlan plan;
  plan.parent = parent;
  plan.shape = tests_.key;
  plan.shape.kind = NodeKind::kMemory;
  const std::uint32_t only = network.node(parent).only_memory;
  if (only != kNil && network.node(only).Bits() == plan.shape.Bits()) {
    return only;
  }
  const std::uint32_t hash = plan.Hash();
  const bool childless = network.node(parent).first_child == kNil;
  const std::uint32_t shared = childless ? kNil : network.FindShared(plan, hash);
  if (shared != kNil) {
    return shared;
  }
  const std::uint32_t made = Make(plan, hash);
  const std::uint32_t twin = TwinOf(made);
  if (twin != kNil) {
    state_.network->MoveBehind(made, twin);
  }
  return made;
}

/// Finds or creates a join or negative node with the tests of the current condition.
std::uint32_t ReteBuilder::FindOrMake(std::uint32_t parent, NodeKind kind, const Condition& condition) {
  const Network& network = *state_.network;
  NodePlan plan;
  plan.parent = parent;
  plan.alpha = state_.alphas.Use(*state_.network, state_.links, state_.wmes, tests_.constants, tests_.mask,
                                 condition.tests_acceptable);
  plan.shape = tests_.key;
  plan.shape.kind = kind;
  plan.tests = tests_.tests;
  plan.disjuncts = tests_.disjuncts;
  const std::uint32_t hash = plan.Hash();
  const bool childless = network.node(parent).first_child == kNil;
  const std::uint32_t shared = childless ? kNil : network.FindShared(plan, hash);
  if (shared != kNil) {
    state_.alphas.GiveUp(*state_.network, state_.links, plan.alpha);
    return shared;
  }
  plan.ancestor = NearestAncestor(parent, plan.alpha);
  return Make(plan, hash);
}

std::uint32_t ReteBuilder::BuildPositive(const Condition& condition, std::uint32_t emitter, std::uint32_t depth) {
  TakeApart(condition, depth);
  const std::uint32_t memory = FindOrMakeMemory(emitter);
  const std::uint32_t first = state_.network->node(memory).first_child;
  const std::uint32_t join = FindOrMake(memory, NodeKind::kJoin, condition);
  if (state_.network->node(memory).first_child != first) {
    MoveIfJoinsAre(2, memory);
  }
  return join;
}

/// In Soar, a memory with only one join forms one node with it. The two are separated when a second join is added, and
/// merged when only one join is left. Both times the node becomes the newest child of its parent.
void ReteBuilder::MoveIfJoinsAre(std::uint32_t count, std::uint32_t memory) {
  Network& network = *state_.network;
  const std::uint32_t twin = TwinOf(memory);
  std::uint32_t joins = 0;
  for (const std::uint32_t parent : {memory, twin}) {
    for (std::uint32_t child = parent == kNil ? kNil : network.node(parent).first_child;
         child != kNil && joins <= count; child = network.node(child).next_sibling) {
      ++joins;
    }
  }
  if (joins != count) {
    return;
  }
  network.MoveToHead(memory);
  if (twin != kNil) {
    network.MoveBehind(twin, memory);
  }
}

std::uint32_t ReteBuilder::BuildNegative(const Condition& condition, std::uint32_t emitter, std::uint32_t depth) {
  const std::size_t trail = trail_.size();
  TakeApart(condition, depth);
  Unbind(trail);
  return FindOrMake(emitter, NodeKind::kNegative, condition);
}

// The nodes of the conjunction must process a token before the conjunctive node does, so that the token is blocked in
// time. Therefore they are before it in the list of children.
std::uint32_t ReteBuilder::BuildConjunctive(const Condition& condition, std::uint32_t emitter, std::uint32_t depth) {
  if (CanBeShared(condition, emitter, depth)) {
    return BuildShared(condition, emitter, depth);
  }
  const std::size_t trail = trail_.size();
  const std::uint32_t bottom = BuildAll(condition.conditions(), emitter, depth);
  Unbind(trail);
  if (bottom == emitter) {
    return emitter;  // The conjunction is empty. The parser never creates one.
  }
  NodePlan node;
  node.parent = emitter;
  node.shape.kind = NodeKind::kConjunctive;
  node.digest = bottom;
  return MakeConjunctive(node, bottom, static_cast<std::uint32_t>(condition.conditions().size()));
}

/// Creates the conjunctive node of a conjunction of `length` conditions that ends with the node `bottom`.
std::uint32_t ReteBuilder::MakeConjunctive(const NodePlan& conjunctive, std::uint32_t bottom, std::uint32_t length) {
  Network& network = *state_.network;
  NodePlan partner;
  partner.parent = bottom;
  partner.shape.kind = NodeKind::kPartner;
  partner.shape.key_id_levels = static_cast<std::uint16_t>(length);
  const std::uint32_t hash = partner.Hash();
  const std::uint32_t shared = network.FindShared(partner, hash);
  if (shared != kNil) {
    return network.node(shared).partner();
  }
  std::uint32_t top = bottom;
  while (network.node(top).parent != conjunctive.parent) {
    top = network.node(top).parent;
  }
  const std::uint32_t node = network.AddNode(conjunctive, conjunctive.Hash());
  network.MoveToHead(top);
  const std::uint32_t twin = TwinOf(top);
  if (twin != kNil) {
    network.MoveBehind(twin, top);
  }
  const std::uint32_t made = network.AddNode(partner, hash);
  network.SetPartner(node, made);
  if (network.node(bottom).kind == NodeKind::kPaths) {
    network.SetPaths(node, top, bottom);
  }
  state_.NodeAdded(node);
  state_.NodeAdded(made);
  state_.shared.new_paths.clear();  // The owners, which are added now, find the existing paths.
  state_.Prime(made);
  state_.Prime(node);
  return node;
}

std::uint32_t ReteBuilder::BuildAll(std::span<const Condition> conditions, std::uint32_t emitter, std::uint32_t depth) {
  for (const Condition& condition : conditions) {
    switch (condition.kind) {
      case ConditionKind::kPositive:
        emitter = BuildPositive(condition, emitter, depth);
        break;
      case ConditionKind::kNegative:
        emitter = BuildNegative(condition, emitter, depth);
        break;
      case ConditionKind::kConjunctiveNegation:
        emitter = BuildConjunctive(condition, emitter, depth);
        break;
    }
    ++depth;
  }
  return emitter;
}

std::uint32_t ReteBuilder::Build(std::span<const Condition> conditions) {
  const std::uint32_t bottom = BuildAll(conditions, 0, 0);
  Unbind(0);
  return bottom;
}

}  // namespace soarbox::kernel
