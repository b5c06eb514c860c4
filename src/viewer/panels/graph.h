// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>
#include <string>
#include <vector>

#include "viewer/panels/panel.h"

namespace soarbox::viewer {

/// One curve of a graph: ticks in order, and values.
struct GraphCurve {
  std::string name;
  ImVec4 color;
  std::vector<std::pair<double, double>> points;
};

/// Draws curves over time into a box of this height, with their range, the present moment, and the values under the
/// mouse. A click goes to that moment. `is_stepped`: values hold until the next.
void DrawGraph(PanelFrame& frame, const char* id, std::span<const GraphCurve> curves, float height, double first_tick,
               double last_tick, bool is_stepped = false);

/// The times below such graphs, one box for all that stand above each other.
void DrawTimeAxis(PanelFrame& frame, double first_tick, double last_tick);
/// The room that it takes.
float TimeAxisHeight();

}  // namespace soarbox::viewer
