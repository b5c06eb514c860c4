// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "world/physics_boxed.h"

// A spatial index of all bodies; for the physics_*.cpp files only.
namespace soarbox::world {

class CrowdBroadphase;

/// All bodies in a grid over the ground plane, stored row by row. It serves the many short queries of a crowd between
/// two steps: a query reads a few cells instead of traversing the trees of the broadphase. Bodies that are wider than
/// 3 m are in a list that every query scans.
///
/// Invariant: while is_known(), it contains each body of the trees with the same bounding box. Code that changes a box
/// must call Forget. Several threads may query at a time.
class BodyField {
 public:
  /// Builds the grid. Leaves it unknown if it would be slower than the trees: if the bodies are too far apart, or if
  /// too many or all of them are wide.
  void Build(const CrowdBroadphase& bodies);
  void Forget() { is_known_ = false; }
  bool is_known() const { return is_known_; }
  static constexpr btScalar kLongest_m = 8;  ///< Longer queries are equally fast with the trees.

  /// Calls visit(const BoxedBody&) for each body whose box overlaps this box, and possibly for others.
  template <class Visit>
  void VisitBox(const btVector3& low, const btVector3& high, const Visit& visit) const;
  /// The same for each body whose box intersects the segment. If visit returns false, stops and returns false. The
  /// segment must not be longer than kLongest_m.
  template <class Visit>
  bool VisitAlong(const btVector3& from, const btVector3& to, const Visit& visit) const;

 private:
  std::size_t Column(btScalar x) const { return Cell(x - corner_x_m_, columns_); }
  std::size_t Row(btScalar z) const { return Cell(z - corner_z_m_, rows_); }
  std::size_t Cell(btScalar distance_m, std::size_t count) const {
    const btScalar last = static_cast<btScalar>(count - 1);
    return static_cast<std::size_t>(std::clamp(distance_m / cell_m_, btScalar{0}, last));
  }
  template <class Visit>
  bool VisitCells(std::size_t row, btScalar from_x, btScalar to_x, const Visit& visit) const {
    const std::size_t* const starts = &starts_[row * columns_];
    const std::size_t end = starts[Column(to_x) + 1];
    for (std::size_t i = starts[Column(from_x)]; i < end; ++i)
      if (!visit(bodies_[i])) return false;
    return true;
  }

  bool is_known_ = false;
  btScalar cell_m_ = 0, corner_x_m_ = 0, corner_z_m_ = 0;
  btScalar reach_m_ = 0;  ///< Maximum distance from the centre of a body in the grid to the end of its box, with some
                          ///< slack.
  std::size_t columns_ = 1, rows_ = 1;
  std::vector<BoxedBody> wide_;
  std::vector<BoxedBody> bodies_;    ///< Sorted by cell.
  std::vector<std::size_t> starts_;  ///< First body of each cell; has one more element than there are cells.
  std::vector<BoxedBody> scratch_;
  std::vector<std::size_t> cells_;  ///< Temporary: the cell of each body in scratch_.
};

template <class Visit>
void BodyField::VisitBox(const btVector3& low, const btVector3& high, const Visit& visit) const {
  const auto always = [&](const BoxedBody& each) {
    visit(each);
    return true;
  };
  for (const BoxedBody& each : wide_) visit(each);
  const std::size_t last = Row(high.z() + reach_m_);
  for (std::size_t row = Row(low.z() - reach_m_); row <= last; ++row)
    VisitCells(row, low.x() - reach_m_, high.x() + reach_m_, always);
}

template <class Visit>
bool BodyField::VisitAlong(const btVector3& from, const btVector3& to, const Visit& visit) const {
  for (const BoxedBody& each : wide_)
    if (!visit(each)) return false;
  const btVector3 along = to - from;
  const std::size_t last = Row(std::max(from.z(), to.z()) + reach_m_);
  for (std::size_t row = Row(std::min(from.z(), to.z()) - reach_m_); row <= last; ++row) {
    // The part of the segment that can intersect bodies of this row.
    btScalar begin = 0, end = 1;
    if (along.z() != 0) {
      const btScalar low_m = corner_z_m_ + static_cast<btScalar>(row) * cell_m_ - reach_m_ - from.z();
      const btScalar high_m = low_m + cell_m_ + 2 * reach_m_;
      const btScalar one = low_m / along.z(), other = high_m / along.z();
      begin = std::max(begin, std::min(one, other));
      end = std::min(end, std::max(one, other));
      if (begin > end) continue;
    }
    const btScalar first_x = from.x() + along.x() * begin, last_x = from.x() + along.x() * end;
    if (!VisitCells(row, std::min(first_x, last_x) - reach_m_, std::max(first_x, last_x) + reach_m_, visit))
      return false;
  }
  return true;
}

}  // namespace soarbox::world
