// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/imagery/filter_kinds.h"

#include <algorithm>

namespace soarbox::kernel::imagery {

std::span<const FilterKind> FilterKinds() {
  static const std::vector<FilterKind> kKinds = [] {
    std::vector<FilterKind> kinds;
    AppendNodeFilters(kinds);
    AppendMeasureFilters(kinds);
    AppendOtherFilters(kinds);
    std::sort(kinds.begin(), kinds.end(), [](const FilterKind& a, const FilterKind& b) { return a.name < b.name; });
    return kinds;
  }();
  return kKinds;
}

const FilterKind* FindFilterKind(std::string_view name) {
  for (const FilterKind& kind : FilterKinds()) {
    if (kind.name == name) return &kind;
  }
  return nullptr;
}

}  // namespace soarbox::kernel::imagery
