// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "viewer/picking.h"

namespace soarbox::viewer {

/// A part of the picture; in px.
struct ScreenBox {
  float left = 0, top = 0, right = 0, bottom = 0;
  float width() const { return right - left; }
  float height() const { return bottom - top; }
  friend bool operator==(const ScreenBox&, const ScreenBox&) = default;
};

/// Whether two boxes come nearer to each other than `gap_px`.
bool Meet(const ScreenBox& a, const ScreenBox& b, float gap_px = 0);
bool Holds(const ScreenBox& outer, const ScreenBox& inner);

enum class Corner : std::uint8_t { kBottomLeft, kBottomRight, kTopRight, kTopLeft };

/// Where a card of this size stands in a corner of an area.
ScreenBox BoxIn(Corner corner, const ScreenBox& area, float width, float height);

/// The corner for a card that is to hide nothing: the one where it stands if that is free, else the first that is; if
/// none is, it stays.
Corner FreeCorner(Corner now, const ScreenBox& area, float width, float height, std::span<const ScreenBox> not_over);

/// Where a label likes to stand.
enum class LabelHabit : std::uint8_t {
  kAbove,   ///< Above the point, else further up and to the sides: names.
  kBeside,  ///< Beside the point with room for an arrow: what somebody says.
  kAround,  ///< Just above the point or below `below_y`: the names of ghosts.
};

/// A label that looks for a place.
struct LabelWish {
  ScreenPoint at;  ///< What it belongs to.
  LabelHabit habit = LabelHabit::kAbove;
  float below_y = 0;                        ///< For kAround.
  float width = 0, height = 0;              ///< px
  float short_width = 0, short_height = 0;  ///< In its short form; 0: it has none.
  bool must_show = false;                   ///< Rather far away than not at all.
  int places = 100;                         ///< How many of its places may be tried; few where many crowd.
  int usual_place = -1;                     ///< Where it stood in the frame before, so that it does not hop about.
};

struct LabelPlace {
  ScreenBox box;
  bool is_short = false;
  int place = -1;  ///< For LabelWish::usual_place of the next frame.
};

/// Places labels one after the other, so that none covers another or is cut by the edge of the picture: the one that
/// comes first has the choice. Pure arithmetic, no drawing.
class LabelLayout {
 public:
  /// area: where labels may stand. gap_px: what stays free between two of them.
  LabelLayout(const ScreenBox& area, float gap_px) : area_(area), gap_px_(gap_px) {}

  /// Something else stands there.
  void Block(const ScreenBox& box) { taken_.push_back(box); }
  /// Labels prefer not to cover this, but may: the bodies of agents.
  void Spare(const ScreenBox& box) { spared_.push_back(box); }

  /// Finds a place and takes it; none if there is no room.
  std::optional<LabelPlace> Place(const LabelWish& wish);

  const std::vector<ScreenBox>& taken() const { return taken_; }

 private:
  bool IsFree(const ScreenBox& box) const;
  bool IsSpared(const ScreenBox& box) const;

  ScreenBox area_;
  float gap_px_;
  std::vector<ScreenBox> taken_, spared_;
};

/// Agents without room for a label, gathered where they crowd.
struct LabelCrowd {
  ScreenPoint at;                    ///< Their middle.
  std::vector<std::size_t> members;  ///< Indices into the points given.
};
/// Points that are nearer to each other than about `reach_px` come into one crowd.
std::vector<LabelCrowd> GatherCrowds(std::span<const ScreenPoint> points, float reach_px);

}  // namespace soarbox::viewer
