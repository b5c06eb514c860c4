// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <cmath>
#include <thread>

#include "viewer/images.h"
#include "viewer/noise.h"
#include "world/math.h"

namespace soarbox::viewer {
namespace {

using Tone = std::array<float, 3>;
using world::Vec3;

Tone Mix(const Tone& a, const Tone& b, float t) {
  return {a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t, a[2] + (b[2] - a[2]) * t};
}

float Smooth(float low, float high, float value) {
  const float t = std::clamp((value - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

/// The direction of a pixel of a cube map's face. Cube maps are left-handed; shaders mirror z.
Vec3 FaceDirection(int face, float s, float t) {
  switch (face) {
    case 0:
      return {1, -t, -s};
    case 1:
      return {-1, -t, s};
    case 2:
      return {s, 1, t};
    case 3:
      return {s, -1, -t};
    case 4:
      return {s, -t, 1};
    default:
      return {-s, -t, -1};
  }
}

Tone Above(const SkyStyle& style, Vec3 d) {
  const float height = d.y;
  Tone air = Mix(style.horizon, style.zenith, std::pow(std::clamp(height, 0.0f, 1.0f), 0.52f));
  if (style.stars > 0) {
    const float star = LatticeValue(FloorToInt(d.x * 260), FloorToInt(d.y * 260), FloorToInt(d.z * 260), 77);
    if (star > 0.9975f) air = Mix(air, {1, 1, 1}, style.stars * (star - 0.9975f) / 0.0025f);
  }
  if (style.cloud_cover <= 0) return air;

  // A flat layer of clouds in perspective; finer noise displaces the coarser noise.
  const float far = 1.0f / (height + 0.14f);
  const float x = d.x * far * 1.55f, y = d.z * far * 1.55f;
  const float bend = Fractal2(x * 1.7f + 5, y * 1.7f, 3, 201) - 0.5f;
  const auto density = [&](float px, float py) { return Fractal2(px + 0.9f * bend, py - 0.9f * bend, 6, 7); };
  const float here = density(x, y);
  const float edge = 0.70f - 0.42f * style.cloud_cover;
  const float cover = Smooth(edge, edge + 0.20f, here);
  if (cover <= 0) return air;
  const float towards_light = density(x + 0.16f, y - 0.12f);
  const float shade = std::clamp(0.5f + 3.2f * (here - towards_light) + 0.9f * (edge + 0.16f - here), 0.0f, 1.0f);
  const Tone cloud = Mix(style.cloud_dark, style.cloud_light, shade);
  // Clouds fade into the haze towards the horizon.
  return Mix(air, Mix(style.horizon, cloud, Smooth(-0.02f, 0.22f, height)), cover * Smooth(0.0f, 0.07f, height));
}

Tone Below(const SkyStyle& style, Vec3 d) {
  const float depth = -d.y, far = 1.0f / (depth + 0.015f);
  const float swell = Fractal2(d.x * far * 1.3f, d.z * far * 3.1f, 4, 91) - 0.5f;
  const float ripple = Fractal2(d.x * far * 9.0f, d.z * far * 16.0f, 3, 131) - 0.5f;
  const float calm = Smooth(0.01f, 0.25f, depth);
  const float mirror = std::pow(1 - depth, 6.0f);
  const Tone reflected = Mix(style.horizon, style.zenith, std::clamp(0.25f + depth + 0.5f * swell, 0.0f, 1.0f));
  Tone sea = Mix(style.water, reflected,
                 std::clamp(0.12f + 0.75f * mirror + (0.35f * swell + 0.25f * ripple) * calm, 0.0f, 1.0f));
  return Mix(style.horizon, sea, Smooth(0.0f, 0.045f, depth));
}

}  // namespace

std::array<Image, 6> SkyImages(const SkyStyle& style, int size) {
  std::array<Image, 6> faces{Image(size, size), Image(size, size), Image(size, size),
                             Image(size, size), Image(size, size), Image(size, size)};
  const auto draw = [&](int face) {
    const float step = 2.0f / static_cast<float>(size);
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        const Vec3 d = world::Normalized(
            FaceDirection(face, (static_cast<float>(x) + 0.5f) * step - 1, (static_cast<float>(y) + 0.5f) * step - 1));
        const Tone tone = d.y >= 0 ? Above(style, d) : Below(style, d);
        faces[static_cast<std::size_t>(face)].Set(x, y, tone[0], tone[1], tone[2]);
      }
    }
  };
  // Each thread computes entire faces, so the result does not depend on the number of threads.
  std::vector<std::thread> painters;
  for (int face = 0; face < 6; ++face) painters.emplace_back(draw, face);
  for (std::thread& painter : painters) painter.join();
  return faces;
}

}  // namespace soarbox::viewer
