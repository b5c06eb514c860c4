// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "world/bodies_around.h"
#include "world/collision.h"
#include "world/ids.h"
#include "world/math.h"
#include "world/media_catalog.h"
#include "world/scene_snapshot.h"
#include "world/settings.h"
#include "world/steer_avoid_objects.h"
#include "world/ways_around.h"
#include "world/workers.h"

namespace soarbox::world {

enum class BodyId : std::uint32_t { kNone = 0 };

enum class BodyShape : std::uint8_t {
  kBox,      ///< size = full extents.
  kCapsule,  ///< Upright; size.x = radius, size.y = total height.
  kSphere,   ///< size.x = radius.
  kPlane,    ///< The half-space below y = 0 of the body.
  kMesh,     ///< The box bounds; the centre of mass is the mesh's origin.
};

struct BodyDef {
  BodyShape shape = BodyShape::kBox;
  Vec3 size{1, 1, 1};
  MeshBounds bounds;     ///< kMesh only.
  bool doorway = false;  ///< kMesh only: the wall has an opening at its foot (modular_meshes.h).
  float mass_kg = 1;     ///< 0 = fixed.
  bool upright = false;  ///< Contacts never turn it, and it may not be an obstacle: an agent.
  bool sensor = false;   ///< Fixed. Meets nothing and is met by nothing, rays included; see SensorChanges.
  Vec3 position;
  Quat orientation;
  EntityId owner = kNoEntity;
};

/// The rigid bodies of one world, on Bullet; the rest of the module does not see Bullet. Units are SI.
///
/// Deterministic: bodies, pairs and contacts are visited in an order that follows from the calls alone, the solver is
/// scalar and keeps its order. Values handed in are finite (callers check); ids must be alive. A body id may be given
/// again after Remove.
class PhysicsWorld {
 public:
  explicit PhysicsWorld(const WorldSettings& settings);
  /// Whether so many bodies have overlapped at once that further ones passed through each other.
  bool IsCrowded() const;
  ~PhysicsWorld();

  BodyId Add(const BodyDef& def);
  void Remove(BodyId body);

  Vec3 Position(BodyId body) const;
  Quat Orientation(BodyId body) const;
  Vec3 Velocity(BodyId body) const;
  Vec3 AngularVelocity(BodyId body) const;
  float Mass(BodyId body) const;
  bool IsSleeping(BodyId body) const;
  /// Half the diagonal of the bounding box.
  float Radius(BodyId body) const;
  /// The lowest and highest corner of the box around the shape, in the body's own frame.
  std::pair<Vec3, Vec3> LocalBox(BodyId body) const;

  // All of these wake the body.
  void SetPosition(BodyId body, Vec3 position);
  void SetOrientation(BodyId body, Quat orientation);
  void SetVelocity(BodyId body, Vec3 velocity);
  void SetAngularVelocity(BodyId body, Vec3 velocity);
  void SetMass(BodyId body, float mass_kg);
  void SetGravity(BodyId body, Vec3 gravity);
  /// For one step.
  void ApplyForce(BodyId body, Vec3 force_n);
  void ApplyAngularImpulse(BodyId body, Vec3 impulse);

  /// `other`: the body that has the axis; kNone: the axis stays where it is. The hinge goes with either body.
  void AddHinge(BodyId body, const HingeDef& hinge, BodyId other);
  /// Removes the hinges that were added for this body.
  void RemoveHinges(BodyId body);
  std::size_t hinge_count() const;

  /// One step. Bodies that leave the range of the numbers are put back at its edge, at rest.
  void Step(float step_s, const Workers& workers = {});
  /// Those that may have moved by themselves in the last step: those that could move and did not sleep. In a fixed
  /// order; some may have gone since, and their ids may belong to others.
  std::span<const BodyId> MovedBodies() const;
  struct Push {
    BodyId body = BodyId::kNone;
    Vec3 force_n;
    Vec3 spin_rad_s{};
  };
  /// What was applied for the last step, in the order of the calls, the first kMostPushes of them: forces; for
  /// velocities that were set, the force that would have changed them so; for angular impulses, the change of the
  /// angular velocity. Nothing in a run depends on it.
  const std::vector<Push>& LastPushes() const;
  static constexpr std::size_t kMostPushes = 8192;
  /// Whether the body is still there, and whose it is.
  EntityId OwnerOf(BodyId body) const;
  /// Sorted by (a, b).
  const std::vector<Collision>& Collisions() const;
  /// Which bodies that can move came into sensors and left them in the last step. Sorted by sensor; those that left
  /// come first, each kind in ascending order.
  const std::vector<SensorChange>& SensorChanges() const;
  std::optional<RayHit> RayCast(Vec3 from, Vec3 to) const;
  /// Makes the questions above and below cheaper until a body moves, comes or goes. Pays off for some for each body.
  void PrepareRays();
  /// Whether nothing but these two is on one of the segments to two places above each other, in front of the target's
  /// surface; either may be kNone. Much faster than RayCast where many bodies are on the way. `around`: of a view that
  /// holds the places, or null.
  bool IsClearToEither(Vec3 from, Vec3 to, Vec3 other, BodyId viewer, BodyId target, const BodiesAround* around) const;
  /// Bounding spheres of the bodies that can move and are not upright, by ascending owner. Valid until the next call
  /// that is not const.
  std::span<const Obstacle> Obstacles();
  void AddDebugLines(std::vector<LineSnapshot>& lines);
  /// Hash of all that decides the future of the bodies that are not upright. Looks only at those that moved or were
  /// changed since the last call; `anew`: at all of them, which gives the same.
  std::uint64_t HashOfThings(bool anew = false);

  // What a body can bear; callers clamp to these.
  static constexpr float kMaxCoordinate_m = 1e6f;
  static constexpr float kMaxSpeed_mps = 1e5f;
  static constexpr float kMaxForce_n = 1e12f;
  static constexpr float kMaxMass_kg = 1e9f;
  static constexpr float kMinSize_m = 0.001f;
  static constexpr float kMaxSize_m = 1e5f;

 private:
  friend class BodiesAround;
  friend class WaysAround;
  friend bool MeetsNothing(const PhysicsWorld& physics, Vec3 from, Vec3 to);
  struct Body;
  struct Impl;
  Body& Get(BodyId body) const;

  std::unique_ptr<Impl> impl_;
};

/// Whether RayCast hits nothing: cheaper than to find what it hits.
bool MeetsNothing(const PhysicsWorld& physics, Vec3 from, Vec3 to);

}  // namespace soarbox::world
