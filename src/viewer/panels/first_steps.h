// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "viewer/panels/panel.h"

namespace soarbox::viewer {

/// Leads somebody new through the window: one thing to do at a time, told in a strip over the picture, until all were
/// done or the user wants no more of it.
class FirstSteps {
 public:
  /// What can be seen of the user in a frame.
  struct Seen {
    std::uint32_t selected = 0;
    std::size_t agents = 0;
    bool shows_why = false, has_asked = false, is_paused = false, is_in_past = false, is_recording = false;
  };
  /// Takes note of what the user has done; a step that is done makes way for the next.
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

/// Draws the strip at the lower edge of this part of the window, and turns the layout's `first_steps` off once it is
/// closed. Gives what it covers.
struct StripPlace {
  ImVec2 corner, size;
};
StripPlace DrawFirstSteps(PanelFrame& frame, FirstSteps& steps, ImVec2 corner, ImVec2 size);

}  // namespace soarbox::viewer
