// SPDX-License-Identifier: BSD-2-Clause
#include <utility>

#include "kernel/match/rete_inline.h"

namespace soarbox::kernel {

void ReteState::LinkLeft(std::uint32_t node) {
  nodes.LinkLeft(node, network->node(node).parent);
}

void ReteState::UnlinkLeft(std::uint32_t node) {
  nodes.UnlinkLeft(node, network->node(node).parent);
}

void ReteState::LinkRight(std::uint32_t node) {
  AlphaState& alpha = alphas[network->node(node).alpha];
  nodes.LinkRight(*network, alpha, node);
  if ((alpha.sparse & AlphaState::kBusy) != 0) [[unlikely]] {
    FindOnlyId(node);
  }
}

void ReteState::UnlinkRight(std::uint32_t node) {
  nodes.UnlinkRight(alphas[network->node(node).alpha], node);
}

void ReteState::FindOnlyId(std::uint32_t index) {
  const Node& node = network->node(index);
  std::uint32_t& id = only_ids[index];
  id = 0;
  if (node.kind != NodeKind::kJoin || node.key == KeyKind::kNone || nodes[node.parent].count != 1 ||
      network->node(node.parent).kind != NodeKind::kMemory || nodes.marks(node.parent).Is(NodeMarks::kSparse) ||
      nodes.marks(node.parent).bits() != 0) {
    return;  // A table is not searched for the one token in it.
  }
  const Node& memory = network->node(node.parent);
  const std::uint32_t token = nodes[node.parent].head;
  id = FieldOf(wmes[ElementAt(tokens.read(), token, memory.key_id_levels)], memory.key_id_field);
}

/// One more node uses an alpha memory. It becomes busy when many of them are linked: counting them at times is enough.
void ReteState::NoteNodes(std::uint32_t alpha) {
  AlphaState& memory = alphas[alpha];
  if (network->alpha(alpha).uses % only_ids.busy_from() != 0 || (memory.sparse & AlphaState::kBusy) != 0) {
    return;
  }
  std::uint32_t linked = 0;
  for (std::uint32_t node = memory.first_node; node != kNil; node = nodes[node].next_right) {
    ++linked;
  }
  if (linked < only_ids.busy_from()) {
    return;
  }
  memory.sparse |= AlphaState::kBusy;
  only_ids.Begin(nodes.size());
  for (std::uint32_t node = memory.first_node; node != kNil; node = nodes[node].next_right) {
    FindOnlyId(node);
  }
}

}  // namespace soarbox::kernel
