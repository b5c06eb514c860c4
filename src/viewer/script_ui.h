// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "viewer/label_layout.h"
#include "viewer/panel_host.h"
#include "viewer/picking.h"

namespace soarbox::viewer {

/// Draws the panels that scripts make (lua_api.md section 10): gradients, plain text, markup, children, panels in the
/// world. Text that would cross the right or bottom edge of its box is cut there.
void DrawScriptUi(const world::SceneSnapshot& snapshot, const Projection& projection, const PanelHost& host);

/// Where those of them stand on the screen that hide what is behind them.
std::vector<ScreenBox> BoxesOfScriptUi(const world::SceneSnapshot& snapshot);

}  // namespace soarbox::viewer
