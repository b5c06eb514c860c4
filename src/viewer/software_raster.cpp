// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/software_raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace soarbox::viewer {
namespace {

using picture::Ink;
using world::Vec3;

constexpr float kNearest_m = 0.1f;

Ink Mixed(const Ink& a, const Ink& b, float share) {
  return {a.r + (b.r - a.r) * share, a.g + (b.g - a.g) * share, a.b + (b.b - a.b) * share, a.a + (b.a - a.a) * share};
}

}  // namespace

SoftwareRaster::SoftwareRaster(int width, int height) : image_(width, height) {}

void SoftwareRaster::Begin(const SoftwareCamera& camera) {
  camera_ = camera;
  right_ = world::Normalized(Cross(camera.ahead, camera.up));
  up_ = Cross(right_, camera.ahead);
  const auto high = static_cast<float>(image_.height);
  const float half = camera.vertical_fov_deg / 2 * std::numbers::pi_v<float> / 180;
  scale_px_ = camera.high_m > 0 ? high / camera.high_m : high / 2 / std::tan(half);
  nearness_.assign(static_cast<std::size_t>(image_.width) * static_cast<std::size_t>(image_.height),
                   -std::numeric_limits<float>::infinity());
}

SoftwareRaster::Point SoftwareRaster::SeenFrom(const Corner& corner) const {
  const Vec3 from = corner.at - camera_.eye;
  return {{Dot(from, right_), Dot(from, up_), Dot(from, camera_.ahead)}, corner.ink};
}

Projected SoftwareRaster::OnPicture(Vec3 seen) const {
  const float scale = camera_.high_m > 0 ? scale_px_ : scale_px_ / seen.z;
  return {static_cast<float>(image_.width) / 2 + seen.x * scale, static_cast<float>(image_.height) / 2 - seen.y * scale,
          seen.z, scale};
}

std::optional<Projected> SoftwareRaster::Project(Vec3 point) const {
  const Point seen = SeenFrom({point, {}});
  if (seen.at.z < kNearest_m) return std::nullopt;
  return OnPicture(seen.at);
}

Vec3 SoftwareRaster::RayOf(int x, int y) const {
  if (camera_.high_m > 0) return camera_.ahead;
  const float across = (static_cast<float>(x) + 0.5f - static_cast<float>(image_.width) / 2) / scale_px_;
  const float above = (static_cast<float>(image_.height) / 2 - static_cast<float>(y) - 0.5f) / scale_px_;
  return world::Normalized(camera_.ahead + across * right_ + above * up_);
}

std::optional<Vec3> SoftwareRaster::WorldAt(int x, int y) const {
  const float depth = DepthAt(x, y);
  if (std::isinf(depth)) return std::nullopt;
  if (camera_.high_m <= 0) {
    const Vec3 ray = RayOf(x, y);
    return camera_.eye + (depth / Dot(ray, camera_.ahead)) * ray;
  }
  const float across = (static_cast<float>(x) + 0.5f - static_cast<float>(image_.width) / 2) / scale_px_;
  const float above = (static_cast<float>(image_.height) / 2 - static_cast<float>(y) - 0.5f) / scale_px_;
  return camera_.eye + across * right_ + above * up_ + depth * camera_.ahead;
}

float SoftwareRaster::DepthAt(int x, int y) const {
  if (x < 0 || y < 0 || x >= image_.width || y >= image_.height) return std::numeric_limits<float>::infinity();
  const float nearness =
      nearness_[static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) + static_cast<std::size_t>(x)];
  if (std::isinf(nearness)) return std::numeric_limits<float>::infinity();
  return camera_.high_m > 0 ? -nearness : 1 / nearness;
}

void SoftwareRaster::Triangle(const Corner& a, const Corner& b, const Corner& c) {
  const std::array<Point, 3> corners = {SeenFrom(a), SeenFrom(b), SeenFrom(c)};
  // Clips at the plane of the camera; up to four corners are left.
  std::array<Point, 4> left;
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point &here = corners[i], &next = corners[(i + 1) % 3];
    const bool is_in = here.at.z >= kNearest_m;
    if (is_in) left[count++] = here;
    if (is_in == (next.at.z >= kNearest_m)) continue;
    const float share = (kNearest_m - here.at.z) / (next.at.z - here.at.z);
    left[count++] = {here.at + share * (next.at - here.at), Mixed(here.ink, next.ink, share)};
  }
  for (std::size_t i = 2; i < count; ++i) Fill(left[0], left[i - 1], left[i]);
}

void SoftwareRaster::Fill(const Point& a, const Point& b, const Point& c) {
  const std::array<const Point*, 3> corners = {&a, &b, &c};
  std::array<Projected, 3> on;
  std::array<float, 3> nearness;
  for (std::size_t i = 0; i < 3; ++i) {
    on[i] = OnPicture(corners[i]->at);
    if (!std::isfinite(on[i].x) || !std::isfinite(on[i].y)) return;
    nearness[i] = camera_.high_m > 0 ? -on[i].depth : 1 / on[i].depth;
  }
  const float area = (on[1].x - on[0].x) * (on[2].y - on[0].y) - (on[2].x - on[0].x) * (on[1].y - on[0].y);
  if (std::abs(area) < 1e-6f) return;
  const auto within = [](float value, int most) {
    return static_cast<int>(std::clamp(value, 0.0f, static_cast<float>(most)));
  };
  const int x0 = within(std::floor(std::min({on[0].x, on[1].x, on[2].x})), image_.width);
  const int x1 = within(std::ceil(std::max({on[0].x, on[1].x, on[2].x})) + 1, image_.width);
  const int y0 = within(std::floor(std::min({on[0].y, on[1].y, on[2].y})), image_.height);
  const int y1 = within(std::ceil(std::max({on[0].y, on[1].y, on[2].y})) + 1, image_.height);
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) {
      const float px = static_cast<float>(x) + 0.5f, py = static_cast<float>(y) + 0.5f;
      const auto weight = [&](std::size_t i, std::size_t j) {
        return ((on[j].x - on[i].x) * (py - on[i].y) - (px - on[i].x) * (on[j].y - on[i].y)) / area;
      };
      const float w0 = weight(1, 2), w1 = weight(2, 0), w2 = weight(0, 1);
      if (w0 < 0 || w1 < 0 || w2 < 0) continue;
      const float near = w0 * nearness[0] + w1 * nearness[1] + w2 * nearness[2];
      float& held =
          nearness_[static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) + static_cast<std::size_t>(x)];
      if (near <= held) continue;
      const auto mix = [&](float Ink::*channel) {
        const float one = a.ink.*channel, two = b.ink.*channel, three = c.ink.*channel;
        if (camera_.high_m > 0) return w0 * one + w1 * two + w2 * three;
        return (w0 * one * nearness[0] + w1 * two * nearness[1] + w2 * three * nearness[2]) / near;
      };
      const Ink ink{mix(&Ink::r), mix(&Ink::g), mix(&Ink::b), mix(&Ink::a)};
      image_.Mix(x, y, ink, 1);
      if (ink.a >= 0.99f) held = near;
    }
  }
}

}  // namespace soarbox::viewer
