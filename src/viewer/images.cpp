// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/images.h"

#include <algorithm>
#include <cmath>

#include "viewer/noise.h"

namespace soarbox::viewer {

void Image::Set(int x, int y, float r, float g, float b, float a) {
  const auto byte = [](float value) {
    return static_cast<std::uint8_t>(std::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f);
  };
  const std::size_t at =
      4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
  pixels[at] = byte(r);
  pixels[at + 1] = byte(g);
  pixels[at + 2] = byte(b);
  pixels[at + 3] = byte(a);
}

namespace {

/// Calls shade(u, v, x, y) for each pixel, u and v in 0..1.
template <typename Shade>
Image Painted(int size, Shade&& shade) {
  Image image(size, size);
  const float step = 1.0f / static_cast<float>(size);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const auto [r, g, b] = shade((static_cast<float>(x) + 0.5f) * step, (static_cast<float>(y) + 0.5f) * step);
      image.Set(x, y, r, g, b);
    }
  }
  return image;
}

std::array<float, 3> Grey(float value) {
  return {value, value, value};
}

/// 0 within `width` of the border of the cell that contains `value` (in cells), else 1.
float InsideCell(float value, float width) {
  const float inside = value - std::floor(value);
  return std::clamp(std::min(inside, 1 - inside) / width, 0.0f, 1.0f);
}

}  // namespace

Image WhiteImage() {
  return Painted(4, [](float, float) { return Grey(1); });
}

Image CheckerImage() {
  return Painted(64, [](float u, float v) {
    const bool odd = (static_cast<int>(u * 8) + static_cast<int>(v * 8)) % 2 != 0;
    return odd ? std::array<float, 3>{1, 0, 1} : std::array<float, 3>{0.06f, 0.02f, 0.06f};
  });
}

Image GrainImage() {
  return Painted(256, [](float u, float v) {
    return std::array<float, 3>{Fractal2(u * 8, v * 8, 5, 11, 8), Fractal2(u * 8, v * 8, 5, 23, 8),
                                Fractal2(u * 8, v * 8, 5, 37, 8)};
  });
}

Image ConcreteImage() {
  return Painted(256, [](float u, float v) {
    const float blotch = Fractal2(u * 4, v * 4, 6, 3, 4), pores = Noise2(u * 96, v * 96, 9, 96);
    const float seam = 0.92f + 0.08f * InsideCell(v * 2, 0.02f);
    return Grey((0.72f + 0.22f * blotch - (pores > 0.86f ? 0.10f : 0.0f)) * seam);
  });
}

Image BrickImage() {
  return Painted(256, [](float u, float v) {
    const float row = std::floor(v * 8), shifted = u * 4 + (static_cast<int>(row) % 2 != 0 ? 0.5f : 0.0f);
    const float brick = std::min(InsideCell(v * 8, 0.09f), InsideCell(shifted, 0.045f));
    const int column = static_cast<int>(std::floor(shifted)) % 4;
    const float tone = 0.78f + 0.3f * LatticeValue(column, static_cast<int>(row), 0, 5) - 0.1f;
    const float rough = 0.85f + 0.3f * (Fractal2(u * 16, v * 16, 4, 7, 16) - 0.5f);
    const float mortar = 0.74f + 0.2f * Noise2(u * 64, v * 64, 13, 64);
    const auto mix = [&](float fired, float lime) {
      return lime * mortar * (1 - brick) + fired * tone * rough * brick;
    };
    return std::array<float, 3>{mix(0.78f, 0.82f), mix(0.43f, 0.79f), mix(0.33f, 0.74f)};
  });
}

Image CrateImage() {
  return Painted(256, [](float u, float v) {
    const float plank = InsideCell(v * 8, 0.05f), number = std::floor(v * 8);
    const float fibre = Fractal2(u * 6, v * 96, 4, 41 + static_cast<std::uint32_t>(number), 0);
    const float tone = 0.80f + 0.16f * LatticeValue(static_cast<int>(number), 0, 0, 19);
    const float value = tone * (0.80f + 0.36f * (fibre - 0.5f) + 0.1f) * (0.62f + 0.38f * plank);
    return std::array<float, 3>{value, value * 0.965f, value * 0.90f};
  });
}

Image LeafImage() {
  return Painted(256, [](float u, float v) {
    const float leaf = Noise2(u * 40, v * 40, 83, 40), mass = Fractal2(u * 6, v * 6, 4, 89, 6);
    const float light = 0.45f + 0.45f * mass + 0.5f * (leaf - 0.5f);
    const float hue = Noise2(u * 20, v * 20, 97, 20);
    return std::array<float, 3>{light * (0.62f + 0.30f * hue), light * 0.95f, light * (0.52f + 0.10f * hue)};
  });
}

Image StoneImage() {
  return Painted(256, [](float u, float v) {
    const float mass = Fractal2(u * 5, v * 5, 6, 103, 5), grain = Fractal2(u * 40, v * 40, 3, 105, 40);
    const float crack = std::abs(Fractal2(u * 4, v * 4, 5, 107, 4) - 0.5f);
    const float value = 0.50f + 0.26f * mass + 0.20f * (grain - 0.5f) - 0.09f * std::max(0.0f, 1 - crack / 0.012f);
    const float lichen = 0.12f * std::clamp(6 * (Fractal2(u * 9, v * 9, 5, 109, 9) - 0.60f), 0.0f, 1.0f);
    return std::array<float, 3>{value - 0.1f * lichen, value + 0.1f * lichen, value * 0.96f - 0.4f * lichen};
  });
}

}  // namespace soarbox::viewer
