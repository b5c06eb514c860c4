// SPDX-License-Identifier: BSD-2-Clause
#include "world/physics_world.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <mutex>
#include <new>

#include "world/limits.h"
#include "world/physics_bullet.h"
#include "world/physics_capsule_plane.h"
#include "world/physics_crowd.h"
#include "world/physics_debug.h"
#include "world/physics_dispatch.h"
#include "world/physics_dynamics.h"
#include "world/physics_lift.h"
#include "world/physics_sensor.h"
#include "world/physics_shape.h"
#include "world/physics_sight.h"
#include "world/physics_ways.h"
#include "world/rotation.h"
#include "world/state_hash.h"

namespace soarbox::world {
namespace {

// A body that moves farther than this in a step gets continuous collision detection (lua_api.md 6).
constexpr float kSweepThreshold_m = 0.5f;
// Bullet links its pools of contacts before the first step. The default size is 4 MB: linking takes a quarter of the
// time of a short run. Contacts that do not fit into a pool come from the heap.
constexpr int kPoolOfContacts = 512;
constexpr float kFriction = 0.5f;
constexpr float kPenetrationRecovery = 0.8f;
// The solver stops early when no contact changes a velocity by more than 1e-5 m/s.
constexpr float kSolvedEnough = 1e-10f;

/// Whether contacts never rotate the body.
bool CannotTurn(const btCollisionObject* object) {
  const btRigidBody* body = btRigidBody::upcast(object);
  return body == nullptr || body->isStaticObject() || body->getAngularFactor().isZero();
}

btScalar ProductOfRollingFrictions(const btCollisionObject* a, const btCollisionObject* b) {
  // Avoids three rows of the solver that would have no effect: most contacts of a crowd are those of agents with the
  // ground.
  if (CannotTurn(a) && CannotTurn(b)) return 0;
  return a->getRollingFriction() * b->getRollingFriction();
}

bool IsUpright(const btCollisionObject& object) {
  const btMatrix3x3& turn = object.getWorldTransform().getBasis();
  return turn[0][1] == 0 && turn[2][1] == 0;
}

// Bullet has one friction rule for all worlds of a process. The sandbox's constants assume the product.
void InstallFrictionRule() {
  static std::once_flag once;
  std::call_once(once, [] { gCalculateCombinedRollingFrictionCallback = ProductOfRollingFrictions; });
}

/// False for values that are not finite.
bool IsWithin(const btVector3& v, btScalar limit) {
  return std::abs(v.x()) <= limit && std::abs(v.y()) <= limit && std::abs(v.z()) <= limit;
}

float Within(float value, float limit) {
  return IsFinite(value) ? std::clamp(value, -limit, limit) : 0.0f;
}

btDefaultCollisionConstructionInfo SmallPools() {
  btDefaultCollisionConstructionInfo pools;
  pools.m_defaultMaxPersistentManifoldPoolSize = kPoolOfContacts;
  pools.m_defaultMaxCollisionAlgorithmPoolSize = kPoolOfContacts;
  return pools;
}

}  // namespace

struct PhysicsWorld::Body {
  PhysicsShape shape;
  std::unique_ptr<btRigidBody> rigid;
  Vec3 gravity;
  bool upright = false;
  bool sensor = false;
  std::vector<EntityId> inside;  ///< Of a sensor, after the last step, in ascending order.
  BodyId id = BodyId::kNone;
  std::uint64_t hash = 0;  ///< Its part of the total hash; 0 if it is not known.
  static constexpr std::size_t kKnown = ~std::size_t{0};
  std::size_t to_hash_at = kKnown;  ///< Index in the list of bodies whose part must be recomputed.

  std::uint64_t Hash() const {
    StateHash made;
    made.Add(static_cast<std::uint64_t>(rigid->getUserIndex()));
    made.Add(FromBullet(rigid->getWorldTransform().getOrigin()));
    made.Add(FromBullet(rigid->getWorldTransform().getRotation()));
    made.Add(FromBullet(rigid->getLinearVelocity()));
    made.Add(FromBullet(rigid->getAngularVelocity()));
    made.Add(static_cast<float>(rigid->getInvMass()));
    made.Add(gravity);
    made.Add(static_cast<float>(rigid->getLinearDamping()), static_cast<float>(rigid->getAngularDamping()));
    for (const EntityId id_inside : inside) made.Add(static_cast<std::uint64_t>(Number(id_inside)));
    return made.value();
  }
};

struct PhysicsWorld::Impl {
  explicit Impl(const WorldSettings& settings)
      : dispatcher(&configuration),
        world(&dispatcher, &broadphase, &solver, &configuration),
        gravity(settings.gravity),
        step_s(settings.step_s) {
    InstallFrictionRule();
    FindCapsulesOnPlanes(dispatcher);
    // Finds several corners of a box on a plane in one step. With one corner per step, small boxes rock forever.
    configuration.setPlaneConvexMultipointIterations(3, 3);
    // The scalar solver rows, because the vectorized ones give different results on different processors.
    solver.setConstraintRowSolverGeneric(solver.getScalarConstraintRowSolverGeneric());
    solver.setConstraintRowSolverLowerLimit(solver.getScalarConstraintRowSolverLowerLimit());
    world.setGravity(ToBullet(gravity));
    world.getDispatchInfo().m_deterministicOverlappingPairs = true;
    btContactSolverInfo& info = world.getSolverInfo();
    info.m_solverMode = SOLVER_USE_WARMSTARTING;
    info.m_numIterations = std::clamp(settings.solver_iterations, 1, 1000);
    info.m_splitImpulse = true;
    info.m_erp2 = kPenetrationRecovery;
    info.m_leastSquaresResidualThreshold = kSolvedEnough;
    broadphase.getOverlappingPairCache()->setOverlapFilterCallback(&pair_limit);
    world.setForceUpdateAllAabbs(false);
  }

  /// Null for kNone.
  const btCollisionObject* ObjectOf(BodyId body) const {
    return body == BodyId::kNone ? nullptr : bodies[static_cast<std::size_t>(body)]->rigid.get();
  }

  void AddToWorld(Body& body) {
    if (body.sensor) return;
    field.Forget();
    crowd.Forget(*body.rigid);
    world.addRigidBody(body.rigid.get());
    crowd.Check(*body.rigid);
    if (!body.rigid->isStaticObject()) body.rigid->setGravity(ToBullet(body.gravity));
  }

  // Updates bounding boxes for ray casts between steps, and for fixed bodies.
  void Moved(Body& body) {
    field.Forget();
    body.rigid->setInterpolationWorldTransform(body.rigid->getWorldTransform());
    if (body.sensor) return HashAnew(body);
    world.updateSingleAabb(body.rigid.get());
    crowd.Check(*body.rigid);
    Wake(body);
    if (!body.upright) ++changes;
  }

  void Wake(Body& body) {
    if (!body.rigid->isStaticObject()) body.rigid->activate(true);
    HashAnew(body);
  }

  void HashAnew(Body& body) {
    if (body.upright || body.to_hash_at != Body::kKnown) return;
    body.to_hash_at = to_hash.size();
    to_hash.push_back(&body);
  }

  void ForgetHash(Body& body) {
    hash_sum -= body.hash;
    if (body.to_hash_at == Body::kKnown) return;
    to_hash.back()->to_hash_at = body.to_hash_at;
    to_hash[body.to_hash_at] = to_hash.back();
    to_hash.pop_back();
  }

  void NotePush(BodyId id, Vec3 force_n, Vec3 spin_rad_s = {}) {
    if (pushes.size() < kMostPushes) pushes.push_back({id, force_n, spin_rad_s});
  }

  void KeepInRange();
  void GatherCollisions();
  void GatherSensorChanges();
  /// Removes the hinges for which `is_meant` returns true.
  template <class IsMeant>
  void RemoveHingesIf(const IsMeant& is_meant);
  void LiftSunken();

  btDefaultCollisionConfiguration configuration{SmallPools()};
  PairDispatcher dispatcher;
  CrowdBroadphase broadphase;
  BodyField field;
  const AllBodies all{broadphase, field};
  PairLimit pair_limit{*broadphase.getOverlappingPairCache()};
  btSequentialImpulseConstraintSolver solver;
  DynamicsWorld world;
  CrowdControl crowd{world, pair_limit};
  SunkenBodies sunken;
  Vec3 gravity;
  float step_s;
  std::vector<std::unique_ptr<Body>> bodies{1};  // Index 0 is BodyId::kNone.
  std::vector<BodyId> free;
  std::vector<Collision> collisions;
  std::vector<BodyId> sensors;  ///< By ascending owner.
  std::vector<SensorChange> sensor_changes;
  struct Hinge {
    BodyId body = BodyId::kNone, other = BodyId::kNone;
    std::unique_ptr<btHingeConstraint> joint;
  };
  std::vector<Hinge> hinges;
  std::vector<Push> pushes, last_pushes;
  std::vector<BodyId> moved;
  std::uint64_t hash_sum = 0;  ///< Sum of the parts of all bodies.
  std::vector<Body*> to_hash;
  /// Incremented when a body that is not upright moves, is added or removed, or changes its mass.
  std::uint64_t changes = 0;
  std::uint64_t obstacles_of = ~0ull;  ///< The value of `changes` for which `obstacles` is valid.
  std::vector<Obstacle> obstacles;
};

namespace {

/// Bullet does not check the result of its allocator, so this never returns null.
void* TakeForBullet(std::size_t size, int alignment) {
  const auto step = static_cast<std::size_t>(alignment);
  void* memory = std::aligned_alloc(step, (size + step - 1) / step * step);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

/// Must run before Bullet allocates memory.
const WorldSettings& WithSafeMemory(const WorldSettings& settings) {
  static const bool is_set = [] {
    btAlignedAllocSetCustomAligned(TakeForBullet, std::free);
    return true;
  }();
  static_cast<void>(is_set);
  return settings;
}

}  // namespace

PhysicsWorld::PhysicsWorld(const WorldSettings& settings) : impl_(std::make_unique<Impl>(WithSafeMemory(settings))) {}

bool PhysicsWorld::IsCrowded() const {
  return impl_->pair_limit.reached;
}

PhysicsWorld::~PhysicsWorld() {
  impl_->RemoveHingesIf([](const auto&) { return true; });
  for (const auto& body : impl_->bodies) {
    if (body && !body->sensor) impl_->world.removeRigidBody(body->rigid.get());
  }
}

PhysicsWorld::Body& PhysicsWorld::Get(BodyId body) const {
  const auto index = static_cast<std::size_t>(body);
  assert(index < impl_->bodies.size() && impl_->bodies[index]);
  return *impl_->bodies[index];
}

BodyId PhysicsWorld::Add(const BodyDef& def) {
  auto body = std::make_unique<Body>();
  body->shape = MakeShape(def);
  body->gravity = impl_->gravity;
  body->upright = def.upright;
  body->sensor = def.sensor;

  const float mass = def.shape == BodyShape::kPlane || def.sensor ? 0.0f : std::clamp(def.mass_kg, 0.0f, kMaxMass_kg);
  btVector3 inertia(0, 0, 0);
  if (mass > 0) body->shape.shape->calculateLocalInertia(mass, inertia);
  btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, body->shape.shape.get(), inertia);
  info.m_startWorldTransform = btTransform(ToBullet(def.orientation), ToBullet(def.position));
  info.m_friction = kFriction;
  info.m_rollingFriction = body->shape.rolling_friction;
  info.m_restitution = 0;
  info.m_linearSleepingThreshold = body->shape.linear_sleeping_mps;
  info.m_angularSleepingThreshold = 1.0f;
  body->rigid = std::make_unique<btRigidBody>(info);
  if (body->shape.swept_radius_m > 0) {
    body->rigid->setCcdMotionThreshold(kSweepThreshold_m);
    body->rigid->setCcdSweptSphereRadius(body->shape.swept_radius_m);
  }
  if (def.upright) {
    body->rigid->setAngularFactor(0);
    body->rigid->setFlags(body->rigid->getFlags() & ~BT_ENABLE_GYROPSCOPIC_FORCE);
  }
  body->rigid->setUserIndex(static_cast<int>(Number(def.owner)));
  body->rigid->setUserPointer(body.get());
  impl_->AddToWorld(*body);
  if (!def.upright) ++impl_->changes;

  BodyId id = static_cast<BodyId>(impl_->bodies.size());
  if (impl_->free.empty()) {
    impl_->bodies.emplace_back();
  } else {
    id = impl_->free.back();
    impl_->free.pop_back();
  }
  body->id = id;
  if (def.sensor) impl_->sensors.push_back(id);
  impl_->HashAnew(*body);
  impl_->bodies[static_cast<std::size_t>(id)] = std::move(body);
  return id;
}

void PhysicsWorld::Remove(BodyId id) {
  Body& body = Get(id);
  if (body.sensor) {
    impl_->ForgetHash(body);
    std::erase(impl_->sensors, id);
    impl_->bodies[static_cast<std::size_t>(id)].reset();
    impl_->free.push_back(id);
    return;
  }
  impl_->RemoveHingesIf([id](const auto& hinge) { return hinge.body == id || hinge.other == id; });
  // Wakes the bodies that touch it. Otherwise a sleeping body that it supported would hang in the air.
  for (int i = 0; i < impl_->dispatcher.getNumManifolds(); ++i) {
    const btPersistentManifold* manifold = impl_->dispatcher.getManifoldByIndexInternal(i);
    const bool touches = manifold->getBody0() == body.rigid.get() || manifold->getBody1() == body.rigid.get();
    if (!touches || manifold->getNumContacts() == 0) continue;
    const btCollisionObject* other =
        manifold->getBody0() == body.rigid.get() ? manifold->getBody1() : manifold->getBody0();
    if (!other->isStaticObject()) other->activate(true);
  }
  if (!body.upright) ++impl_->changes;
  impl_->field.Forget();
  impl_->ForgetHash(body);
  impl_->crowd.Forget(*body.rigid);
  impl_->sunken.Forget(*body.rigid);
  impl_->world.removeRigidBody(body.rigid.get());
  impl_->bodies[static_cast<std::size_t>(id)].reset();
  impl_->free.push_back(id);
}

Vec3 PhysicsWorld::Position(BodyId body) const {
  return FromBullet(Get(body).rigid->getWorldTransform().getOrigin());
}
Quat PhysicsWorld::Orientation(BodyId body) const {
  return FromBullet(Get(body).rigid->getWorldTransform().getRotation());
}
Vec3 PhysicsWorld::Velocity(BodyId body) const {
  return FromBullet(Get(body).rigid->getLinearVelocity());
}
Vec3 PhysicsWorld::AngularVelocity(BodyId body) const {
  return FromBullet(Get(body).rigid->getAngularVelocity());
}

float PhysicsWorld::Mass(BodyId body) const {
  const btScalar inverse = Get(body).rigid->getInvMass();
  return inverse > 0 ? 1.0f / inverse : 0.0f;
}

bool PhysicsWorld::IsSleeping(BodyId body) const {
  return !Get(body).rigid->isActive();
}

float PhysicsWorld::Radius(BodyId body) const {
  btVector3 low, high;
  Get(body).rigid->getAabb(low, high);
  return (high - low).length() / 2;
}

std::pair<Vec3, Vec3> PhysicsWorld::LocalBox(BodyId body) const {
  btVector3 low, high;
  Get(body).rigid->getCollisionShape()->getAabb(btTransform::getIdentity(), low, high);
  return {FromBullet(low), FromBullet(high)};
}

void PhysicsWorld::SetPosition(BodyId id, Vec3 position) {
  Body& body = Get(id);
  body.rigid->getWorldTransform().setOrigin(ToBullet(position));
  impl_->Moved(body);
}

void PhysicsWorld::SetOrientation(BodyId id, Quat orientation) {
  Body& body = Get(id);
  const bool was_upright = body.upright && IsUpright(*body.rigid);
  body.rigid->getWorldTransform().setRotation(ToBullet(orientation));
  body.rigid->updateInertiaTensor();
  if (was_upright && IsUpright(*body.rigid)) {
    // A capsule that rotates about its own axis occupies the same space.
    body.rigid->setInterpolationWorldTransform(body.rigid->getWorldTransform());
    impl_->Wake(body);
    return;
  }
  impl_->Moved(body);
}

void PhysicsWorld::SetVelocity(BodyId id, Vec3 velocity) {
  Body& body = Get(id);
  const float inverse_mass = static_cast<float>(body.rigid->getInvMass());
  const Vec3 change = velocity - FromBullet(body.rigid->getLinearVelocity());
  if (inverse_mass > 0 && change != Vec3{}) impl_->NotePush(id, change / (inverse_mass * impl_->step_s));
  body.rigid->setLinearVelocity(ToBullet(velocity));
  impl_->Wake(body);
}

void PhysicsWorld::SetAngularVelocity(BodyId id, Vec3 velocity) {
  Body& body = Get(id);
  body.rigid->setAngularVelocity(ToBullet(velocity));
  impl_->Wake(body);
}

void PhysicsWorld::SetMass(BodyId id, float mass_kg) {
  Body& body = Get(id);
  if (body.sensor || body.shape.shape->getShapeType() == STATIC_PLANE_PROXYTYPE) return;
  const float mass = std::clamp(mass_kg, 0.0f, kMaxMass_kg);
  const bool was_fixed = body.rigid->isStaticObject();
  const bool fixed = mass == 0;
  // Fixed and dynamic bodies have different collision groups, so a change requires a new entry.
  if (was_fixed != fixed) {
    impl_->crowd.Forget(*body.rigid);
    impl_->world.removeRigidBody(body.rigid.get());
  }
  btVector3 inertia(0, 0, 0);
  if (!fixed) body.shape.shape->calculateLocalInertia(mass, inertia);
  body.rigid->setMassProps(mass, inertia);
  body.rigid->updateInertiaTensor();
  if (fixed) {
    body.rigid->setLinearVelocity(btVector3(0, 0, 0));
    body.rigid->setAngularVelocity(btVector3(0, 0, 0));
    body.rigid->clearForces();
  }
  if (was_fixed != fixed) {
    impl_->AddToWorld(body);
  } else if (!fixed) {
    body.rigid->setGravity(ToBullet(body.gravity));
  }
  impl_->Wake(body);
  if (!body.upright) ++impl_->changes;
}

void PhysicsWorld::SetGravity(BodyId id, Vec3 gravity) {
  Body& body = Get(id);
  body.gravity = gravity;
  if (!body.rigid->isStaticObject()) body.rigid->setGravity(ToBullet(gravity));
  impl_->Wake(body);
}

void PhysicsWorld::ApplyForce(BodyId id, Vec3 force_n) {
  Body& body = Get(id);
  body.rigid->applyCentralForce(ToBullet(force_n));
  impl_->Wake(body);
  impl_->NotePush(id, force_n);
}

std::span<const BodyId> PhysicsWorld::MovedBodies() const {
  return impl_->moved;
}

const std::vector<PhysicsWorld::Push>& PhysicsWorld::LastPushes() const {
  return impl_->last_pushes;
}

EntityId PhysicsWorld::OwnerOf(BodyId id) const {
  const auto index = static_cast<std::size_t>(id);
  if (index >= impl_->bodies.size() || !impl_->bodies[index]) return kNoEntity;
  return static_cast<EntityId>(impl_->bodies[index]->rigid->getUserIndex());
}

void PhysicsWorld::ApplyAngularImpulse(BodyId id, Vec3 impulse) {
  Body& body = Get(id);
  if (!body.rigid->isStaticObject()) {
    const btVector3 before = body.rigid->getAngularVelocity();
    body.rigid->applyTorqueImpulse(ToBullet(impulse));
    impl_->NotePush(id, {}, FromBullet(body.rigid->getAngularVelocity() - before));
  }
  impl_->Wake(body);
}

void PhysicsWorld::Step(float step_s, const Workers& workers) {
  impl_->field.Forget();
  impl_->pushes.swap(impl_->last_pushes);
  impl_->pushes.clear();
  impl_->dispatcher.SetWorkers(&workers);
  impl_->world.stepSimulation(step_s, 0);
  impl_->dispatcher.SetWorkers(nullptr);
  impl_->KeepInRange();
  impl_->crowd.CheckAll();
  impl_->GatherCollisions();
  impl_->LiftSunken();
  impl_->GatherSensorChanges();
  ++impl_->changes;
}

/// Applies to the bodies that have moved, and records them.
void PhysicsWorld::Impl::KeepInRange() {
  // A body that falls asleep loses its velocity.
  for (const BodyId id : moved)
    if (const auto& body = bodies[static_cast<std::size_t>(id)]) HashAnew(*body);
  moved.clear();
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    const auto& body = bodies[i];
    if (!body || body->rigid->isStaticObject() || !body->rigid->isActive()) continue;
    if (!body->upright) moved.push_back(body->id);
    HashAnew(*body);
    btRigidBody& rigid = *body->rigid;
    const btMatrix3x3& turn = rigid.getWorldTransform().getBasis();
    const btVector3& place = rigid.getWorldTransform().getOrigin();
    if (IsWithin(place, kMaxCoordinate_m) && IsWithin(rigid.getLinearVelocity(), kMaxSpeed_mps) &&
        IsWithin(rigid.getAngularVelocity(), kMaxSpeed_mps) && IsWithin(turn[0] + turn[1] + turn[2], 9))
      continue;
    const Vec3 position = FromBullet(place);
    const btVector3 edge(Within(position.x, kMaxCoordinate_m), Within(position.y, kMaxCoordinate_m),
                         Within(position.z, kMaxCoordinate_m));
    rigid.setWorldTransform(btTransform(btQuaternion::getIdentity(), edge));
    rigid.setLinearVelocity(btVector3(0, 0, 0));
    rigid.setAngularVelocity(btVector3(0, 0, 0));
    rigid.clearForces();
    Moved(*body);
  }
}

void PhysicsWorld::Impl::GatherCollisions() {
  collisions.clear();
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
    const btPersistentManifold* manifold = dispatcher.getManifoldByIndexInternal(i);
    for (int point = 0; point < manifold->getNumContacts(); ++point) {
      const btManifoldPoint& contact = manifold->getContactPoint(point);
      if (contact.getDistance() >= 0) continue;
      collisions.push_back({static_cast<EntityId>(manifold->getBody0()->getUserIndex()),
                            static_cast<EntityId>(manifold->getBody1()->getUserIndex()),
                            FromBullet(contact.getPositionWorldOnA()), FromBullet(contact.getPositionWorldOnB()),
                            FromBullet(contact.m_normalWorldOnB)});
      break;
    }
  }
  std::stable_sort(collisions.begin(), collisions.end(),
                   [](const Collision& x, const Collision& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
}

void PhysicsWorld::Impl::LiftSunken() {
  sunken.BeginStep();
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
    btRigidBody* rigid = sunken.Look(*dispatcher.getManifoldByIndexInternal(i));
    if (rigid == nullptr) continue;
    const btVector3 place = SunkenBodies::FreePlaceAbove(world, *rigid);
    if (place == rigid->getWorldTransform().getOrigin()) continue;
    rigid->getWorldTransform().setOrigin(place);
    rigid->setLinearVelocity(btVector3(0, 0, 0));
    Moved(*static_cast<Body*>(rigid->getUserPointer()));
  }
}

void PhysicsWorld::Impl::GatherSensorChanges() {
  sensor_changes.clear();
  std::vector<EntityId> now;
  for (const BodyId id : sensors) {
    Body& body = *bodies[static_cast<std::size_t>(id)];
    FindInside(world, all, *body.rigid, now);
    if (now == body.inside) continue;
    const auto sensor = static_cast<EntityId>(body.rigid->getUserIndex());
    for (const EntityId other : body.inside)
      if (!std::ranges::binary_search(now, other)) sensor_changes.push_back({sensor, other, false});
    for (const EntityId other : now)
      if (!std::ranges::binary_search(body.inside, other)) sensor_changes.push_back({sensor, other, true});
    body.inside.swap(now);
    HashAnew(body);
  }
}

const std::vector<Collision>& PhysicsWorld::Collisions() const {
  return impl_->collisions;
}

const std::vector<SensorChange>& PhysicsWorld::SensorChanges() const {
  return impl_->sensor_changes;
}

void PhysicsWorld::AddHinge(BodyId id, const HingeDef& hinge, BodyId other) {
  Body& body = Get(id);
  const btVector3 point = ToBullet(hinge.point), axis = ToBullet(hinge.axis).normalized();
  const auto local_point = [&](const Body& of) { return of.rigid->getWorldTransform().invXform(point); };
  const auto local_axis = [&](const Body& of) { return of.rigid->getWorldTransform().getBasis().transpose() * axis; };
  std::unique_ptr<btHingeConstraint> joint;
  if (other == BodyId::kNone) {
    joint = std::make_unique<btHingeConstraint>(*body.rigid, local_point(body), local_axis(body));
  } else {
    const Body& holder = Get(other);
    joint = std::make_unique<btHingeConstraint>(*body.rigid, *holder.rigid, local_point(body), local_point(holder),
                                                local_axis(body), local_axis(holder));
  }
  constexpr btScalar kRadians = SIMD_PI / 180;
  if (hinge.low_deg <= hinge.high_deg) joint->setLimit(hinge.low_deg * kRadians, hinge.high_deg * kRadians);
  if (hinge.friction_nm > 0) joint->enableAngularMotor(true, 0, hinge.friction_nm * impl_->step_s);
  impl_->world.addConstraint(joint.get(), true);
  impl_->hinges.push_back({id, other, std::move(joint)});
  impl_->Wake(body);
  if (other != BodyId::kNone) impl_->Wake(Get(other));
}

template <class IsMeant>
void PhysicsWorld::Impl::RemoveHingesIf(const IsMeant& is_meant) {
  std::erase_if(hinges, [&](const Hinge& hinge) {
    if (!is_meant(hinge)) return false;
    for (const BodyId end : {hinge.body, hinge.other})
      if (end != BodyId::kNone) Wake(*bodies[static_cast<std::size_t>(end)]);
    world.removeConstraint(hinge.joint.get());
    return true;
  });
}

void PhysicsWorld::RemoveHinges(BodyId body) {
  impl_->RemoveHingesIf([body](const auto& hinge) { return hinge.body == body; });
}

std::size_t PhysicsWorld::hinge_count() const {
  return impl_->hinges.size();
}

namespace {

std::optional<RayHit> HitOf(const FirstHit& hit, Vec3 from, Vec3 to) {
  if (hit.body == nullptr) return std::nullopt;
  return RayHit{static_cast<EntityId>(hit.body->getUserIndex()), from + (to - from) * hit.entry.fraction,
                FromBullet(hit.entry.normal)};
}

}  // namespace

std::optional<RayHit> PhysicsWorld::RayCast(Vec3 from, Vec3 to) const {
  if (from == to) return std::nullopt;
  return HitOf(FindFirstHit(impl_->all, ToBullet(from), ToBullet(to)), from, to);
}

bool MeetsNothing(const PhysicsWorld& physics, Vec3 from, Vec3 to) {
  return from == to || EntersNothing(physics.impl_->all, ToBullet(from), ToBullet(to));
}

void PhysicsWorld::PrepareRays() {
  if (!impl_->field.is_known()) impl_->field.Build(impl_->broadphase);
}

struct BodiesAround::Bodies {
  NearBodies near;
};

BodiesAround::BodiesAround(const PhysicsWorld& physics, const View& view)
    : bodies_(std::make_unique<Bodies>(Bodies{NearBodies(physics.impl_->all, view)})) {}
BodiesAround::BodiesAround(BodiesAround&&) noexcept = default;
BodiesAround& BodiesAround::operator=(BodiesAround&&) noexcept = default;
BodiesAround::~BodiesAround() = default;

std::optional<RayHit> BodiesAround::RayCast(Vec3 from, Vec3 to) const {
  if (!IsFinite(from) || !IsFinite(to)) return std::nullopt;
  const Vec3 begin = LimitPosition(from), end = LimitPosition(to);
  if (begin == end) return std::nullopt;
  return HitOf(bodies_->near.FindFirst(ToBullet(begin), ToBullet(end)), begin, end);
}

bool BodiesAround::MeetsNoOther(Vec3 from, Vec3 to, EntityId viewer, EntityId target) const {
  if (!IsFinite(from) || !IsFinite(to)) return true;
  const Vec3 begin = LimitPosition(from), end = LimitPosition(to);
  return begin == end || bodies_->near.MeetsNoOther(ToBullet(begin), ToBullet(end), static_cast<int>(Number(viewer)),
                                                    static_cast<int>(Number(target)));
}

bool PhysicsWorld::IsClearToEither(Vec3 from, Vec3 to, Vec3 other, BodyId viewer, BodyId target,
                                   const BodiesAround* around) const {
  const btVector3 begin = ToBullet(from), end = ToBullet(to), other_end = ToBullet(other);
  const btCollisionObject *self = impl_->ObjectOf(viewer), *aim = impl_->ObjectOf(target);
  if (around != nullptr) return around->bodies_->near.IsClearToEither(begin, end, other_end, self, aim);
  return IsClear(impl_->all, begin, end, self, aim) || IsClear(impl_->all, begin, other_end, self, aim);
}

struct WaysAround::Ways {
  LevelWays level;
};

WaysAround::WaysAround(const PhysicsWorld& physics, const Walker& walker, float reach_m) {
  if (!IsFinite(walker.place) || !IsFinite(reach_m) || !IsFinite(walker.half_width_m)) return;
  ways_ = std::make_unique<Ways>(Ways{LevelWays(walker, reach_m)});
  LevelWays& level = ways_->level;
  VisitTouching(physics.impl_->all, level.low(), level.high(), [&](const BoxedBody& each) { level.Consider(each); });
}
WaysAround::WaysAround(WaysAround&&) noexcept = default;
WaysAround& WaysAround::operator=(WaysAround&&) noexcept = default;
WaysAround::~WaysAround() = default;

bool WaysAround::IsOpen(Vec3 direction, float length_m) const {
  if (ways_ == nullptr || !IsFinite(direction) || !IsFinite(length_m)) return true;
  return ways_->level.IsOpen(direction, length_m);
}

std::span<const Obstacle> PhysicsWorld::Obstacles() {
  Impl& impl = *impl_;
  if (impl.obstacles_of == impl.changes) return impl.obstacles;
  std::vector<std::pair<int, const Body*>> movable;
  for (const auto& body : impl.bodies) {
    if (body && !body->upright && !body->rigid->isStaticObject()) {
      movable.emplace_back(body->rigid->getUserIndex(), body.get());
    }
  }
  std::sort(movable.begin(), movable.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
  impl.obstacles.clear();
  for (const auto& [owner, body] : movable) {
    btVector3 low, high;
    body->rigid->getAabb(low, high);
    impl.obstacles.push_back({FromBullet(body->rigid->getWorldTransform().getOrigin()), (high - low).length() / 2});
  }
  impl.obstacles_of = impl.changes;
  return impl.obstacles;
}

std::uint64_t PhysicsWorld::HashOfThings(bool anew) {
  Impl& impl = *impl_;
  if (anew) {
    for (const auto& body : impl.bodies)
      if (body) impl.HashAnew(*body);
  }
  for (Body* body : impl.to_hash) {
    const std::uint64_t hash = body->Hash();
    impl.hash_sum += hash - body->hash;
    body->hash = hash;
    body->to_hash_at = Body::kKnown;
  }
  impl.to_hash.clear();
  return impl.hash_sum;
}

void PhysicsWorld::AddDebugLines(std::vector<LineSnapshot>& lines) {
  PhysicsLineCollector collector(lines);
  impl_->world.setDebugDrawer(&collector);
  impl_->world.debugDrawWorld();
  for (const BodyId sensor : impl_->sensors) {
    const Body& body = Get(sensor);
    impl_->world.debugDrawObject(body.rigid->getWorldTransform(), body.shape.shape.get(), btVector3(0, 1, 1));
  }
  impl_->world.setDebugDrawer(nullptr);
}

}  // namespace soarbox::world
