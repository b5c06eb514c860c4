// SPDX-License-Identifier: BSD-2-Clause
#include "world/path.h"

#include <algorithm>
#include <cmath>

namespace soarbox::world {

Path::Path(std::span<const Vec3> points, bool cyclic, float radius_m)
    : points_(points.begin(), points.end()), cyclic_(cyclic), radius_m_(radius_m) {
  if (cyclic && !points_.empty()) points_.push_back(points_.front());
  distances_.reserve(points_.size());
  float distance = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (i > 0) distance += Distance(points_[i - 1], points_[i]);
    distances_.push_back(distance);
  }
}

Path::Nearest Path::NearestTo(Vec3 query) const {
  if (points_.empty()) return {query, 0};
  Nearest best{points_.front(), 0};
  float best_squared = LengthSquared(query - points_.front());
  for (std::size_t i = 1; i < points_.size(); ++i) {
    const Vec3 start = points_[i - 1];
    const Vec3 along = points_[i] - start;
    const float squared = LengthSquared(along);
    if (!(squared > 0)) continue;
    const float fraction = std::clamp(Dot(query - start, along) / squared, 0.0f, 1.0f);
    const Vec3 point = start + along * fraction;
    const float distance_squared = LengthSquared(query - point);
    if (distance_squared < best_squared) {
      best_squared = distance_squared;
      best = {point, distances_[i - 1] + fraction * (distances_[i] - distances_[i - 1])};
    }
  }
  return best;
}

Vec3 Path::PointAt(float distance_along_m) const {
  if (points_.empty()) return {};
  const float length = length_m();
  if (!(length > 0)) return points_.front();
  float distance = distance_along_m;
  if (cyclic_) {
    distance = std::fmod(distance, length);
    if (distance < 0) distance += length;
  }
  if (!(distance > 0)) return points_.front();
  if (distance >= length) return points_.back();
  // The first point after the distance. It has a predecessor, because distance > 0.
  const auto next = std::upper_bound(distances_.begin(), distances_.end(), distance);
  const auto i = static_cast<std::size_t>(next - distances_.begin());
  const float segment = distances_[i] - distances_[i - 1];
  const float fraction = segment > 0 ? (distance - distances_[i - 1]) / segment : 0.0f;
  return points_[i - 1] + (points_[i] - points_[i - 1]) * fraction;
}

}  // namespace soarbox::world
