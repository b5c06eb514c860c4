// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>

#include "kernel/match/rete_inline.h"

/// Sparse memories. Most pairs that reach a memory never join with anything, because the join below is a filter (has
/// this colour, is the current one). Filters are detected in chains of only children: a memory, its join, the memory
/// below, and its join. The lower memory becomes sparse when many of its pairs do not join. A sparse memory creates a
/// token for a pair only when the pair joins. Until then the pair is parked, and is on no list of its token or its
/// element.
///
/// Sparse memories have no observable effect. A pair gets its serial number when it arrives. Lists to which a late
/// token is added are sorted by serial number before their order matters. The count of a sparse memory includes parked
/// pairs, so that unlinking takes place at the same time: a pair is subtracted when its element leaves the join's alpha
/// memory or its token is removed. Parked pairs themselves are dropped later, when their space is needed.
///
/// A memory is a *hop* if its pairs are found by the value of their element: (s ^many x) above (x ^attribute known). A
/// new token is joined with each x of a bucket, but few x have the attribute. Pairs that are adjacent in the bucket are
/// parked as one *run*, which only stores the first and last element. The pairs are counted, but nothing is written for
/// each. An element that arrives at the join below finds x by the value, and the tokens above by x's identifier. Then
/// it splits the run at the pair. The pair's serial number is that of the run plus the number of the run's elements
/// before it. If some elements have left, it is smaller than originally, but the order is the same. The elements of a
/// run are in the order of the bucket. Therefore a bucket in any other order (of an alpha memory that was filled when a
/// rule was added) has no runs.
///
/// A parked pair's token always exists: it joins with the pair's element, so a token was created even if its own memory
/// is sparse.
namespace soarbox::kernel {

namespace {

constexpr std::size_t kMostRuns = 2048;  ///< Maximum number of runs that are searched one by one.

}  // namespace

// Parked pairs --------------------------------------------------------------------------------------------------------

/// Creates tokens for the pairs in runs that an element joins with, and gathers them. The value of the pair's element
/// is the identifier of the new element, and the pair's token is newer than the pair's element.
void ReteState::GatherFromRuns(std::uint32_t join, std::uint32_t wme, std::uint32_t key) {
  const Network& net = *network;
  const Node& node = net.node(join);
  const Node& memory = net.node(node.parent);
  const Node& feeding = net.node(memory.parent);
  const Wme& element = wmes[wme];
  const NodeMarks above = nodes.marks(feeding.parent);
  const bool sorted = !above.Is(NodeMarks::kSparse) || !SparseOf(feeding.parent).unsorted;
  const std::size_t before = gathered.size();
  bool too_many = false;  // True if searching the table is faster.
  alphas.ForEachWithValue(feeding.alpha, element.id.bits(), [&](const AlphaItem& item) {
    const std::uint64_t arrival = links[item.wme].serial;
    for (std::uint32_t token = nodes.BucketHead(feeding.parent, above.bits(), item.id); token != kNil;
         token = tokens[token].next_in_bucket) {
      if (tokens[token].serial < arrival) {
        if (sorted) {
          return;
        }
        continue;
      }
      if (tokens[token].key != item.id || !HasKey(tokens, wmes, node, token, item.wme, element) ||
          !PassesAll(*this, net, node, token, item.wme, element)) {
        continue;
      }
      too_many = SparseOf(node.parent).runs.size() > kMostRuns;
      if (too_many) {
        return;
      }
      const auto is_pair = [&](std::uint32_t made) {
        return tokens[made].parent == token && tokens[made].wme == item.wme;
      };
      ParkedPair pair{token, item.wme, 0, key, kNil};
      if (std::ranges::none_of(gathered, is_pair) && TakeFromRun(node.parent, pair)) {
        gathered.push_back(Unpark(node.parent, pair));
      }
    }
  });
  if (gathered.size() > before) {
    tokens.SortByAge(gathered);
    sparse.CountLate(SparseOf(node.parent), gathered.size() - before);
  }
  if (too_many) {
    ExpandRuns(node.parent);
  }
}

/// Removes a pair from its run and computes its serial number. The pairs before and after it remain runs.
bool ReteState::TakeFromRun(std::uint32_t index, ParkedPair& pair) {
  SparseState& memory = SparseOf(index);
  const std::uint64_t arrival = links[pair.wme].serial;
  for (std::size_t n = memory.runs.size(); n-- > 0;) {
    ParkedRun& run = memory.runs[n];
    if (run.parent != pair.parent || arrival > run.newest || arrival < run.oldest ||
        SparseMemories::IsStale(tokens, run)) {
      continue;
    }
    ParkedRun rest = run;
    std::uint64_t last = 0;
    run.count = rest.count = 0;
    ForEachOfRun(*this, index, run, [&](std::uint32_t wme) {
      const std::uint64_t came = links[wme].serial;
      if (came > arrival) {
        ++run.count;
        last = came;
      } else if (came < arrival) {
        rest.newest = rest.count == 0 ? came : rest.newest;
        ++rest.count;
      }
      return false;
    });
    pair.serial = run.serial + run.count;
    rest.serial = pair.serial + 1;
    run.oldest = last;
    if (run.count == 0) {
      run = rest;
      rest.count = 0;
    }
    if (run.count == 0) {
      run = memory.runs.back();
      memory.runs.pop_back();
    } else if (rest.count != 0) {
      sparse.Park(tokens, memory, rest);
    }
    return true;
  }
  return false;
}

/// Parks the pairs of all runs one by one.
void ReteState::ExpandRuns(std::uint32_t index) {
  SparseState& memory = SparseOf(index);
  const Node& node = network->node(index);
  for (const ParkedRun& run : memory.runs) {
    if (SparseMemories::IsStale(tokens, run)) {
      continue;
    }
    std::uint64_t serial = run.serial;
    ForEachOfRun(*this, index, run, [&](std::uint32_t wme) {
      if (memory.logged == memory.log_limit) {
        sparse.MakeRoomToPark(tokens, links, memory);
      }
      memory.log[memory.logged++] = {run.parent, wme, serial++, KeyOfPair(*this, node, run.parent, wme).key, kNil};
      return false;
    });
  }
  memory.runs.clear();
}

/// Creates tokens for the parked pairs that an element joins with, and gathers them.
void ReteState::GatherParked(std::uint32_t join, std::uint32_t wme, std::uint32_t key) {
  const Network& net = *network;
  const Node& node = net.node(join);
  const Wme& element = wmes[wme];
  SparseState& memory = SparseOf(node.parent);
  if (memory.logged != 0) {
    sparse.Index(tokens, links, memory);
  }
  const std::size_t before = gathered.size();
  sparse.TakePairs(memory, key, [&](const ParkedPair& pair) {
    if (SparseMemories::IsStale(tokens, links, pair)) {
      return true;
    }
    if (!HasKey(tokens, wmes, node, pair.parent, pair.wme, element) ||
        !PassesAll(*this, net, node, pair.parent, pair.wme, element)) {
      return false;
    }
    gathered.push_back(Unpark(node.parent, pair));
    return true;
  });
  if (gathered.size() > before) {
    tokens.SortByAge(gathered);
    sparse.CountLate(memory, gathered.size() - before);
  }
}

/// Creates a token for a pair that is no longer parked.
std::uint32_t ReteState::Unpark(std::uint32_t node, const ParkedPair& pair) {
  SparseState& memory = SparseOf(node);
  const std::uint32_t token = tokens.Make(links, node, pair.parent, pair.wme, pair.serial);
  nodes.Insert(tokens, nodes[node], node, token, pair.key, true, memory.tokens);
  const Token& made = tokens[token];
  if (made.next_sibling != kNil && tokens[made.next_sibling].serial > pair.serial) {
    tokens[pair.parent].node |= Token::kUnsortedBit;
  }
  if (made.next_of_wme != kNil && tokens[made.next_of_wme].serial > pair.serial) {
    links[pair.wme].unsorted = true;
  }
  if (made.next_in_bucket != kNil && tokens[made.next_in_bucket].serial > pair.serial) {
    memory.unsorted = true;
  }
  return token;
}

// Departure -----------------------------------------------------------------------------------------------------------

/// An element is leaving the alpha memory of a join that feeds a sparse memory: subtracts its pairs.
void ReteState::ForgetPairs(std::uint32_t join, std::uint32_t wme) {
  const Network& net = *network;
  const Node& node = net.node(join);
  const Wme& element = wmes[wme];
  const std::uint32_t key = KeyOfElement(node, element);
  std::uint32_t pairs = 0;
  for (std::uint32_t token = nodes.BucketHead(node.parent, key); token != kNil;) {
    Token& left = tokens[token];
    if (left.key == key && HasKey(tokens, wmes, node, left.parent, left.wme, element) &&
        PassesAll(*this, net, node, left.parent, left.wme, element)) {
      --left.pairs;
      ++pairs;
    }
    token = left.next_in_bucket;
  }
  if (pairs != 0) {
    ForgetPairsOf(node.only_memory, pairs);
  }
}

// Conversion to sparse and plain memories -----------------------------------------------------------------------------

void ReteState::MakeSparse(std::uint32_t index) {
  const std::uint32_t place = sparse.Take();
  NodeState& state = nodes[index];
  sparse[place].node = index;
  sparse[place].tokens = state.count;
  sparse[place].tries = static_cast<std::uint8_t>(state.score & SparseMemories::kTryMask);
  state.place = place;
  nodes.marks(index).Set(NodeMarks::kSparse);
  if (!only_ids.empty()) {
    only_ids.SecondToken(nodes, state.first_linked);
  }
  const std::uint32_t join = network->node(index).parent;
  nodes.marks(join).Set(NodeMarks::kFeedsSparse);
  ++alphas[network->node(join).alpha].sparse;
  feeders.Add(network->node(join).alpha, join);
  nodes.marks(network->node(join).parent).Set(NodeMarks::kAboveSparse);
  nodes.ForEachToken(tokens, index, [this](std::uint32_t token) { ++tokens[tokens[token].parent].pairs; });
}

void ReteState::MakeScoredSparse() {
  for (const std::uint32_t node : sparse.becoming_sparse()) {
    if (node < nodes.size() && network->node(node).kind == NodeKind::kMemory &&
        !nodes.marks(node).Is(NodeMarks::kSparse) && nodes[node].score != kNil) {
      MakeSparse(node);
    }
  }
  sparse.becoming_sparse().clear();
  for (const std::uint32_t node : sparse.becoming_plain()) {
    if (node >= nodes.size() || !nodes.marks(node).Is(NodeMarks::kSparse)) {
      continue;
    }
    // It may become sparse again, but each time it takes longer: the behaviour of an agent during its set-up does not
    // predict its later behaviour.
    const std::uint32_t tries = std::min(SparseOf(node).tries + 1u, SparseMemories::kTryMask);
    MakePlain(node);
    nodes[node].score = tries;
  }
  sparse.becoming_plain().clear();
}

/// Creates tokens for all parked pairs and sorts all buckets. From then on the memory is an ordinary one.
void ReteState::MakePlain(std::uint32_t index) {
  if (!nodes.marks(index).Is(NodeMarks::kSparse)) {
    if (network->node(index).kind == NodeKind::kMemory) {
      nodes[index].score = kNil;
    }
    return;
  }
  NodeState& state = nodes[index];
  SparseState& memory = SparseOf(index);
  ExpandRuns(index);
  sparse.Index(tokens, links, memory);
  sparse.TakeTable(memory, [&](const ParkedPair& pair) {
    if (!SparseMemories::IsStale(tokens, links, pair)) {
      Unpark(index, pair);
    }
  });
  if (memory.unsorted) {
    nodes.SortBuckets(tokens, index);
  }
  nodes.ForEachToken(tokens, index, [this](std::uint32_t token) { tokens[tokens[token].parent].pairs = 0; });
  const std::uint32_t join = network->node(index).parent;
  nodes.marks(join).Unset(NodeMarks::kFeedsSparse);
  --alphas[network->node(join).alpha].sparse;
  feeders.Remove(network->node(join).alpha, join);
  nodes.marks(network->node(join).parent).Unset(NodeMarks::kAboveSparse);
  nodes.marks(index).Unset(NodeMarks::kSparse);
  sparse.GiveBack(state.place);
  state.score = kNil;
}

/// A node has a new child: a chain of single children may end there, and a new chain may begin.
void ReteState::ChildAdded(std::uint32_t child) {
  const std::uint32_t parent = network->node(child).parent;
  const NodeKind kind = network->node(parent).kind;
  if (kind != NodeKind::kJoin && kind != NodeKind::kMemory && kind != NodeKind::kAnchors) {
    return;
  }
  MakePlain(parent);
  // Below a node with several children no memory can be sparse: it became plain when the second child was added.
  std::uint32_t other = kNil;
  for (std::uint32_t n = network->node(parent).first_child; n != kNil; n = network->node(n).next_sibling) {
    if (n == child) {
      continue;
    }
    if (other != kNil) {
      return;
    }
    other = n;
  }
  if (other != kNil) {
    const std::uint32_t memory = kind == NodeKind::kJoin ? other : network->node(other).only_memory;
    if (memory != kNil) {
      MakePlain(memory);
    }
  }
  if (kind == NodeKind::kMemory && SparseMemories::CanBeSparse(*network, parent)) {
    nodes[parent].score = 0;
  }
}

}  // namespace soarbox::kernel
