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

/// Guides a new user through the window. A strip over the picture shows one task at a time, until all are done or the
/// user closes it.
class FirstSteps {
 public:
  /// The user's state as seen in a frame.
  struct Seen {
    std::uint32_t selected = 0;
    std::size_t agents = 0;
    bool shows_why = false, has_asked = false, is_paused = false, is_in_past = false, is_recording = false;
  };
  /// Notes what the user has done. When a step is done, the next one follows.
  void Note(const Seen& seen);
  void Skip() { ++at_; }
  void Begin() { *this = FirstSteps(); }

  static constexpr std::size_t kSteps = 5;
  /// Index of the current step, from 0; kSteps: all are done.
  std::size_t at() const { return at_; }
  /// The current task; at the end, suggestions for further steps.
  std::string_view text() const;

 private:
  bool IsDone(const Seen& seen) const;

  std::size_t at_ = 0;
  std::optional<std::uint32_t> first_selected_;
};

/// Returns a place for a strip in an area that covers none of the boxes: at the lower edge, in the middle or at a side,
/// narrower if necessary, else at the upper edge. If all places cover something, returns the middle of the lower edge.
/// `height_of` returns the strip's height for a width.
ScreenBox PlaceOfStrip(const ScreenBox& area, float width, const std::function<float(float)>& height_of,
                       std::span<const ScreenBox> not_over);

/// Draws the strip over this part of the window without covering these boxes. Sets the layout's `first_steps` to false
/// when it is closed. Returns the covered box.
ScreenBox DrawFirstSteps(PanelFrame& frame, FirstSteps& steps, const ScreenBox& area,
                         std::span<const ScreenBox> not_over);

}  // namespace soarbox::viewer
