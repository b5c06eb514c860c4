// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "world/physics_field.h"
#include "world/physics_probe.h"
#include "world/ways_around.h"

// Which level ways are open among bodies, for the physics_*.cpp files only.
namespace soarbox::world {

/// The bodies that a walker may meet, whatever its direction. Of most it is certain from above whether they are in the
/// way, four at a time: they stand upright and fill a circle. The others are tested as rays are (EntryOf), so that the
/// answer is that of rays.
class LevelWays {
 public:
  /// `reach_m`: how far from the walker's place its ways and their sides may extend.
  LevelWays(const Walker& walker, float reach_m);

  /// The box outside of which no body matters.
  const btVector3& low() const { return low_; }
  const btVector3& high() const { return high_; }
  /// Takes each body whose box touches that one, once.
  void Consider(const BoxedBody& each);

  bool IsOpen(Vec3 direction, float length_m) const;

 private:
  static constexpr std::size_t kLanes = 4;
  using Four [[gnu::vector_size(16)]] = btScalar;
  using Mask [[gnu::vector_size(16)]] = int;
  /// Circles seen from above, about the place. No segment that stays outside of the outer one enters the body; each
  /// that goes into the inner one from outside of the outer one does. The inner one is empty if that is not certain.
  struct Circles {
    Four x{}, z{}, outer{}, inner{};
  };
  struct Circle {
    btScalar x, z, outer, inner;
  };
  /// One of the three segments of a way.
  struct Segment {
    btVector3 from, to;
    Probe probe;
    bool Enters(const BoxedBody& each) const;
  };
  struct Way;

  bool IsOwn(const btCollisionObject& body) const;
  Circle CircleOf(const BoxedBody& each) const;
  bool IsPlaneAfar(const BoxedBody& each) const;
  /// Whether the walker stands in the middle of the body, so that it never enters it.
  bool StandsIn(const BoxedBody& each) const;
  bool IsNear(const Circle& circle, const Way& way) const;
  bool IsBlockedForCertain(const Way& way, std::uint64_t& groups) const;
  bool IsOwnFirst(const Way& way, const Segment& segment) const;
  template <class Visit>
  bool VisitNear(const Way& way, std::uint64_t groups, const Visit& visit) const;

  Walker walker_;
  float reach_m_;
  btScalar slack_m_;  ///< SlackAbout its place.
  btVector3 low_, high_;
  std::vector<BoxedBody> own_;  ///< What is not in the walker's way but may hide what is.
  std::vector<BoxedBody> bodies_;
  std::vector<Circles> circles_;  ///< Of the bodies.
};

}  // namespace soarbox::world
