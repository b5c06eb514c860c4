// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "picture/image.h"

namespace soarbox::picture {

/// A picture made of shapes, which can be written as SVG or drawn to pixels. Positions are in px from the top left.
struct Drawing {
  enum class Anchor { kStart, kMiddle, kEnd };

  struct Path {
    std::vector<std::pair<float, float>> points;
    float width_px = 1;
    Ink ink;
  };
  struct Disc {
    float x = 0, y = 0, radius = 1;
    Ink ink;
  };
  struct Box {
    float x = 0, y = 0, w = 0, h = 0;
    Ink ink;
  };
  struct Text {
    float x = 0, y = 0;  ///< At the baseline.
    float size_px = 12;
    Anchor anchor = Anchor::kStart;
    Ink ink;
    std::string words;
  };
  using Shape = std::variant<Path, Disc, Box, Text>;

  float width = 640, height = 360;
  std::string title;  ///< A description for people who cannot see it.
  std::vector<Shape> shapes;

  void Line(float x0, float y0, float x1, float y1, float width_px, Ink ink) {
    shapes.emplace_back(Path{{{x0, y0}, {x1, y1}}, width_px, ink});
  }
};

/// Writes a complete SVG file.
std::string SvgOf(const Drawing& drawing);
/// Draws on a white background with `scale` pixels for each px.
Image ImageOf(const Drawing& drawing, float scale = 2);

}  // namespace soarbox::picture
