// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "viewer/panel_host.h"
#include "viewer/picking.h"
#include "viewer/viewer.h"
#include "world/overlay_snapshot.h"

namespace soarbox::viewer {

/// What labels are made from.
struct LabelScene {
  const std::vector<world::AgentSnapshot>& agents;
  const world::OverlaySnapshot& overlays;
  const std::vector<std::uint32_t>& selection;
  std::uint32_t hovered = 0;
  std::uint32_t hidden = 0;  ///< The agent whose eyes the camera looks out of.
};

/// A part of the picture that is taken; in px.
struct ScreenBox {
  float left = 0, top = 0, right = 0, bottom = 0;
};

/// Puts name, state and health above each agent and keeps them apart: a label that would cover a nearer one moves up a
/// little, and loses its second line or goes if that does not help. Selected ones always stay. They keep out of
/// `taken` and add themselves to it.
void DrawAgentLabels(const PanelHost& host, const LabelScene& scene, const world::CameraSnapshot& camera,
                     const Projection& projection, std::vector<ScreenBox>& taken);

/// What agents say, in bubbles beside their heads; adds these to `taken`.
void DrawSpeech(const PanelHost& host, const LabelScene& scene, const Projection& projection,
                std::vector<ScreenBox>& taken);

/// The names of figures that are not there, clear of what is taken.
void DrawGhostLabels(const PanelHost& host, const std::vector<Ghost>& ghosts, const Projection& projection,
                     const std::vector<ScreenBox>& taken);

/// What there is to say about the agent under the cursor.
void DrawTooltip(const PanelHost& host, const world::AgentSnapshot& agent, const world::OverlaySnapshot& overlays,
                 ScreenPoint cursor);

/// The box that the user draws to select what is in it.
void DrawSelectionBox(ScreenPoint from, ScreenPoint to);

/// A remark in the lower middle of the picture; opacity 0..1.
void DrawNotice(const PanelHost& host, const std::string& text, float opacity);

/// The overlay of an agent; null if there is none.
const world::AgentOverlay* OverlayOf(const world::OverlaySnapshot& overlays, std::uint32_t agent_id);

}  // namespace soarbox::viewer
