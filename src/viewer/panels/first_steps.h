// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "viewer/label_layout.h"
#include "viewer/panels/panel.h"

namespace soarbox::viewer {

/// Leads a new user through the window: one thing to do at a time, told in a strip over the picture, until all are
/// done or the user closes it.
class FirstSteps {
 public:
  /// What can be seen of the user in a frame.
  struct Seen {
    std::uint32_t selected = 0;
    std::size_t agents = 0;
    bool shows_why = false, has_asked = false, is_paused = false, is_in_past = false, is_recording = false;
  };
  /// Notes what the user has done; when a step is done, the next one follows.
  void Note(const Seen& seen);
  void Skip() { ++at_; }
  void Begin() { *this = FirstSteps(); }

  static constexpr std::size_t kSteps = 5;
  /// From 0 on; kSteps: all are done.
  std::size_t at() const { return at_; }
  /// What to do now; at the end, what else there is.
  std::string_view text() const;

 private:
  bool IsDone(const Seen& seen) const;

  std::size_t at_ = 0;
  std::optional<std::uint32_t> first_selected_;
};

/// Where a strip stands in an area so that it covers none of the boxes: at the lower edge, in the middle or to a side,
/// narrower if need be, else at the upper one. If all places cover something, in the middle of the lower edge.
/// `height_of`: how high it is in a width.
ScreenBox PlaceOfStrip(const ScreenBox& area, float width, const std::function<float(float)>& height_of,
                       std::span<const ScreenBox> not_over);

/// Draws the strip over this part of the window, beside these boxes, and turns the layout's `first_steps` off once it
/// is closed. Gives what it covers.
ScreenBox DrawFirstSteps(PanelFrame& frame, FirstSteps& steps, const ScreenBox& area,
                         std::span<const ScreenBox> not_over);

}  // namespace soarbox::viewer
