// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/imagery/space.h"

#include <algorithm>

namespace soarbox::kernel::imagery {
namespace {

using Rows = std::array<Vec3, 3>;

Vec3 ColumnOf(const Rows& rows, int column) {
  return {rows[0][column], rows[1][column], rows[2][column]};
}

Rows ProductOf(const Rows& a, const Rows& b) {
  Rows result;
  for (int column = 0; column < 3; ++column) {
    const Vec3 of_b = ColumnOf(b, column);
    for (int row = 0; row < 3; ++row)
      result[static_cast<std::size_t>(row)][column] = Dot(a[static_cast<std::size_t>(row)], of_b);
  }
  return result;
}

Rows RotationAbout(int axis, double angle) {
  const double sine = std::sin(angle), cosine = std::cos(angle);
  const int next = (axis + 1) % 3, after = (axis + 2) % 3;
  Rows rows{};
  const auto at = [&](int row, int column) -> double& { return rows[static_cast<std::size_t>(row)][column]; };
  at(axis, axis) = 1;
  at(next, next) = at(after, after) = cosine;
  at(after, next) = sine;
  at(next, after) = -sine;
  return rows;
}

double Determinant(const Rows& rows) {
  return Dot(rows[0], Cross(rows[1], rows[2]));
}

/// The rotation nearest to a regular matrix, by Newton's iteration for the polar decomposition.
Rows NearestRotation(Rows rows) {
  for (int step = 0; step < 60; ++step) {
    const double determinant = Determinant(rows);
    if (std::abs(determinant) < 1e-300) break;
    // The rows of the transposed inverse are the cofactors.
    const Rows inverse{Cross(rows[1], rows[2]) * (1 / determinant), Cross(rows[2], rows[0]) * (1 / determinant),
                       Cross(rows[0], rows[1]) * (1 / determinant)};
    double moved = 0;
    for (std::size_t row = 0; row < 3; ++row) {
      const Vec3 next = (rows[row] + inverse[row]) * 0.5;
      moved = std::max(moved, Length(next - rows[row]));
      rows[row] = next;
    }
    if (moved < 1e-15) break;
  }
  return rows;
}

std::array<double, 4> QuaternionOf(const Rows& rows) {
  const double xx = rows[0].x, yy = rows[1].y, zz = rows[2].z;
  const double trace = xx + yy + zz;
  if (trace > 0) {
    const double root = std::sqrt(trace + 1), factor = 0.5 / root;
    return {(rows[2].y - rows[1].z) * factor, (rows[0].z - rows[2].x) * factor, (rows[1].x - rows[0].y) * factor,
            0.5 * root};
  }
  const int first = xx >= yy && xx >= zz ? 0 : yy >= zz ? 1 : 2;
  const int second = (first + 1) % 3, third = (first + 2) % 3;
  const auto at = [&](int row, int column) { return rows[static_cast<std::size_t>(row)][column]; };
  const double root = std::sqrt(std::max(0.0, at(first, first) - at(second, second) - at(third, third) + 1));
  if (root == 0) return {0, 0, 0, 1};
  const double factor = 0.5 / root;
  std::array<double, 4> result{};
  result[static_cast<std::size_t>(first)] = 0.5 * root;
  result[3] = (at(third, second) - at(second, third)) * factor;
  result[static_cast<std::size_t>(second)] = (at(second, first) + at(first, second)) * factor;
  result[static_cast<std::size_t>(third)] = (at(third, first) + at(first, third)) * factor;
  return result;
}

}  // namespace

// Boxes ---------------------------------------------------------------------------------------------------------------

void Box::Include(const Vec3& point) {
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = std::min(low[axis], point[axis]);
    high[axis] = std::max(high[axis], point[axis]);
  }
}

void Box::Include(const Box& other) {
  Include(other.low);
  Include(other.high);
}

bool Box::Touches(const Box& other) const {
  for (int axis = 0; axis < 3; ++axis) {
    if (high[axis] < other.low[axis] || low[axis] > other.high[axis]) return false;
  }
  return true;
}

bool Box::Contains(const Box& other) const {
  for (int axis = 0; axis < 3; ++axis) {
    if (high[axis] < other.high[axis] || low[axis] > other.low[axis]) return false;
  }
  return true;
}

double Box::Gap(const Box& other) const {
  Vec3 gap;
  for (int axis = 0; axis < 3; ++axis) {
    gap[axis] = std::max({0.0, other.low[axis] - high[axis], low[axis] - other.high[axis]});
  }
  return Length(gap);
}

// Transforms ----------------------------------------------------------------------------------------------------------

Transform::Transform(const Pose& pose) : shift_(pose.position) {
  if (pose.rotation != Vec3{}) {
    rows_ = ProductOf(ProductOf(RotationAbout(2, pose.rotation.z), RotationAbout(1, pose.rotation.y)),
                      RotationAbout(0, pose.rotation.x));
  }
  for (Vec3& row : rows_) {
    for (int axis = 0; axis < 3; ++axis) row[axis] *= pose.scale[axis];
  }
}

Vec3 Transform::Turn(const Vec3& direction) const {
  return {Dot(rows_[0], direction), Dot(rows_[1], direction), Dot(rows_[2], direction)};
}

Vec3 Transform::TurnTransposed(const Vec3& direction) const {
  return rows_[0] * direction.x + rows_[1] * direction.y + rows_[2] * direction.z;
}

Transform operator*(const Transform& outer, const Transform& inner) {
  Transform result;
  result.rows_ = ProductOf(outer.rows_, inner.rows_);
  result.shift_ = outer(inner.shift_);
  return result;
}

double Transform::UniformScale() const {
  const Vec3 x = ColumnOf(rows_, 0), y = ColumnOf(rows_, 1), z = ColumnOf(rows_, 2);
  const double square = Dot(x, x), tolerance = 1e-12 * square;
  const auto near = [&](double a, double b) { return std::abs(a - b) <= tolerance; };
  const bool keeps_angles = near(Dot(y, y), square) && near(Dot(z, z), square) && near(Dot(x, y), 0) &&
                            near(Dot(y, z), 0) && near(Dot(x, z), 0);
  return keeps_angles ? std::sqrt(square) : -1;
}

Transform::Parts Transform::Decompose() const {
  Parts parts;
  parts.position = shift_;
  const std::array<Vec3, 3> columns{ColumnOf(rows_, 0), ColumnOf(rows_, 1), ColumnOf(rows_, 2)};
  const Vec3 lengths{Length(columns[0]), Length(columns[1]), Length(columns[2])};
  const auto upright = [&](std::size_t a, std::size_t b) {
    const double both = lengths[static_cast<int>(a)] * lengths[static_cast<int>(b)];
    return std::abs(Dot(columns[a], columns[b])) <= 1e-14 * both;
  };
  Rows rotation{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  if (lengths.x > 0 && lengths.y > 0 && lengths.z > 0) {
    if (upright(0, 1) && upright(1, 2) && upright(0, 2)) {
      for (int axis = 0; axis < 3; ++axis) {
        for (std::size_t row = 0; row < 3; ++row) rotation[row][axis] = rows_[row][axis] / lengths[axis];
      }
      parts.scale = lengths;
    } else {
      rotation = NearestRotation(rows_);
      for (int axis = 0; axis < 3; ++axis) {
        parts.scale[axis] = Dot(ColumnOf(rotation, axis), columns[static_cast<std::size_t>(axis)]);
      }
    }
    if (Determinant(rotation) < 0) {  // A reflection: the scaling gets the negative sign.
      for (Vec3& row : rotation) row = -row;
      parts.scale = -parts.scale;
    }
  } else {
    parts.scale = lengths;
  }
  parts.rotation = QuaternionOf(rotation);
  for (double& part : parts.rotation) part += 0.0;  // Avoids -0.
  return parts;
}

}  // namespace soarbox::kernel::imagery
