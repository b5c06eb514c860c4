// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "diagnostics/result.h"
#include "serve/place.h"

namespace soarbox::serve {

/// Links with which others can watch the run of a place, but not change anything. A link does not contain the id of the
/// place, which is its secret. A place has at most one link. After it was withdrawn, the next link is different. Stored
/// on the disk.
class WatchLinks {
 public:
  explicit WatchLinks(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// The id of the place's link; empty if it has none.
  std::string Find(const Place& place) const;
  /// The same; creates the link if there is none.
  Result<std::string> FindOrMake(const Place& place) const;
  void Withdraw(const Place& place) const;
  /// The id of the place that a link refers to. Fails if the link is not valid.
  Result<std::string> PlaceOf(std::string_view link) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace soarbox::serve
