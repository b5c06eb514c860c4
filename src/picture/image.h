// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace soarbox::picture {

/// A colour in the colour space of the screen, 0 to 1 per channel.
struct Ink {
  float r = 0, g = 0, b = 0, a = 1;
};

/// Pixels of three bytes (red, green, blue), in rows from the top.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;

  Image() = default;
  Image(int w, int h, Ink background = {1, 1, 1, 1});
  std::uint8_t* At(int x, int y) {
    return &rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x))];
  }
  const std::uint8_t* At(int x, int y) const { return const_cast<Image*>(this)->At(x, y); }
  /// Blends a colour into a pixel, with its alpha times `cover`. Ignores pixels outside the image.
  void Mix(int x, int y, Ink ink, float cover);

  // Antialiased shapes. Positions and sizes are in pixels; the centre of a pixel has a fractional part of one half.
  void Line(float x0, float y0, float x1, float y1, float width_px, Ink ink);
  void Disc(float x, float y, float radius, Ink ink);
  void Ring(float x, float y, float radius, float width_px, Ink ink);
  void Box(float x, float y, float w, float h, Ink ink);
};

/// The picture at half the width and height; each pixel is the mean of four. Both sizes must be even.
Image Halved(const Image& image);

}  // namespace soarbox::picture
