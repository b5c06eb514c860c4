// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace soarbox::kernel {

/// The flags of an interned constant.
struct PoolMarks {
  static constexpr std::uint8_t kLive = 1, kPinned = 2, kMarked = 4;
  std::uint8_t bits = 0;

  bool Live() const { return (bits & kLive) != 0; }
  bool Pinned() const { return (bits & kPinned) != 0; }
};

/// An interned text. A TextArena owns the characters.
struct TextEntry {
  const char* text = nullptr;
  std::uint32_t length = 0;
  std::uint32_t hash = 0;
  std::uint32_t stamp = 0;
  PoolMarks marks;

  std::string_view View() const { return {text, length}; }
  bool Is(std::uint32_t other_hash, std::string_view key) const { return hash == other_hash && View() == key; }
  std::uint32_t Hash() const { return hash; }
};

/// A 64-bit number in a pool: an integer, or the bits of a double.
struct NumberEntry {
  std::uint64_t bits = 0;
  std::uint32_t stamp = 0;
  PoolMarks marks;

  /// Doubles with short mantissas, such as 2.0 and 2.5, differ only in their upper bits. So the upper half is mixed
  /// into the lower half before the multiplication.
  static std::uint32_t HashOf(std::uint64_t bits) {
    bits ^= bits >> 32;
    return static_cast<std::uint32_t>((bits * 0x9E3779B97F4A7C15ull) >> 32);
  }
  bool Is(std::uint32_t, std::uint64_t key) const { return bits == key; }
  std::uint32_t Hash() const { return HashOf(bits); }
};

/// Interned constants of one kind. Entries have stable indices, from `first_index` on, and are found by their contents
/// through a hash index with open addressing. Freed entries are reused, the last freed first.
///
/// Invariant: the index contains exactly the live entries and is at most half full. About half of all searches are for
/// constants that are not in the pool. Such a search ends at an empty position, so it is short only if many positions
/// are empty.
template <typename Entry>
class ConstantPool {
 public:
  static constexpr std::uint32_t kNotFound = 0xFFFFFFFFu;

  std::uint32_t first_index() const { return first_; }
  std::uint32_t end_index() const { return first_ + static_cast<std::uint32_t>(entries_.size()); }
  const std::vector<Entry>& entries() const { return entries_; }
  std::size_t live() const { return live_; }

  Entry& operator[](std::uint32_t index) { return entries_[index - first_]; }
  const Entry& operator[](std::uint32_t index) const { return entries_[index - first_]; }

  template <typename Key>
  std::uint32_t Find(std::uint32_t hash, const Key& key) const {
    if (slots_.empty()) {
      return kNotFound;
    }
    const std::uint32_t slot = slots_[Search(hash, key)];
    return slot == 0 ? kNotFound : first_ + slot - 1;
  }

  /// Returns the index of the entry with this key. If there is none, adds the entry that `make()` returns.
  template <typename Key, typename Make>
  std::uint32_t FindOrAdd(std::uint32_t hash, const Key& key, Make make) {
    if (!slots_.empty()) {
      const std::uint32_t at = Search(hash, key);
      if (slots_[at] != 0) {
        return first_ + slots_[at] - 1;
      }
      if ((live_ + 1) * 2 <= slots_.size()) {
        const std::uint32_t local = Place(make());
        slots_[at] = local + 1;
        return first_ + local;
      }
    }
    return Add(make());
  }

  /// Adds an entry, which must not be present, and returns its index.
  std::uint32_t Add(const Entry& entry) {
    if ((live_ + 1) * 2 > slots_.size()) {
      Rehash(slots_.empty() ? 16 : slots_.size() * 2);
    }
    const std::uint32_t local = Place(entry);
    Enter(local);
    return first_ + local;
  }

  /// Frees the live entries for which `drop(entry)` returns true; `drop` must release what the entry owns. Returns the
  /// number of freed entries.
  template <typename Drop>
  std::size_t FreeIf(Drop drop) {
    const std::size_t first_freed = free_.size();
    for (std::size_t local = 0; local < entries_.size(); ++local) {
      if (entries_[local].marks.Live() && drop(entries_[local])) free_.push_back(static_cast<std::uint32_t>(local));
    }
    const std::size_t freed = free_.size() - first_freed;
    // Closing many gaps one by one costs more than rebuilding the index from the remaining entries.
    const bool rebuild = freed * 4 > live_;
    for (std::size_t n = first_freed; n < free_.size(); ++n) {
      if (!rebuild) Leave(free_[n]);
      entries_[free_[n]] = Entry{};
    }
    live_ -= freed;
    if (rebuild) Rehash(slots_.size());
    return freed;
  }

  /// Replaces all contents by `entries`; the first one gets the index `first_index`.
  void Reset(std::uint32_t first_index, std::vector<Entry> entries) {
    first_ = first_index;
    entries_ = std::move(entries);
    free_ = std::vector<std::uint32_t>();
    live_ = 0;
    for (std::size_t local = entries_.size(); local-- > 0;) {
      if (entries_[local].marks.Live()) {
        ++live_;
      } else {
        free_.push_back(static_cast<std::uint32_t>(local));
      }
    }
    std::size_t size = 16;
    while (live_ * 2 > size) {
      size *= 2;
    }
    slots_ = std::vector<std::uint32_t>();
    if (live_ > 0) {
      Rehash(size);
    }
  }

  std::size_t MemoryBytes() const {
    return entries_.capacity() * sizeof(Entry) + (slots_.capacity() + free_.capacity()) * sizeof(std::uint32_t);
  }

 private:
  /// Returns the position in `slots_` of the entry with this key, or the empty position where it would be inserted.
  template <typename Key>
  std::uint32_t Search(std::uint32_t hash, const Key& key) const {
    const std::uint32_t mask = static_cast<std::uint32_t>(slots_.size()) - 1;
    std::uint32_t at = hash & mask;
    while (slots_[at] != 0 && !entries_[slots_[at] - 1].Is(hash, key)) {
      at = (at + 1) & mask;
    }
    return at;
  }

  /// Stores an entry without adding it to the index. Returns its local index.
  std::uint32_t Place(const Entry& entry) {
    ++live_;
    if (free_.empty()) {
      entries_.push_back(entry);
      return static_cast<std::uint32_t>(entries_.size() - 1);
    }
    const std::uint32_t local = free_.back();
    free_.pop_back();
    entries_[local] = entry;
    return local;
  }

  void Enter(std::uint32_t local) {
    const std::uint32_t mask = static_cast<std::uint32_t>(slots_.size()) - 1;
    std::uint32_t at = entries_[local].Hash() & mask;
    while (slots_[at] != 0) {
      at = (at + 1) & mask;
    }
    slots_[at] = local + 1;
  }

  /// Removes an entry from the index. Moves later entries back, so that no tombstones are needed.
  void Leave(std::uint32_t local) {
    const std::uint32_t mask = static_cast<std::uint32_t>(slots_.size()) - 1;
    std::uint32_t gap = entries_[local].Hash() & mask;
    while (slots_[gap] != local + 1) {
      gap = (gap + 1) & mask;
    }
    for (std::uint32_t at = (gap + 1) & mask; slots_[at] != 0; at = (at + 1) & mask) {
      const std::uint32_t home = entries_[slots_[at] - 1].Hash() & mask;
      if (((at - home) & mask) >= ((at - gap) & mask)) {
        slots_[gap] = slots_[at];
        gap = at;
      }
    }
    slots_[gap] = 0;
  }

  void Rehash(std::size_t size) {
    slots_.assign(size, 0);
    for (std::size_t local = 0; local < entries_.size(); ++local) {
      if (entries_[local].marks.Live()) {
        Enter(static_cast<std::uint32_t>(local));
      }
    }
  }

  std::uint32_t first_ = 0;
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> slots_;  ///< 1 + the local index of an entry, 0 if empty. A power of two.
  std::vector<std::uint32_t> free_;
  std::size_t live_ = 0;
};

}  // namespace soarbox::kernel
