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
#include "world/entity_ids.h"
#include "world/math.h"
#include "world/media_catalog.h"
#include "world/scene_snapshot.h"
#include "world/steer_avoid_objects.h"
#include "world/ways_around.h"
#include "world/workers.h"
#include "world/world_settings.h"

namespace soarbox::world {

enum class BodyId : std::uint32_t { kNone = 0 };

enum class BodyShape : std::uint8_t {
  kBox,      ///< size = full extents.
  kCapsule,  ///< Upright; size.x = radius, size.y = total height.
  kSphere,   ///< size.x = radius.
  kPlane,    ///< The half-space below y = 0 of the body.
  kMesh,     ///< The bounding box; the centre of mass is the mesh's origin.
};

struct BodyDef {
  BodyShape shape = BodyShape::kBox;
  Vec3 size{1, 1, 1};
  MeshBounds bounds;     ///< kMesh only.
  bool doorway = false;  ///< kMesh only: the wall has a doorway (modular_meshes.h).
  float mass_kg = 1;     ///< 0 = fixed.
  bool upright = false;  ///< Contacts never turn it, and it may not be an obstacle: an agent.
  bool sensor = false;   ///< Fixed. Collides with nothing, and rays do not hit it; see SensorChanges.
  Vec3 position;
  Quat orientation;
  EntityId owner = kNoEntity;
};

/// The rigid bodies of one world, implemented with Bullet. No other part of the module includes Bullet. Units are SI.
///
/// Deterministic: the order of bodies, pairs and contacts depends only on the calls; the solver is scalar and keeps its
/// order. Callers must pass finite values and valid ids. Ids are reused after Remove.
class PhysicsWorld {
 public:
  explicit PhysicsWorld(const WorldSettings& settings);
  /// Whether, at some time, so many bodies overlapped that further ones passed through each other.
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
  /// The minimum and maximum corner of the bounding box of the shape, in the body's own frame.
  std::pair<Vec3, Vec3> LocalBox(BodyId body) const;

  // All of the following wake the body.
  void SetPosition(BodyId body, Vec3 position);
  void SetOrientation(BodyId body, Quat orientation);
  void SetVelocity(BodyId body, Vec3 velocity);
  void SetAngularVelocity(BodyId body, Vec3 velocity);
  void SetMass(BodyId body, float mass_kg);
  void SetGravity(BodyId body, Vec3 gravity);
  /// For one step.
  void ApplyForce(BodyId body, Vec3 force_n);
  void ApplyAngularImpulse(BodyId body, Vec3 impulse);

  /// `other`: the body that carries the axis; kNone: the axis is fixed in the world. Removing either body removes the
  /// hinge.
  void AddHinge(BodyId body, const HingeDef& hinge, BodyId other);
  /// Removes the hinges that were added for this body.
  void RemoveHinges(BodyId body);
  std::size_t hinge_count() const;

  /// One step. Bodies that leave the range of coordinates or exceed the maximum speed are put back into the range, at
  /// rest and without rotation.
  void Step(float step_s, const Workers& workers = {});
  /// The bodies that may have moved in the last step, except upright ones: those that are not fixed and were not
  /// asleep. In a fixed order. Some may have been removed since, and their ids reused.
  std::span<const BodyId> MovedBodies() const;
  struct Push {
    BodyId body = BodyId::kNone;
    Vec3 force_n;
    Vec3 spin_rad_s{};
  };
  /// The forces of the last step, in the order of the calls; at most the first kMostPushes. For velocities that were
  /// set: the force that would have caused the change. For angular impulses: the change of the angular velocity.
  /// Nothing in a run depends on it.
  const std::vector<Push>& LastPushes() const;
  static constexpr std::size_t kMostPushes = 8192;
  /// The owner of a body; kNoEntity if the body was removed.
  EntityId OwnerOf(BodyId body) const;
  /// Sorted by (a, b).
  const std::vector<Collision>& Collisions() const;
  /// The movable bodies that entered or left sensors in the last step. Sorted by sensor; for each sensor, first the
  /// bodies that left, then those that entered, each in ascending order.
  const std::vector<SensorChange>& SensorChanges() const;
  std::optional<RayHit> RayCast(Vec3 from, Vec3 to) const;
  /// Makes the queries above and below cheaper until a body moves, is added or is removed. Worthwhile if there are
  /// several queries per body.
  void PrepareRays();
  /// Whether no body is on at least one of two segments: from `from` to `to`, or from `from` to `other`. These end
  /// points must be one above the other. Each segment ends at the surface of `target`. Ignores `viewer` and `target`;
  /// both may be kNone. Much faster than RayCast if many bodies are near.
  /// `around`: the bodies of a view that contains the points, or null.
  bool IsClearToEither(Vec3 from, Vec3 to, Vec3 other, BodyId viewer, BodyId target, const BodiesAround* around) const;
  /// Bounding spheres of the bodies that can move and are not upright, by ascending owner. Valid until the next call
  /// that is not const.
  std::span<const Obstacle> Obstacles();
  void AddDebugLines(std::vector<LineSnapshot>& lines);
  /// Hash of all state that determines the future of bodies that are not upright. Reads only bodies that have moved or
  /// changed since the last call. With `anew`, reads all bodies; the hash is the same.
  std::uint64_t HashOfThings(bool anew = false);

  // Limits of bodies. Callers clamp values to these.
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

/// Whether RayCast hits nothing. Cheaper than RayCast.
bool MeetsNothing(const PhysicsWorld& physics, Vec3 from, Vec3 to);

}  // namespace soarbox::world
