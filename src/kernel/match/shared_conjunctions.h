// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "kernel/match/element_links.h"
#include "kernel/match/meeting_order.h"
#include "kernel/match/network.h"
#include "kernel/match/node_states.h"
#include "kernel/match/pair_tests.h"
#include "kernel/match/token_pool.h"
#include "kernel/match/wme.h"

namespace soarbox::kernel {

/// An agent's data on shared conjunctions (rete_shared.cpp).
struct [[gnu::visibility("hidden")]] SharedConjunctions {
  bool allowed = true;                           ///< See Rete::ShareConjunctions.
  bool exist = false;                            ///< There are or were some.
  bool path_element = false;                     ///< The element that is leaving may be part of a path.
  std::uint32_t last_owner = kNil;               ///< The owner created last.
  std::vector<std::uint32_t> new_paths;          ///< Paths whose owners are not blocked yet.
  std::vector<OwnerAndPath> pairings, openings;  ///< Scratch.

  /// Whether a path that has an owner's key blocks the owner.
  static bool Pairs(const Network& net, const TokenPool& tokens, const WmeTable& wmes, const PairTests& tests,
                    std::uint32_t owner, std::uint32_t path);
  /// Whether a token belongs to a shared conjunction's own conditions.
  static bool IsInPath(const NodeStates& nodes, const Token& token);
  /// Whether an owner is blocked by a path without the element.
  static bool StaysBlocked(const TokenPool& tokens, std::uint32_t owner, std::uint32_t wme);
  /// Finds the owners that nothing will block after the paths with an element are removed. Stores them in `openings`,
  /// in reverse order of opening. Moves the element's tokens in paths after its other tokens.
  void FindOpenings(const Network& network, const NodeStates& nodes, TokenPool& tokens, ElementLinks& links,
                    std::uint32_t wme);
};

}  // namespace soarbox::kernel
