// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "viewer/label_layout.h"
#include "viewer/panel_host.h"
#include "viewer/picking.h"
#include "viewer/viewer.h"

namespace soarbox::viewer {

/// The window's own overlays, drawn in each frame.

inline constexpr float kStatusBar_px = 26;  ///< Its height.

/// Returns the area in which cards may be placed in a picture of this size.
ScreenBox AreaOfCards(float width_px, float height_px);

/// Draws a bar along the top: running or paused, time, tick, speed, agents, frames per second (0: not shown).
void DrawStatusBar(const PanelHost& host, const RunStatus& status, const world::SceneSnapshot& scene,
                   float frames_per_second);

/// Draws the list of keys in the middle of the window.
void DrawKeyHelp(const PanelHost& host);

/// Draws a card about the selected agent in a corner. Returns its box.
ScreenBox DrawAgentCard(const PanelHost& host, const world::AgentSnapshot& agent, bool followed, Corner corner);

}  // namespace soarbox::viewer
