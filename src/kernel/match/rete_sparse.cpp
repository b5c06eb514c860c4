// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <bit>
#include <new>

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
/// A parked pair's token always exists: it joins with the pair's element, so it was made if its own memory is sparse.
namespace soarbox::kernel {

namespace {

/// Tests whose result cannot change while the elements stay.
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

// Parking -------------------------------------------------------------------------------------------------------------

/// Drops stale pairs from a full log, and lets it grow if that leaves too many.
void ReteState::MakeRoomToPark(SparseState& memory) {
  std::uint32_t kept = 0;
  for (std::uint32_t n = 0; n < memory.logged; ++n) {
    if (!IsStale(memory.log[n])) {
      memory.log[kept++] = memory.log[n];
    }
  }
  memory.saved += memory.logged - kept;
  memory.logged = kept;
  memory.log_limit = std::min(3 * kept + 16, std::max(most_partial_matches, kept));
  if (memory.log_limit == kept) {
    log_at_limit = true;
    throw std::bad_alloc();
  }
  if (memory.log_limit > memory.log.size()) {
    memory.log.resize(memory.log_limit);
  }
}

/// Moves the log into the table.
void ReteState::IndexParked(SparseState& memory) {
  if (memory.bits == 0 || memory.indexed + memory.logged > 1u << memory.bits) {
    GrowParkedTable(memory, memory.logged);
  }
  for (std::uint32_t n = 0; n < memory.logged; ++n) {
    const ParkedPair& pair = memory.log[n];
    if (IsStale(pair)) {
      continue;
    }
    std::uint32_t index = free_parked;
    if (index != kNil) {
      free_parked = parked[index].next;
    } else {
      index = parked.Append();
    }
    ParkedPair& indexed = parked[index];
    indexed = pair;
    std::uint32_t& head = tables[memory.table + Hash(indexed.key, memory.bits)];
    indexed.next = head;
    head = index;
    ++memory.indexed;
  }
  memory.logged = 0;
}

/// Drops stale pairs from the table and makes it large enough for what is left and `more` pairs.
void ReteState::GrowParkedTable(SparseState& memory, std::size_t more) {
  std::uint32_t kept = kNil;
  memory.indexed = 0;
  for (std::uint32_t n = 0; memory.bits != 0 && n < 1u << memory.bits; ++n) {
    for (std::uint32_t index = tables[memory.table + n]; index != kNil;) {
      ParkedPair& pair = parked[index];
      const std::uint32_t next = pair.next;
      std::uint32_t& list = IsStale(pair) ? free_parked : kept;
      memory.indexed += &list == &kept ? 1 : 0;
      pair.next = list;
      list = index;
      index = next;
    }
  }
  if (memory.bits != 0) {
    tables.Free(memory.table, memory.bits);
  }
  memory.bits = static_cast<std::uint8_t>(std::bit_width(2 * (memory.indexed + more) + 15));
  memory.table = tables.Allocate(memory.bits);
  while (kept != kNil) {
    ParkedPair& pair = parked[kept];
    const std::uint32_t next = pair.next;
    std::uint32_t& head = tables[memory.table + Hash(pair.key, memory.bits)];
    pair.next = head;
    head = kept;
    kept = next;
  }
}

/// Makes tokens of the parked pairs that an element joins with and gathers them.
void ReteState::GatherParked(std::uint32_t join, std::uint32_t wme, std::uint32_t key) {
  const Network& net = *network;
  const Node& node = net.node(join);
  const Wme& element = wmes[wme];
  SparseState& memory = SparseOf(node.parent);
  if (memory.logged != 0) {
    IndexParked(memory);
  }
  const std::size_t before = gathered.size();
  std::uint32_t previous = kNil;
  const std::uint32_t bucket = memory.table + Hash(key, memory.bits);
  for (std::uint32_t index = tables[bucket]; index != kNil;) {
    const ParkedPair& pair = parked[index];
    const std::uint32_t next = pair.next;
    const bool stale = pair.key == key && IsStale(pair);
    if (pair.key == key && (stale || (HasKey(*this, node, pair.parent, pair.wme, element) &&
                                      PassesAll(*this, net, node, pair.parent, pair.wme, element)))) {
      (previous != kNil ? parked[previous].next : tables[bucket]) = next;
      if (!stale) {
        gathered.push_back(Unpark(node.parent, pair));
      }
      parked[index].next = free_parked;
      free_parked = index;
      --memory.indexed;
    } else {
      previous = index;
    }
    index = next;
  }
  if (gathered.size() > before) {
    SortByAge(gathered);
    // Tokens that are made late anyway are dear.
    memory.late += static_cast<std::uint32_t>(gathered.size() - before);
    if (memory.late > threshold[memory.tries] >> kTryBits && memory.late > memory.saved / 2) {
      becoming_plain.push_back(memory.node);
      memory.late = 0;
    }
  }
}

/// Makes a token of a pair that is not parked any more.
std::uint32_t ReteState::Unpark(std::uint32_t node, const ParkedPair& pair) {
  SparseState& memory = SparseOf(node);
  const std::uint32_t token = MakeToken(*this, node, pair.parent, pair.wme, pair.serial);
  InsertWithKey(*this, nodes[node], node, token, pair.key, true, memory.tokens);
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

// Order ---------------------------------------------------------------------------------------------------------------

/// Newest first.
void ReteState::SortByAge(std::vector<std::uint32_t>& list) const {
  const Records<const Token> all = tokens.records();
  const auto newer = [all](std::uint32_t a, std::uint32_t b) { return all[a].serial > all[b].serial; };
  if (!std::ranges::is_sorted(list, newer)) {
    std::ranges::sort(list, newer);
  }
}

void ReteState::SortChildren(std::uint32_t parent) {
  sorting.clear();
  for (std::uint32_t token = tokens[parent].first_child; token != kNil; token = tokens[token].next_sibling) {
    sorting.push_back(token);
  }
  SortByAge(sorting);
  std::uint32_t previous = kNil;
  for (const std::uint32_t token : sorting) {
    tokens[token].previous_sibling = previous;
    (previous == kNil ? tokens[parent].first_child : tokens[previous].next_sibling) = token;
    previous = token;
  }
  tokens[previous].next_sibling = kNil;
  tokens[parent].node &= ~Token::kUnsortedBit;
}

void ReteState::SortTokensOf(std::uint32_t wme) {
  sorting.clear();
  for (std::uint32_t token = links[wme].first_token; token != kNil; token = tokens[token].next_of_wme) {
    sorting.push_back(token);
  }
  SortByAge(sorting);
  std::uint32_t previous = kNil;
  for (const std::uint32_t token : sorting) {
    tokens[token].previous_of_wme = previous;
    (previous == kNil ? links[wme].first_token : tokens[previous].next_of_wme) = token;
    previous = token;
  }
  if (previous != kNil) {
    tokens[previous].next_of_wme = kNil;
  }
  links[wme].unsorted = false;
}

// Departure -----------------------------------------------------------------------------------------------------------

/// An element is leaving the alpha memory of a join that feeds a sparse memory: counts its pairs off.
void ReteState::ForgetPairs(std::uint32_t join, std::uint32_t wme) {
  const Network& net = *network;
  const Node& node = net.node(join);
  const Wme& element = wmes[wme];
  const std::uint32_t key = KeyOfElement(node, element);
  std::uint32_t pairs = 0;
  for (std::uint32_t token = BucketHead(*this, node.parent, key); token != kNil;) {
    Token& left = tokens[token];
    if (left.key == key && HasKey(*this, node, left.parent, left.wme, element) &&
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

/// The last pair of a sparse memory is gone.
void ReteState::SparseEmptied(std::uint32_t memory) {
  const std::uint32_t join = network->node(memory).first_child;
  if (marks[join].Is(NodeMarks::kLeftLinked) && marks[join].Is(NodeMarks::kRightLinked)) {
    UnlinkRight(join);
  }
}

// Becoming sparse, and plain again ------------------------------------------------------------------------------------

bool ReteState::CanBeSparse(std::uint32_t index) const {
  const Network& net = *network;
  const Node& node = net.node(index);
  if (node.kind != NodeKind::kMemory || node.key == KeyKind::kNone || node.first_child == kNil) {
    return false;
  }
  const Node& join = net.node(node.first_child);
  const Node& feeding = net.node(node.parent);
  return join.next_sibling == kNil && AreStable(net, join) && feeding.kind == NodeKind::kJoin &&
         IsOnlyChild(net, node) && AreStable(net, feeding) && IsOnlyChild(net, feeding);
}

void ReteState::MakeSparse(std::uint32_t index) {
  std::uint32_t place = static_cast<std::uint32_t>(sparse.size());
  if (free_sparse.empty()) {
    sparse.push_back(std::make_unique<SparseState>());
  } else {
    place = free_sparse.back();
    free_sparse.pop_back();
  }
  NodeState& state = nodes[index];
  sparse[place]->node = index;
  sparse[place]->tokens = state.count;
  sparse[place]->tries = static_cast<std::uint8_t>(state.score & kTryMask);
  state.place = place;
  marks[index].Set(NodeMarks::kSparse);
  if (!only_id.empty()) {
    SecondToken(state.first_linked);
  }
  const std::uint32_t join = network->node(index).parent;
  marks[join].Set(NodeMarks::kFeedsSparse);
  ++alphas[network->node(join).alpha].sparse;
  marks[network->node(join).parent].Set(NodeMarks::kAboveSparse);
  ForEachToken(index, [this](std::uint32_t token) { ++tokens[tokens[token].parent].pairs; });
}

void ReteState::MakeScoredSparse() {
  for (const std::uint32_t node : becoming_sparse) {
    if (node < nodes.size() && network->node(node).kind == NodeKind::kMemory && !marks[node].Is(NodeMarks::kSparse) &&
        nodes[node].score != kNil) {
      MakeSparse(node);
    }
  }
  becoming_sparse.clear();
  for (const std::uint32_t node : becoming_plain) {
    MakePlainForNow(node);
  }
  becoming_plain.clear();
}

/// It may become sparse again, but takes longer to each time: what happens while an agent sets itself up tells little
/// of what it does later.
void ReteState::MakePlainForNow(std::uint32_t index) {
  if (index >= nodes.size() || !marks[index].Is(NodeMarks::kSparse)) {
    return;
  }
  const std::uint32_t tries = std::min(SparseOf(index).tries + 1u, kTryMask);
  MakePlain(index);
  nodes[index].score = tries;
}

/// Makes tokens of all parked pairs, puts all buckets in order and lets the memory be as any other from now on.
void ReteState::MakePlain(std::uint32_t index) {
  if (!marks[index].Is(NodeMarks::kSparse)) {
    if (network->node(index).kind == NodeKind::kMemory) {
      nodes[index].score = kNil;
    }
    return;
  }
  NodeState& state = nodes[index];
  SparseState& memory = SparseOf(index);
  IndexParked(memory);
  for (std::uint32_t n = 0; n < 1u << memory.bits; ++n) {
    for (std::uint32_t at = tables[memory.table + n]; at != kNil;) {
      const std::uint32_t next = parked[at].next;
      if (!IsStale(parked[at])) {
        Unpark(index, parked[at]);
      }
      parked[at].next = free_parked;
      free_parked = at;
      at = next;
    }
  }
  tables.Free(memory.table, memory.bits);
  const std::uint32_t bits = marks[index].bits();
  for (std::uint32_t n = 0; memory.unsorted && n < 1u << bits; ++n) {
    SortBucket(bits == 0 ? state.head : tables[state.head + n]);
  }
  ForEachToken(index, [this](std::uint32_t token) { tokens[tokens[token].parent].pairs = 0; });
  const std::uint32_t join = network->node(index).parent;
  marks[join].Unset(NodeMarks::kFeedsSparse);
  --alphas[network->node(join).alpha].sparse;
  marks[network->node(join).parent].Unset(NodeMarks::kAboveSparse);
  marks[index].Unset(NodeMarks::kSparse);
  memory = SparseState();
  free_sparse.push_back(state.place);
  state.score = kNil;
}

void ReteState::SortBucket(std::uint32_t& head) {
  sorting.clear();
  for (std::uint32_t token = head; token != kNil; token = tokens[token].next_in_bucket) {
    sorting.push_back(token);
  }
  SortByAge(sorting);
  std::uint32_t* link = &head;
  std::uint32_t previous = kNil;
  for (const std::uint32_t token : sorting) {
    *link = token;
    tokens[token].previous_in_bucket = previous;
    link = &tokens[token].next_in_bucket;
    previous = token;
  }
  *link = kNil;
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
  if (kind == NodeKind::kMemory && CanBeSparse(parent)) {
    nodes[parent].score = 0;
  }
}

}  // namespace soarbox::kernel
