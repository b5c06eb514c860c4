// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <vector>

#include "picture/drawing.h"

namespace soarbox::report {

/// A plot, and a name for its file without an ending.
struct Plot {
  std::string name;
  picture::Drawing drawing;
};

/// The plots of a report, from its data (RunData, SweepData).
///
/// Of a sweep: rates with their intervals; of each number, its distribution, a histogram, and the differences from the
/// first variant; ratings of a tournament. Of a run: a map with everybody's path, and health and speed over time.
std::vector<Plot> PlotsOf(const std::string& data);

}  // namespace soarbox::report
