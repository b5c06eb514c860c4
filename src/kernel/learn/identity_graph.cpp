// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/learn/identity_graph.h"

#include <algorithm>
#include <utility>

namespace soarbox::kernel {

void IdentityGraph::Clear() {
  records_.clear();
  std::ranges::fill(slots_, kNone);
  joins_ = 0;
}

std::uint32_t IdentityGraph::Slot(const Key& key) const {
  const std::uint32_t mask = static_cast<std::uint32_t>(slots_.size()) - 1;
  std::uint32_t hash = key.firing * 0x9E3779B1u ^ key.place * 0x85EBCA6Bu;
  hash ^= hash >> 15;
  std::uint32_t slot = hash & mask;
  while (slots_[slot] != kNone && records_[slots_[slot]].key != key) slot = (slot + 1) & mask;
  return slot;
}

IdentityGraph::Node IdentityGraph::Of(Key key) {
  if (2 * (records_.size() + 1) > slots_.size()) {
    slots_.assign(std::max<std::size_t>(64, 2 * slots_.size()), kNone);
    for (Node node = 0; node < records_.size(); ++node) slots_[Slot(records_[node].key)] = node;
  }
  Node& slot = slots_[Slot(key)];
  if (slot == kNone) {
    slot = static_cast<Node>(records_.size());
    Record& record = records_.emplace_back();
    record.key = key;
    record.parent = slot;
  }
  return slot;
}

IdentityGraph::Node IdentityGraph::Root(Node node) const {
  while (records_[node].parent != node) {
    records_[node].parent = records_[records_[node].parent].parent;
    node = records_[node].parent;
  }
  return node;
}

void IdentityGraph::Join(Node a, Node b) {
  a = Root(a);
  b = Root(b);
  if (a == b) return;
  ++joins_;
  if (records_[b].size >= records_[a].size) std::swap(a, b);
  records_[b].parent = a;
  records_[a].size += records_[b].size;
  records_[a].literal = records_[a].literal || records_[b].literal;
}

}  // namespace soarbox::kernel
