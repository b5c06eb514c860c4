// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "debugger/scene_shapes.h"
#include "viewer/overlay_painter.h"

namespace soarbox::viewer {

/// What the selected agent imagines, over the world: wire and skin of each shape, and the lines of the answer that is
/// looked at with its value.
void PaintImagined(const std::vector<debugger::SceneShape>& shapes, const debugger::AnswerLines& answer,
                   OverlayMarks& marks);

}  // namespace soarbox::viewer
