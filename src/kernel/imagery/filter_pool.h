// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "kernel/imagery/filter.h"
#include "kernel/imagery/status_line.h"

namespace soarbox::kernel::imagery {

/// The filters of a scene. Equal filters are shared and computed once. The results of a filter depend on when it was
/// first computed (which nodes existed, which position was the first). Therefore only filters that begin in the same
/// look are equal. Constants and timeless filters (FilterKind) are always equal.
///
/// A look is one round over all extracts of a state. The changes of its filters can be read until it ends.
class FilterPool {
 public:
  using Make = std::function<std::shared_ptr<Filter>()>;

  FilterPool() = default;
  FilterPool(const FilterPool&) = delete;
  FilterPool& operator=(const FilterPool&) = delete;

  std::uint64_t look() const { return look_; }
  /// Call it after all readers have read: clears the changes of the filters.
  void EndLook();
  /// Returns the filter with this description; creates it if there is none.
  std::shared_ptr<Filter> Share(const std::string& description, const Make& make);

  // Called by filters.
  /// Returns a number that is unique among filters.
  std::uint64_t Enter(const Filter& filter);
  void NoteUpdate(Filter& filter) { updated_.push_back(&filter); }
  void Leave(const Filter& filter);

  std::size_t MemoryBytes() const;

 private:
  std::uint64_t look_ = 1, last_serial_ = 0;
  std::vector<Filter*> updated_;  ///< The filters updated in this look.
  std::unordered_set<const Filter*> filters_;
  std::unordered_map<std::string, std::weak_ptr<Filter>> shared_;
  std::size_t tidy_at_ = 64;
};

/// A filter as rules specified it: the computation, which may be shared, and the statuses on the rules' identifiers.
class FilterUse {
 public:
  FilterUse(MemoryWriter& writer, Symbol owner, std::shared_ptr<Filter> filter,
            std::vector<std::unique_ptr<FilterUse>> parameters)
      : status_(writer, owner), filter_(std::move(filter)), parameters_(std::move(parameters)) {}

  Filter& filter() { return *filter_; }
  const Filter& filter() const { return *filter_; }
  const std::shared_ptr<Filter>& shared() const { return filter_; }
  /// Call after an update: writes the statuses of the parameters, then that of the filter itself.
  void TellParameters();
  void Tell();
  /// Calls `mark` for each symbol that the filter and its parameters refer to.
  void Mark(const std::function<void(Symbol)>& mark) const;

 private:
  StatusLine status_;
  std::shared_ptr<Filter> filter_;
  std::vector<std::unique_ptr<FilterUse>> parameters_;
};

}  // namespace soarbox::kernel::imagery
