// SPDX-License-Identifier: BSD-2-Clause
// Adds and removes nodes, and their state in the agent.
#include <utility>
#include <vector>

#include "kernel/match/rete_inline.h"

namespace soarbox::kernel {

void ReteState::NodeAdded(std::uint32_t index) {
  nodes.MakeRoom(index + 1u);  // A reused index needs no initialization: RemoveNode has reset its state.
  only_ids.MakeRoom(nodes.size());
  ChildAdded(index);
  const Node& node = network->node(index);
  if (node.kind == NodeKind::kNegative) {
    nodes.marks(index).Set(NodeMarks::kNegative);
  } else if (node.kind != NodeKind::kMemory && node.kind != NodeKind::kAnchors && node.kind != NodeKind::kPaths) {
    nodes.marks(index).Set(NodeMarks::kOther);
  }
  if (node.kind == NodeKind::kAnchors || nodes.marks(node.parent).Is(NodeMarks::kInPath)) {
    nodes.marks(index).Set(NodeMarks::kInPath);
  }
  if (node.kind == NodeKind::kJoin) {
    if (nodes.marks(index).Is(NodeMarks::kInPath)) {
      alphas[node.alpha].sparse |= AlphaState::kInPaths;
    }
    const bool has_tokens = nodes[node.parent].count != 0;
    if (!has_tokens || alphas[node.alpha].count != 0) {
      joins().LinkLeft(index);
    }
    if (has_tokens) {
      joins().LinkRight(index);
      joins().NoteNodes(node.alpha);
    }
  }
}

/// Passes to a new node everything that its parent has emitted so far, newest first.
void ReteState::Prime(std::uint32_t child) {
  const std::uint32_t parent = network->node(child).parent;
  if (network->node(parent).kind == NodeKind::kMemory || network->node(parent).kind == NodeKind::kAnchors) {
    return;  // The child is a join: it emits pairs when its own children are primed.
  }
  std::vector<Emission> all = std::exchange(primed, {});
  all.clear();
  emissions().AddTo(parent, all);
  for (const Emission& emission : all) {
    Left(child, emission.first, emission.second);
  }
  primed = std::move(all);
}

void ReteState::RemoveTokens(std::uint32_t node) {
  std::vector<std::uint32_t> all;
  nodes.ForEachToken(tokens, node, [&](std::uint32_t token) { all.push_back(token); });
  for (const std::uint32_t token : all) {
    RemoveSubtree(token);
  }
}

void ReteState::RemoveNode(std::uint32_t index) {
  if (network->node(index).kind == NodeKind::kJoin) {
    MakePlain(network->node(index).parent);
  }
  const NodeMarks has = nodes.marks(index);
  if (has.Is(NodeMarks::kLeftLinked)) {
    joins().UnlinkLeft(index);
  }
  if (has.Is(NodeMarks::kRightLinked)) {
    joins().UnlinkRight(index);
  }
  const std::uint32_t alpha = network->node(index).alpha;
  network->RemoveNode(index);
  if (alpha != kNil) {
    alphas.GiveUp(*network, links, alpha);
  }
  nodes.Reset(index);
}

}  // namespace soarbox::kernel
