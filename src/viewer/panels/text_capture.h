// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>
#include <vector>

namespace soarbox::viewer {

/// A run of letters on the screen, as they were drawn.
struct ShownText {
  std::string text;       ///< UTF-8.
  std::vector<float> at;  ///< For each byte where its letter begins, px; one more for the end.
  float top = 0, bottom = 0;
  ImVec4 seen{0, 0, 0, 0};  ///< What its letters fill of what may be drawn to: left, top, right, bottom, px.
  bool is_cut = false;      ///< Some of its letters lie outside of what may be drawn to.
  bool is_cut_x = false, is_cut_y = false;  ///< At the left or right; above or below.

  /// The middle of a part of it.
  ImVec2 MiddleOf(std::size_t first, std::size_t length) const {
    return {(at[first] + at[first + length]) / 2, (top + bottom) / 2};
  }
};

/// Reads back from a frame's triangles which texts it shows and where: what a user can see, clipped and scrolled. For
/// tests and for scripts that act on the window by what stands in it.
std::vector<ShownText> CaptureText(const ImDrawData& drawn, const ImFontAtlas& fonts);

/// The n-th place (from 1) where the text stands; first the runs that are just this text, then those that hold it.
/// Null if there are fewer.
struct TextPlace {
  const ShownText* run = nullptr;
  std::size_t first = 0;
};
TextPlace FindText(const std::vector<ShownText>& shown, std::string_view text, int number = 1);

}  // namespace soarbox::viewer
