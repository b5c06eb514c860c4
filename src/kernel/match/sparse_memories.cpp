// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/match/sparse_memories.h"

#include <bit>
#include <new>

namespace soarbox::kernel {

namespace {

/// Whether the result of a test cannot change while the elements exist.
bool IsStable(const NodeTest& test) {
  switch (test.op) {
    case TestOp::kIsGoal:
    case TestOp::kSameLti:
    case TestOp::kNotSameLti:
    case TestOp::kIsLti:
    case TestOp::kIsNotLti:
      return false;
    default:
      return true;
  }
}

bool AreStable(const Network& network, const Node& node) {
  return std::ranges::all_of(network.tests(node), IsStable);
}

bool IsOnlyChild(const Network& network, const Node& node) {
  const Node& first = network.node(network.node(node.parent).first_child);
  return &first == &node && node.next_sibling == kNil;
}

}  // namespace

std::uint32_t SparseMemories::Take() {
  if (free_.empty()) {
    states_.push_back(std::make_unique<SparseState>());
    return static_cast<std::uint32_t>(states_.size() - 1);
  }
  const std::uint32_t place = free_.back();
  free_.pop_back();
  return place;
}

void SparseMemories::GiveBack(std::uint32_t place) {
  *states_[place] = SparseState();
  free_.push_back(place);
}

// Pairs ---------------------------------------------------------------------------------------------------------------

void SparseMemories::MakeRoomToPark(const TokenPool& tokens, const ElementLinks& elements, SparseState& memory) {
  // A pair parked after the last departure is not stale; others are looked up.
  const std::uint64_t last_departure = std::max(tokens.last_forgotten(), elements.last_serial());
  std::uint32_t kept = 0;
  for (std::uint32_t n = 0; n < memory.logged; ++n) {
    const ParkedPair& pair = memory.log[n];
    if (pair.serial < last_departure && IsStale(tokens, elements, pair)) continue;
    if (kept != n) memory.log[kept] = pair;
    ++kept;
  }
  memory.saved += memory.logged - kept;
  memory.logged = kept;
  memory.log_limit = std::min(3 * kept + 16, std::max(most_, kept));
  if (memory.log_limit == kept) {
    log_at_limit_ = true;
    throw std::bad_alloc();
  }
  if (memory.log_limit > memory.log.size()) {
    memory.log.resize(memory.log_limit);
  }
}

void SparseMemories::MakeRoomForRuns(const TokenPool& tokens, SparseState& memory) {
  std::size_t kept = 0;
  for (const ParkedRun& run : memory.runs) {
    if (IsStale(tokens, run)) {
      memory.saved += run.count;
    } else {
      memory.runs[kept++] = run;
    }
  }
  memory.runs.resize(kept);
  memory.run_limit = std::min<std::size_t>(3 * kept + 16, std::max<std::size_t>(most_, kept));
  if (memory.run_limit == kept) {
    log_at_limit_ = true;
    throw std::bad_alloc();
  }
  memory.runs.reserve(memory.run_limit);
}

void SparseMemories::Index(const TokenPool& tokens, const ElementLinks& elements, SparseState& memory) {
  if (memory.bits == 0 || memory.indexed + memory.logged > 1u << memory.bits) {
    GrowTable(tokens, elements, memory, memory.logged);
  }
  for (std::uint32_t n = 0; n < memory.logged; ++n) {
    const ParkedPair& pair = memory.log[n];
    if (IsStale(tokens, elements, pair)) {
      continue;
    }
    std::uint32_t index = free_parked_;
    if (index != kNil) {
      free_parked_ = parked_[index].next;
    } else {
      index = parked_.Append();
    }
    ParkedPair& indexed = parked_[index];
    indexed = pair;
    std::uint32_t& head = tables_[memory.table + TablePool::Hash(indexed.key, memory.bits)];
    indexed.next = head;
    head = index;
    ++memory.indexed;
  }
  memory.logged = 0;
}

/// Drops stale pairs from the table, and makes it large enough for the remaining pairs and `more` others.
void SparseMemories::GrowTable(const TokenPool& tokens, const ElementLinks& elements, SparseState& memory,
                               std::size_t more) {
  std::uint32_t kept = kNil;
  memory.indexed = 0;
  for (std::uint32_t n = 0; memory.bits != 0 && n < 1u << memory.bits; ++n) {
    for (std::uint32_t index = tables_[memory.table + n]; index != kNil;) {
      ParkedPair& pair = parked_[index];
      const std::uint32_t next = pair.next;
      std::uint32_t& list = IsStale(tokens, elements, pair) ? free_parked_ : kept;
      memory.indexed += &list == &kept ? 1 : 0;
      pair.next = list;
      list = index;
      index = next;
    }
  }
  if (memory.bits != 0) {
    tables_.Free(memory.table, memory.bits);
  }
  memory.bits = static_cast<std::uint8_t>(std::bit_width(2 * (memory.indexed + more) + 15));
  memory.table = tables_.Allocate(memory.bits);
  while (kept != kNil) {
    ParkedPair& pair = parked_[kept];
    const std::uint32_t next = pair.next;
    std::uint32_t& head = tables_[memory.table + TablePool::Hash(pair.key, memory.bits)];
    pair.next = head;
    head = kept;
    kept = next;
  }
}

void SparseMemories::CountLate(SparseState& memory, std::size_t count) {
  memory.late += static_cast<std::uint32_t>(count);
  if (memory.late > threshold_[memory.tries] >> kTryBits && memory.late > memory.saved / 2) {
    becoming_plain_.push_back(memory.node);
    memory.late = 0;
  }
}

// All memories --------------------------------------------------------------------------------------------------------

void SparseMemories::SetLimit(std::uint32_t most) {
  parked_.SetLimit(most);
  most_ = most;
}

void SparseMemories::Release() {
  states_.clear();
  parked_.Release();
  free_parked_ = kNil;
  tables_ = TablePool();
}

std::size_t SparseMemories::MemoryBytes() const {
  std::size_t bytes =
      states_.size() * (sizeof(SparseState) + sizeof(states_[0])) + parked_.MemoryBytes() + tables_.MemoryBytes();
  for (const auto& state : states_) {
    bytes += state->log.capacity() * sizeof(ParkedPair) + state->runs.capacity() * sizeof(ParkedRun);
  }
  return bytes;
}

bool SparseMemories::CanBeSparse(const Network& net, std::uint32_t index) {
  const Node& node = net.node(index);
  if (node.kind != NodeKind::kMemory || node.key == KeyKind::kNone || node.first_child == kNil) {
    return false;
  }
  const Node& join = net.node(node.first_child);
  const Node& feeding = net.node(node.parent);
  return join.next_sibling == kNil && AreStable(net, join) && feeding.kind == NodeKind::kJoin &&
         IsOnlyChild(net, node) && AreStable(net, feeding) && IsOnlyChild(net, feeding);
}

}  // namespace soarbox::kernel
