// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cmath>
#include <cstdint>

namespace soarbox::viewer {

/// Seeded lattice noise for computed textures. The same on every machine and in every run.

/// A hash of a lattice point, 0..1.
inline float LatticeValue(int x, int y, int z, std::uint32_t seed) {
  std::uint32_t h = seed + static_cast<std::uint32_t>(x) * 0x8da6b343u + static_cast<std::uint32_t>(y) * 0xd8163841u +
                    static_cast<std::uint32_t>(z) * 0xcb1ab31fu;
  h ^= h >> 16;
  h *= 0x7feb352du;
  h ^= h >> 15;
  h *= 0x846ca68bu;
  h ^= h >> 16;
  return static_cast<float>(h >> 8) * (1.0f / 16777216.0f);
}

inline int FloorToInt(float x) {
  const int whole = static_cast<int>(x);
  return x < static_cast<float>(whole) ? whole - 1 : whole;
}

/// Smooth noise in the plane, 0..1. Repeats every `period` lattice cells if `period` is positive.
inline float Noise2(float x, float y, std::uint32_t seed, int period = 0) {
  const int x0 = FloorToInt(x), y0 = FloorToInt(y);
  const float fx = x - static_cast<float>(x0), fy = y - static_cast<float>(y0);
  const auto wrap = [period](int i) { return period > 0 ? ((i % period) + period) % period : i; };
  const int xa = wrap(x0), xb = wrap(x0 + 1), ya = wrap(y0), yb = wrap(y0 + 1);
  const float sx = fx * fx * (3 - 2 * fx), sy = fy * fy * (3 - 2 * fy);
  const float a = LatticeValue(xa, ya, 0, seed), b = LatticeValue(xb, ya, 0, seed);
  const float c = LatticeValue(xa, yb, 0, seed), d = LatticeValue(xb, yb, 0, seed);
  return a + (b - a) * sx + (c - a) * sy + (a - b - c + d) * sx * sy;
}

/// Sum of octaves of Noise2, each twice as fine and half as strong as the one before, scaled to 0..1.
inline float Fractal2(float x, float y, int octaves, std::uint32_t seed, int period = 0) {
  float sum = 0, weight = 0.5f, total = 0;
  for (int i = 0; i < octaves; ++i) {
    sum += weight * Noise2(x, y, seed + static_cast<std::uint32_t>(i) * 101u, period);
    total += weight;
    weight *= 0.5f;
    x *= 2;
    y *= 2;
    period *= 2;
  }
  return sum / total;
}

}  // namespace soarbox::viewer
