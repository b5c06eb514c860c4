// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/cloth_image.h"

#include <algorithm>
#include <cmath>

#include "viewer/noise.h"

namespace soarbox::viewer {
namespace {

using Tone = std::array<float, 3>;

constexpr int kCells = 4;

Tone Mix(const Tone& a, const Tone& b, float t) {
  return {a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t, a[2] + (b[2] - a[2]) * t};
}

/// Four tones in patches of about the size of a hand.
Tone Camouflage(float u, float v) {
  const float broad = Fractal2(u * 9, v * 9, 3, 61), other = Fractal2(u * 11 + 7, v * 11, 3, 67),
              small = Fractal2(u * 22, v * 22, 2, 71);
  Tone tone{0.47f, 0.45f, 0.33f};
  if (broad > 0.53f) tone = {0.33f, 0.36f, 0.23f};
  if (other > 0.60f) tone = {0.30f, 0.25f, 0.17f};
  if (small > 0.66f) tone = {0.58f, 0.54f, 0.42f};
  return tone;
}

Tone ClothTone(Cloth cloth, float u, float v) {
  switch (cloth) {
    case Cloth::kCamouflage:
      return Camouflage(u, v);
    case Cloth::kWebbing:
      return {0.34f, 0.335f, 0.255f};
    case Cloth::kSkin:
      return Mix({0.74f, 0.53f, 0.42f}, {0.66f, 0.45f, 0.35f}, Fractal2(u * 14, v * 14, 3, 5));
    case Cloth::kLeather:
      return {0.20f, 0.155f, 0.115f};
    case Cloth::kMetal:
      return {0.20f, 0.205f, 0.215f};
    case Cloth::kGlass:
      return {0.05f, 0.07f, 0.09f};
    case Cloth::kHelmet:
      return Mix({0.38f, 0.385f, 0.285f}, {0.33f, 0.335f, 0.25f}, Fractal2(u * 10, v * 10, 3, 9));
    case Cloth::kRubber:
      return {0.105f, 0.10f, 0.095f};
    case Cloth::kSteel:
      return {0.42f, 0.43f, 0.45f};
    case Cloth::kDarkCamouflage: {
      const Tone tone = Camouflage(u, v);
      const float grey = 0.35f * (tone[0] + tone[1] + tone[2]) / 3;
      return {0.22f * tone[0] + grey, 0.25f * tone[1] + grey, 0.42f * tone[2] + grey};
    }
    case Cloth::kDarkWebbing:
      return {0.125f, 0.13f, 0.14f};
    case Cloth::kDarkHelmet:
      return Mix({0.15f, 0.155f, 0.165f}, {0.12f, 0.125f, 0.135f}, Fractal2(u * 10, v * 10, 3, 9));
    case Cloth::kTeam:
      return {1, 1, 1};
  }
  return {1, 1, 1};
}

/// Visibility of the threads.
float WeaveOf(Cloth cloth) {
  switch (cloth) {
    case Cloth::kCamouflage:
    case Cloth::kWebbing:
    case Cloth::kDarkCamouflage:
    case Cloth::kDarkWebbing:
      return 0.14f;
    case Cloth::kDarkHelmet:
    case Cloth::kHelmet:
    case Cloth::kLeather:
      return 0.08f;
    default:
      return 0.03f;
  }
}

}  // namespace

Image ClothImage(int cell_size) {
  Image image(kCells * cell_size, kCells * cell_size);
  for (int cell = 0; cell <= static_cast<int>(Cloth::kDarkHelmet); ++cell) {
    const auto cloth = static_cast<Cloth>(cell);
    for (int y = 0; y < cell_size; ++y) {
      for (int x = 0; x < cell_size; ++x) {
        const float u = static_cast<float>(x) / static_cast<float>(cell_size),
                    v = static_cast<float>(y) / static_cast<float>(cell_size);
        const Tone tone = ClothTone(cloth, u, v);
        const float worn = 0.88f + 0.24f * Fractal2(u * 7, v * 7, 4, 31 + static_cast<std::uint32_t>(cell));
        const float thread = 1 + WeaveOf(cloth) * (LatticeValue(x, y, cell, 3) - 0.5f);
        const float shade = worn * thread;
        image.Set((cell % kCells) * cell_size + x, (cell / kCells) * cell_size + y, tone[0] * shade, tone[1] * shade,
                  tone[2] * shade);
      }
    }
  }
  return image;
}

ClothPlace PlaceOnCloth(Cloth cloth, world::Vec3 at) {
  const auto cell = static_cast<int>(cloth);
  // The body spans at most two metres in each direction. A border separates neighbouring cells in coarse mipmap levels.
  const float u = std::clamp((at.x + 0.6f * at.z + 1) / 2, 0.0f, 1.0f);
  const float v = std::clamp(1 - (at.y + 0.25f * at.z) / 1.85f, 0.0f, 1.0f);
  const auto within = [](int index, float share) {
    return (static_cast<float>(index) + 0.06f + 0.88f * share) / static_cast<float>(kCells);
  };
  return {within(cell % kCells, u), within(cell / kCells, v)};
}

float GlossOf(Cloth cloth) {
  switch (cloth) {
    case Cloth::kGlass:
      return 0.9f;
    case Cloth::kMetal:
    case Cloth::kSteel:
      return 0.5f;
    case Cloth::kLeather:
      return 0.22f;
    case Cloth::kRubber:
      return 0.2f;
    case Cloth::kHelmet:
    case Cloth::kDarkHelmet:
    case Cloth::kSkin:
    case Cloth::kTeam:
      return 0.12f;
    default:
      return 0.0f;
  }
}

}  // namespace soarbox::viewer
