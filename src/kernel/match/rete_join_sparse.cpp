// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/match/sparse_pairs.h"

/// How the pairs of a new token reach a sparse memory (rete_sparse.cpp): one pair, the pairs of a join, or runs of
/// pairs.
namespace soarbox::kernel {

namespace {

/// ReteState::JoinSparsely as a separate function: most pairs that arrive alone do not join.
[[gnu::noinline]] void JoinSparselyOf(ReteState& state, std::uint32_t index, std::uint32_t parent, std::uint32_t wme,
                                      std::uint64_t serial, const KeyParts& key, std::uint32_t item) {
  state.JoinSparsely(index, parent, wme, serial, key, item);
}

}  // namespace

/// A pair in a sparse memory joins: creates a token for it.
void ReteState::JoinSparsely(std::uint32_t index, std::uint32_t parent, std::uint32_t wme, std::uint64_t serial,
                             KeyParts key, std::uint32_t item) {
  const std::uint32_t token = tokens.Make(links, index, parent, wme, serial);
  nodes.Insert(tokens, nodes[index], index, token, key.key, true, SparseOf(index).tokens);
  const std::uint32_t join = network->node(index).first_child;
  JoinFrom(join, network->node(join), token, key, item);
}

/// Passes a token and the elements of a bucket, from `item` on, to a sparse memory that is a hop. Pairs that do not
/// join are parked in runs.
template <KeyKind kind>
[[gnu::always_inline]] inline void ReteState::JoinRuns(const RightSide& right, std::uint32_t index, std::uint32_t token,
                                                       std::uint32_t id, std::uint32_t item) {
  const Node& node = network->node(index);
  const Node& joined = network->node(node.first_child);
  constexpr bool kWithValue = kind == KeyKind::kIdValue;
  NodeState& memory = nodes[index];
  SparseState& parked = sparse[memory.place];
  KeyParts key;
  if (kWithValue) {
    key.value = BitsOf(wmes.data()[ElementAt(tokens.read(), token, node.key_value_levels - 1u)], node.key_value_field);
  }
  ParkedRun run{token, 0, tokens.next_serial(), 0, 0};
  while (item != kNil) {
    const Records<const AlphaItem> all = alphas.items();
    const std::uint32_t first = item;
    std::uint32_t last = item;
    std::uint32_t found = kNil;
    for (; item != kNil; item = all[item].next_in_bucket) {
      const AlphaItem& at = all[item];
      if (at.id != id) {
        continue;
      }
      key.id = at.value;
      key.key = kWithValue ? PairKey(key.id, key.value) : key.id;
      found = right.FirstOf<kind>(key);
      if (found != kNil && joined.test_count != 0) {
        found = FirstPassingOf(*this, right, joined, key, token, at.wme, found);
      }
      if (found != kNil) [[unlikely]] {
        break;
      }
      ++run.count;
      last = item;
    }
    const std::uint64_t serial = run.serial + run.count;
    const std::uint32_t arrived = run.count + (found != kNil ? 1 : 0);
    tokens.set_next_serial(run.serial + arrived);
    memory.count += arrived;
    tokens[token].pairs += arrived;
    if (run.count != 0) {
      run.newest = links[all[first].wme].serial;
      run.oldest = links[all[last].wme].serial;
      sparse.Park(tokens, parked, run);
    }
    if (found == kNil) {
      return;
    }
    const std::uint32_t wme = all[item].wme;
    item = all[item].next_in_bucket;
    JoinSparsely(index, token, wme, serial, key, found);
    while (item != kNil && alphas.item(item).id != id) {
      item = alphas.item(item).next_in_bucket;
    }
    run.serial = tokens.next_serial();
    run.count = 0;
  }
}

void ReteState::JoinHop(std::uint32_t index, std::uint32_t token, std::uint32_t id, std::uint32_t item) {
  const std::uint32_t join = network->node(index).first_child;
  joins().LinkOnlyJoin(index, join);
  const RightSide right(alphas, network->node(join));
  switch (right.kind()) {
    case KeyKind::kId:
      JoinRuns<KeyKind::kId>(right, index, token, id, item);
      break;
    case KeyKind::kIdValue:
      JoinRuns<KeyKind::kIdValue>(right, index, token, id, item);
      break;
    case KeyKind::kNone:
      break;  // The memory has a key.
  }
}

/// Passes the elements that a new token joins with, from `item` on, to the sparse memory below the join.
void ReteState::JoinSparse(const Node& node, const RightSide& right, std::uint32_t token, const KeyParts& key,
                           std::uint32_t item) {
  const std::uint32_t parent = tokens[token].parent;
  const std::uint32_t wme = tokens[token].wme;
  const std::uint32_t element = right.Element(item);
  std::uint32_t next = right.Next(item, key);
  if (node.test_count != 0) {
    next = FirstPassing(*this, right, node, key, parent, wme, next);
  }
  if (next == kNil) {
    LeftSparse(node.only_memory, token, element);
  } else if (right.kind() != KeyKind::kId) {
    LeftSparse(node.only_memory, token, element);
    do {
      LeftSparse(node.only_memory, token, right.Element(next));
      next = FirstPassing(*this, right, node, key, parent, wme, right.Next(next, key));
    } while (next != kNil);
  } else if (node.test_count == 0 && network->node(node.only_memory).IsHop() &&
             (alphas[node.alpha].sparse & AlphaState::kPrimed) == 0) {
    JoinHop(node.only_memory, token, key.id, item);
  } else if (node.test_count == 0) {
    AddPairs<Differ::kElements>(*this, node.only_memory, TokenAndBucket{*this, token, item, key.id});
  } else {
    AddPairs<Differ::kElements>(*this, node.only_memory,
                                TokenAndPassing{*this, right, node, key, token, item, parent, wme});
  }
}

/// Passes one pair to a sparse memory.
void ReteState::LeftSparse(std::uint32_t index, std::uint32_t parent, std::uint32_t wme) {
  const Node& node = network->node(index);
  const std::uint32_t join = node.first_child;
  NodeState& state = nodes[index];
  if (state.count == 0) {
    joins().LinkOnlyJoin(index, join);
  }
  const Node& joined = network->node(join);
  const KeyParts key = KeyOfPair(*this, node, parent, wme);
  const std::uint64_t serial = tokens.TakeSerial();
  ++state.count;
  ++tokens[parent].pairs;
  std::uint32_t item = FirstOffered(*this, joined, key);
  if (item != kNil && joined.test_count != 0) {
    item = FirstPassing(*this, RightSide(alphas, joined), joined, key, parent, wme, item);
  }
  if (item != kNil) {
    JoinSparselyOf(*this, index, parent, wme, serial, key, item);
    return;
  }
  SparseState& memory = SparseOf(index);
  if (memory.logged == memory.log_limit) [[unlikely]] {
    sparse.MakeRoomToPark(tokens, links, memory);
  }
  ParkedPair& pair = memory.log.data()[memory.logged++];
  pair.parent = parent;
  pair.wme = wme;
  pair.serial = serial;
  pair.key = key.key;
}

}  // namespace soarbox::kernel
