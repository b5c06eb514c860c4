// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "debugger/scene_shapes.h"
#include "viewer/overlay_painter.h"

namespace soarbox::viewer {

/// Paints the imagined scene of the selected agent over the world: each shape as wire and surface, and the lines of the
/// selected answer with its value.
void PaintImagined(const std::vector<debugger::SceneShape>& shapes, const debugger::AnswerLines& answer,
                   OverlayMarks& marks);

}  // namespace soarbox::viewer
