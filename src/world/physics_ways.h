// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "world/physics_field.h"
#include "world/physics_probe.h"
#include "world/ways_around.h"

// Which horizontal paths are free among bodies; for the physics_*.cpp files only.
namespace soarbox::world {

/// The bodies that may block a walker in any direction. Most of them are upright and fill a circle. For these, a view
/// from above shows whether they block a path; this is computed for four bodies at a time. The others are tested with
/// EntryOf, as for a ray. The answer is the same as if all were tested in this way.
class LevelWays {
 public:
  /// `reach_m`: maximum distance from the walker's position of all points of its paths, including their sides.
  LevelWays(const Walker& walker, float reach_m);

  /// The box that contains all bodies that matter.
  const btVector3& low() const { return low_; }
  const btVector3& high() const { return high_; }
  /// Adds a body. Call it once for each body whose box overlaps that box.
  void Consider(const BoxedBody& each);

  bool IsOpen(Vec3 direction, float length_m) const;

 private:
  static constexpr std::size_t kLanes = 4;
  using Four [[gnu::vector_size(16)]] = btScalar;
  using Mask [[gnu::vector_size(16)]] = int;
  /// Two concentric circles per body, seen from above, relative to the walker's position. A segment that stays outside
  /// the outer circle does not enter the body. A segment from outside the outer circle into the inner one does. The
  /// inner circle is empty if that is not certain.
  struct Circles {
    Four x{}, z{}, outer{}, inner{};
  };
  struct Circle {
    btScalar x, z, outer, inner;
  };
  /// One of the three segments of a path.
  struct Segment {
    btVector3 from, to;
    Probe probe;
    bool Enters(const BoxedBody& each) const;
  };
  struct Way;

  bool IsOwn(const btCollisionObject& body) const;
  Circle CircleOf(const BoxedBody& each) const;
  bool IsPlaneAfar(const BoxedBody& each) const;
  /// Whether the walker is inside the body, so that its paths never enter it.
  bool StandsIn(const BoxedBody& each) const;
  bool IsNear(const Circle& circle, const Way& way) const;
  bool IsBlockedForCertain(const Way& way, std::uint64_t& groups) const;
  bool IsOwnFirst(const Way& way, const Segment& segment) const;
  template <class Visit>
  bool VisitNear(const Way& way, std::uint64_t groups, const Visit& visit) const;

  Walker walker_;
  float reach_m_;
  btScalar slack_m_;  ///< SlackAbout the walker's position.
  btVector3 low_, high_;
  std::vector<BoxedBody> own_;  ///< Bodies that do not block the walker, but may hide others.
  std::vector<BoxedBody> bodies_;
  std::vector<Circles> circles_;  ///< Circles of bodies_.
};

}  // namespace soarbox::world
