// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "kernel/base/plain_vector.h"
#include "kernel/match/element_links.h"
#include "kernel/match/network.h"
#include "kernel/match/record_array.h"
#include "kernel/match/table_pool.h"
#include "kernel/match/wme.h"

namespace soarbox::kernel {

/// A hash key for an identifier and a value.
inline std::uint32_t PairKey(std::uint32_t id, std::uint32_t value) {
  return (id * 0x85EBCA6Bu) ^ (value * 0xC2B2AE35u);
}

/// Nodes with up to this number of tokens have no hash tables.
inline constexpr std::uint32_t kTinyMemory = 8;

/// An element in an alpha memory.
struct AlphaItem {
  std::uint32_t wme;
  std::uint32_t alpha;
  std::uint32_t id, value;                           ///< Symbol bits of the element's id and value, for the indexes.
  std::uint32_t next, previous;                      ///< All items of the memory, newest first.
  std::uint32_t next_in_bucket, previous_in_bucket;  ///< Index by identifier, if the memory has one.
  std::uint32_t next_in_pair;                        ///< Index by identifier and value, if it has one.
  std::uint32_t next_in_value;                       ///< Index by value, if it has one.
  std::uint32_t next_of_wme;
};

struct AlphaState {
  std::uint32_t first = kNil;  ///< The newest item.
  std::uint32_t count = 0;
  std::uint32_t first_node = kNil, last_node = kNil;  ///< Right-linked nodes; descendants are before ancestors.
  std::uint32_t id_table = 0, pair_table = 0;
  std::uint8_t id_bits = 0, pair_bits = 0, value_bits = 0;  ///< 0: no table.
  bool has_tables = false;                                  ///< At least one of them is not 0.
  std::uint32_t sparse = 0;  ///< Number of joins that feed sparse memories, plus the flags kInPaths, kBusy, kPrimed.

  static constexpr std::uint32_t kInPaths = 0x80000000u;  ///< Joins of shared conjunctions use or have used it.
  static constexpr std::uint32_t kBusy = 0x40000000u;     ///< It has many right-linked nodes: see OnlyIds.
  static constexpr std::uint32_t kPrimed = 0x20000000u;   ///< Its items may not be in order of arrival.
  static constexpr std::uint32_t kFlags = kInPaths | kBusy | kPrimed;
};
static_assert(sizeof(AlphaState) == 32, "alpha memories are addressed by a shift");

/// The alpha memories of an agent: the elements that pass each set of constant tests, newest first. Indexes by
/// identifier, by identifier and value, and by value are created on demand.
///
/// Invariants: an element has one item in each memory whose tests it passes. The item is on the memory's list, on the
/// element's own list, and in each index of the memory. NodeStates stores which nodes are linked to a memory.
class [[gnu::visibility("hidden")]] AlphaMemories {
 public:
  AlphaState& operator[](std::uint32_t alpha) {
    return states_[alpha];
  }
  const AlphaState& operator[](std::uint32_t alpha) const {
    return states_[alpha];
  }
  const AlphaItem& item(std::uint32_t item) const {
    return items_[item];
  }
  Records<const AlphaItem> items() const {
    return items_.records();
  }

  /// Initializes a new, empty memory.
  void Begin(std::uint32_t alpha);
  /// Adds an element to a memory. `first_item` is the head of the element's own list.
  [[gnu::always_inline]] void Insert(std::uint32_t alpha, std::uint32_t wme, const Wme& element,
                                     std::uint32_t& first_item) {
    std::uint32_t index = free_;
    if (index != kNil) [[likely]] {
      free_ = items_[index].next;
    } else {
      index = items_.Append();
    }
    const Records<AlphaItem> all = items_.records();
    AlphaState& memory = states_[alpha];
    AlphaItem& item = all[index];
    item.wme = wme;
    item.alpha = alpha;
    item.id = element.id.bits();
    item.value = element.value.bits();
    item.previous = kNil;
    item.next = memory.first;
    if (memory.first != kNil) {
      all[memory.first].previous = index;
    }
    memory.first = index;
    item.next_of_wme = first_item;
    first_item = index;
    ++memory.count;

    if (memory.has_tables) {
      InsertInTables(memory, alpha, index);
    }
  }
  /// Removes an item from its memory's list and indexes. The caller updates the count and the element's own list.
  [[gnu::always_inline]] void TakeOut(AlphaState & memory, std::uint32_t index) {
    const Records<AlphaItem> all = items_.records();
    const AlphaItem& item = all[index];
    const std::uint32_t next = item.next;
    const std::uint32_t previous = item.previous;
    if (next != kNil) {
      all[next].previous = previous;
    }
    (previous != kNil ? all[previous].next : memory.first) = next;
    if (memory.has_tables) {
      TakeOutOfTables(memory, item, index);
    }
  }
  [[gnu::always_inline]] void Free(std::uint32_t index) {
    items_[index].next = free_;
    free_ = index;
  }
  /// Adds a use of the memory with these constant tests, and creates the memory if it does not exist. A new memory is
  /// filled from the next more general memory, or from all elements, newest first. Each item becomes the first one of
  /// its element's list.
  std::uint32_t Use(Network & network, ElementLinks & links, const WmeTable& wmes, const std::uint32_t(&constants)[3],
                    std::uint32_t mask, bool acceptable);
  /// A node no longer uses this memory.
  void GiveUp(Network & network, ElementLinks & links, std::uint32_t alpha);
  /// Removes a memory with all its items.
  void Drop(std::uint32_t alpha, ElementLinks & elements);

  /// Makes an index of 2^bits buckets, or more if there are more items.
  void MakeTable(AlphaState & memory, std::uint32_t & table, std::uint8_t & table_bits, std::uint8_t bits);
  std::uint32_t OldestItem(const AlphaState& memory) const;
  void EnterByValue(std::uint32_t alpha, std::uint32_t index);
  void BuildIdTable(std::uint32_t alpha, std::uint8_t bits);
  void BuildPairTable(std::uint32_t alpha, std::uint8_t bits);
  /// The first item of a bucket of an index, which the memory must have.
  std::uint32_t IdBucket(const AlphaState& memory, std::uint32_t id) const {
    return tables_[memory.id_table + TablePool::Hash(id, memory.id_bits)];
  }
  std::uint32_t PairBucket(const AlphaState& memory, std::uint32_t key) const {
    return tables_[memory.pair_table + TablePool::Hash(key, memory.pair_bits)];
  }
  /// Calls visit(item) for the items whose element has this value. Creates the index if there is none.
  template <typename Visit>
  void ForEachWithValue(std::uint32_t alpha, std::uint32_t value, Visit && visit) {
    const AlphaState& memory = states_[alpha];
    if (memory.value_bits == 0) [[unlikely]] {
      BuildValueTable(alpha, 3);
    }
    std::uint32_t index = tables_[value_tables_[alpha] + TablePool::Hash(value, memory.value_bits)];
    for (; index != kNil; index = items_[index].next_in_value) {
      if (items_[index].value == value) {
        visit(items_[index]);
      }
    }
  }
  /// The number of items in an index, for comparison with the memory's list.
  std::uint32_t CountInIdTable(const AlphaState& memory) const;
  std::uint32_t CountInPairTable(const AlphaState& memory) const;

  /// Frees the memory of all items. Afterwards no element is in any memory.
  void Release();
  void ShrinkToFit() {
    states_.shrink_to_fit();
  }
  std::size_t MemoryBytes() const {
    return states_.capacity() * sizeof(AlphaState) + items_.MemoryBytes() + tables_.MemoryBytes();
  }

 private:
  [[gnu::always_inline]] void InsertInTables(AlphaState & memory, std::uint32_t alpha, std::uint32_t index) {
    const Records<AlphaItem> all = items_.records();
    AlphaItem& item = all[index];
    if (memory.id_bits != 0) {
      if (memory.count > 1u << memory.id_bits) [[unlikely]] {
        BuildIdTable(alpha, static_cast<std::uint8_t>(memory.id_bits + 2));
      } else {
        std::uint32_t& head = tables_[memory.id_table + TablePool::Hash(item.id, memory.id_bits)];
        item.previous_in_bucket = kNil;
        item.next_in_bucket = head;
        if (head != kNil) {
          all[head].previous_in_bucket = index;
        }
        head = index;
      }
    }
    if (memory.pair_bits != 0) {
      if (memory.count > 1u << memory.pair_bits) [[unlikely]] {
        BuildPairTable(alpha, static_cast<std::uint8_t>(memory.pair_bits + 2));
      } else {
        std::uint32_t& head =
            tables_[memory.pair_table + TablePool::Hash(PairKey(item.id, item.value), memory.pair_bits)];
        item.next_in_pair = head;
        head = index;
      }
    }
    if (memory.value_bits != 0) [[unlikely]] {
      InsertByValue(alpha, index);
    }
  }
  [[gnu::always_inline]] void TakeOutOfTables(AlphaState & memory, const AlphaItem& item, std::uint32_t index) {
    const Records<AlphaItem> all = items_.records();
    if (memory.id_bits != 0) {
      const std::uint32_t next_in_bucket = item.next_in_bucket;
      if (next_in_bucket != kNil) {
        all[next_in_bucket].previous_in_bucket = item.previous_in_bucket;
      }
      (item.previous_in_bucket != kNil ? all[item.previous_in_bucket].next_in_bucket
                                       : tables_[memory.id_table + TablePool::Hash(item.id, memory.id_bits)]) =
          next_in_bucket;
    }
    if (memory.pair_bits != 0) {
      std::uint32_t* link =
          &tables_[memory.pair_table + TablePool::Hash(PairKey(item.id, item.value), memory.pair_bits)];
      while (*link != index) {
        link = &all[*link].next_in_pair;
      }
      *link = item.next_in_pair;
    }
    if (memory.value_bits != 0) [[unlikely]] {
      TakeOutByValue(item.alpha, index);
    }
  }
  void InsertByValue(std::uint32_t alpha, std::uint32_t index);
  void TakeOutByValue(std::uint32_t alpha, std::uint32_t index);
  void BuildValueTable(std::uint32_t alpha, std::uint8_t bits);
  std::uint32_t CountInTable(std::uint32_t table, std::uint32_t bits, std::uint32_t AlphaItem::*next) const;

  PlainVector<AlphaState> states_;
  RecordArray<AlphaItem> items_;
  std::uint32_t free_ = kNil;
  TablePool tables_;
  std::vector<std::uint32_t> value_tables_;  ///< By alpha memory, for those that have value_bits.
};

}  // namespace soarbox::kernel
