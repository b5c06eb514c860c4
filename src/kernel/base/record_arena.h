// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <vector>

#include "kernel/base/ids.h"

namespace soarbox::kernel {

/// The records of one kind that an agent owns. Records never move: a RecordId is a pointer, and references stay valid
/// while other records are allocated. Freed records are reused, the last freed first, so the steady state does not
/// allocate. `kNextFree` is the member that links free records; Give overwrites it.
template <typename Record, RecordId<Record> Record::*kNextFree>
class RecordArena {
  static_assert(std::is_trivially_destructible_v<Record>);

 public:
  /// Returns a record with its default contents.
  RecordId<Record> Take() {
    if (free_ == RecordId<Record>::kNone) [[unlikely]]
      Grow();
    const RecordId<Record> taken = free_;
    free_ = (*taken.record).*kNextFree;
    *taken.record = Record{};
    return taken;
  }
  void Give(RecordId<Record> record) {
    (*record.record).*kNextFree = free_;
    free_ = record;
  }
  /// Visits every allocated record, in use or free. The order depends only on earlier calls.
  template <typename Visit>
  void ForEach(Visit&& visit) const {
    for (const Slab& slab : slabs_) {
      for (std::size_t n = 0; n < slab.size; ++n) visit(RecordId<Record>{&slab.records[n]});
    }
  }
  /// Frees all records; keeps the memory.
  void Clear() {
    free_ = {};
    for (std::size_t n = slabs_.size(); n-- > 0;) {
      std::fill_n(slabs_[n].records.get(), slabs_[n].size, Record{});
      LinkFree(slabs_[n]);
    }
  }
  std::size_t MemoryBytes() const {
    std::size_t bytes = slabs_.capacity() * sizeof(Slab);
    for (const Slab& slab : slabs_) bytes += slab.size * sizeof(Record);
    return bytes;
  }

 private:
  /// The first slab fits a small agent. Each later one doubles the total, up to a limit that bounds the waste.
  static constexpr std::size_t kFirst = 8, kLargest = 2048;
  struct Slab {
    std::unique_ptr<Record[]> records;
    std::size_t size;
  };

  /// Frees all records of a slab, which must have their default contents.
  void LinkFree(const Slab& slab) {
    for (std::size_t n = slab.size; n-- > 0;) Give(RecordId<Record>{&slab.records[n]});
  }
  [[gnu::noinline, gnu::cold]] void Grow() {
    std::size_t size = kFirst;
    if (!slabs_.empty()) size = std::min(slabs_.back().size * (slabs_.size() > 1 ? 2 : 1), kLargest);
    slabs_.push_back({std::make_unique<Record[]>(size), size});
    LinkFree(slabs_.back());
  }

  RecordId<Record> free_;
  std::vector<Slab> slabs_;
};

}  // namespace soarbox::kernel
