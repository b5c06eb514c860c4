// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/decide/instantiation_table.h"

#include <algorithm>

namespace soarbox::kernel {

InstantiationId InstantiationTable::Make() {
  const InstantiationId id = records_.Take();
  Instantiation& record = *id.record;
  record.live = true;
  record.serial = next_serial_++;
  return id;
}

void InstantiationTable::Free(InstantiationId id) {
  Instantiation& record = *id.record;
  if (record.trace_count > 0) {
    if (free_traces_.size() <= record.trace_count) free_traces_.resize(record.trace_count + 1u);
    free_traces_[record.trace_count].push_back(record.first_trace);
  }
  record.live = false;
  record.trace_count = 0;
  records_.Give(id);
}

std::span<ConditionTrace> InstantiationTable::MakeTrace(InstantiationId id, std::size_t count) {
  Instantiation& record = *id.record;
  record.trace_count = static_cast<std::uint16_t>(count);
  if (count < free_traces_.size() && !free_traces_[count].empty()) {
    record.first_trace = free_traces_[count].back();
    free_traces_[count].pop_back();
  } else {
    record.first_trace = static_cast<std::uint32_t>(traces_.size());
    traces_.resize(traces_.size() + count);
  }
  return {traces_.data() + record.first_trace, count};
}

void InstantiationTable::ExtendTrace(InstantiationId id, std::span<const ConditionTrace> more) {
  const Instantiation before = *id.record;
  const std::span<ConditionTrace> traces = MakeTrace(id, before.trace_count + more.size());
  std::copy_n(traces_.begin() + before.first_trace, before.trace_count, traces.begin());
  std::copy(more.begin(), more.end(), traces.begin() + before.trace_count);
  if (before.trace_count == 0) return;
  if (free_traces_.size() <= before.trace_count) free_traces_.resize(before.trace_count + 1u);
  free_traces_[before.trace_count].push_back(before.first_trace);
}

std::span<const ConditionTrace> InstantiationTable::Trace(InstantiationId id) const {
  const Instantiation& record = *id.record;
  return {traces_.data() + record.first_trace, record.trace_count};
}

void InstantiationTable::Clear() {
  records_.Clear();
  traces_.clear();
  free_traces_.clear();
  next_serial_ = 1;
}

std::size_t InstantiationTable::MemoryBytes() const {
  return records_.MemoryBytes() + traces_.capacity() * sizeof(ConditionTrace);
}

}  // namespace soarbox::kernel
