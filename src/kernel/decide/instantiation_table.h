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
  /// Reserves memory for a small agent, so that its first decisions do not allocate more than later ones.
  InstantiationTable() { traces_.reserve(32); }

  InstantiationId Make();
  /// Skips serial numbers: Soar also counts instantiations that were started and discarded.
  void SkipSerials(std::uint32_t count) { next_serial_ += count; }
  std::uint32_t last_serial() const { return next_serial_ - 1; }
  /// Frees the record and its trace. The caller must have released what the trace refers to.
  void Free(InstantiationId id);
  Instantiation& operator[](InstantiationId id) { return *id.record; }
  const Instantiation& operator[](InstantiationId id) const { return *id.record; }

  /// Allocates the trace of an instantiation.
  std::span<ConditionTrace> MakeTrace(InstantiationId id, std::size_t count);
  /// Appends to the trace of an instantiation. The total length must not exceed 65,535.
  void ExtendTrace(InstantiationId id, std::span<const ConditionTrace> more);
  std::span<const ConditionTrace> Trace(InstantiationId id) const;

  template <typename Visit>
  void ForEach(Visit&& visit) const {
    records_.ForEach([&](InstantiationId id) {
      if (id.record->live) visit(*id.record);
    });
  }
  void Clear();
  std::size_t MemoryBytes() const;

 private:
  RecordArena<Instantiation, &Instantiation::next_free> records_;
  std::vector<ConditionTrace> traces_;
  std::vector<std::vector<std::uint32_t>> free_traces_;  ///< By length of the trace.
  std::uint32_t next_serial_ = 1;
};

}  // namespace soarbox::kernel
