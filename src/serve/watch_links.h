// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "diagnostics/result.h"
#include "serve/place.h"

namespace soarbox::serve {

/// Links by which others watch the run of a place and change nothing. A link does not hold the id of the place, which
/// is its secret. A place has at most one; if it is withdrawn, the next one is another. Kept on the disk.
class WatchLinks {
 public:
  explicit WatchLinks(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// The id of the place's link; empty: it has none.
  std::string Find(const Place& place) const;
  /// Likewise; makes it if there is none.
  Result<std::string> FindOrMake(const Place& place) const;
  void Withdraw(const Place& place) const;
  /// The id of the place that a link leads to; the error says that it leads nowhere.
  Result<std::string> PlaceOf(std::string_view link) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace soarbox::serve
