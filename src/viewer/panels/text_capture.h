// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>
#include <vector>

namespace soarbox::viewer {

/// A run of letters on the screen.
struct ShownText {
  std::string text;       ///< UTF-8.
  std::vector<float> at;  ///< For each byte, the x position where its letter begins, px; one more for the end.
  float top = 0, bottom = 0;
  ImVec4 seen{0, 0, 0,
              0};  ///< The visible part of the letters inside of the clipping rectangle: left, top, right, bottom, px.
  bool is_cut = false;                      ///< Some letters are outside of the clipping rectangle.
  bool is_cut_x = false, is_cut_y = false;  ///< Left or right; above or below.

  /// The centre of a part of the run.
  ImVec2 MiddleOf(std::size_t first, std::size_t length) const {
    return {(at[first] + at[first + length]) / 2, (top + bottom) / 2};
  }
};

/// Reads the visible texts and their places from a frame's triangles, after clipping and scrolling. For tests and for
/// scripts that act on the window by its texts.
std::vector<ShownText> CaptureText(const ImDrawData& drawn, const ImFontAtlas& fonts);

/// The n-th place (from 1) of a text: first the runs that are exactly this text, then those that contain it. `run` is
/// null if there are fewer places.
struct TextPlace {
  const ShownText* run = nullptr;
  std::size_t first = 0;
};
TextPlace FindText(const std::vector<ShownText>& shown, std::string_view text, int number = 1);

}  // namespace soarbox::viewer
