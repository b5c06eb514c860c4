// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "world/bodies_around.h"
#include "world/physics_directions.h"
#include "world/physics_probe.h"
#include "world/physics_trees.h"

// What is on a segment, for the physics_*.cpp files only. Changes nothing, so that several threads may ask at a time.
namespace soarbox::world {

/// The first body that the segment enters; of several at one point, the one with the smallest owner.
FirstHit FindFirstHit(const AllBodies& bodies, const btVector3& from, const btVector3& to);

/// Whether the segment enters no body: FindFirstHit finds none.
bool EntersNothing(const AllBodies& bodies, const btVector3& from, const btVector3& to);

/// Whether nothing but these two is on the segment in front of the target. The target may be null.
bool IsClear(const AllBodies& bodies, const btVector3& from, const btVector3& to, const btCollisionObject* viewer,
             const btCollisionObject* target);

/// The bodies around somebody who looks, for many segments from there: each looks at those of its own direction that it
/// comes near, seen from above.
class NearBodies {
 public:
  NearBodies(const AllBodies& bodies, const View& view);

  /// Whether the segment to one of two places above each other, within the view, is clear (IsClear).
  bool IsClearToEither(const btVector3& from, const btVector3& to, const btVector3& other,
                       const btCollisionObject* viewer, const btCollisionObject* target) const;
  /// FindFirstHit of a segment from there to a place within the view.
  FirstHit FindFirst(const btVector3& from, const btVector3& to) const;

 private:
  /// A plane is on all lines seen from above, but few cross it.
  struct Plane {
    BoxedBody body;
    WorldPlane plane;
  };

  struct Line;

  template <class Visit>
  bool VisitNear(const Line& line, const Visit& visit) const;
  bool HidesForCertain(const BoxedBody& each, const Line& line, btScalar rise, btScalar before, btScalar along,
                       btScalar beside) const;

  btScalar slack_m_;               ///< SlackAbout the viewer.
  std::vector<BoxedBody> bodies_;  ///< Their circles are about the viewer.
  std::vector<Plane> planes_;
  Directions directions_;  ///< Of the bodies.
};

}  // namespace soarbox::world
