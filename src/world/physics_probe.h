// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <cstring>

#include "world/physics_bullet.h"
#include "world/physics_ray.h"

// Tests of a segment against bodies; for the physics_*.cpp files only.
namespace soarbox::world {

/// A segment prepared for tests against bounding boxes. It computes with vectors of four numbers, of which the fourth
/// is unused.
class Probe {
 public:
  Probe(const btVector3& from, const btVector3& to) {
    constexpr btScalar kLarge = 1e18f;
    const btVector3 along = to - from;
    for (int axis = 0; axis < 3; ++axis) inverse_[axis] = along[axis] != 0 ? 1 / along[axis] : kLarge;
    for (int axis = 0; axis < 3; ++axis) from_[axis] = from[axis];
  }

  /// Whether the segment, from its start to the fraction `share`, intersects the box.
  bool Meets(const btDbvtVolume& box, btScalar share) const {
    const Four a = (Load(box.Mins()) - from_) * inverse_, b = (Load(box.Maxs()) - from_) * inverse_;
    const Four enter = a < b ? a : b, leave = a < b ? b : a;
    return std::max(std::max(enter[0], enter[1]), std::max(enter[2], btScalar{0})) <=
           std::min(std::min(leave[0], leave[1]), std::min(leave[2], share));
  }

 private:
  using Four [[gnu::vector_size(16)]] = btScalar;
  static Four Load(const btVector3& vector) {
    static_assert(sizeof(Four) == sizeof(btVector3));
    Four loaded;
    std::memcpy(&loaded, &vector, sizeof(loaded));  // Not aligned.
    return loaded;
  }

  Four from_{}, inverse_{};
};

struct FirstHit {
  const btCollisionObject* body = nullptr;
  RayEntry entry;
};

/// If the segment enters the body before the first hit so far, makes it the first hit. If it enters both at the same
/// point, the body with the smaller owner wins.
inline void TakeIfFirst(const btCollisionObject& body, const btVector3& from, const btVector3& to, FirstHit& first,
                        btScalar& share) {
  const auto entry = EntryOf(body, from, to);
  if (!entry || entry->fraction > share) return;
  const bool ties = first.body != nullptr && entry->fraction == share;
  if (ties && body.getUserIndex() >= first.body->getUserIndex()) return;
  first = {&body, *entry};
  share = entry->fraction;
}

}  // namespace soarbox::world
