// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/script_ui_places.h"

#include <algorithm>

namespace soarbox::viewer {
namespace {

using world::UiSnapshot;

/// How far a panel that was placed for the window must go to be in the picture.
float ShiftInto(float begin, float size, float room, float window) {
  constexpr float kMargin_px = 12;
  const float end = begin + size;
  if (begin < 0 || end <= room || end > window) return 0;  // In it already, or where its script wants it: outside.
  return std::max(-begin, std::min(0.0f, room - kMargin_px - end));
}

}  // namespace

ScriptUiPlaces::ScriptUiPlaces(const world::SceneSnapshot& snapshot, const ScreenRoom& room) : room_(room) {
  for (const UiSnapshot& ui : snapshot.ui) by_id_[ui.id] = &ui;
}

ScriptUiPlaces::Stand ScriptUiPlaces::Of(const UiSnapshot& ui) const {
  Stand stand{{ui.x, ui.y}, &ui};
  // A family is never deeper than there are panels.
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

std::vector<ScreenBox> BoxesOfScriptUi(const world::SceneSnapshot& snapshot, const ScreenRoom& room) {
  std::vector<ScreenBox> boxes;
  const ScriptUiPlaces places(snapshot, room);
  for (const UiSnapshot& ui : snapshot.ui) {
    const bool hides = ui.has_gradient || !ui.text.empty() || !ui.caption.empty() || !ui.material.empty();
    if (!ui.visible || !hides || ui.width <= 0 || ui.height <= 0) continue;
    const auto [corner, top] = places.Of(ui);
    if (top->in_world) continue;
    boxes.push_back({corner.x, corner.y, corner.x + ui.width, corner.y + ui.height});
  }
  return boxes;
}

}  // namespace soarbox::viewer
