// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>

#include "kernel/match/rete_inline.h"

/// Sparse memories: most pairs that reach a memory never join with anything, because the join below is a filter (has
/// this colour, is the current one). Where a memory, its only join, that join's only memory and the only join of that
/// follow each other, the lower memory becomes sparse when many of its pairs do not join: it makes a token of a pair
/// only when the pair joins. Until then the pair is parked, on no list of its token or its element.
///
/// Nothing that can be observed depends on it. A pair's serial number is taken when it arrives; lists that a late token
/// comes into are sorted by it before their order matters. The count of a sparse memory includes parked pairs, so that
/// unlinking happens when it would: pairs are counted off when their element leaves the join's alpha memory or their
/// token goes. Parked pairs themselves are dropped later, when they are in the way.
///
/// A memory is a *hop* if its pairs are found by the value of their element: (s ^many x) above (x ^attribute known). A
/// token that comes meets each x of a bucket, and hardly any has the attribute. Those that follow each other in the
/// bucket are parked as one *run*, which only says between which elements they are; their number is counted, but
/// nothing is written for each. An element that comes to the join below finds x by the value, the tokens above by x's
/// identifier, and takes its pair out of the run, which becomes two. Its serial number is that of the run and how many
/// of the run's elements stand in front of it: less than when the run was parked, if some have left, but of the same
/// order. A run's elements come in the order in which the bucket has them, so that a bucket in any other order (of an
/// alpha memory that was filled when a rule was added) has none.
///
/// A parked pair's token always exists: it joins with the pair's element, so it was made if its own memory is sparse.
namespace soarbox::kernel {

namespace {

constexpr std::size_t kMostRuns = 2048;  ///< That are searched one by one.

}  // namespace

// Parked pairs --------------------------------------------------------------------------------------------------------

/// Makes tokens of those pairs in runs that an element joins with, and gathers them: pairs of an element that has the
/// new one's identifier as its value, and of a younger token.
void ReteState::GatherFromRuns(std::uint32_t join, std::uint32_t wme, std::uint32_t key) {
  const Network& net = *network;
  const Node& node = net.node(join);
  const Node& memory = net.node(node.parent);
  const Node& feeding = net.node(memory.parent);
  const Wme& element = wmes[wme];
  const NodeMarks above = nodes.marks(feeding.parent);
  const bool sorted = !above.Is(NodeMarks::kSparse) || !SparseOf(feeding.parent).unsorted;
  const std::size_t before = gathered.size();
  bool too_many = false;  // The table finds them faster.
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

/// Takes a pair out of the run that it is in and finds its serial number. Those before it and those behind it stay
/// runs.
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

/// Makes tokens of the parked pairs that an element joins with and gathers them.
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

/// Makes a token of a pair that is not parked any more.
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

/// An element is leaving the alpha memory of a join that feeds a sparse memory: counts its pairs off.
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

// Becoming sparse, and plain again ------------------------------------------------------------------------------------

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
    signatures.AddAll(index);
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
    // It may become sparse again, but takes longer to each time: what happens while an agent sets itself up tells
    // little of what it does later.
    const std::uint32_t tries = std::min(SparseOf(node).tries + 1u, SparseMemories::kTryMask);
    MakePlain(node);
    nodes[node].score = tries;
  }
  sparse.becoming_plain().clear();
}

/// Makes tokens of all parked pairs, puts all buckets in order and lets the memory be as any other from now on.
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

/// A node has got a child: what was a row of single children may not be one any more, and a new row may begin.
void ReteState::ChildAdded(std::uint32_t child) {
  const std::uint32_t parent = network->node(child).parent;
  const NodeKind kind = network->node(parent).kind;
  if (kind != NodeKind::kJoin && kind != NodeKind::kMemory && kind != NodeKind::kAnchors) {
    return;
  }
  MakePlain(parent);
  // Below a node of several children no memory can be sparse: what it had became plain when the second child came.
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
