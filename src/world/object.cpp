// SPDX-License-Identifier: BSD-2-Clause
#include "world/object.h"

#include <algorithm>

#include "world/limits.h"
#include "world/physics_world.h"
#include "world/rotation.h"
#include "world/scene.h"

namespace soarbox::world {

void Object::MoveNode() {
  scene_.PlaceWorldNode(node_, Position(), Orientation());
}

Vec3 Object::Position() const {
  return physics_.Position(body_);
}
Quat Object::Orientation() const {
  return physics_.Orientation(body_);
}
Vec3 Object::Velocity() const {
  return physics_.Velocity(body_);
}
Vec3 Object::AngularVelocity() const {
  return physics_.AngularVelocity(body_);
}
float Object::Mass() const {
  return physics_.Mass(body_);
}
float Object::Radius() const {
  return physics_.Radius(body_);
}
std::pair<Vec3, Vec3> Object::LocalBox() const {
  return physics_.LocalBox(body_);
}
bool Object::IsSleeping() const {
  return physics_.IsSleeping(body_);
}

bool Object::SetPosition(Vec3 position) {
  if (!IsFinite(position)) return false;
  physics_.SetPosition(body_, LimitPosition(position));
  MoveNode();
  return true;
}

bool Object::SetOrientation(Quat orientation) {
  if (!IsFinite(orientation)) return false;
  physics_.SetOrientation(body_, Normalized(orientation));
  MoveNode();
  return true;
}

bool Object::SetVelocity(Vec3 velocity) {
  if (!IsFinite(velocity)) return false;
  physics_.SetVelocity(body_, LimitVelocity(velocity));
  return true;
}

bool Object::SetAngularVelocity(Vec3 radians_per_s) {
  if (!IsFinite(radians_per_s)) return false;
  physics_.SetAngularVelocity(body_, LimitVelocity(radians_per_s));
  return true;
}

bool Object::SetMass(float mass_kg) {
  if (!IsFinite(mass_kg)) return false;
  physics_.SetMass(body_, std::max(0.0f, mass_kg));
  return true;
}

bool Object::SetGravity(Vec3 gravity) {
  if (!IsFinite(gravity)) return false;
  physics_.SetGravity(body_, LimitVelocity(gravity));
  return true;
}

bool Object::ApplyForce(Vec3 force_n) {
  if (!IsFinite(force_n)) return false;
  physics_.ApplyForce(body_, LimitForce(force_n));
  return true;
}

bool Object::ApplyAngularImpulse(Vec3 impulse) {
  if (!IsFinite(impulse)) return false;
  physics_.ApplyAngularImpulse(body_, LimitForce(impulse));
  return true;
}

bool Object::AddHinge(const HingeDef& hinge, const Object* other) {
  const bool is_finite = IsFinite(hinge.point) && IsFinite(hinge.axis) && IsFinite(hinge.low_deg) &&
                         IsFinite(hinge.high_deg) && IsFinite(hinge.friction_nm);
  if (!is_finite || LengthSquared(hinge.axis) == 0 || other == this) return false;
  if (kind_ == ObjectKind::kSensor || (other != nullptr && other->kind_ == ObjectKind::kSensor)) return false;
  HingeDef limited = hinge;
  limited.point = LimitPosition(hinge.point);
  limited.axis = Normalized(hinge.axis);
  physics_.AddHinge(body_, limited, other == nullptr ? BodyId::kNone : other->body_);
  return true;
}

void Object::RemoveHinges() {
  physics_.RemoveHinges(body_);
}

}  // namespace soarbox::world
