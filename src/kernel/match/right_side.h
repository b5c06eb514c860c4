// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

#include "kernel/match/alpha_memories.h"
#include "kernel/match/network.h"

namespace soarbox::kernel {

/// The key of a token of a memory.
struct KeyParts {
  std::uint32_t key = 0;    ///< As in Token::key.
  std::uint32_t id = 0;     ///< kId, kIdValue.
  std::uint32_t value = 0;  ///< kIdValue.
};

/// The elements that the right side of a join or a negative node offers for a key; all look-ups on the right side use
/// this class. The caller must still evaluate the tests. Valid until an element enters or leaves the alpha memory.
/// Creates the index if there is none.
class [[gnu::visibility("hidden")]] RightSide {
 public:
  [[gnu::always_inline]] RightSide(AlphaMemories & alphas, const Node& join) : RightSide(alphas, join, FoundTag()) {
    constexpr std::uint8_t kFirstBits = 3;
    if (kind_ == KeyKind::kId && alpha_.id_bits == 0) [[unlikely]] {
      alphas.BuildIdTable(join.alpha, kFirstBits);
    } else if (kind_ == KeyKind::kIdValue && alpha_.pair_bits == 0) [[unlikely]] {
      alphas.BuildPairTable(join.alpha, kFirstBits);
    }
  }

  /// The same after an item has been found: creates no index.
  [[gnu::always_inline]] static RightSide OfFound(const AlphaMemories& alphas, const Node& join) {
    return RightSide(alphas, join, FoundTag());
  }

  /// The newest item with this key, or kNil.
  template <KeyKind kind>
  [[gnu::always_inline]] std::uint32_t FirstOf(const KeyParts& key) const {
    if constexpr (kind == KeyKind::kId) {
      return FromId(alphas_.IdBucket(alpha_, key.id), key);
    } else if constexpr (kind == KeyKind::kIdValue) {
      return FromPair(alphas_.PairBucket(alpha_, key.key), key);
    } else {
      return alpha_.first;
    }
  }
  [[gnu::always_inline]] std::uint32_t First(const KeyParts& key) const {
    switch (kind_) {
      case KeyKind::kNone:
        return FirstOf<KeyKind::kNone>(key);
      case KeyKind::kId:
        return FirstOf<KeyKind::kId>(key);
      case KeyKind::kIdValue:
        return FirstOf<KeyKind::kIdValue>(key);
    }
    return kNil;
  }
  /// The next item with this key.
  template <KeyKind kind>
  [[gnu::always_inline]] std::uint32_t NextOf(std::uint32_t item, const KeyParts& key) const {
    const AlphaItem& at = alphas_.item(item);
    if constexpr (kind == KeyKind::kId) {
      return FromId(at.next_in_bucket, key);
    } else if constexpr (kind == KeyKind::kIdValue) {
      return FromPair(at.next_in_pair, key);
    } else {
      return at.next;
    }
  }
  [[gnu::always_inline]] std::uint32_t Next(std::uint32_t item, const KeyParts& key) const {
    switch (kind_) {
      case KeyKind::kNone:
        return NextOf<KeyKind::kNone>(item, key);
      case KeyKind::kId:
        return NextOf<KeyKind::kId>(item, key);
      case KeyKind::kIdValue:
        return NextOf<KeyKind::kIdValue>(item, key);
    }
    return kNil;
  }
  /// Calls visit(element) for each element offered for a key, newest first.
  template <typename Visit>
  [[gnu::always_inline]] void ForEach(const KeyParts& key, Visit&& visit) const {
    for (std::uint32_t item = First(key); item != kNil; item = Next(item, key)) {
      visit(Element(item));
    }
  }
  std::uint32_t Element(std::uint32_t item) const {
    return alphas_.item(item).wme;
  }
  KeyKind kind() const {
    return kind_;
  }

 private:
  struct FoundTag {};
  [[gnu::always_inline]] RightSide(const AlphaMemories& alphas, const Node& join, FoundTag)
      : alphas_(alphas), alpha_(alphas[join.alpha]), kind_(join.key) {}

  [[gnu::always_inline]] std::uint32_t FromId(std::uint32_t item, const KeyParts& key) const {
    const Records<const AlphaItem> items = alphas_.items();
    while (item != kNil && items[item].id != key.id) {
      item = items[item].next_in_bucket;
    }
    return item;
  }
  [[gnu::always_inline]] std::uint32_t FromPair(std::uint32_t item, const KeyParts& key) const {
    const Records<const AlphaItem> items = alphas_.items();
    while (item != kNil && (items[item].id != key.id || items[item].value != key.value)) {
      item = items[item].next_in_pair;
    }
    return item;
  }

  const AlphaMemories& alphas_;
  const AlphaState& alpha_;
  KeyKind kind_;
};

}  // namespace soarbox::kernel
