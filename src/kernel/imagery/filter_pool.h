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

/// The filters of a scene. Filters that are alike are shared and computed once. What a filter found depends on when it
/// was first computed (which nodes existed, which place was the first), so only filters that begin in the same look are
/// alike. Constants and timeless filters (FilterKind) are always alike.
///
/// A look is one round over all extracts of a state. You can read the changes of its filters until it ends.
class FilterPool {
 public:
  using Make = std::function<std::shared_ptr<Filter>()>;

  FilterPool() = default;
  FilterPool(const FilterPool&) = delete;
  FilterPool& operator=(const FilterPool&) = delete;

  std::uint64_t look() const { return look_; }
  /// Call when all readers have read: forgets what the filters changed.
  void EndLook();
  /// The filter with this description, or a new one.
  std::shared_ptr<Filter> Share(const std::string& description, const Make& make);

  // For filters.
  /// Returns a number that no other filter has.
  std::uint64_t Enter(const Filter& filter);
  void NoteUpdate(Filter& filter) { updated_.push_back(&filter); }
  void Leave(const Filter& filter);

  std::size_t MemoryBytes() const;

 private:
  std::uint64_t look_ = 1, last_serial_ = 0;
  std::vector<Filter*> updated_;  ///< In this look.
  std::unordered_set<const Filter*> filters_;
  std::unordered_map<std::string, std::weak_ptr<Filter>> shared_;
  std::size_t tidy_at_ = 64;
};

/// A filter as rules described it: the computation, which others may share, and the statuses on its identifiers.
class FilterUse {
 public:
  FilterUse(MemoryWriter& writer, Symbol owner, std::shared_ptr<Filter> filter,
            std::vector<std::unique_ptr<FilterUse>> parameters)
      : status_(writer, owner), filter_(std::move(filter)), parameters_(std::move(parameters)) {}

  Filter& filter() { return *filter_; }
  const Filter& filter() const { return *filter_; }
  const std::shared_ptr<Filter>& shared() const { return filter_; }
  /// After an update: writes the statuses of the parameters, then that of the filter itself.
  void TellParameters();
  void Tell();
  /// Calls `mark` for each symbol that the filter and its parameters hold.
  void Mark(const std::function<void(Symbol)>& mark) const;

 private:
  StatusLine status_;
  std::shared_ptr<Filter> filter_;
  std::vector<std::unique_ptr<FilterUse>> parameters_;
};

}  // namespace soarbox::kernel::imagery
