// SPDX-License-Identifier: BSD-2-Clause
#include <utility>

#include "kernel/match/rete_inline.h"

namespace soarbox::kernel {

void ReteState::LinkLeft(std::uint32_t node) {
  NodeState& state = nodes[node];
  std::uint32_t& head = nodes[network->node(node).parent].first_linked;
  state.previous_left = kNil;
  state.next_left = head;
  if (head != kNil) {
    nodes[head].previous_left = node;
  }
  head = node;
  marks[node].Set(NodeMarks::kLeftLinked);
}

void ReteState::UnlinkLeft(std::uint32_t node) {
  const NodeState& state = nodes[node];
  if (state.next_left != kNil) {
    nodes[state.next_left].previous_left = state.previous_left;
  }
  if (state.previous_left != kNil) {
    nodes[state.previous_left].next_left = state.next_left;
  } else {
    nodes[network->node(node).parent].first_linked = state.next_left;
  }
  marks[node].Unset(NodeMarks::kLeftLinked);
}

// In front of the nearest linked ancestor with the same alpha memory, else at the end: a descendant must see a new
// element before its ancestor makes tokens of it, or it would see the pair twice.
void ReteState::LinkRight(std::uint32_t node) {
  NodeState& state = nodes[node];
  AlphaState& alpha = alphas[network->node(node).alpha];
  std::uint32_t ancestor = network->node(node).ancestor;
  while (ancestor != kNil && !marks[ancestor].Is(NodeMarks::kRightLinked)) {
    ancestor = network->node(ancestor).ancestor;
  }
  state.next_right = ancestor;
  state.previous_right = ancestor == kNil ? alpha.last_node : nodes[ancestor].previous_right;
  (ancestor == kNil ? alpha.last_node : nodes[ancestor].previous_right) = node;
  (state.previous_right == kNil ? alpha.first_node : nodes[state.previous_right].next_right) = node;
  marks[node].Set(NodeMarks::kRightLinked);
  if ((alpha.sparse & AlphaState::kBusy) != 0) [[unlikely]] {
    FindOnlyId(node);
  }
}

void ReteState::FindOnlyId(std::uint32_t index) {
  const Node& node = network->node(index);
  std::uint32_t& id = only_id[index];
  id = 0;
  if (node.kind != NodeKind::kJoin || node.key == KeyKind::kNone || nodes[node.parent].count != 1 ||
      network->node(node.parent).kind != NodeKind::kMemory || marks[node.parent].Is(NodeMarks::kSparse) ||
      marks[node.parent].bits() != 0) {
    return;  // A table is not searched for the one token in it.
  }
  const Node& memory = network->node(node.parent);
  const std::uint32_t token = nodes[node.parent].head;
  id = FieldOf(wmes[ElementAt(std::as_const(tokens).records(), token, memory.key_id_levels)], memory.key_id_field);
}

/// One more node uses an alpha memory. It becomes busy when many of them are linked: counting them at times is enough.
void ReteState::NoteNodes(std::uint32_t alpha) {
  AlphaState& memory = alphas[alpha];
  if (network->alpha(alpha).uses % busy_from != 0 || (memory.sparse & AlphaState::kBusy) != 0) {
    return;
  }
  std::uint32_t linked = 0;
  for (std::uint32_t node = memory.first_node; node != kNil; node = nodes[node].next_right) {
    ++linked;
  }
  if (linked < busy_from) {
    return;
  }
  memory.sparse |= AlphaState::kBusy;
  only_id.resize(nodes.size());
  for (std::uint32_t node = memory.first_node; node != kNil; node = nodes[node].next_right) {
    FindOnlyId(node);
  }
}

void ReteState::UnlinkRight(std::uint32_t node) {
  const NodeState& state = nodes[node];
  AlphaState& alpha = alphas[network->node(node).alpha];
  (state.next_right == kNil ? alpha.last_node : nodes[state.next_right].previous_right) = state.previous_right;
  (state.previous_right == kNil ? alpha.first_node : nodes[state.previous_right].next_right) = state.next_right;
  marks[node].Unset(NodeMarks::kRightLinked);
}

}  // namespace soarbox::kernel
