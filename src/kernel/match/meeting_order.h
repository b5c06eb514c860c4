// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

#include "kernel/match/element_links.h"
#include "kernel/match/token_pool.h"

namespace soarbox::kernel {

/// A token that a path blocks, and a token higher up on that path.
struct OwnerAndPath {
  std::uint32_t owner = kNil;
  std::uint32_t prefix = kNil;
  std::uint32_t path = kNil;
  std::uint32_t place = 0;    ///< Decides ties.
  std::uint32_t node = kNil;  ///< Of the owner.
  std::uint64_t serial = 0;   ///< Of the owner.
  std::uint64_t due = 0;      ///< For openings: tokens younger than this come first.
};

/// The order in which the owners of shared conjunctions meet the paths that block them (rete_shared.cpp).
class [[gnu::visibility("hidden")]] MeetingOrder {
 public:
  MeetingOrder(const TokenPool& tokens, const ElementLinks& elements) : tokens_(tokens), elements_(elements) {}

  /// The meeting of an owner and a token on a path.
  OwnerAndPath Meeting(std::uint32_t owner, std::uint32_t prefix) const;
  /// Whether the partial match of a's owner and prefix would have been created after that of b's.
  bool CameLater(const OwnerAndPath& a, const OwnerAndPath& b) const;

 private:
  bool CameWithElement(const Token& token) const;

  const TokenPool& tokens_;
  const ElementLinks& elements_;
};

}  // namespace soarbox::kernel
