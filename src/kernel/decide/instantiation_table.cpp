// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/decide/instantiation_table.h"

namespace soarbox::kernel {

InstantiationId InstantiationTable::Make() {
  InstantiationId id;
  if (!free_.empty()) {
    id = free_.back();
    free_.pop_back();
    records_[Index(id)] = Instantiation{};
  } else {
    id = static_cast<InstantiationId>(records_.size());
    records_.emplace_back();
  }
  Instantiation& record = records_[Index(id)];
  record.live = true;
  record.serial = next_serial_++;
  ++live_;
  return id;
}

void InstantiationTable::Free(InstantiationId id) {
  Instantiation& record = records_[Index(id)];
  if (record.trace_count > 0) {
    if (free_traces_.size() <= record.trace_count) free_traces_.resize(record.trace_count + 1u);
    free_traces_[record.trace_count].push_back(record.first_trace);
  }
  record.live = false;
  record.trace_count = 0;
  free_.push_back(id);
  --live_;
}

std::span<ConditionTrace> InstantiationTable::MakeTrace(InstantiationId id, std::size_t count) {
  Instantiation& record = records_[Index(id)];
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

std::span<const ConditionTrace> InstantiationTable::Trace(InstantiationId id) const {
  const Instantiation& record = records_[Index(id)];
  return {traces_.data() + record.first_trace, record.trace_count};
}

std::span<ConditionTrace> InstantiationTable::MutableTrace(InstantiationId id) {
  const Instantiation& record = records_[Index(id)];
  return {traces_.data() + record.first_trace, record.trace_count};
}

void InstantiationTable::Clear() {
  records_.clear();
  free_.clear();
  traces_.clear();
  free_traces_.clear();
  live_ = 0;
  next_serial_ = 1;
}

std::size_t InstantiationTable::MemoryBytes() const {
  return records_.capacity() * sizeof(Instantiation) + free_.capacity() * sizeof(InstantiationId) +
         traces_.capacity() * sizeof(ConditionTrace);
}

}  // namespace soarbox::kernel
