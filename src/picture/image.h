// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace soarbox::picture {

/// A colour as on the screen, 0 to 1 per channel.
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
  /// Mixes the colour into a pixel; its share is the colour's alpha times `cover`. Ignores pixels outside of the image.
  void Mix(int x, int y, Ink ink, float cover);

  // Shapes with smooth edges. Places and sizes are in pixels; a pixel's middle is at half a number.
  void Line(float x0, float y0, float x1, float y1, float width_px, Ink ink);
  void Disc(float x, float y, float radius, Ink ink);
  void Ring(float x, float y, float radius, float width_px, Ink ink);
  void Box(float x, float y, float w, float h, Ink ink);
};

/// The same picture with half the width and height; each pixel is the mean of four. Both sizes must be even.
Image Halved(const Image& image);

}  // namespace soarbox::picture
