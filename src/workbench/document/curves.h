// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <utility>
#include <vector>

namespace soarbox::workbench::document {

/// At most kMostPoints points of a curve: of many, the least and the greatest of each part of the time.
std::vector<std::pair<double, double>> Thinned(std::vector<std::pair<double, double>> points);
inline constexpr std::size_t kMostPoints = 600;

}  // namespace soarbox::workbench::document
