// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <vector>

#include "picture/drawing.h"

namespace soarbox::report {

/// A plot, and a name for its file without an extension.
struct Plot {
  std::string name;
  picture::Drawing drawing;
};

/// The plots of a report, from its data (RunData, SweepData).
///
/// For a sweep: rates with their intervals; for each number, its distribution, a histogram, and the differences from
/// the first variant; ratings of a tournament. For a run: a map with the paths of all agents, and health and speed over
/// time.
std::vector<Plot> PlotsOf(const std::string& data);

}  // namespace soarbox::report
