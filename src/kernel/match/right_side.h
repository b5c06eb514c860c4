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
/// Creates an index if it is worthwhile.
class [[gnu::visibility("hidden")]] RightSide {
 public:
  enum Kind : std::uint8_t { kIdTable, kPairTable, kAll, kIdList, kPairList };

  [[gnu::always_inline]] RightSide(AlphaMemories & alphas, const Node& join)
      : alphas_(alphas), alpha_(alphas[join.alpha]) {
    if (join.key == KeyKind::kNone) {
      kind_ = kAll;
      return;
    }
    const bool by_id = join.key == KeyKind::kId;
    if ((by_id ? alpha_.id_bits : alpha_.pair_bits) == 0) {
      if (alpha_.count <= kTinyMemory) {
        kind_ = by_id ? kIdList : kPairList;
        return;
      }
      by_id ? alphas.BuildIdTable(join.alpha, 5) : alphas.BuildPairTable(join.alpha, 5);
    }
    kind_ = by_id ? kIdTable : kPairTable;
  }

  /// The same after an item has been found: creates no index.
  [[gnu::always_inline]] static RightSide OfFound(const AlphaMemories& alphas, const Node& join) {
    return RightSide(alphas, join, FoundTag());
  }

  /// The newest item with this key, or kNil.
  template <Kind kind>
  [[gnu::always_inline]] std::uint32_t FirstOf(const KeyParts& key) const {
    if constexpr (kind == kIdTable) {
      return FromId(alphas_.IdBucket(alpha_, key.id), key);
    } else if constexpr (kind == kPairTable) {
      return FromPair(alphas_.PairBucket(alpha_, key.key), key);
    } else if constexpr (kind == kIdList) {
      return FromIdList(alpha_.first, key);
    } else if constexpr (kind == kPairList) {
      return FromPairList(alpha_.first, key);
    } else {
      return alpha_.first;
    }
  }
  [[gnu::always_inline]] std::uint32_t First(const KeyParts& key) const {
    switch (kind_) {
      case kIdTable:
        return FirstOf<kIdTable>(key);
      case kPairTable:
        return FirstOf<kPairTable>(key);
      case kAll:
        return FirstOf<kAll>(key);
      case kIdList:
        return FirstOf<kIdList>(key);
      case kPairList:
        return FirstOf<kPairList>(key);
    }
    return kNil;
  }
  /// The next item with this key.
  template <Kind kind>
  [[gnu::always_inline]] std::uint32_t NextOf(std::uint32_t item, const KeyParts& key) const {
    const AlphaItem& at = alphas_.item(item);
    if constexpr (kind == kIdTable) {
      return FromId(at.next_in_bucket, key);
    } else if constexpr (kind == kPairTable) {
      return FromPair(at.next_in_pair, key);
    } else if constexpr (kind == kIdList) {
      return FromIdList(at.next, key);
    } else if constexpr (kind == kPairList) {
      return FromPairList(at.next, key);
    } else {
      return at.next;
    }
  }
  [[gnu::always_inline]] std::uint32_t Next(std::uint32_t item, const KeyParts& key) const {
    switch (kind_) {
      case kIdTable:
        return NextOf<kIdTable>(item, key);
      case kPairTable:
        return NextOf<kPairTable>(item, key);
      case kAll:
        return NextOf<kAll>(item, key);
      case kIdList:
        return NextOf<kIdList>(item, key);
      case kPairList:
        return NextOf<kPairList>(item, key);
    }
    return kNil;
  }
  /// Calls visit(element) for each element offered for a key, newest first.
  template <typename Visit>
  [[gnu::always_inline]] void ForEach(const KeyParts& key, Visit&& visit) const {
    switch (kind_) {
      case kIdTable:
        ForEachOf<kIdTable>(key, visit);
        break;
      case kPairTable:
        ForEachOf<kPairTable>(key, visit);
        break;
      case kAll:
        ForEachOf<kAll>(key, visit);
        break;
      case kIdList:
        ForEachOf<kIdList>(key, visit);
        break;
      case kPairList:
        ForEachOf<kPairList>(key, visit);
        break;
    }
  }
  std::uint32_t Element(std::uint32_t item) const {
    return alphas_.item(item).wme;
  }
  Kind kind() const {
    return kind_;
  }

 private:
  struct FoundTag {};
  [[gnu::always_inline]] RightSide(const AlphaMemories& alphas, const Node& join, FoundTag)
      : alphas_(alphas), alpha_(alphas[join.alpha]) {
    if (join.key == KeyKind::kId) {
      kind_ = alpha_.id_bits != 0 ? kIdTable : kIdList;
    } else if (join.key == KeyKind::kIdValue) {
      kind_ = alpha_.pair_bits != 0 ? kPairTable : kPairList;
    }
  }

  template <Kind kind, typename Visit>
  [[gnu::always_inline]] void ForEachOf(const KeyParts& key, Visit& visit) const {
    for (std::uint32_t item = FirstOf<kind>(key); item != kNil; item = NextOf<kind>(item, key)) {
      visit(Element(item));
    }
  }
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
  [[gnu::always_inline]] std::uint32_t FromIdList(std::uint32_t item, const KeyParts& key) const {
    const Records<const AlphaItem> items = alphas_.items();
    while (item != kNil && items[item].id != key.id) {
      item = items[item].next;
    }
    return item;
  }
  [[gnu::always_inline]] std::uint32_t FromPairList(std::uint32_t item, const KeyParts& key) const {
    const Records<const AlphaItem> items = alphas_.items();
    while (item != kNil && (items[item].id != key.id || items[item].value != key.value)) {
      item = items[item].next;
    }
    return item;
  }

  const AlphaMemories& alphas_;
  const AlphaState& alpha_;
  Kind kind_ = kAll;
};

}  // namespace soarbox::kernel
