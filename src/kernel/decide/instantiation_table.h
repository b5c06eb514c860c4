// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernel/base/record_arena.h"
#include "kernel/decide/instantiation.h"

namespace soarbox::kernel {

/// The instantiations of an agent and the traces of their conditions, in arenas with free lists.
class InstantiationTable {
 public:
  /// With room for a small agent, so that its first decisions cost what the later ones do.
  InstantiationTable() { traces_.reserve(32); }

  InstantiationId Make();
  /// Numbers that no instantiation gets: Soar counts those that were begun and given up, too.
  void SkipSerials(std::uint32_t count) { next_serial_ += count; }
  std::uint32_t last_serial() const { return next_serial_ - 1; }
  /// Gives the record and its trace back; the caller has dropped what the trace refers to.
  void Free(InstantiationId id);
  Instantiation& operator[](InstantiationId id) { return *id.record; }
  const Instantiation& operator[](InstantiationId id) const { return *id.record; }

  /// Room for the trace of an instantiation.
  std::span<ConditionTrace> MakeTrace(InstantiationId id, std::size_t count);
  /// Adds to the trace of an instantiation; never more than 65,535 in all.
  void ExtendTrace(InstantiationId id, std::span<const ConditionTrace> more);
  std::span<const ConditionTrace> Trace(InstantiationId id) const;

  template <typename Visit>
  void ForEach(Visit&& visit) const {
    records_.ForEach([&](InstantiationId id) {
      if (id.record->live) visit(*id.record);
    });
  }
  std::uint32_t live_count() const { return live_; }
  void Clear();
  std::size_t MemoryBytes() const;

 private:
  RecordArena<Instantiation, &Instantiation::next_free> records_;
  std::vector<ConditionTrace> traces_;
  std::vector<std::vector<std::uint32_t>> free_traces_;  ///< By length.
  std::uint32_t live_ = 0;
  std::uint32_t next_serial_ = 1;
};

}  // namespace soarbox::kernel
