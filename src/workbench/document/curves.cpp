// SPDX-License-Identifier: BSD-2-Clause
#include "workbench/document/curves.h"

#include <algorithm>

namespace soarbox::workbench::document {

std::vector<std::pair<double, double>> Thinned(std::vector<std::pair<double, double>> points) {
  if (points.size() <= kMostPoints) return points;
  std::vector<std::pair<double, double>> kept{points.front()};
  const std::size_t parts = kMostPoints / 2 - 1, inner = points.size() - 2;
  for (std::size_t part = 0; part < parts; ++part) {
    const auto first = points.begin() + static_cast<std::ptrdiff_t>(1 + inner * part / parts);
    const auto last = points.begin() + static_cast<std::ptrdiff_t>(1 + inner * (part + 1) / parts);
    if (first == last) continue;
    const auto by_value = [](const auto& a, const auto& b) { return a.second < b.second; };
    auto [least, most] = std::minmax_element(first, last, by_value);
    if (most < least) std::swap(least, most);
    kept.push_back(*least);
    if (least != most) kept.push_back(*most);
  }
  kept.push_back(points.back());
  return kept;
}

}  // namespace soarbox::workbench::document
