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

/// Input of the labels of a frame.
struct LabelScene {
  const std::vector<world::AgentSnapshot>& agents;
  const world::OverlaySnapshot& overlays;
  const std::vector<std::uint32_t>& selection;
  std::uint32_t hovered = 0;
  std::uint32_t hidden = 0;  ///< The agent through whose eyes the camera looks.
  std::span<const Ghost> ghosts = {};
  bool names = true, speech = true;         ///< Which labels are switched on.
  std::span<const ScreenBox> blocked = {};  ///< Parts of the picture that other things cover.
};

/// A label of the last frame, with its place.
struct ShownLabel {
  enum class Kind : std::uint8_t {
    kName,    ///< Team, name, state and health.
    kDot,     ///< An agent without space for its name.
    kSpeech,  ///< Speech of one or several agents.
    kGhost,   ///< The name of a ghost.
    kPlace,   ///< The name of a waypoint, a region, a thing or an item.
  };
  Kind kind = Kind::kName;
  std::uint32_t agent_id = 0;  ///< 0: several, or none.
  ScreenBox box;
  bool is_short = false;
};

/// Names above agents, and speech bubbles. Labels do not cover each other and are not cut by the picture's edge. The
/// selected and the nearest agents have priority. If there is no space for a label, it is shortened, then replaced by a
/// dot. A label keeps its place from frame to frame if it can.
class AgentLabels {
 public:
  /// Draws them below the panels of ImGui's current frame, in a picture of ImGui's display size.
  void Draw(ImFont* name_font, ImFont* text_font, const LabelScene& scene, const world::CameraSnapshot& camera,
            const Projection& projection);

  /// The labels of the last Draw().
  const std::vector<ShownLabel>& shown() const { return shown_; }
  /// Returns the agent whose label the last Draw() placed there; 0 if there is none, or if the label belongs to several
  /// agents.
  std::uint32_t AgentAt(ScreenPoint pixel) const;

 private:
  std::vector<ShownLabel> shown_;
  std::unordered_map<std::uint64_t, int> places_;  ///< Last place of each label, by kind and agent.
};

/// Returns the overlay of an agent; null if it has none.
const world::AgentOverlay* OverlayOf(const world::OverlaySnapshot& overlays, std::uint32_t agent_id);

/// Texts for a label, shortened to a length that labels can show.
std::string ScoreText(float score);
std::string LabelName(const world::AgentSnapshot& agent);

}  // namespace soarbox::viewer
