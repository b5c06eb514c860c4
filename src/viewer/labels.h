// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "viewer/label_layout.h"
#include "viewer/picking.h"
#include "viewer/viewer.h"
#include "world/overlay_snapshot.h"

struct ImFont;

namespace soarbox::viewer {

/// What labels are made from.
struct LabelScene {
  const std::vector<world::AgentSnapshot>& agents;
  const world::OverlaySnapshot& overlays;
  const std::vector<std::uint32_t>& selection;
  std::uint32_t hovered = 0;
  std::uint32_t hidden = 0;  ///< The agent whose eyes the camera looks out of.
  std::span<const Ghost> ghosts = {};
  bool names = true, speech = true;         ///< Which of them are on.
  float top_px = 0;                         ///< A bar over the picture ends here.
  std::span<const ScreenBox> blocked = {};  ///< Where something else stands in the picture.
};

/// Something that the labels of a frame say, and where.
struct ShownLabel {
  enum class Kind : std::uint8_t {
    kName,    ///< Team, name, state and health.
    kDot,     ///< An agent without room for its name.
    kCrowd,   ///< How many of each team stand where there is no room for names.
    kSpeech,  ///< What one or several say.
    kGhost,   ///< The name of a ghost.
    kPlace,   ///< The name of a waypoint, a region, a thing or an item.
  };
  Kind kind = Kind::kName;
  std::uint32_t agent_id = 0;  ///< 0: several, or none.
  ScreenBox box;
  bool is_short = false;
};

/// Names above agents and bubbles for what they say. No two cover each other, and none is cut by the picture's edge:
/// the selected and the nearest come first; a label without room is shortened, then becomes a dot, then part of a
/// crowd's number. A label stays where it stood in the frame before, if it can.
class AgentLabels {
 public:
  /// Draws them behind the panels of ImGui's present frame, into a picture of ImGui's display size.
  void Draw(ImFont* name_font, ImFont* text_font, const LabelScene& scene, const world::CameraSnapshot& camera,
            const Projection& projection);

  /// What the last Draw drew.
  const std::vector<ShownLabel>& shown() const { return shown_; }
  /// The agent whose label the last Draw drew there; 0 if there is none, or one of several agents.
  std::uint32_t AgentAt(ScreenPoint pixel) const;

 private:
  std::vector<ShownLabel> shown_;
  std::unordered_map<std::uint64_t, int> places_;  ///< By kind and agent: where it stood.
};

/// The overlay of an agent; null if there is none.
const world::AgentOverlay* OverlayOf(const world::OverlaySnapshot& overlays, std::uint32_t agent_id);

/// Its name, of a length that labels can show.
std::string ScoreText(float score);
std::string LabelName(const world::AgentSnapshot& agent);

}  // namespace soarbox::viewer
