// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>

#include "kernel/match/rete_builder.h"
#include "kernel/match/rete_state.h"

/// Determines which conjunctions are shared, and builds their nodes. Shared conjunctions are described in
/// rete_shared.cpp.
namespace soarbox::kernel {

namespace {

/// Visits the variables in a field's equality tests.
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

/// Whether a field is compared with a variable for which `is` returns true.
template <typename Is>
bool ComparesWith(const Test& test, Is is) {
  if (test.kind == TestKind::kConjunction) {
    return std::ranges::any_of(test.parts(), [&](const Test& part) { return ComparesWith(part, is); });
  }
  return test.kind != TestKind::kBlank && test.kind != TestKind::kLiteral && test.kind != TestKind::kDisjunction &&
         test.referent().IsVariable() && is(test.referent());
}

/// Whether the result of a test of an element stays the same as long as the element exists.
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

/// A conjunction can be shared if it is a path: two or more positive conditions. The identifier of the first condition
/// must be bound outside, those of all others inside. Sharing is worthwhile if several tokens may have the same first
/// identifier, and if a test compares bindings of these tokens with the path. Conditions after such a comparison must
/// be about the same object: otherwise the comparison might have prevented many partial matches.
///
/// Sharing is not possible if several tokens already wait for the conjunction: the order in which they would have met
/// its elements is unknown. It is also not possible if the first condition is joined with a memory that other rules
/// use. The order of that memory's children determines the order of their matches.
bool ReteBuilder::CanBeShared(const Condition& condition, std::uint32_t emitter, std::uint32_t depth) {
  const std::span<const Condition> conditions = condition.conditions();
  if (!state_.shared.allowed || path_.IsBuilt() || conditions.size() < 2) {
    return false;
  }
  std::vector<Symbol>& inside = inside_;
  inside.clear();
  Binding anchor;
  Symbol compared;  // The identifier of the first condition that compares with a binding outside.
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
    return true;  // Another shared conjunction has the same anchors.
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
  // Owners and paths meet by the identifier and the first other binding that must be equal.
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
