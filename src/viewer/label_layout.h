// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "viewer/picking.h"

namespace soarbox::viewer {

/// A rectangle of the picture, in px.
struct ScreenBox {
  float left = 0, top = 0, right = 0, bottom = 0;
  float width() const { return right - left; }
  float height() const { return bottom - top; }
  friend bool operator==(const ScreenBox&, const ScreenBox&) = default;
};

/// Whether the distance between two boxes is less than `gap_px`.
bool Meet(const ScreenBox& a, const ScreenBox& b, float gap_px = 0);
bool Holds(const ScreenBox& outer, const ScreenBox& inner);

/// The places that a label prefers.
enum class LabelHabit : std::uint8_t {
  kAbove,   ///< Above the point, else further up and to the sides: names.
  kBeside,  ///< Next to the point, with space for an arrow: speech.
  kAround,  ///< Directly above the point or below `below_y`: names of ghosts and places.
};

/// A label that needs a place.
struct LabelWish {
  ScreenPoint at;  ///< The point that it labels.
  LabelHabit habit = LabelHabit::kAbove;
  float below_y = 0;                        ///< For kAround.
  float width = 0, height = 0;              ///< px
  float short_width = 0, short_height = 0;  ///< In its short form; 0: it has none.
  bool must_show = false;                   ///< Shown far from its point rather than not at all.
  int places = 100;                         ///< Maximum number of places to try; small in crowds.
  int usual_place = -1;                     ///< Its place in the previous frame, so that it does not jump.
};

struct LabelPlace {
  ScreenBox box;
  bool is_short = false;
  int place = -1;  ///< For LabelWish::usual_place of the next frame.
};

/// Places labels one after the other. Labels do not cover each other and are not cut by the edge of the picture.
/// Earlier labels choose first. It only computes; it draws nothing.
class LabelLayout {
 public:
  /// `area` contains all labels. `gap_px` is the minimum distance between two labels.
  LabelLayout(const ScreenBox& area, float gap_px) : area_(area), gap_px_(gap_px) {}

  /// No label may cover this box.
  void Block(const ScreenBox& box) { taken_.push_back(box); }
  /// Labels avoid this box if they can: the bodies of agents.
  void Spare(const ScreenBox& box) { spared_.push_back(box); }

  /// Finds a place and reserves it; nothing if there is no space.
  std::optional<LabelPlace> Place(const LabelWish& wish);

  const std::vector<ScreenBox>& taken() const { return taken_; }

 private:
  bool IsFree(const ScreenBox& box) const;
  bool IsSpared(const ScreenBox& box) const;

  ScreenBox area_;
  float gap_px_;
  std::vector<ScreenBox> taken_, spared_;
};

}  // namespace soarbox::viewer
