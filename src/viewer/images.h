// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace soarbox::viewer {

/// Pictures that are computed: the textures of the scene and its sky. Four bytes per pixel (red, green, blue, alpha),
/// rows from the top, colours in sRGB as on the screen.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;

  Image(int w, int h)
      : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * 4, 255) {}
  void Set(int x, int y, float r, float g, float b, float a = 1);  ///< 0..1, clamped.
};

Image WhiteImage();
/// Magenta and black squares, for missing textures.
Image CheckerImage();
/// Three unrelated tileable noise patterns in red, green and blue, for the ground.
Image GrainImage();
Image ConcreteImage();
Image BrickImage();
/// Brushed planks in pale grey, to be tinted.
Image CrateImage();

/// Leaves in several shades of green, seen from a distance.
Image LeafImage();
/// Weathered stone with veins and lichen.
Image StoneImage();

/// A sky: clouds above, water below the horizon. Colours are red, green and blue, 0..1.
struct SkyStyle {
  std::array<float, 3> zenith{0.20f, 0.42f, 0.74f};
  std::array<float, 3> horizon{0.80f, 0.87f, 0.92f};
  std::array<float, 3> cloud_light{0.985f, 0.98f, 0.97f};
  std::array<float, 3> cloud_dark{0.60f, 0.655f, 0.72f};
  std::array<float, 3> water{0.10f, 0.30f, 0.39f};
  float cloud_cover = 0.6f;  ///< 0 clear, 1 overcast.
  float stars = 0;           ///< 0..1
};
/// Six square faces of `size` pixels: +x, -x, +y, -y, +z, -z in the orientation of cube maps.
std::array<Image, 6> SkyImages(const SkyStyle& style, int size);

}  // namespace soarbox::viewer
