// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "kernel/match/rete_inline.h"

/// The pairs of tokens and elements that joins find, one after the other.
namespace soarbox::kernel {

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
[[gnu::noinline]] inline std::uint32_t FirstPassingOf(const ReteState& state, const RightSide& right, const Node& join,
                                                      const KeyParts& key, std::uint32_t parent, std::uint32_t wme,
                                                      std::uint32_t item) {
  return FirstPassing(state, right, join, key, parent, wme, item);
}

/// The newest item that a join's right side offers for a key; its tests have not been evaluated.
[[gnu::always_inline]] inline std::uint32_t FirstOffered(ReteState& state, const Node& join, const KeyParts& key) {
  return RightSide(state.alphas, join).First(key);
}

/// Pairs of a token and the elements with a given identifier in a bucket, from `item` on.
struct [[gnu::visibility("hidden")]] TokenAndBucket {
  static constexpr bool kMakesTokens = false;
  const ReteState& state;
  std::uint32_t token, item, id;

  [[gnu::always_inline]] bool Next(std::uint32_t & left, std::uint32_t & element) {
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
struct [[gnu::visibility("hidden")]] TokenAndPassing {
  static constexpr bool kMakesTokens = false;
  const ReteState& state;
  const RightSide& right;
  const Node& join;
  KeyParts key;
  std::uint32_t token, item, parent, wme;

  [[gnu::always_inline]] bool Next(std::uint32_t & left, std::uint32_t & element) {
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
struct [[gnu::visibility("hidden")]] TokensAndElement {
  static constexpr bool kMakesTokens = false;
  const std::uint32_t* at;
  const std::uint32_t* end;
  std::uint32_t wme;

  [[gnu::always_inline]] bool Next(std::uint32_t & left, std::uint32_t & element) {
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
class [[gnu::visibility("hidden")]] BucketTokens {
 public:
  [[gnu::always_inline]] BucketTokens(ReteState & state, std::uint32_t index, const TokenAndBucket& pairs)
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
    return true;
  }
  std::uint32_t token() const {
    return token_;
  }
  const KeyParts& key() const {
    return key_;
  }

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
struct [[gnu::visibility("hidden")]] BucketTokensAndElements {
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
  [[gnu::always_inline]] bool Next(std::uint32_t & left, std::uint32_t & element) {
    if (!Begin()) {
      return false;
    }
    left = tokens.token();
    element = right.Element(item);
    item = right.Next(item, tokens.key());
    return true;
  }
};

}  // namespace soarbox::kernel
