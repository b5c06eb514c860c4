// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>

#include "kernel/match/rete_inline.h"

/// Joins and their memories. Most of the work of a match is done here.
namespace soarbox::kernel {

namespace {

/// JoinLinks::FindOnlyId as a separate function.
[[gnu::noinline]] void FindOnlyId(ReteState& state, std::uint32_t node) {
  state.joins().FindOnlyId(node);
}

/// Computes the set of identifiers that the tokens of a memory can join with.
[[gnu::noinline]] void RenewSignature(ReteState& state, std::uint32_t index) {
  const Node& node = state.network->node(index);
  KeySignatures::Set set = 0;
  state.nodes.ForEachToken(state.tokens, index, [&](std::uint32_t token) {
    const std::uint32_t id =
        node.kind == NodeKind::kAnchors
            ? state.tokens[token].key
            : BitsOf(state.wmes[ElementAt(state.tokens.read(), token, node.key_id_levels)], node.key_id_field);
    set |= KeySignatures::Of(id);
  });
  state.signatures.Replace(index, set);
}

/// The first item, from `item` on, whose element passes the tests of a join with (parent, wme).
[[gnu::always_inline]] inline std::uint32_t FirstPassing(const ReteState& state, const RightSide& right,
                                                         const Node& join, const KeyParts& key, std::uint32_t parent,
                                                         std::uint32_t wme, std::uint32_t item) {
  while (item != kNil && !PassesAll(state, *state.network, join, parent, wme, state.wmes[right.Element(item)])) {
    item = right.Next(item, key);
  }
  return item;
}

/// FirstPassing as a separate function, for loops that seldom call it.
[[gnu::noinline]] std::uint32_t FirstPassingOf(const ReteState& state, const RightSide& right, const Node& join,
                                               const KeyParts& key, std::uint32_t parent, std::uint32_t wme,
                                               std::uint32_t item) {
  return FirstPassing(state, right, join, key, parent, wme, item);
}

/// The newest item that a join's right side offers for a key; its tests have not been evaluated.
[[gnu::always_inline]] inline std::uint32_t FirstOffered(ReteState& state, const Node& join, const KeyParts& key) {
  return RightSide(state.alphas, join).First(key);
}

/// Pairs of a token and the elements with a given identifier in a bucket, from `item` on.
struct TokenAndBucket {
  static constexpr bool kMakesTokens = false;
  const ReteState& state;
  std::uint32_t token, item, id;

  [[gnu::always_inline]] bool Next(std::uint32_t& left, std::uint32_t& element) {
    const Records<const AlphaItem> all = state.alphas.items();
    while (item != kNil && all[item].id != id) {
      item = all[item].next_in_bucket;
    }
    if (item == kNil) {
      return false;
    }
    left = token;
    element = all[item].wme;
    item = all[item].next_in_bucket;
    return true;
  }
};

/// Pairs of a token and the elements that pass the tests of a join, from `item` on.
struct TokenAndPassing {
  static constexpr bool kMakesTokens = false;
  const ReteState& state;
  const RightSide& right;
  const Node& join;
  KeyParts key;
  std::uint32_t token, item, parent, wme;

  [[gnu::always_inline]] bool Next(std::uint32_t& left, std::uint32_t& element) {
    if (item == kNil) {
      return false;
    }
    left = token;
    element = right.Element(item);
    item = FirstPassing(state, right, join, key, parent, wme, right.Next(item, key));
    return true;
  }
};

/// Pairs of several tokens and one element.
struct TokensAndElement {
  static constexpr bool kMakesTokens = false;
  const std::uint32_t* at;
  const std::uint32_t* end;
  std::uint32_t wme;

  [[gnu::always_inline]] bool Next(std::uint32_t& left, std::uint32_t& element) {
    if (at == end) {
      return false;
    }
    left = *at++;
    element = wme;
    return true;
  }
};

/// Creates the tokens of a memory for pairs of one token and the elements of a bucket (elements with the same
/// identifier). The memory is not sparse, has a join, and has other tokens.
class BucketTokens {
 public:
  [[gnu::always_inline]] BucketTokens(ReteState& state, std::uint32_t index, const TokenAndBucket& pairs)
      : state_(state),
        index_(index),
        node_(state.network->node(index)),
        memory_(state.nodes[index]),
        pairs_(pairs),
        id_moves_(node_.key != KeyKind::kNone && node_.key_id_levels == 0),
        with_value_(node_.key == KeyKind::kIdValue),
        value_moves_(node_.key_value_levels == 0),
        scored_(memory_.score != kNil) {}

  /// Creates the next token. Returns false after the last one. Call it when the previous token has been joined.
  [[gnu::always_inline]] bool Next() {
    if (scored_ && token_ != kNil) {
      state_.sparse.AddToScore(memory_.score, index_, state_.tokens[token_].first_child != kNil);
    }
    std::uint32_t parent = kNil;
    std::uint32_t wme = kNil;
    if (!pairs_.Next(parent, wme)) {
      return false;
    }
    if (token_ == kNil) {
      key_ = KeyOfPair(state_, node_, parent, wme);
    }
    token_ = MakeToken(state_, index_, parent, wme);
    if (id_moves_) {
      key_.key = key_.id = BitsOf(state_.wmes.data()[wme], node_.key_id_field);
    }
    if (with_value_) {
      if (value_moves_) {
        key_.value = BitsOf(state_.wmes.data()[wme], node_.key_value_field);
      }
      key_.key = PairKey(key_.id, key_.value);
    }
    state_.nodes.Insert(state_.tokens, memory_, index_, token_, key_.key, node_.key != KeyKind::kNone, memory_.count);
    if (!state_.signatures.empty()) [[unlikely]] {
      state_.signatures.Add(index_, key_.id, memory_.count);
    }
    return true;
  }
  std::uint32_t token() const { return token_; }
  const KeyParts& key() const { return key_; }

 private:
  ReteState& state_;
  const std::uint32_t index_;
  const Node& node_;
  NodeState& memory_;
  TokenAndBucket pairs_;
  const bool id_moves_, with_value_, value_moves_, scored_;
  KeyParts key_;
  std::uint32_t token_ = kNil;
};

/// Pairs of such tokens and the elements that each joins with. The join has no tests.
struct BucketTokensAndElements {
  static constexpr bool kMakesTokens = true;
  BucketTokens& tokens;
  const RightSide& right;
  std::uint32_t item = kNil;  ///< The next element of the current token.

  /// Finds the first pair. Returns false if there is none.
  [[gnu::always_inline]] bool Begin() {
    while (item == kNil) {
      if (!tokens.Next()) {
        return false;
      }
      item = right.First(tokens.key());
    }
    return true;
  }
  [[gnu::always_inline]] bool Next(std::uint32_t& left, std::uint32_t& element) {
    if (!Begin()) {
      return false;
    }
    left = tokens.token();
    element = right.Element(item);
    item = right.Next(item, tokens.key());
    return true;
  }
};

/// In which of their elements the pairs of a source may differ: up to which level above the pair.
enum class Differ : std::uint32_t {
  kElements = 1,  ///< All pairs have the same token.
  kSiblings = 2,  ///< Their tokens have the same parent.
  kAll = 0xFFFFFFFFu
};

/// The next pair of a source, which may take serial numbers for tokens.
template <typename Source>
[[gnu::always_inline]] inline bool NextPair(ReteState& state, Source& source, std::uint64_t& serial,
                                            std::uint32_t& parent, std::uint32_t& wme) {
  if constexpr (!Source::kMakesTokens) {
    return source.Next(parent, wme);
  }
  state.tokens.set_next_serial(serial);
  const bool is_pair = source.Next(parent, wme);
  serial = state.tokens.next_serial();
  return is_pair;
}

/// Passes pairs to a sparse memory. Most pairs end here: they are parked after one look-up on the other side.
/// Everything that is the same for all pairs is computed once. `source.Next(parent, wme)` returns the next pair, or
/// false after the last one; there must be at least one.
template <Differ differ, RightSide::Kind kind, bool with_value, typename Source>
[[gnu::always_inline]] inline void AddPairsOf(ReteState& state, std::uint32_t index, const RightSide& right,
                                              Source source) {
  const Network& net = *state.network;
  const Node& node = net.node(index);
  const Node& joined = net.node(node.first_child);
  const std::uint32_t id_levels = node.key_id_levels;
  const std::uint32_t value_levels = node.key_value_levels;
  const Field id_field = node.key_id_field;
  const Field value_field = node.key_value_field;
  const Wme* const wmes = state.wmes.data();
  NodeState& memory = state.nodes[index];
  SparseState& sparse = state.sparse[memory.place];
  const bool tested = joined.test_count != 0;
  constexpr auto kDiffering = static_cast<std::uint32_t>(differ);
  constexpr bool kOneParent = differ == Differ::kElements;

  std::uint32_t parent = kNil;
  std::uint32_t wme = kNil;
  source.Next(parent, wme);
  KeyParts key;
  std::uint64_t serial = state.tokens.next_serial();
  ParkedPair* log = sparse.log.data() + sparse.logged;
  ParkedPair* end = sparse.log.data() + sparse.log_limit;
  std::uint32_t arrived = 0;
  bool first = true;
  do {
    const Records<Token> tokens = state.tokens.records();
    if (id_levels == 0) {
      key.id = BitsOf(wmes[wme], id_field);
    } else if (id_levels < kDiffering || first) {
      key.id = BitsOf(wmes[ElementAt(state.tokens.read(), parent, id_levels - 1u)], id_field);
    }
    if (!with_value) {
      key.key = key.id;
    } else {
      if (value_levels == 0) {
        key.value = BitsOf(wmes[wme], value_field);
      } else if (value_levels < kDiffering || first) {
        key.value = BitsOf(wmes[ElementAt(state.tokens.read(), parent, value_levels - 1u)], value_field);
      }
      key.key = PairKey(key.id, key.value);
    }
    first = false;
    if (!kOneParent) {
      ++tokens[parent].pairs;
    }
    ++arrived;
    const std::uint64_t now = serial++;
    std::uint32_t item = right.FirstOf<kind>(key);
    if (item != kNil && tested) {
      item = FirstPassingOf(state, right, joined, key, parent, wme, item);
    }
    if (item == kNil && log != end) [[likely]] {
      log->parent = parent;
      log->wme = wme;
      log->serial = now;
      log->key = key.key;
      ++log;
      continue;
    }
    state.tokens.set_next_serial(serial);
    memory.count += arrived;
    if (kOneParent) {
      tokens[parent].pairs += arrived;
    }
    arrived = 0;
    sparse.logged = static_cast<std::uint32_t>(log - sparse.log.data());
    if (item != kNil) {
      state.JoinSparsely(index, parent, wme, now, key, item);
    } else {
      state.sparse.MakeRoomToPark(state.tokens, state.links, sparse);
      sparse.log[sparse.logged++] = {parent, wme, now, key.key, kNil};
    }
    serial = state.tokens.next_serial();
    log = sparse.log.data() + sparse.logged;
    end = sparse.log.data() + sparse.log_limit;
  } while (NextPair(state, source, serial, parent, wme));
  state.tokens.set_next_serial(serial);
  memory.count += arrived;
  if (kOneParent) {
    state.tokens[parent].pairs += arrived;
  }
  sparse.logged = static_cast<std::uint32_t>(log - sparse.log.data());
}

template <Differ differ, typename Source>
[[gnu::always_inline]] inline void AddPairs(ReteState& state, std::uint32_t index, Source source) {
  const std::uint32_t join = state.network->node(index).first_child;
  state.joins().LinkOnlyJoin(index, join);
  const RightSide right(state.alphas, state.network->node(join));
  switch (right.kind()) {
    case RightSide::kIdTable:
      AddPairsOf<differ, RightSide::kIdTable, false>(state, index, right, source);
      break;
    case RightSide::kPairTable:
      AddPairsOf<differ, RightSide::kPairTable, true>(state, index, right, source);
      break;
    case RightSide::kIdList:
      AddPairsOf<differ, RightSide::kIdList, false>(state, index, right, source);
      break;
    case RightSide::kPairList:
      AddPairsOf<differ, RightSide::kPairList, true>(state, index, right, source);
      break;
    case RightSide::kAll:
      break;  // The memory has a key.
  }
}

/// ReteState::JoinSparsely as a separate function: most pairs that arrive alone do not join.
[[gnu::noinline]] void JoinSparselyOf(ReteState& state, std::uint32_t index, std::uint32_t parent, std::uint32_t wme,
                                      std::uint64_t serial, const KeyParts& key, std::uint32_t item) {
  state.JoinSparsely(index, parent, wme, serial, key, item);
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
  if (memory != kNil && node.test_count == 0 && right.kind() == RightSide::kIdTable) {
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
template <RightSide::Kind kind>
[[gnu::always_inline]] inline void ReteState::JoinRuns(const RightSide& right, std::uint32_t index, std::uint32_t token,
                                                       std::uint32_t id, std::uint32_t item) {
  const Node& node = network->node(index);
  const Node& joined = network->node(node.first_child);
  constexpr bool kWithValue = kind == RightSide::kPairTable || kind == RightSide::kPairList;
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
    case RightSide::kIdTable:
      JoinRuns<RightSide::kIdTable>(right, index, token, id, item);
      break;
    case RightSide::kPairTable:
      JoinRuns<RightSide::kPairTable>(right, index, token, id, item);
      break;
    case RightSide::kIdList:
      JoinRuns<RightSide::kIdList>(right, index, token, id, item);
      break;
    case RightSide::kPairList:
      JoinRuns<RightSide::kPairList>(right, index, token, id, item);
      break;
    case RightSide::kAll:
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
  } else if (right.kind() != RightSide::kIdTable) {
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
  if (!signatures.empty()) [[unlikely]] {
    signatures.Add(index, key.id, state.count);
  }
  JoinAll(state, token, key);
  if (state.score != kNil) {
    sparse.AddToScore(state.score, index, tokens[token].first_child != kNil);
  }
}

/// Creates a token for the identifier at the beginning of a shared conjunction, and all its paths.
std::uint32_t ReteState::MakeAnchor(std::uint32_t anchors, std::uint32_t id) {
  const std::uint32_t token = MakeToken(*this, anchors, kNil, kNil);
  nodes.Insert(tokens, anchors, token, id, true);
  if (!signatures.empty()) {
    signatures.Add(anchors, id, nodes[anchors].count);
  }
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

/// Joins an element that has entered the alpha memory of a left-linked join with the tokens on the other side. Returns
/// false if none of them has its key.
[[gnu::always_inline]] inline bool ReteState::RightJoin(std::uint32_t index, const Node& node, std::uint32_t wme,
                                                        const Wme& element) {
  const NodeMarks memory = nodes.marks(node.parent);
  if (memory.Is(NodeMarks::kSparse)) {
    RightSparse(index, wme);
    return true;
  }
  const std::uint32_t key = KeyOfElement(node, element);
  const Records<const Token> all = tokens.read();
  std::uint32_t token = nodes.BucketHead(node.parent, memory.bits(), key);
  while (token != kNil && all[token].key != key) {
    token = all[token].next_in_bucket;
  }
  if (token == kNil) {
    return false;
  }
  RightMatch(index, wme, token, key);
  return true;
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
    const bool is_join = node.kind == NodeKind::kJoin;
    const std::uint32_t memory = is_join ? node.parent : index;
    if (wanted == 0 && is_join && nodes[memory].count == 1) {
      FindOnlyId(*this, index);  // The memory had more than one token.
      wanted = ids[index];
      if (wanted != 0 && wanted != id) {
        continue;
      }
    }
    const bool is_set = wanted == 0 && node.key != KeyKind::kNone && !nodes.marks(memory).Is(NodeMarks::kSparse);
    if (is_set && !signatures.MayHave(memory, id)) {
      continue;
    }
    if (!is_join) {
      RightNegative(index, node, wme);
    } else if (!RightJoin(index, node, wme, element) && is_set && signatures.IsStale(memory, nodes[memory].count)) {
      RenewSignature(*this, memory);
    }
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
