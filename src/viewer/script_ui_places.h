// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "viewer/label_layout.h"
#include "viewer/picking.h"
#include "world/scene_snapshot.h"

namespace soarbox::viewer {

/// The screen size that a script received at the start, and the size that is available now. Panels around the picture
/// make it smaller than the window.
struct ScreenRoom {
  float width = 0, height = 0;                ///< Of the picture.
  float window_width = 0, window_height = 0;  ///< Of the window.
};

/// Positions of the panels of scripts in the picture. A panel that was placed for the entire window and would be
/// outside of the picture is moved into it. Valid while the snapshot exists.
class ScriptUiPlaces {
 public:
  ScriptUiPlaces(const world::SceneSnapshot& snapshot, const ScreenRoom& room);

  /// The corner of a panel, and the root of its tree of panels.
  struct Stand {
    ScreenPoint corner;
    const world::UiSnapshot* top = nullptr;
  };
  Stand Of(const world::UiSnapshot& ui) const;

 private:
  std::unordered_map<std::uint32_t, const world::UiSnapshot*> by_id_;
  ScreenRoom room_;
};

/// 1 px of a panel in the world.
inline constexpr float kPanelMetresPerPixel = 0.005f;

/// Returns the uppermost button under a pixel; null if there is none. A button in the world is found from both sides.
const world::UiSnapshot* ButtonAt(const world::SceneSnapshot& snapshot, const ScreenRoom& room,
                                  const Projection& projection, ScreenPoint pixel);

/// The parts of the picture that these panels cover. Does not include panels in the world.
std::vector<ScreenBox> BoxesOfScriptUi(const world::SceneSnapshot& snapshot, const ScreenRoom& room);

}  // namespace soarbox::viewer
