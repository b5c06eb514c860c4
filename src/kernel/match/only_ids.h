// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "kernel/match/node_states.h"

namespace soarbox::kernel {

/// For right-linked nodes of busy alpha memories whose memory has one token: the identifier that an element must have
/// to join; 0: unknown. Empty while no alpha memory is busy.
class OnlyIds {
 public:
  /// See Rete::BusyFrom.
  std::uint32_t busy_from() const { return busy_from_; }
  void set_busy_from(std::uint32_t nodes) { busy_from_ = nodes; }

  bool empty() const { return ids_.empty(); }
  std::uint32_t& operator[](std::uint32_t node) { return ids_[node]; }
  std::uint32_t operator[](std::uint32_t node) const { return ids_[node]; }
  const std::uint32_t* data() const { return ids_.data(); }
  /// A memory gets its second token: elements with more than one identifier can now join.
  [[gnu::noinline]] void SecondToken(const NodeStates& nodes, std::uint32_t first_join) {
    for (std::uint32_t join = first_join; join != kNil; join = nodes[join].next_left) {
      ids_[join] = 0;
    }
  }
  /// Creates the table for `nodes` nodes.
  void Begin(std::size_t nodes) { ids_.resize(nodes); }
  /// The number of nodes is now `nodes`.
  void MakeRoom(std::size_t nodes) {
    if (!ids_.empty() && ids_.size() < nodes) {
      ids_.resize(std::max(nodes, ids_.size() * 2));
    }
  }

 private:
  std::vector<std::uint32_t> ids_;
  std::uint32_t busy_from_ = 32;
};

}  // namespace soarbox::kernel
