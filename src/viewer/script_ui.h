// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "viewer/panel_host.h"
#include "viewer/picking.h"
#include "viewer/script_ui_places.h"

namespace soarbox::viewer {

/// Draws the panels that scripts make (lua_api.md section 10): gradients, plain text, markup, children, panels in the
/// world. Text that would cross the right or bottom edge of its box is cut there.
void DrawScriptUi(const world::SceneSnapshot& snapshot, const Projection& projection, const PanelHost& host,
                  const ScreenRoom& room);

}  // namespace soarbox::viewer
