// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/match/alpha_memories.h"
#include "kernel/match/network.h"
#include "kernel/match/node_states.h"
#include "kernel/match/pair_tests.h"
#include "kernel/match/token_pool.h"
#include "kernel/match/wme.h"

namespace soarbox::kernel {

/// A token and an element that a node has passed to its children; kNil where there is none.
using Emission = std::pair<std::uint32_t, std::uint32_t>;

/// Determines the pairs that the nodes of an agent have emitted and not withdrawn. Has no state of its own.
class [[gnu::visibility("hidden")]] EmissionReader {
 public:
  EmissionReader(const Network& network, const AlphaMemories& alphas, const NodeStates& nodes, const TokenPool& tokens,
                 const WmeTable& wmes, const PairTests& tests)
      : network_(network), alphas_(alphas), nodes_(nodes), tokens_(tokens), wmes_(wmes), tests_(tests) {}

  /// Newest first.
  std::vector<Emission> Of(std::uint32_t node) const;
  void AddTo(std::uint32_t node, std::vector<Emission> & out) const;
  /// The tokens of a node, newest first.
  std::vector<std::uint32_t> TokensByAge(std::uint32_t node) const;
  /// The owners of a shared conjunction for which (parent, wme), emitted by a join of it, is a partial match.
  std::vector<std::uint32_t> OwnersOf(std::uint32_t conjunctive, std::uint32_t join, std::uint32_t parent,
                                      std::uint32_t wme) const;

 private:
  const Network& network_;
  const AlphaMemories& alphas_;
  const NodeStates& nodes_;
  const TokenPool& tokens_;
  const WmeTable& wmes_;
  const PairTests& tests_;
};

}  // namespace soarbox::kernel
