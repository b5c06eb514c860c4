// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>

#include "kernel/match/rete_builder.h"
#include "kernel/match/rete_state.h"

/// Which conjunctions are shared, and their nodes. What that means: rete_shared.cpp.
namespace soarbox::kernel {

namespace {

/// The variables that a field is tested for equality with.
template <typename Visit>
void ForEachEqual(const Test& test, Visit visit) {
  if (test.kind == TestKind::kEqual && test.referent().IsVariable()) {
    visit(test.referent());
  } else if (test.kind == TestKind::kConjunction) {
    for (const Test& part : test.parts()) {
      ForEachEqual(part, visit);
    }
  }
}

/// Whether a field is compared with a variable that `is` tells of.
template <typename Is>
bool ComparesWith(const Test& test, Is is) {
  if (test.kind == TestKind::kConjunction) {
    return std::ranges::any_of(test.parts(), [&](const Test& part) { return ComparesWith(part, is); });
  }
  return test.kind != TestKind::kBlank && test.kind != TestKind::kLiteral && test.kind != TestKind::kDisjunction &&
         test.referent().IsVariable() && is(test.referent());
}

/// Whether what the test says of an element is the same as long as the element is there.
bool IsLasting(const Test& test) {
  switch (test.kind) {
    case TestKind::kSameLti:
    case TestKind::kNotSameLti:
    case TestKind::kIsLti:
    case TestKind::kIsNotLti:
      return false;
    case TestKind::kConjunction:
      return std::ranges::all_of(test.parts(), IsLasting);
    default:
      return true;
  }
}

}  // namespace

/// A conjunction can be shared if it is a path: two or more positive conditions, the first of an identifier bound
/// outside, each other of an identifier bound inside. It is worth it if several tokens may have that identifier and
/// something compares what they have with the path. What comes behind such a comparison must be of the same object:
/// otherwise it might be much that the comparison would have kept away.
///
/// Not while several tokens wait for it already: the order in which they would have met its elements is not known. And
/// not where the first condition is joined with a memory that other rules have as well: the order of its children says
/// in which order their matches appear.
bool ReteBuilder::CanBeShared(const Condition& condition, std::uint32_t emitter, std::uint32_t depth) {
  const std::span<const Condition> conditions = condition.conditions();
  if (!state_.shared.allowed || path_.IsBuilt() || conditions.size() < 2) {
    return false;
  }
  std::vector<Symbol>& inside = inside_;
  inside.clear();
  Binding anchor;
  Symbol compared;  // The identifier of the first condition that compares with something outside.
  for (const Condition& part : conditions) {
    if (part.kind != ConditionKind::kPositive || !IsLasting(part.id) || !IsLasting(part.attribute) ||
        !IsLasting(part.value)) {
      return false;
    }
    Symbol id;
    ForEachEqual(part.id, [&](Symbol variable) {
      if (!id &&
          (inside.empty() ? BindingOf(variable).depth != kNil : std::ranges::find(inside, variable) != inside.end())) {
        id = variable;
      }
    });
    if (!id || (compared && id != compared)) {
      return false;
    }
    if (inside.empty()) {
      anchor = BindingOf(id);
    }
    const auto is_outside = [&](Symbol variable) {
      return variable != id && BindingOf(variable).depth != kNil && std::ranges::find(inside, variable) == inside.end();
    };
    if (ComparesWith(part.id, is_outside) || ComparesWith(part.attribute, is_outside) ||
        ComparesWith(part.value, is_outside)) {
      compared = id;
    }
    for (const Test* field : {&part.id, &part.attribute, &part.value}) {
      ForEachEqual(*field, [&](Symbol variable) { inside.push_back(variable); });
    }
  }
  if (!compared || anchor.depth + 1 >= depth) {
    return false;
  }
  NodePlan memory;
  memory.parent = emitter;
  memory.shape = ShapeOf(NodeKind::kAnchors, depth, anchor);
  if (state_.network->FindShared(memory, memory.Hash()) != kNil) {
    return true;  // As an equal rule would be.
  }
  memory.shape.kind = NodeKind::kMemory;
  return state_.network->FindShared(memory, memory.Hash()) == kNil && state_.emissions().Of(emitter).size() < 2;
}

std::uint32_t ReteBuilder::BuildShared(const Condition& condition, std::uint32_t emitter, std::uint32_t depth) {
  state_.shared.exist = true;
  const std::span<const Condition> conditions = condition.conditions();
  const auto length = static_cast<std::uint32_t>(conditions.size());
  const std::size_t trail = trail_.size();
  path_.first = depth;
  path_.last = depth + length - 1;
  path_.anchored = false;
  path_.anchor = NodeShape();
  path_.tests.clear();
  std::uint32_t bottom = emitter;
  for (std::uint32_t n = 0; n < length; ++n) {
    TakeApart(conditions[n], depth + n);
    std::uint32_t memory;
    if (n == 0) {
      memory = FindOrMakeShaped(emitter, NodeKind::kAnchors, path_.anchor);
      tests_.key = NodeShape();
      tests_.key.key = KeyKind::kId;
    } else {
      memory = FindOrMakeMemory(bottom);
    }
    bottom = FindOrMake(memory, NodeKind::kJoin, conditions[n]);
  }
  Unbind(trail);
  path_.first = kNil;

  NodePlan owner;
  owner.parent = emitter;
  owner.shape = path_.anchor;
  owner.shape.kind = NodeKind::kConjunctive;
  NodeShape paths;
  paths.key = KeyKind::kId;
  paths.key_id_field = Field::kId;
  paths.key_id_levels = static_cast<std::uint16_t>(length - 1);
  // Owners and paths meet by the identifier, and by the first other binding that must be equal.
  const auto equal = std::ranges::find_if(path_.tests, [](const NodeTest& test) { return test.op == TestOp::kEqual; });
  if (equal != path_.tests.end()) {
    paths.key = owner.shape.key = KeyKind::kIdValue;
    owner.shape.key_value_levels = static_cast<std::uint16_t>(equal->levels - 1u);
    owner.shape.key_value_field = equal->referent_field;
    paths.key_value_levels = equal->count;
    paths.key_value_field = equal->field;
  }
  bottom = FindOrMakeShaped(bottom, NodeKind::kPaths, paths, path_.tests);
  owner.tests = path_.tests;
  owner.digest = bottom;
  return MakeConjunctive(owner, bottom, length);
}

}  // namespace soarbox::kernel
