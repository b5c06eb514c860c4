// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "world/bodies_around.h"
#include "world/physics_directions.h"
#include "world/physics_probe.h"
#include "world/physics_trees.h"

// Queries along segments; for the physics_*.cpp files only. They change nothing, so several threads may query at a
// time.
namespace soarbox::world {

/// The first body that the segment enters. If it enters several at the same point, the one with the smallest owner.
FirstHit FindFirstHit(const AllBodies& bodies, const btVector3& from, const btVector3& to);

/// Whether the segment enters no body, that is, FindFirstHit finds none.
bool EntersNothing(const AllBodies& bodies, const btVector3& from, const btVector3& to);

/// Whether no body except these two is on the segment before the target. The target may be null.
bool IsClear(const AllBodies& bodies, const btVector3& from, const btVector3& to, const btCollisionObject* viewer,
             const btCollisionObject* target);

/// The bodies around a viewer, for many segments from the same position. A query tests only bodies in the direction of
/// the segment and close to it, seen from above.
class NearBodies {
 public:
  NearBodies(const AllBodies& bodies, const View& view);

  /// Whether the segment to at least one of two points, one above the other and within the view, is clear (IsClear).
  bool IsClearToEither(const btVector3& from, const btVector3& to, const btVector3& other,
                       const btCollisionObject* viewer, const btCollisionObject* target) const;
  /// Like FindFirstHit, for a segment from the viewer to a point within the view.
  FirstHit FindFirst(const btVector3& from, const btVector3& to) const;
  /// Whether FindFirst finds nothing, or a body of one of these owners.
  bool MeetsNoOther(const btVector3& from, const btVector3& to, int viewer, int target) const;

 private:
  /// Planes are not in the index of directions: seen from above, a plane is in every direction.
  struct Plane {
    BoxedBody body;
    WorldPlane plane;
  };

  struct Line;

  template <class Visit>
  bool VisitNear(const Line& line, const Visit& visit) const;
  bool HidesForCertain(const BoxedBody& each, const Line& line, btScalar rise, btScalar before, btScalar along,
                       btScalar beside) const;
  bool IsInside(const BoxedBody& each, const btVector3& point) const;

  btScalar slack_m_;               ///< SlackAbout the viewer's position.
  std::vector<BoxedBody> bodies_;  ///< Their circles are relative to the viewer.
  std::vector<Plane> planes_;
  Directions directions_;  ///< Index of bodies_.
};

}  // namespace soarbox::world
