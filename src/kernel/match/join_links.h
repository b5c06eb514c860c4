// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

#include "kernel/match/alpha_memories.h"
#include "kernel/match/network.h"
#include "kernel/match/node_states.h"
#include "kernel/match/only_ids.h"
#include "kernel/match/token_pool.h"
#include "kernel/match/wme.h"

namespace soarbox::kernel {

/// Links joins and negative nodes to their memories and alpha memories, and unlinks them (unlinking is described at
/// NodeState). Has no state of its own.
class [[gnu::visibility("hidden")]] JoinLinks {
 public:
  [[gnu::always_inline]] JoinLinks(const Network& network, AlphaMemories& alphas, NodeStates& nodes, OnlyIds& only_ids,
                                   const TokenPool& tokens, const WmeTable& wmes)
      : network_(network), alphas_(alphas), nodes_(nodes), only_ids_(only_ids), tokens_(tokens), wmes_(wmes) {}

  [[gnu::always_inline]] void LinkLeft(std::uint32_t join) {
    nodes_.LinkLeft(join, network_.node(join).parent);
  }
  [[gnu::always_inline]] void UnlinkLeft(std::uint32_t join) {
    nodes_.UnlinkLeft(join, network_.node(join).parent);
  }
  [[gnu::always_inline]] void LinkRight(std::uint32_t node) {
    AlphaState& alpha = alphas_[network_.node(node).alpha];
    nodes_.LinkRight(network_, alpha, node);
    if ((alpha.sparse & AlphaState::kBusy) != 0) [[unlikely]] {
      FindOnlyId(node);
    }
  }
  [[gnu::always_inline]] void UnlinkRight(std::uint32_t node) {
    nodes_.UnlinkRight(alphas_[network_.node(node).alpha], node);
  }

  /// Links a join to its alpha memory because its own memory has tokens. Returns false if the alpha memory is empty;
  /// the join then leaves its memory's list.
  [[gnu::always_inline]] bool LinkJoin(std::uint32_t join) {
    LinkRight(join);
    if (alphas_[network_.node(join).alpha].count == 0) {
      UnlinkLeft(join);
      return false;
    }
    return true;
  }
  /// A pair is about to enter a sparse memory. If it is the first one, its join must be linked to the alpha memory.
  [[gnu::always_inline]] void LinkOnlyJoin(std::uint32_t memory, std::uint32_t join) {
    if (nodes_[memory].count == 0 && nodes_.marks(join).Is(NodeMarks::kLeftLinked) &&
        !nodes_.marks(join).Is(NodeMarks::kRightLinked)) {
      LinkJoin(join);
    }
  }
  /// The last token of a memory or a negative node is leaving: elements need not be joined with the node any more.
  [[gnu::always_inline]] void MemoryEmptied(std::uint32_t node) {
    if (nodes_.marks(node).Is(NodeMarks::kNegative)) {
      if (nodes_.marks(node).Is(NodeMarks::kRightLinked)) {
        UnlinkRight(node);
      }
      return;
    }
    for (std::uint32_t join = nodes_[node].first_linked; join != kNil; join = nodes_[join].next_left) {
      if (nodes_.marks(join).Is(NodeMarks::kRightLinked)) {
        UnlinkRight(join);
      }
    }
  }
  /// The last pair of a sparse memory has left.
  [[gnu::noinline]] void SparseEmptied(std::uint32_t memory);

  /// For a node that is right-linked to a busy alpha memory: see OnlyIds.
  [[gnu::always_inline]] void FindOnlyId(std::uint32_t node) {
    FindOnlyId(network_, nodes_, only_ids_, tokens_, wmes_, node);
  }
  /// One more node uses an alpha memory. The memory becomes busy when many of its nodes are linked. They are counted
  /// only at every busy_from()-th use.
  void NoteNodes(std::uint32_t alpha);

 private:
  // Static, so that objects created on the stack stay in registers.
  [[gnu::noinline]] static void FindOnlyId(const Network& network, const NodeStates& nodes, OnlyIds& only_ids,
                                           const TokenPool& tokens, const WmeTable& wmes, std::uint32_t index);

  const Network& network_;
  AlphaMemories& alphas_;
  NodeStates& nodes_;
  OnlyIds& only_ids_;
  const TokenPool& tokens_;
  const WmeTable& wmes_;
};

}  // namespace soarbox::kernel
