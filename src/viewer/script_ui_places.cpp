// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/script_ui_places.h"

#include <algorithm>
#include <utility>

namespace soarbox::viewer {
namespace {

using world::UiSnapshot;

/// How far a panel that was placed for the window must move to be in the picture.
float ShiftInto(float begin, float size, float room, float window) {
  constexpr float kMargin_px = 12;
  const float end = begin + size;
  if (begin < 0 || end <= room || end > window) return 0;  // Already in the picture, or intentionally outside.
  return std::max(-begin, std::min(0.0f, room - kMargin_px - end));
}

}  // namespace

ScriptUiPlaces::ScriptUiPlaces(const world::SceneSnapshot& snapshot, const ScreenRoom& room) : room_(room) {
  for (const UiSnapshot& ui : snapshot.ui) by_id_[ui.id] = &ui;
}

ScriptUiPlaces::Stand ScriptUiPlaces::Of(const UiSnapshot& ui) const {
  Stand stand{{ui.x, ui.y}, &ui};
  // Limits the depth to the number of panels, in case of a cycle.
  for (std::size_t depth = 0; stand.top->parent_id != 0 && depth < by_id_.size(); ++depth) {
    const auto parent = by_id_.find(stand.top->parent_id);
    if (parent == by_id_.end()) break;
    stand.top = parent->second;
    stand.corner = {stand.corner.x + stand.top->x, stand.corner.y + stand.top->y};
  }
  if (stand.top->in_world) return stand;
  stand.corner.x += ShiftInto(stand.top->x, stand.top->width, room_.width, room_.window_width);
  stand.corner.y += ShiftInto(stand.top->y, stand.top->height, room_.height, room_.window_height);
  return stand;
}

namespace {

/// The four corners, in the picture, of a panel at `begin` in its tree of panels; none if one is behind the camera.
std::vector<ScreenPoint> CornersInWorld(const UiSnapshot& ui, ScreenPoint begin, const UiSnapshot& top,
                                        const Projection& projection) {
  const world::Vec3 right = Rotate(top.world_orientation, {kPanelMetresPerPixel, 0, 0});
  const world::Vec3 down = Rotate(top.world_orientation, {0, -kPanelMetresPerPixel, 0});
  std::vector<ScreenPoint> corners;
  for (const auto& [x, y] : {std::pair{0.0f, 0.0f}, {ui.width, 0.0f}, {ui.width, ui.height}, {0.0f, ui.height}}) {
    const auto pixel = projection.Project(top.world_position + right * (begin.x + x) + down * (begin.y + y));
    if (!pixel) return {};
    corners.push_back(*pixel);
  }
  return corners;
}

/// Whether a point lies on the same side of all edges.
bool IsInsideRectangle(const std::vector<ScreenPoint>& corners, ScreenPoint at) {
  int left = 0, right = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ScreenPoint a = corners[i], b = corners[(i + 1) % corners.size()];
    const float side = (b.x - a.x) * (at.y - a.y) - (b.y - a.y) * (at.x - a.x);
    ++(side >= 0 ? left : right);
  }
  return !corners.empty() && (left == 0 || right == 0);
}

}  // namespace

const UiSnapshot* ButtonAt(const world::SceneSnapshot& snapshot, const ScreenRoom& room, const Projection& projection,
                           ScreenPoint pixel) {
  const ScriptUiPlaces places(snapshot, room);
  const UiSnapshot* found = nullptr;
  for (const UiSnapshot& ui : snapshot.ui) {
    if (!ui.visible || ui.button.empty() || (found != nullptr && found->layer > ui.layer)) continue;
    const auto [corner, top] = places.Of(ui);
    const bool is_over = top->in_world ? IsInsideRectangle(CornersInWorld(ui, corner, *top, projection), pixel)
                                       : pixel.x >= corner.x && pixel.x < corner.x + ui.width && pixel.y >= corner.y &&
                                             pixel.y < corner.y + ui.height;
    if (is_over) found = &ui;
  }
  return found;
}

std::vector<ScreenBox> BoxesOfScriptUi(const world::SceneSnapshot& snapshot, const ScreenRoom& room) {
  std::vector<ScreenBox> boxes;
  const ScriptUiPlaces places(snapshot, room);
  for (const UiSnapshot& ui : snapshot.ui) {
    const bool hides = ui.has_gradient || ui.has_bar || !ui.button.empty() || !ui.text.empty() || !ui.caption.empty() ||
                       !ui.material.empty();
    if (!ui.visible || !hides || ui.width <= 0 || ui.height <= 0) continue;
    const auto [corner, top] = places.Of(ui);
    if (top->in_world) continue;
    boxes.push_back({corner.x, corner.y, corner.x + ui.width, corner.y + ui.height});
  }
  return boxes;
}

}  // namespace soarbox::viewer
