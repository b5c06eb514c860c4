// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "world/physics_bullet.h"
#include "world/physics_ray.h"

// What is on a segment, for the physics_*.cpp files only. Reads the broad phase's trees and changes nothing, so that
// several threads may ask at a time.
namespace soarbox::world {

class CrowdBroadphase;

struct FirstHit {
  const btCollisionObject* body = nullptr;
  RayEntry entry;
};
/// The first body that the segment enters; of several at one point, the one with the smallest owner.
FirstHit FindFirstHit(const CrowdBroadphase& bodies, const btVector3& from, const btVector3& to);

/// The bodies around a place, for many segments there. For segments within the box it gives the same answers as the
/// functions for all bodies: it passes over four bodies at a time if the segment, seen from above, does not come near
/// them.
class NearBodies {
 public:
  /// Those whose boxes touch that box.
  NearBodies(const CrowdBroadphase& bodies, const btVector3& low, const btVector3& high);

  FirstHit FindFirst(const btVector3& from, const btVector3& to) const;
  /// Whether the first body that the segment enters is of one of these two owners, or there is none.
  bool IsOpen(const btVector3& from, const btVector3& to, int owner, int other) const;
  bool IsClear(const btVector3& from, const btVector3& to, const btCollisionObject* viewer,
               const btCollisionObject* target) const;

 private:
  struct Boxed {
    btDbvtVolume box;
    const btCollisionObject* body = nullptr;
  };
  static constexpr std::size_t kLanes = 4;
  using Four [[gnu::vector_size(16)]] = btScalar;
  /// Circles around four bodies' boxes, seen from above.
  struct Circles {
    Four x{}, z{}, radius{};
  };

  template <class Visit>
  bool VisitNear(const btVector3& from, const btVector3& to, const Visit& visit) const;

  std::vector<Boxed> bodies_;
  std::vector<Circles> circles_;
};

/// Whether nothing but these two is on the segment in front of the target. The target may be null.
bool IsClear(const CrowdBroadphase& bodies, const btVector3& from, const btVector3& to, const btCollisionObject* viewer,
             const btCollisionObject* target);

}  // namespace soarbox::world
