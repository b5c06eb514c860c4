// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/imagery/convex.h"

#include <algorithm>
#include <array>
#include <vector>

namespace soarbox::kernel::imagery {
namespace {

/// Up to four points of the difference of two bodies. Finds the point of their convex hull that is nearest to the
/// origin.
class Simplex {
 public:
  bool Has(const Vec3& point) const {
    return std::find(points_.begin(), points_.begin() + size_, point) != points_.begin() + size_;
  }
  int size() const { return size_; }
  const Vec3& At(int n) const { return points_[static_cast<std::size_t>(n)]; }
  void Add(const Vec3& point) { points_[static_cast<std::size_t>(size_++)] = point; }
  double Extent() const {
    double extent = 0;
    for (int n = 0; n < size_; ++n) extent = std::max(extent, Dot(At(n), At(n)));
    return extent;
  }

  /// Finds the nearest point and drops the corners that do not contribute to it. Returns true if the origin is inside.
  bool Reduce(Vec3& nearest) {
    switch (size_) {
      case 1:
        nearest = At(0);
        return false;
      case 2:
        nearest = OnSegment();
        return false;
      case 3:
        nearest = OnTriangle();
        return false;
      default:
        return InTetrahedron(nearest);
    }
  }

 private:
  void Keep(const Vec3& a) {
    points_[0] = a;
    size_ = 1;
  }
  void Keep(const Vec3& a, const Vec3& b) {
    points_[0] = a;
    points_[1] = b;
    size_ = 2;
  }

  Vec3 OnSegment() {
    const Vec3 a = At(0), b = At(1), along = b - a;
    const double length = Dot(along, along), to = -Dot(a, along);
    if (to <= 0 || length == 0) {
      Keep(a);
      return a;
    }
    if (to >= length) {
      Keep(b);
      return b;
    }
    return a + along * (to / length);
  }

  /// The nearest point of a triangle: on its face, or else on the best of its edges and corners.
  Vec3 OnTriangle() {
    const Vec3 a = At(0), b = At(1), c = At(2);
    const Vec3 ab = b - a, ac = c - a, normal = Cross(ab, ac);
    const double area = Dot(normal, normal);
    const double flat = 1e-30 * Dot(ab, ab) * Dot(ac, ac);
    if (area > flat) {
      // Barycentric coordinates of the origin's projection onto the plane.
      const double of_c = Dot(Cross(ab, -a), normal), of_b = Dot(Cross(-a, ac), normal);
      const double of_a = area - of_b - of_c;
      if (of_a >= 0 && of_b >= 0 && of_c >= 0) return normal * (Dot(a, normal) / area);
    }
    Simplex best;
    Vec3 nearest;
    double least = -1;
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      Simplex edge;
      edge.Keep(from, to);
      const Vec3 point = edge.OnSegment();
      if (least >= 0 && Dot(point, point) >= least) continue;
      least = Dot(point, point);
      best = edge;
      nearest = point;
    }
    *this = best;
    return nearest;
  }

  bool InTetrahedron(Vec3& nearest) {
    const std::array<Vec3, 4> corners = points_;
    const Vec3 inner = Cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double volume = Dot(inner, corners[3] - corners[0]);
    const double scale =
        Length(corners[1] - corners[0]) * Length(corners[2] - corners[0]) * Length(corners[3] - corners[0]);
    const bool flat = std::abs(volume) <= 1e-14 * scale;
    constexpr int kFaces[4][4] = {{0, 1, 2, 3}, {0, 1, 3, 2}, {0, 2, 3, 1}, {1, 2, 3, 0}};
    Simplex best;
    double least = -1;
    for (const auto& face : kFaces) {
      const Vec3 a = corners[static_cast<std::size_t>(face[0])], b = corners[static_cast<std::size_t>(face[1])],
                 c = corners[static_cast<std::size_t>(face[2])], other = corners[static_cast<std::size_t>(face[3])];
      const Vec3 normal = Cross(b - a, c - a);
      // If the origin and the fourth corner are on different sides, the face may be the nearest.
      if (!flat && Dot(normal, other - a) * Dot(normal, -a) >= 0) continue;
      Simplex triangle;
      triangle.points_ = {a, b, c, {}};
      triangle.size_ = 3;
      const Vec3 point = triangle.OnTriangle();
      if (least >= 0 && Dot(point, point) >= least) continue;
      least = Dot(point, point);
      best = triangle;
      nearest = point;
    }
    if (least < 0) return true;
    *this = best;
    return false;
  }

  std::array<Vec3, 4> points_{};
  int size_ = 0;
};

}  // namespace

Vec3 Solid::Support(const Vec3& direction) const {
  if (ellipsoid != nullptr) {
    const Vec3 local = ellipsoid->TurnTransposed(direction);
    const double length = Length(local);
    return length > 0 ? (*ellipsoid)(local * (radius / length)) : ellipsoid->shift();
  }
  double farthest = 0;
  const Vec3* best = nullptr;
  for (const Vec3& point : points) {
    const double along = Dot(point, direction);
    if (best != nullptr && along <= farthest) continue;
    farthest = along;
    best = &point;
  }
  return best == nullptr ? Vec3{} : *best;
}

namespace {

/// A point of the difference of two bodies, and the point of the first body for it.
struct Difference {
  Vec3 corner, of_a;
};

/// The point of `a` that corresponds to a point of the simplex: the same combination of the corners.
Vec3 PointOfFirst(const Simplex& simplex, const Vec3& nearest, std::span<const Difference> seen) {
  const auto of_a = [&](int n) {
    const auto found = std::find_if(seen.begin(), seen.end(),
                                    [&](const Difference& difference) { return difference.corner == simplex.At(n); });
    return found == seen.end() ? Vec3{} : found->of_a;
  };
  if (simplex.size() < 2) return of_a(0);
  const Vec3 along = simplex.At(1) - simplex.At(0), to = nearest - simplex.At(0);
  const double length = Dot(along, along);
  if (simplex.size() == 2) {
    const double share = length > 0 ? Dot(to, along) / length : 0;
    return of_a(0) + (of_a(1) - of_a(0)) * share;
  }
  const Vec3 other = simplex.At(2) - simplex.At(0), normal = Cross(along, other);
  const double area = Dot(normal, normal);
  if (area <= 0) return of_a(0);
  const double of_second = Dot(Cross(to, other), normal) / area, of_third = Dot(Cross(along, to), normal) / area;
  return of_a(0) + (of_a(1) - of_a(0)) * of_second + (of_a(2) - of_a(0)) * of_third;
}

/// The shortest vector from the core of b to that of a, and the size of the compared bodies. Returns false if they
/// touch. `on_a`: receives its end on a, if not null.
bool NearestVector(const Solid& a, const Solid& b, Vec3& nearest, double& extent, Vec3* on_a = nullptr) {
  constexpr int kMostSteps = 200;
  Simplex simplex;
  std::vector<Difference> seen;
  const auto add = [&](const Vec3& corner, const Vec3& of_a) {
    simplex.Add(corner);
    if (on_a != nullptr) seen.push_back({corner, of_a});
  };
  const Vec3 first = a.Support({1, 0, 0});
  nearest = first - b.Support({-1, 0, 0});
  add(nearest, first);
  extent = Dot(nearest, nearest);
  for (int step = 0; step < kMostSteps; ++step) {
    const double square = Dot(nearest, nearest);
    // Almost touching, relative to the size of the compared bodies.
    if (!(square > 1e-22 * extent)) return false;
    const Vec3 of_a = a.Support(-nearest), corner = of_a - b.Support(nearest);
    const double progress = square - Dot(nearest, corner);
    if (progress <= 1e-13 * square || simplex.Has(corner)) break;
    add(corner, of_a);
    extent = std::max(extent, Dot(corner, corner));
    Vec3 next;
    if (simplex.Reduce(next)) return false;
    if (!(Dot(next, next) < square)) break;  // Because of rounding, it is not nearer.
    nearest = next;
  }
  if (on_a != nullptr) *on_a = PointOfFirst(simplex, nearest, seen);
  return true;
}

}  // namespace

double DistanceBetween(const Solid& a, const Solid& b) {
  Vec3 nearest;
  double extent = 0;
  if (!NearestVector(a, b, nearest, extent)) return 0;
  const double distance = Length(nearest) - (a.margin + b.margin);
  return distance > 1e-11 * std::sqrt(extent) ? distance : 0;
}

bool ShortestBetween(const Solid& a, const Solid& b, Vec3& from, Vec3& to) {
  Vec3 nearest;
  double extent = 0;
  if (!NearestVector(a, b, nearest, extent, &from)) return false;
  to = from - nearest;
  const double length = Length(nearest);
  if (length <= a.margin + b.margin) return false;
  const Vec3 unit = nearest * (1 / length);
  from = from - unit * a.margin;
  to = to + unit * b.margin;
  return true;
}

bool HasPoint(const Solid& solid, const Vec3& point) {
  if (solid.ellipsoid == nullptr && solid.points.size() == 1) {
    // As in Soar 9.6.3, points just below the surface of a ball do not belong to it.
    constexpr double kSkin = 2e-4;
    return Distance(solid.points[0], point) <= solid.margin * (1 - kSkin);
  }
  Solid single;
  single.points = std::span(&point, 1);
  return DistanceBetween(solid, single) <= 0;
}

}  // namespace soarbox::kernel::imagery
