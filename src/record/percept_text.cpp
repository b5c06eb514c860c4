// SPDX-License-Identifier: BSD-2-Clause
#include "record/percept_text.h"

namespace soarbox::record {

void ApplyPercepts(std::span<const std::string> changes, PerceptValues& values) {
  for (const std::string_view change : changes) {
    if (!change.starts_with('-')) {
      const std::size_t blank = change.find(' ');
      if (blank != std::string_view::npos)
        values.insert_or_assign(std::string(change.substr(0, blank)), std::string(change.substr(blank + 1)));
      continue;
    }
    const std::string_view path = change.substr(1);
    const auto is_below = [&](std::string_view key) {
      return key.starts_with(path) && (key.size() == path.size() || key[path.size()] == '.');
    };
    for (auto at = values.lower_bound(path); at != values.end() && at->first.starts_with(path);)
      at = is_below(at->first) ? values.erase(at) : std::next(at);
  }
}

}  // namespace soarbox::record
