// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/imagery/filter_pool.h"

#include <algorithm>

namespace soarbox::kernel::imagery {

void FilterPool::EndLook() {
  for (Filter* const filter : updated_) filter->ClearChanges();
  updated_.clear();
  ++look_;
}

std::shared_ptr<Filter> FilterPool::Share(const std::string& description, const Make& make) {
  std::weak_ptr<Filter>& known = shared_[description];
  std::shared_ptr<Filter> filter = known.lock();
  if (filter == nullptr) known = filter = make();
  if (shared_.size() > tidy_at_) {
    std::erase_if(shared_, [](const auto& entry) { return entry.second.expired(); });
    tidy_at_ = 2 * shared_.size() + 64;
  }
  return filter;
}

std::uint64_t FilterPool::Enter(const Filter& filter) {
  filters_.insert(&filter);
  return ++last_serial_;
}

void FilterPool::Leave(const Filter& filter) {
  filters_.erase(&filter);
  std::erase(updated_, &filter);
}

std::size_t FilterPool::MemoryBytes() const {
  std::size_t bytes = (shared_.size() + filters_.size()) * 128;
  for (const Filter* const filter : filters_) bytes += filter->MemoryBytes();
  return bytes;
}

void FilterUse::TellParameters() {
  for (const auto& parameter : parameters_) {
    parameter->Tell();
    if (!parameter->filter_->works()) break;  // The parameters after it were not updated.
  }
}

void FilterUse::Tell() {
  TellParameters();
  for (const std::string& status : filter_->said()) status_.Set(status);
  status_.Set(filter_->status());
}

void FilterUse::Mark(const std::function<void(Symbol)>& mark) const {
  if (status_.owner()) mark(status_.owner());
  if (status_.symbol()) mark(status_.symbol());
  for (const auto& parameter : parameters_) parameter->Mark(mark);
}

}  // namespace soarbox::kernel::imagery
