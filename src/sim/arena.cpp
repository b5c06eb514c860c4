// SPDX-License-Identifier: BSD-2-Clause
#include "sim/arena.h"

#include <algorithm>
#include <sstream>

#include "sim/directions.h"
#include "world/animation/animator.h"
#include "world/rotation.h"
#include "world/state_hash.h"

namespace soarbox::sim {
namespace {

constexpr float kShotsKept_s = 2;
constexpr std::size_t kMostShots = 200;

constexpr float kMessagesKept_s = 10;
constexpr std::size_t kMostTouching = 4096;
constexpr std::string_view kWays = "soarbox-ways";

std::string_view KindOf(world::ObjectKind kind) {
  switch (kind) {
    case world::ObjectKind::kBox:
      return "box";
    case world::ObjectKind::kCapsule:
    case world::ObjectKind::kPhysicsCapsule:
      return "capsule";
    case world::ObjectKind::kPhysicsSphere:
      return "sphere";
    case world::ObjectKind::kPlane:
      return "plane";
    case world::ObjectKind::kMesh:
      return "mesh";
    case world::ObjectKind::kSensor:
      return "sensor";
  }
  return "thing";
}

}  // namespace

Arena::Arena(world::World& world, Report report) : world_(world), report_(std::move(report)) {}

Actor& Arena::Add(world::EntityId agent, const BodyKind& kind, bool is_scripted) {
  world::Agent& body = *world_.FindAgent(agent);
  actors_.push_back(std::make_unique<Actor>(*this, world_, agent, kind, is_scripted));
  if (is_scripted) return *actors_.back();
  body.SetHeight(kind.height_m);
  body.SetRadius(kind.radius_m);
  body.SetMass(kind.mass_kg);
  body.SetMaxSpeed(kind.max_speed_mps);
  body.SetMaxForce(kind.max_force_n);
  body.SetHealth(kind.health);
  GiveLooks(*actors_.back());
  return *actors_.back();
}

void Arena::Remove(world::EntityId agent) {
  Tell(agent, "leaves", "a script removed it");
  std::erase_if(actors_, [&](const auto& actor) { return actor->id() == agent; });
  std::erase_if(touching_, [&](const auto& pair) { return pair.first == agent || pair.second == agent; });
}

/// A person that walks as the body moves, with a rifle if it is armed; or a plain capsule.
void Arena::GiveLooks(Actor& actor) {
  world::Scene& scene = world_.scene();
  const BodyKind& kind = actor.kind();
  const world::NodeId node = actor.body().node();
  if (kind.looks != "person") {
    // The viewer replaces a capsule with the material of a creature by its figure.
    const std::string_view material = MaterialOfLooks(kind.looks);
    scene.SetMaterial(scene.CreateCapsule(node, kind.height_m, kind.radius_m),
                      material.empty() ? kind.material : std::string(material));
    return;
  }
  const world::NodeId person = scene.CreateMesh(node, "models/soarbox/soldier.mesh");
  scene.SetPosition(person, {0, -kind.height_m / 2, 0});
  world::Animator* animator = scene.AnimatorOf(person);
  if (animator == nullptr) return;
  actor.SetLooks(person);
  if (!kind.armed) return;
  const world::NodeId rifle = scene.CreateMesh(node, "models/soarbox/rifle.mesh");
  if (const int hand = animator->rig().skeleton.Find("b_RightHand"); hand >= 0)
    scene.AttachToBone(person, static_cast<std::size_t>(hand), rifle, {0.04f, 0.05f, -0.01f},
                       world::FromRotationVector({98, 97, 0}));
}

Actor* Arena::Find(world::EntityId agent) {
  const auto at = std::lower_bound(actors_.begin(), actors_.end(), agent,
                                   [](const auto& actor, world::EntityId id) { return actor->id() < id; });
  return at != actors_.end() && (*at)->id() == agent ? at->get() : nullptr;
}

world::EntityId Arena::FindAgentNamed(std::string_view name) const {
  for (const world::EntityId id : world_.AgentIds())
    if (world_.FindAgent(id)->name() == name) return id;
  return world::kNoEntity;
}

std::string Arena::NameOfObject(world::EntityId object) const {
  if (const auto at = places_.object_names.find(object); at != places_.object_names.end()) return at->second;
  const world::Object* found = world_.FindObject(object);
  return found == nullptr ? std::string() : std::string(KindOf(found->kind())) + "-" + std::to_string(Number(object));
}

world::EntityId Arena::FindObjectNamed(std::string_view name) const {
  for (const auto& [id, own] : places_.object_names)
    if (own == name && world_.FindObject(id) != nullptr) return id;
  for (const world::EntityId id : world_.ObjectIds())
    if (NameOfObject(id) == name) return id;
  return world::kNoEntity;
}

bool Arena::PutDown(const CarriedThing& thing, world::Vec3 ground) {
  const Item& item = thing.item;
  const world::EntityId id = item.shape == "column" ? world_.CreateCapsule(item.size.y, item.size.x / 2)
                                                    : world_.CreateBox(item.size.x, item.size.y, item.size.z);
  world::Object* object = world_.FindObject(id);
  if (object == nullptr) return false;
  object->SetMass(item.mass_kg);
  object->SetPosition(ground + world::Vec3{0, item.size.y / 2, 0});
  if (!item.material.empty()) world_.scene().SetMaterial(object->node(), item.material);
  places_.object_names[id] = thing.name;
  Item& placed = places_.items[id] = item;
  placed.object = id;
  return true;
}

void Arena::BuildWays() {
  // Navigation meshes ignore planes, so a slab directly below the ground is used instead.
  constexpr float kSide_m = 160, kThick_m = 1, kBelow_m = 0.02f;
  if (ground_ == world::kNoEntity) {
    ground_ = world_.CreateBox(kSide_m, kThick_m, kSide_m);
    if (world::Object* slab = world_.FindObject(ground_)) {
      slab->SetMass(0);
      slab->SetPosition({0, -kThick_m / 2 - kBelow_m, 0});
      // It is hidden, because drawing it below the ground would cost as much as drawing the ground.
      world_.scene().SetVisible(world_.NodeOf(ground_), false);
    }
  }
  world::NavigationConfig config;
  config.walkable_radius_m = 0.5f;
  config.cell_size_m = 0.25f;
  config.climb_height_m = 0.3f;
  config.min_region_cells = 8;
  config.merge_region_cells = 20;
  has_ways_ = world_.CreateNavigationMesh(kWays, config).ok();
  for (const world::EntityId id : world_.ObjectIds())
    if (!places_.items.contains(id)) things_of_ways_.push_back(id);
}

std::vector<world::Vec3> Arena::FindWay(world::Vec3 from, world::Vec3 to) {
  if (!has_ways_) return {};
  const Result<const world::NavigationMesh*> mesh = world_.navigation().Find(kWays);
  has_ways_ = mesh.ok();
  if (!has_ways_) return {};
  std::vector<world::Vec3> way = mesh.value()->FindPath(from, to);
  if (!way.empty()) way.erase(way.begin());
  return way;
}

bool Arena::MayReach(world::Vec3 from, world::Vec3 to, float within_m) {
  const Result<const world::NavigationMesh*> mesh = world_.navigation().Find(kWays);
  if (!has_ways_ || !mesh.ok()) return true;
  const auto things = world_.ObjectIds();
  return !std::includes(things.begin(), things.end(), things_of_ways_.begin(), things_of_ways_.end()) ||
         mesh.value()->MayReach(from, to, within_m);
}

void Arena::Foresee(const world::Workers& workers) {
  const auto last = std::ranges::find_if(actors_, [](const auto& actor) { return !actor->OnlyWalks(); });
  const auto count = static_cast<std::size_t>(last - actors_.begin());
  constexpr std::size_t kWorthThread = 8;
  world::WorkInPieces(workers, count, kWorthThread, [this](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) actors_[i]->Foresee();
  });
}

void Arena::Step() {
  board_.Forget(world_.tick(), static_cast<std::uint64_t>(kMessagesKept_s / world_.settings().step_s));
  for (const auto& actor : actors_) {
    actor->Step();
    world_.SyncAgent(actor->id());
  }
}

void Arena::HearCollisions() {
  std::set<std::pair<world::EntityId, world::EntityId>> now;
  for (const world::Collision& collision : world_.Collisions()) {
    for (const auto& [self, other] : {std::pair{collision.a, collision.b}, std::pair{collision.b, collision.a}}) {
      Actor* actor = Find(self);
      if (actor == nullptr || now.size() >= kMostTouching) continue;
      const world::Object* object = world_.FindObject(other);
      if (object != nullptr && (object->kind() == world::ObjectKind::kPlane || other == ground_)) continue;
      // Standing on something is not a collision.
      if (object != nullptr && collision.normal_on_b.y * (self == collision.a ? 1 : -1) > 0.7f) continue;
      now.insert({self, other});
      if (touching_.contains({self, other})) continue;
      Happening happening;
      happening.type = "collision";
      const world::Agent* agent = world_.FindAgent(other);
      happening.by = agent != nullptr ? agent->name() : NameOfObject(other);
      happening.bearing_deg = BearingOf(actor->body().Position(), actor->body().Forward(),
                                        agent != nullptr ? agent->Position() : collision.point_b);
      actor->Notice(std::move(happening));
    }
  }
  touching_ = std::move(now);
}

void Arena::OnShot(const world::Shot& shot) {
  const world::Agent& shooter = *world_.FindAgent(shot.shooter);
  const float heard_m = [&] {
    const Actor* actor = Find(shot.shooter);
    return actor != nullptr && actor->weapon() ? actor->weapon()->settings().heard_m : 0.0f;
  }();
  world_.debug().Line(shot.from, shot.to, {1, 0.8f, 0.2f});
  const auto kept = static_cast<std::uint64_t>(kShotsKept_s / world_.settings().step_s);
  while (!past_.shots.empty() && past_.shots.front().tick + kept < world_.tick()) past_.shots.pop_front();
  if (past_.shots.size() >= kMostShots) past_.shots.pop_front();
  past_.shots.push_back({shot, world_.tick()});
  for (const auto& actor : actors_) {
    if (actor->id() == shot.shooter || !actor->IsAlive()) continue;
    const bool is_hit = actor->id() == shot.hit;
    const float range_m = FlatDistance(actor->body().Position(), shot.from);
    if (!is_hit && range_m > heard_m) continue;
    Happening happening;
    happening.type = is_hit ? "hit" : "shot-heard";
    happening.by = shooter.name();
    happening.bearing_deg = BearingOf(actor->body().Position(), actor->body().Forward(), shot.from);
    happening.damage = is_hit ? shot.damage : 0;
    actor->Notice(std::move(happening));
    // A shot reveals the position of the shooter.
    Contact& contact = actor->contacts()[shot.shooter];
    if (contact.agent == world::kNoEntity || !contact.visible) {
      contact.agent = shot.shooter;
      contact.source = Contact::Source::kHearing;
      contact.noticed_tick = world_.tick();
      contact.position = shooter.Position();
      contact.velocity = shooter.Velocity();
      contact.forward = shooter.Forward();
    }
  }
  const world::Agent* victim = world_.FindAgent(shot.hit);
  Tell(shot.shooter, "shoots", victim != nullptr ? "hits " + victim->name() : "misses");
  if (shot.killed) Tell(shot.hit, "dies", "shot by " + shooter.name());
}

void Arena::Order(world::EntityId agent, const std::string& order) {
  world::Message message;
  message.to = agent;
  message.about = "order";
  std::istringstream words(order);
  std::string name = "action", value;
  if (!(words >> value)) return;
  do {
    message.fields.push_back({name, value});
  } while (message.fields.size() < 20 && words >> name >> value);
  board_.Post(std::move(message), world_.tick());
}

void Arena::Tell(world::EntityId agent, std::string_view news, std::string text, std::optional<Speech> speech) {
  if (news == "dies") past_.deaths[agent] = {text, world_.time_s()};
  RunEvent event;
  event.kind = EventKind::kNews;
  event.agent = world_.FindAgent(agent)->name();
  event.news = news;
  event.text = std::move(text);
  if (speech) event.values = *std::move(speech);
  event.position = world_.FindAgent(agent)->Position();
  report_(std::move(event));
}

void Arena::AddTo(world::StateHash& hash) const {
  for (const auto& actor : actors_) actor->AddTo(hash);
  hash.Add(std::uint64_t{board_.messages().size()});
}

}  // namespace soarbox::sim
