// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "viewer/label_layout.h"
#include "viewer/panel_host.h"
#include "viewer/picking.h"

namespace soarbox::viewer {

/// What a script knows of the screen, and what it has: panels around the picture leave it less than the window, which
/// is what it was told when it began.
struct ScreenRoom {
  float width = 0, height = 0;                ///< Of the picture.
  float window_width = 0, window_height = 0;  ///< Of the window.
};

/// Draws the panels that scripts make (lua_api.md section 10): gradients, plain text, markup, children, panels in the
/// world. Text that would cross the right or bottom edge of its box is cut there. A panel that was placed for the whole
/// window and would lie beside the picture is moved into it.
void DrawScriptUi(const world::SceneSnapshot& snapshot, const Projection& projection, const PanelHost& host,
                  const ScreenRoom& room);

/// Where those of them stand on the screen that hide what is behind them.
std::vector<ScreenBox> BoxesOfScriptUi(const world::SceneSnapshot& snapshot, const ScreenRoom& room);

}  // namespace soarbox::viewer
