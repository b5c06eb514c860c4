// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>
#include <string>
#include <vector>

#include "viewer/panels/panel.h"

namespace soarbox::viewer {

/// A curve of a graph: ticks in order, with values. At most some hundred points.
struct GraphCurve {
  std::string name;
  ImVec4 color;
  std::vector<std::pair<double, double>> points;
};

/// Draws curves over time in a box of this height, with their range, the current moment, and the values under the
/// mouse. A click goes to that moment. `is_stepped`: a value lasts until the next one.
void DrawGraph(PanelFrame& frame, const char* id, std::span<const GraphCurve> curves, float height, double first_tick,
               double last_tick, bool is_stepped = false);

/// Draws the times below such graphs, once for all graphs above each other.
void DrawTimeAxis(PanelFrame& frame, double first_tick, double last_tick);
/// Height of the time axis.
float TimeAxisHeight();

}  // namespace soarbox::viewer
