// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "viewer/panel_host.h"
#include "viewer/panel_images.h"
#include "viewer/picking.h"
#include "viewer/script_ui_places.h"

namespace soarbox::viewer {

/// Ids of the button under the pointer and of the button that is held down; 0: none.
struct ButtonState {
  std::uint32_t hovered = 0, held = 0;
};

/// Draws the panels that scripts create (lua_api.md section 10): gradients, images, bars, plain text, markup, buttons,
/// children, panels in the world. Text that would cross the right or bottom edge of its box is cut there.
void DrawScriptUi(const world::SceneSnapshot& snapshot, const Projection& projection, const PanelHost& host,
                  const ScreenRoom& room, PanelImages& images, const ButtonState& buttons);

}  // namespace soarbox::viewer
