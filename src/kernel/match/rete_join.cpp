// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>

#include "kernel/match/sparse_pairs.h"

/// Joins and their memories. Most of the work of a match is done here.
namespace soarbox::kernel {

namespace {

/// JoinLinks::FindOnlyId as a separate function.
[[gnu::noinline]] void FindOnlyId(ReteState& state, std::uint32_t node) {
  state.joins().FindOnlyId(node);
}

/// The part of ReteState::JoinFrom for joins with tests or several children, and for tokens that join with more than
/// one element.
[[gnu::noinline]] void JoinMany(ReteState& state, std::uint32_t join, const Node& node, std::uint32_t token,
                                const KeyParts& key, std::uint32_t item) {
  const RightSide right = RightSide::OfFound(state.alphas, node);
  const std::uint32_t parent = state.tokens[token].parent;
  const std::uint32_t wme = state.tokens[token].wme;
  if (node.test_count != 0) {
    item = FirstPassing(state, right, node, key, parent, wme, item);
    if (item == kNil) {
      return;
    }
  }
  if (state.nodes.marks(join).Is(NodeMarks::kFeedsSparse)) {
    state.JoinSparse(node, right, token, key, item);
    return;
  }
  const std::uint32_t memory = node.only_memory;
  if (memory != kNil && node.test_count == 0 && right.kind() == KeyKind::kId) {
    state.JoinBucket(memory, token, key.id, item);
    return;
  }
  do {
    const std::uint32_t element = right.Element(item);
    if (memory != kNil) {
      state.LeftPlain(memory, token, element);
    } else {
      state.Emit(join, token, element);
    }
    item = FirstPassing(state, right, node, key, parent, wme, right.Next(item, key));
  } while (item != kNil);
}

}  // namespace

// Left side -----------------------------------------------------------------------------------------------------------

/// Emits the pairs of a token and the elements that it joins with, from `item` on; `item` has the token's key. Most
/// tokens join with one element, for which a small function is faster.
void ReteState::JoinFrom(std::uint32_t join, const Node& node, std::uint32_t token, KeyParts key, std::uint32_t item) {
  const std::uint32_t memory = node.only_memory;
  if (memory != kNil && node.test_count == 0) {
    const RightSide right = RightSide::OfFound(alphas, node);
    if (right.Next(item, key) == kNil) {
      if (nodes.marks(join).Is(NodeMarks::kFeedsSparse)) {
        LeftSparse(memory, token, right.Element(item));
      } else {
        LeftPlain(memory, token, right.Element(item));
      }
      return;
    }
  }
  JoinMany(*this, join, node, token, key, item);
}

/// Passes a token and the elements of a bucket with an identifier, from `item` on, to a memory that is not sparse. If
/// the memory has tokens and only one linked join, everything that is the same for all pairs is computed once.
void ReteState::JoinBucket(std::uint32_t index, std::uint32_t parent, std::uint32_t id, std::uint32_t item) {
  TokenAndBucket pairs{*this, parent, item, id};
  const std::uint32_t join = nodes[index].first_linked;
  if (alphas.item(item).next_in_bucket == kNil || join == kNil || nodes[index].count == 0 ||
      nodes[join].next_left != kNil) {
    std::uint32_t left = kNil;
    std::uint32_t wme = kNil;
    while (pairs.Next(left, wme)) {
      LeftPlain(index, parent, wme);
    }
    return;
  }
  if (!only_ids.empty()) [[unlikely]] {
    only_ids[join] = 0;
  }
  const Node& joined = network->node(join);
  const RightSide right(alphas, joined);
  BucketTokens made(*this, index, pairs);
  if (joined.test_count == 0 && nodes.marks(join).Is(NodeMarks::kFeedsSparse) &&
      !network->node(joined.only_memory).IsHop()) {
    BucketTokensAndElements joining{made, right};
    if (joining.Begin()) {
      AddPairs<Differ::kSiblings>(*this, joined.only_memory, joining);
    }
    return;
  }
  while (made.Next()) {
    const std::uint32_t found = right.First(made.key());
    if (found != kNil) {
      JoinFrom(join, joined, made.token(), made.key(), found);
    }
  }
}

void ReteState::LeftMemory(std::uint32_t index, std::uint32_t parent, std::uint32_t wme) {
  if (nodes.marks(index).Is(NodeMarks::kSparse)) {
    LeftSparse(index, parent, wme);
  } else {
    LeftPlain(index, parent, wme);
  }
}

/// Passes a token of a memory to a join below it.
[[gnu::always_inline]] inline void ReteState::JoinOne(std::uint32_t join, std::uint32_t token, const KeyParts& key) {
  const Node& joined = network->node(join);
  const std::uint32_t item = FirstOffered(*this, joined, key);
  if (item != kNil) {
    JoinFrom(join, joined, token, key, item);
  }
}

/// Passes the token to the joins in the memory's list, from `next` on.
void ReteState::JoinRest(std::uint32_t next, std::uint32_t token, KeyParts key) {
  while (next != kNil) {
    const std::uint32_t join = next;
    next = nodes[join].next_left;
    if (nodes.marks(join).Is(NodeMarks::kRightLinked) || joins().LinkJoin(join)) {
      JoinOne(join, token, key);
    }
  }
}

/// Passes a new token of a memory to the joins below it. Most memories have one join, for which a loop would be
/// expensive. While a memory has other tokens, its joins are linked to their alpha memories.
[[gnu::always_inline]] inline void ReteState::JoinAll(const NodeState& memory, std::uint32_t token,
                                                      const KeyParts& key) {
  const std::uint32_t join = memory.first_linked;
  if (join == kNil) {
    return;
  }
  const std::uint32_t next = nodes[join].next_left;
  if (memory.count != 1) {
    if (memory.count == 2 && !only_ids.empty()) [[unlikely]] {
      only_ids.SecondToken(nodes, join);
    }
    JoinOne(join, token, key);
  } else if (nodes.marks(join).Is(NodeMarks::kRightLinked) || joins().LinkJoin(join)) {
    JoinOne(join, token, key);
  }
  if (next != kNil) {
    JoinRest(next, token, key);
  }
}

/// Processes a pair that reaches a memory that is not sparse.
void ReteState::LeftPlain(std::uint32_t index, std::uint32_t parent, std::uint32_t wme) {
  const Node& node = network->node(index);
  NodeState& state = nodes[index];
  const std::uint32_t token = MakeToken(*this, index, parent, wme);
  const KeyParts key = KeyOfPair(*this, node, parent, wme);
  nodes.Insert(tokens, state, index, token, key.key, node.key != KeyKind::kNone, state.count);
  JoinAll(state, token, key);
  if (state.score != kNil) {
    sparse.AddToScore(state.score, index, tokens[token].first_child != kNil);
  }
}

/// Creates a token for the identifier at the beginning of a shared conjunction, and all its paths.
std::uint32_t ReteState::MakeAnchor(std::uint32_t anchors, std::uint32_t id) {
  const std::uint32_t token = MakeToken(*this, anchors, kNil, kNil);
  nodes.Insert(tokens, anchors, token, id, true);
  JoinAll(nodes[anchors], token, KeyParts{id, id, 0});
  return token;
}

// Right side ----------------------------------------------------------------------------------------------------------

/// Calls visit(token) for the tokens, from `token` on, that join with an element, newest first.
template <typename Visit>
[[gnu::always_inline]] inline void ForEachLeft(const ReteState& state, const Node& node, std::uint32_t token,
                                               std::uint32_t key, const Wme& element, Visit&& visit) {
  while (token != kNil) {
    const Token& left = state.tokens[token];
    const std::uint32_t next = left.next_in_bucket;
    if (left.key == key && HasKey(state.tokens, state.wmes, node, left.parent, left.wme, element) &&
        PassesAll(state, *state.network, node, left.parent, left.wme, element)) {
      visit(token);
    }
    token = next;
  }
}

/// Emits the pairs of an element and all gathered tokens.
void ReteState::EmitGathered(std::uint32_t join, std::uint32_t wme) {
  if (gathered.empty()) {
    return;
  }
  const Node& node = network->node(join);
  if (nodes.marks(join).Is(NodeMarks::kFeedsSparse)) {
    AddPairs<Differ::kAll>(*this, node.only_memory,
                           TokensAndElement{gathered.data(), gathered.data() + gathered.size(), wme});
  } else if (node.only_memory != kNil) {
    for (const std::uint32_t token : gathered) {
      LeftPlain(node.only_memory, token, wme);
    }
  } else {
    for (const std::uint32_t token : gathered) {
      Emit(join, token, wme);
    }
  }
}

void ReteState::RightSparse(std::uint32_t join, std::uint32_t wme) {
  const Node& node = network->node(join);
  const Wme& element = wmes[wme];
  const std::uint32_t key = KeyOfElement(node, element);
  const SparseState& memory = SparseOf(node.parent);
  gathered.clear();
  ForEachLeft(*this, node, nodes.BucketHead(node.parent, key), key, element,
              [this](std::uint32_t token) { gathered.push_back(token); });
  if (!memory.runs.empty()) {
    GatherFromRuns(join, wme, key);
  }
  if (memory.logged != 0 || memory.indexed != 0) {
    GatherParked(join, wme, key);
  }
  if (memory.unsorted) {
    tokens.SortByAge(gathered);
  }
  EmitGathered(join, wme);
  if (!shared.new_paths.empty()) [[unlikely]] {
    BlockOwners(node.parent);
  }
}

/// Joins an element that has entered the alpha memory of a left-linked join with the tokens on the other side.
[[gnu::always_inline]] inline void ReteState::RightJoin(std::uint32_t index, const Node& node, std::uint32_t wme,
                                                        const Wme& element) {
  const NodeMarks memory = nodes.marks(node.parent);
  if (memory.Is(NodeMarks::kSparse)) {
    RightSparse(index, wme);
    return;
  }
  const std::uint32_t key = KeyOfElement(node, element);
  const Records<const Token> all = tokens.read();
  std::uint32_t token = nodes.BucketHead(node.parent, memory.bits(), key);
  while (token != kNil && all[token].key != key) {
    token = all[token].next_in_bucket;
  }
  if (token != kNil) {
    RightMatch(index, wme, token, key);
  }
}

/// Joins the element with the tokens of a bucket, from `token` on, that have its key and pass the tests.
void ReteState::RightMatch(std::uint32_t index, std::uint32_t wme, std::uint32_t token, std::uint32_t key) {
  const Node& node = network->node(index);
  const Wme& element = wmes[wme];
  std::uint32_t late = 0;  // Number of tokens that join. A sparse memory would have parked them.
  if (nodes.marks(index).Is(NodeMarks::kFeedsSparse)) {
    gathered.clear();
    ForEachLeft(*this, node, token, key, element, [this](std::uint32_t left) { gathered.push_back(left); });
    late = static_cast<std::uint32_t>(gathered.size());
    EmitGathered(index, wme);
  } else {
    const std::uint32_t only = node.only_memory;
    ForEachLeft(*this, node, token, key, element, [this, only, index, wme, &late](std::uint32_t left) {
      ++late;
      if (only != kNil) {
        LeftPlain(only, left, wme);
      } else {
        Emit(index, left, wme);
      }
    });
  }
  std::uint32_t& score = nodes[node.parent].score;
  if (score != kNil) {
    SparseMemories::LowerScore(score, 2 + 2 * late);
  }
  if (!shared.new_paths.empty()) [[unlikely]] {
    BlockOwners(node.parent);
  }
}

/// Processes an element that has entered the alpha memory of a negative node.
void ReteState::RightNegative(std::uint32_t index, const Node& node, std::uint32_t wme) {
  const Wme& element = wmes[wme];
  const std::uint32_t key = KeyOfElement(node, element);
  ForEachLeft(*this, node, nodes.BucketHead(index, key), key, element,
              [this, wme](std::uint32_t left) { Block(left, wme); });
}

/// Processes the first element of an alpha memory. The joins of its list, from `first` on, were not linked on the left
/// (except those that are added meanwhile).
[[gnu::always_inline]] inline void ReteState::RightFirst(std::uint32_t first, std::uint32_t wme) {
  for (std::uint32_t index = first; index != kNil;) {
    const std::uint32_t next = nodes[index].next_right;
    const Node& node = network->node(index);
    if (node.kind != NodeKind::kJoin) {
      RightNegative(index, node, wme);
    } else {
      const bool waited = !nodes.marks(index).Is(NodeMarks::kLeftLinked);
      if (waited) {
        joins().LinkLeft(index);
        if (!only_ids.empty()) [[unlikely]] {
          FindOnlyId(*this, index);  // It was not updated for tokens that arrived meanwhile.
        }
      }
      if (waited && nodes[node.parent].count == 0) {
        joins().UnlinkRight(index);
      } else {
        RightJoin(index, node, wme, wmes[wme]);
      }
    }
    index = next;
  }
}

/// Processes a further element of an alpha memory: all joins of its list, from `first` on, are linked on the left.
[[gnu::always_inline]] inline void ReteState::RightAll(std::uint32_t first, std::uint32_t wme, const Wme& element) {
  const std::uint32_t value = element.value.bits();
  const std::uint32_t place = ValueFilter::Place(value);
  const std::uint32_t known = ValueFilter::Knows(value) ? ~std::uint32_t{0} : 0;
  const std::uint32_t id = element.id.bits();
  const Node* const topology = network->nodes();
  for (std::uint32_t index = first; index != kNil;) {
    const std::uint32_t next = nodes[index].next_right;
    const Node& node = topology[index];
    if (((place - node.filter.lowest) & known) <= node.filter.range) {
      if (node.IsJoinById() && nodes.marks(node.parent).HasList()) [[likely]] {
        const Records<const Token> all = tokens.read();
        std::uint32_t token = nodes[node.parent].head;
        while (token != kNil && all[token].key != id) {
          token = all[token].next_in_bucket;
        }
        if (token != kNil) {
          RightMatch(index, wme, token, id);
        }
      } else if (node.kind == NodeKind::kJoin) {
        RightJoin(index, node, wme, element);
      } else {
        RightNegative(index, node, wme);
      }
    }
    index = next;
  }
}

/// Like RightAll, for a busy alpha memory: most joins wait for other identifiers.
void ReteState::RightBusy(std::uint32_t first, std::uint32_t wme) {
  const Wme& element = wmes[wme];
  const std::uint32_t id = element.id.bits();
  const std::uint32_t value = element.value.bits();
  const std::uint32_t place = ValueFilter::Place(value);
  const std::uint32_t known = ValueFilter::Knows(value) ? ~std::uint32_t{0} : 0;
  const std::uint32_t* const ids = only_ids.data();
  const NodeState* const states = nodes.data();
  for (std::uint32_t next = first; next != kNil;) {
    // Most iterations end here.
    std::uint32_t wanted = ids[next];
    while (wanted != id && wanted != 0) {
      next = states[next].next_right;
      if (next == kNil) {
        return;
      }
      wanted = ids[next];
    }
    const std::uint32_t index = next;
    next = states[index].next_right;
    const Node& node = network->node(index);
    if (((place - node.filter.lowest) & known) > node.filter.range) {
      continue;
    }
    if (node.kind != NodeKind::kJoin) {
      RightNegative(index, node, wme);
      continue;
    }
    if (wanted == 0 && nodes[node.parent].count == 1) {
      FindOnlyId(*this, index);  // The memory had more than one token.
      wanted = ids[index];
      if (wanted != 0 && wanted != id) {
        continue;
      }
    }
    RightJoin(index, node, wme, element);
  }
}

void ReteState::AddWme(std::uint32_t wme) {
  const Wme& element = wmes[wme];
  links.Enter(wme, tokens.TakeSerial(), element.timetag, wmes.capacity());

  const std::uint32_t fields[3] = {element.id.bits(), element.attribute.bits(), element.value.bits()};
  // Two small loops (first find, then fill) are faster than one that needs all registers at once.
  std::uint32_t found[8];
  std::uint32_t* end = found;
  network->ForEachAlpha(fields, element.acceptable, [&](std::uint32_t alpha) { *end++ = alpha; });
  for (const std::uint32_t* at = found; at != end; ++at) {
    const std::uint32_t alpha = *at;
    alphas.Insert(alpha, wme, element, links[wme].first_item);
    const std::uint32_t node = alphas[alpha].first_node;
    if (node == kNil) {
      continue;
    }
    if (alphas[alpha].count == 1) {
      RightFirst(node, wme);
    } else if ((alphas[alpha].sparse & AlphaState::kBusy) != 0) [[unlikely]] {
      RightBusy(node, wme);
    } else {
      RightAll(node, wme, element);
    }
  }
  if (sparse.HasChanges()) {
    MakeScoredSparse();
  }
}

}  // namespace soarbox::kernel
