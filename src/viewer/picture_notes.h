// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

#include "viewer/label_layout.h"
#include "viewer/panel_host.h"
#include "viewer/picking.h"
#include "world/overlay_snapshot.h"

namespace soarbox::viewer {

/// Draws a tooltip about the agent under the cursor.
void DrawTooltip(const PanelHost& host, const world::AgentSnapshot& agent, const world::OverlaySnapshot& overlays);

/// Draws the box of a selection in progress.
void DrawSelectionBox(ScreenPoint from, ScreenPoint to);

/// Draws the time of the scene in the upper left corner, for pictures without a toolbar. Returns the covered box.
ScreenBox DrawClock(const PanelHost& host, const world::SceneSnapshot& scene);

/// Draws a remark in the lower middle of the picture; opacity 0..1.
void DrawNotice(const PanelHost& host, const std::string& text, float opacity);

}  // namespace soarbox::viewer
