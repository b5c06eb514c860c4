// SPDX-License-Identifier: BSD-2-Clause
#include "world/physics_field.h"

#include "world/physics_trees.h"

namespace soarbox::world {
namespace {

constexpr btScalar kCell_m = 2, kLargestCell_m = 8;
constexpr btScalar kWide_m = 1.5f;  ///< From the centre to the end of the box.
constexpr std::size_t kMostWide = 128;

btScalar HalfWidthOf(const btDbvtVolume& box) {
  const btVector3 half = box.Extents();
  return std::max(half.x(), half.z());
}

}  // namespace

void BodyField::Build(const CrowdBroadphase& bodies) {
  Forget();
  wide_.clear();
  scratch_.clear();
  constexpr btScalar kFar_m = 1e30f;
  btScalar low_x = kFar_m, low_z = kFar_m, high_x = -kFar_m, high_z = -kFar_m, widest = 0;
  const bool are_few = VisitTrees(
      bodies, [](const btDbvtVolume&) { return true; },
      [&](const btDbvtVolume& box, const btCollisionObject& body) {
        const btScalar half = HalfWidthOf(box);
        if (!(half <= kWide_m)) {
          wide_.push_back(SeenFromAbove(body, box));
          return wide_.size() <= kMostWide;
        }
        const btVector3 middle = box.Center();
        widest = std::max(widest, half);
        low_x = std::min(low_x, middle.x());
        low_z = std::min(low_z, middle.z());
        high_x = std::max(high_x, middle.x());
        high_z = std::max(high_z, middle.z());
        scratch_.push_back(SeenFromAbove(body, box));
        return true;
      });
  if (!are_few || scratch_.empty()) return;
  corner_x_m_ = low_x;
  corner_z_m_ = low_z;
  const btScalar most_cells = static_cast<btScalar>(4 * scratch_.size() + 256);
  for (cell_m_ = kCell_m; ((high_x - low_x) / cell_m_ + 1) * ((high_z - low_z) / cell_m_ + 1) > most_cells;
       cell_m_ *= 2)
    if (cell_m_ >= kLargestCell_m) return;
  columns_ = static_cast<std::size_t>((high_x - low_x) / cell_m_) + 1;
  rows_ = static_cast<std::size_t>((high_z - low_z) / cell_m_) + 1;
  // An upper bound of rounding errors, here and in queries.
  constexpr btScalar kSlack_m = 0.02f, kSlack = 1e-5f;
  const btScalar farthest = std::max(std::max(-low_x, high_x), std::max(-low_z, high_z));
  reach_m_ = widest + kSlack_m + kSlack * std::max(farthest, btScalar{0});

  starts_.assign(columns_ * rows_ + 1, 0);
  cells_.resize(scratch_.size());
  for (std::size_t i = 0; i < scratch_.size(); ++i) {
    const btVector3 middle = scratch_[i].box.Center();
    cells_[i] = Row(middle.z()) * columns_ + Column(middle.x());
    ++starts_[cells_[i] + 1];
  }
  for (std::size_t cell = 1; cell < starts_.size(); ++cell) starts_[cell] += starts_[cell - 1];
  bodies_.resize(scratch_.size());
  // Filling a cell moves its start to the start of the next cell; the second loop moves the starts back.
  for (std::size_t i = 0; i < scratch_.size(); ++i) bodies_[starts_[cells_[i]]++] = scratch_[i];
  for (std::size_t cell = starts_.size() - 1; cell > 0; --cell) starts_[cell] = starts_[cell - 1];
  starts_[0] = 0;
  is_known_ = true;
}

}  // namespace soarbox::world
