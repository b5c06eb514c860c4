// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/label_layout.h"

#include <algorithm>
#include <cmath>

namespace soarbox::viewer {
namespace {

/// An offset from the point to the middle of a label's lower edge, in widths and heights of the label.
struct Step {
  float x, y;
};
constexpr Step kAbove[] = {{0, 0},        {0, -0.6f},    {0.6f, -0.3f},  {-0.6f, -0.3f}, {0, -1.2f},     {1.1f, 0.4f},
                           {-1.1f, 0.4f}, {0.7f, -1.2f}, {-0.7f, -1.2f}, {0, -1.8f},     {1.2f, -0.8f},  {-1.2f, -0.8f},
                           {0.6f, 1.9f},  {-0.6f, 1.9f}, {0, -2.6f},     {1.3f, -1.8f},  {-1.3f, -1.8f}, {0, -3.6f}};
/// For labels next to a point: the side, and the number of heights below the middle.
constexpr Step kBeside[] = {{1, 0},     {-1, 0},    {1, -1.1f},  {-1, -1.1f}, {1, 1.1f},
                            {-1, 1.1f}, {1, -2.2f}, {-1, -2.2f}, {1, 2.2f},   {-1, 2.2f}};
constexpr float kArrow_px = 22;
constexpr int kAroundPlaces = 5;

int CountOf(LabelHabit habit) {
  switch (habit) {
    case LabelHabit::kAbove:
      return static_cast<int>(std::size(kAbove));
    case LabelHabit::kBeside:
      return static_cast<int>(std::size(kBeside));
    case LabelHabit::kAround:
      return kAroundPlaces;
  }
  return 0;
}

/// The box of a label at one of its usual places, moved into the area.
ScreenBox BoxAt(const LabelWish& wish, int place, float width, float height, const ScreenBox& area) {
  float left = wish.at.x - width / 2, top = wish.at.y - height;
  switch (wish.habit) {
    case LabelHabit::kAbove:
      left += kAbove[place].x * width;
      top += kAbove[place].y * height;
      break;
    case LabelHabit::kBeside:
      left = kBeside[place].x > 0 ? wish.at.x + kArrow_px : wish.at.x - kArrow_px - width;
      top = wish.at.y - height * 0.7f + kBeside[place].y * height;
      break;
    case LabelHabit::kAround: {
      const float line = height + 3;
      const float tops[kAroundPlaces] = {top - 2, wish.below_y + 2, wish.below_y + 2 + line, top - 2 - line,
                                         wish.below_y + 2 + 2 * line};
      top = tops[place];
      break;
    }
  }
  left = std::round(std::clamp(left, area.left, std::max(area.left, area.right - width)));
  top = std::round(std::clamp(top, area.top, std::max(area.top, area.bottom - height)));
  return {left, top, left + width, top + height};
}

}  // namespace

bool Meet(const ScreenBox& a, const ScreenBox& b, float gap_px) {
  return a.left < b.right + gap_px && b.left < a.right + gap_px && a.top < b.bottom + gap_px &&
         b.top < a.bottom + gap_px;
}

bool Holds(const ScreenBox& outer, const ScreenBox& inner) {
  return inner.left >= outer.left && inner.right <= outer.right && inner.top >= outer.top &&
         inner.bottom <= outer.bottom;
}

bool LabelLayout::IsFree(const ScreenBox& box) const {
  return Holds({area_.left - 1, area_.top - 1, area_.right + 1, area_.bottom + 1}, box) &&
         std::none_of(taken_.begin(), taken_.end(), [&](const ScreenBox& t) { return Meet(box, t, gap_px_); });
}

bool LabelLayout::IsSpared(const ScreenBox& box) const {
  return std::none_of(spared_.begin(), spared_.end(), [&](const ScreenBox& s) { return Meet(box, s); });
}

std::optional<LabelPlace> LabelLayout::Place(const LabelWish& wish) {
  const auto take = [&](const ScreenBox& box, bool is_short, int place) {
    taken_.push_back(box);
    return LabelPlace{box, is_short, place};
  };
  const int count = std::min(CountOf(wish.habit), wish.places);
  for (const bool is_short : {false, true}) {
    const float width = is_short ? wish.short_width : wish.width, height = is_short ? wish.short_height : wish.height;
    if (width <= 0) continue;
    std::optional<LabelPlace> second;  // Free, but over the body of an agent.
    for (int i = -1; i < count; ++i) {
      const int place = i < 0 ? wish.usual_place : i;
      if (place < 0 || place >= count) continue;
      const ScreenBox box = BoxAt(wish, place, width, height, area_);
      if (!IsFree(box)) continue;
      if (IsSpared(box)) return take(box, is_short, place);
      if (!second) second = LabelPlace{box, is_short, place};
    }
    if (second) return take(second->box, is_short, second->place);
  }
  if (!wish.must_show) return std::nullopt;
  // Any free place, the nearest first.
  const float width = wish.short_width > 0 ? wish.short_width : wish.width;
  const float height = wish.short_width > 0 ? wish.short_height : wish.height;
  std::optional<ScreenBox> best;
  float best_away = 0;
  for (float top = area_.top; top + height <= area_.bottom; top += height / 2) {
    for (float left = area_.left; left + width <= area_.right; left += width / 4) {
      const float x = left + width / 2 - wish.at.x, y = top + height - wish.at.y;
      const float away = x * x + y * y;
      const ScreenBox box{std::round(left), std::round(top), std::round(left) + width, std::round(top) + height};
      if ((best && away >= best_away) || !IsFree(box)) continue;
      best = box;
      best_away = away;
    }
  }
  if (!best) return std::nullopt;
  return take(*best, wish.short_width > 0, -1);
}

}  // namespace soarbox::viewer
