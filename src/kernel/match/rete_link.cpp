// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/match/rete_state.h"

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
}

void ReteState::UnlinkRight(std::uint32_t node) {
  const NodeState& state = nodes[node];
  AlphaState& alpha = alphas[network->node(node).alpha];
  (state.next_right == kNil ? alpha.last_node : nodes[state.next_right].previous_right) = state.previous_right;
  (state.previous_right == kNil ? alpha.first_node : nodes[state.previous_right].next_right) = state.next_right;
  marks[node].Unset(NodeMarks::kRightLinked);
}

}  // namespace soarbox::kernel
