// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/match/join_links.h"

namespace soarbox::kernel {

void JoinLinks::SparseEmptied(std::uint32_t memory) {
  const std::uint32_t join = network_.node(memory).first_child;
  if (nodes_.marks(join).Is(NodeMarks::kLeftLinked) && nodes_.marks(join).Is(NodeMarks::kRightLinked)) {
    UnlinkRight(join);
  }
}

void JoinLinks::FindOnlyId(const Network& network, const NodeStates& nodes, OnlyIds& only_ids, const TokenPool& tokens,
                           const WmeTable& wmes, std::uint32_t index) {
  const Node& node = network.node(index);
  std::uint32_t& id = only_ids[index];
  id = 0;
  if (node.kind != NodeKind::kJoin || node.key == KeyKind::kNone || nodes[node.parent].count != 1 ||
      network.node(node.parent).kind != NodeKind::kMemory || nodes.marks(node.parent).Is(NodeMarks::kSparse) ||
      nodes.marks(node.parent).bits() != 0) {
    return;  // Also if the only token is in a table: it is not searched there.
  }
  const Node& memory = network.node(node.parent);
  const std::uint32_t token = nodes[node.parent].head;
  id = BitsOf(wmes[ElementAt(tokens.read(), token, memory.key_id_levels)], memory.key_id_field);
}

void JoinLinks::NoteNodes(std::uint32_t alpha) {
  AlphaState& memory = alphas_[alpha];
  if (network_.alpha(alpha).uses % only_ids_.busy_from() != 0 || (memory.sparse & AlphaState::kBusy) != 0) {
    return;
  }
  std::uint32_t linked = 0;
  for (std::uint32_t node = memory.first_node; node != kNil; node = nodes_[node].next_right) {
    ++linked;
  }
  if (linked < only_ids_.busy_from()) {
    return;
  }
  memory.sparse |= AlphaState::kBusy;
  only_ids_.Begin(nodes_.size());
  for (std::uint32_t node = memory.first_node; node != kNil; node = nodes_[node].next_right) {
    FindOnlyId(node);
  }
}

}  // namespace soarbox::kernel
