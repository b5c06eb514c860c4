// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <utility>
#include <vector>

namespace soarbox::workbench::document {

/// Reduces a curve to at most kMostPoints points: keeps the minimum and the maximum of each interval of time.
std::vector<std::pair<double, double>> Thinned(std::vector<std::pair<double, double>> points);
inline constexpr std::size_t kMostPoints = 600;

}  // namespace soarbox::workbench::document
