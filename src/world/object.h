// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "world/entity_ids.h"
#include "world/math.h"

namespace soarbox::world {

struct HingeDef;
class PhysicsWorld;
class Scene;
enum class BodyId : std::uint32_t;

/// The kinds of objects. Sizes: see World::Create*.
enum class ObjectKind : std::uint8_t { kBox, kCapsule, kPlane, kMesh, kPhysicsCapsule, kPhysicsSphere, kSensor };

/// One object of the sandbox: a body and a scene node with its drawable (no drawable for the physics-only kinds).
///
/// Owned by the World; found by id (World::FindObject); destroyed in the first BeginTick after World::RemoveObject.
/// Created at the origin with 1 kg, dynamic (planes: fixed). Mass 0 means fixed: the object does not move by itself,
/// but collides and can be teleported. Each setter and force wakes the body. Setters refuse values that are not finite:
/// they return false and change nothing.
class Object {
 public:
  Object(const Object&) = delete;
  Object& operator=(const Object&) = delete;

  EntityId id() const { return id_; }
  NodeId node() const { return node_; }
  ObjectKind kind() const { return kind_; }

  /// World position of the centre of mass (meshes: of the mesh's origin).
  Vec3 Position() const;
  /// Moves body and node at once; does not change the velocity.
  bool SetPosition(Vec3 position);
  Quat Orientation() const;
  bool SetOrientation(Quat orientation);
  Vec3 Velocity() const;
  bool SetVelocity(Vec3 velocity);
  Vec3 AngularVelocity() const;
  bool SetAngularVelocity(Vec3 radians_per_s);

  /// In kg; 0 for fixed bodies.
  float Mass() const;
  /// Negative values count as 0. Recomputes the inertia. 0 makes the body fixed, a positive value makes it dynamic
  /// again.
  bool SetMass(float mass_kg);
  /// In m/s^2; replaces the world's gravity for this object.
  bool SetGravity(Vec3 gravity);

  /// Applies a force in newtons at the centre of mass, for the next step only; forces add up.
  bool ApplyForce(Vec3 force_n);
  /// The sandbox's impulse is a force that acts for one step (lua_api.md 17, quirk 1): 15000 on 15 kg gives 33.3 m/s.
  bool ApplyImpulse(Vec3 force_n) { return ApplyForce(force_n); }
  /// In N m s; changes the angular velocity at once.
  bool ApplyAngularImpulse(Vec3 impulse);

  /// Attaches it to a hinge, so that it can only turn about the hinge's axis. `other`: the object that carries the
  /// axis; null: the axis is fixed in the world. Returns false for sensors, for `other` == this, for a zero axis and
  /// for values that are not finite.
  bool AddHinge(const HingeDef& hinge, const Object* other);
  /// Removes the hinges that were added for this object.
  void RemoveHinges();

  /// Half the diagonal of the body's axis-aligned bounding box, collision margins included; huge for a plane.
  float Radius() const;
  /// The minimum and maximum corner of the body's bounding box in its own frame, including collision margins.
  std::pair<Vec3, Vec3> LocalBox() const;
  bool IsSleeping() const;
  /// Whether RemoveObject was called. The object is destroyed in the next BeginTick.
  bool removal_requested() const { return removal_requested_; }

 private:
  friend class World;
  Object(PhysicsWorld& physics, Scene& scene, EntityId id, NodeId node, ObjectKind kind, BodyId body)
      : physics_(physics), scene_(scene), id_(id), node_(node), kind_(kind), body_(body) {}
  void MoveNode();

  PhysicsWorld& physics_;
  Scene& scene_;
  EntityId id_;
  NodeId node_;
  ObjectKind kind_;
  BodyId body_;
  bool removal_requested_ = false;
};

}  // namespace soarbox::world
