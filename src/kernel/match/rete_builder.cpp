// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/match/rete_builder.h"

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
    case TestKind::kImpasse:  // No identifier is an attribute impasse any more.
    case TestKind::kBlank:
    case TestKind::kConjunction:
      break;
  }
  return TestOp::kNever;
}

}  // namespace

// Bindings ------------------------------------------------------------------------------------------------------------

ReteBuilder::Binding& ReteBuilder::BindingOf(Symbol variable) {
  if (variable.index() >= bindings_.size()) {
    bindings_.resize(variable.index() + 1u);
  }
  return bindings_[variable.index()];
}

void ReteBuilder::Unbind(std::size_t trail) {
  while (trail_.size() > trail) {
    bindings_[trail_.back().variable] = trail_.back().before;
    trail_.pop_back();
  }
}

// Tests ---------------------------------------------------------------------------------------------------------------

void ReteBuilder::AddEquality(const Test& test, Field field, std::uint32_t depth) {
  const auto place = static_cast<std::uint32_t>(field);
  if (test.kind == TestKind::kConjunction) {
    for (const Test& part : test.parts()) {
      AddEquality(part, field, depth);
    }
    return;
  }
  if (test.kind != TestKind::kEqual) {
    return;
  }
  NodeTest node_test;
  node_test.op = TestOp::kEqual;
  node_test.field = field;
  if (!test.referent().IsVariable()) {
    if (tests_.constants[place] == 0) {
      tests_.constants[place] = test.referent().bits();
      tests_.mask |= 1u << place;
      return;
    }
    node_test.referent = test.referent().bits();
    tests_.tests.push_back(node_test);
    return;
  }
  Binding& binding = BindingOf(test.referent());
  const Binding before = binding;
  trail_.push_back({test.referent().index(), before});
  binding.depth = depth;
  binding.field = field;
  if (before.depth == kNil) {
    return;
  }
  node_test.against_binding = true;
  node_test.levels = static_cast<std::uint16_t>(depth - before.depth);
  node_test.referent_field = before.field;
  tests_.tests.push_back(node_test);
}

void ReteBuilder::AddTest(const Test& test, Field field, std::uint32_t depth) {
  if (test.kind == TestKind::kConjunction) {
    for (const Test& part : test.parts()) {
      AddTest(part, field, depth);
    }
    return;
  }
  if (test.kind == TestKind::kBlank || test.kind == TestKind::kEqual) {
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
      node_test.op = TestOp::kNever;  // Rules are checked before they come here; this cannot be satisfied.
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

void ReteBuilder::TakeApart(const Condition& condition, std::uint32_t depth) {
  tests_.tests.clear();
  tests_.disjuncts.clear();
  tests_.mask = 0;
  std::fill(tests_.constants, tests_.constants + 3, 0u);
  AddEquality(condition.id, Field::kId, depth);
  AddEquality(condition.attribute, Field::kAttribute, depth);
  AddEquality(condition.value, Field::kValue, depth);
  AddTest(condition.id, Field::kId, depth);
  AddTest(condition.attribute, Field::kAttribute, depth);
  AddTest(condition.value, Field::kValue, depth);
  ChooseKey();
}

// The key takes over the first equality of the identifier with an earlier binding, and of the value if the attribute is
// a constant (then an alpha memory holds each pair at most once).
void ReteBuilder::ChooseKey() {
  tests_.key = Node();
  const auto take = [this](Field field) -> const NodeTest* {
    for (const NodeTest& test : tests_.tests) {
      if (test.op == TestOp::kEqual && test.against_binding && test.field == field && test.levels > 0) {
        return &test;
      }
    }
    return nullptr;
  };
  const NodeTest* id = take(Field::kId);
  if (id == nullptr) {
    return;
  }
  tests_.key.key = KeyKind::kId;
  tests_.key.key_id_levels = static_cast<std::uint16_t>(id->levels - 1u);
  tests_.key.key_id_field = id->referent_field;
  tests_.tests.erase(tests_.tests.begin() + (id - tests_.tests.data()));
  if ((tests_.mask & 2u) == 0) {
    return;
  }
  if (const NodeTest* value = take(Field::kValue)) {
    tests_.key.key = KeyKind::kIdValue;
    tests_.key.key_value_levels = static_cast<std::uint16_t>(value->levels - 1u);
    tests_.key.key_value_field = value->referent_field;
    tests_.tests.erase(tests_.tests.begin() + (value - tests_.tests.data()));
  }
}

// Nodes ---------------------------------------------------------------------------------------------------------------

// Through the conjunction of a conjunctive node: what comes after it must see an element before the conjunction does.
std::uint32_t ReteBuilder::NearestAncestor(std::uint32_t node, std::uint32_t alpha) const {
  const Network& network = *state_.network;
  while (node != kNil) {
    const Node& n = network.node(node);
    if (n.alpha == alpha) {
      return node;
    }
    node = n.kind == NodeKind::kConjunctive ? network.node(n.partner).parent : n.parent;
  }
  return kNil;
}

std::uint32_t ReteBuilder::MakeNode(std::uint32_t parent, Node node, bool with_tests) {
  const std::span<const NodeTest> tests =
      with_tests ? std::span<const NodeTest>(tests_.tests) : std::span<const NodeTest>();
  const std::uint32_t shared = state_.network->FindShared(parent, node, tests, tests_.disjuncts);
  if (shared != kNil) {
    if (node.alpha != kNil) {
      state_.DropAlpha(node.alpha);
    }
    return shared;
  }
  if (node.alpha != kNil) {
    node.ancestor = NearestAncestor(parent, node.alpha);
  }
  const std::uint32_t made = state_.network->AddNode(parent, node, tests, tests_.disjuncts);
  state_.NodeAdded(made);
  state_.Prime(made);
  return made;
}

std::uint32_t ReteBuilder::BuildPositive(const Condition& condition, std::uint32_t emitter, std::uint32_t depth) {
  TakeApart(condition, depth);
  Node memory = tests_.key;
  memory.kind = NodeKind::kMemory;
  const std::uint32_t parent = MakeNode(emitter, memory, false);
  Node join = tests_.key;
  join.kind = NodeKind::kJoin;
  join.alpha = state_.MakeAlpha(tests_.constants, tests_.mask, condition.tests_acceptable);
  return MakeNode(parent, join, true);
}

std::uint32_t ReteBuilder::BuildNegative(const Condition& condition, std::uint32_t emitter, std::uint32_t depth) {
  const std::size_t trail = trail_.size();
  TakeApart(condition, depth);
  Unbind(trail);
  Node node = tests_.key;
  node.kind = NodeKind::kNegative;
  node.alpha = state_.MakeAlpha(tests_.constants, tests_.mask, condition.tests_acceptable);
  return MakeNode(emitter, node, true);
}

// The conjunction's own nodes must see a token before the conjunctive node does, so that it is blocked in time: they
// stand in front of it.
std::uint32_t ReteBuilder::BuildConjunctive(const Condition& condition, std::uint32_t emitter, std::uint32_t depth) {
  const std::size_t trail = trail_.size();
  const std::uint32_t bottom = BuildAll(condition.conditions(), emitter, depth);
  Unbind(trail);
  if (bottom == emitter) {
    return emitter;  // An empty conjunction; the parser never makes one.
  }
  Network& network = *state_.network;
  Node partner;
  partner.kind = NodeKind::kPartner;
  partner.key_id_levels = static_cast<std::uint16_t>(condition.conditions().size());
  const std::uint32_t shared = network.FindShared(bottom, partner, {}, {});
  if (shared != kNil) {
    return network.node(shared).partner;
  }
  std::uint32_t top = bottom;
  while (network.node(top).parent != emitter) {
    top = network.node(top).parent;
  }
  Node node;
  node.kind = NodeKind::kConjunctive;
  const std::uint32_t conjunctive = network.AddNode(emitter, node, {}, {}, bottom);
  network.MoveToHead(top);
  const std::uint32_t made = network.AddNode(bottom, partner, {}, {});
  network.SetPartner(conjunctive, made);
  state_.NodeAdded(conjunctive);
  state_.NodeAdded(made);
  state_.Prime(made);
  state_.Prime(conjunctive);
  return conjunctive;
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
