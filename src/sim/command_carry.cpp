// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <utility>

#include "sim/arena.h"
#include "sim/conduct.h"
#include "sim/directions.h"

// Commands: take, put down and give things.
namespace soarbox::sim {
namespace {

constexpr float kHandy_m = 0.2f;  ///< Half the width of a thing that fits at the feet.

StepResult PickUp(Actor& actor, Running& command) {
  Places& places = actor.arena().places();
  const std::string name = command.Word("object");
  const world::EntityId id = actor.arena().FindObjectNamed(name);
  const world::Object* object = actor.world().FindObject(id);
  if (object == nullptr) return StepResult::Failed("no-such-object");
  const auto item = places.items.find(id);
  if (item == places.items.end()) return StepResult::Failed("not-an-item");
  // A wide thing is taken by its edge.
  const float reach_m = kArmsReach_m + std::max(0.0f, item->second.HalfWidth_m() - kHandy_m);
  if (FlatDistance(actor.body().Position(), object->Position()) > reach_m) return StepResult::Failed("out-of-reach");
  if (item->second.gives == "ammunition" && actor.weapon()) {
    actor.weapon()->AddReserve(static_cast<int>(item->second.amount));
  } else if (item->second.gives == "health") {
    actor.body().SetHealth(std::min(actor.kind().health, actor.body().Health() + item->second.amount));
  } else {
    actor.Carry({name, item->second});
  }
  actor.arena().Tell(actor.id(), "takes", name);
  actor.world().RemoveObject(id);
  places.items.erase(item);
  places.object_names.erase(id);
  return StepResult::Done();
}

StepResult Drop(Actor& actor, Running& command) {
  const std::string name = command.Word("object");
  const auto carried = std::ranges::find(actor.carried(), name, &CarriedThing::name);
  if (carried == actor.carried().end()) return StepResult::Failed("not-carried");
  // In front of its feet. A small thing is put below the feet if an object is in the way.
  constexpr float kBefore_m = 0.4f;
  const float half_m = carried->item.HalfWidth_m();
  world::Vec3 place = actor.body().Position();
  const world::Vec3 ahead = place + actor.body().Forward() * (actor.RadiusWithout(name) + (kBefore_m + half_m));
  const bool is_free = !actor.world().RayCast(place, ahead + actor.body().Forward() * (half_m - kHandy_m));
  if (is_free) place = ahead;
  place.y -= actor.body().Height() / 2;
  if ((!is_free && half_m > kHandy_m) || !actor.arena().PutDown(*carried, place)) {
    return StepResult::Failed("no-room");
  }
  actor.LetGo(name);
  actor.arena().Tell(actor.id(), "drops", name);
  return StepResult::Done();
}

StepResult Give(Actor& actor, Running& command) {
  const std::string name = command.Word("object");
  if (std::ranges::find(actor.carried(), name, &CarriedThing::name) == actor.carried().end())
    return StepResult::Failed("not-carried");
  const world::EntityId id = actor.arena().FindAgentNamed(command.Word("to"));
  if (id == actor.id()) return StepResult::Failed("itself");
  Actor* other = actor.arena().Find(id);
  if (other == nullptr) return StepResult::Failed("no-such-agent");
  if (!other->IsAlive()) return StepResult::Failed("target-dead");
  // Both agents reach out; the distance is between their surfaces.
  const float apart_m =
      FlatDistance(actor.body().Position(), other->body().Position()) - actor.body().Radius() - other->body().Radius();
  if (apart_m > kArmsReach_m) return StepResult::Failed("out-of-reach");
  actor.arena().Tell(actor.id(), "gives", name + " to " + other->body().name());
  other->Carry(std::move(*actor.LetGo(name)));
  return StepResult::Done();
}

constexpr Conduct kCarryConducts[] = {{"pick-up", PickUp}, {"drop", Drop}, {"give", Give}};

}  // namespace

std::span<const Conduct> CarryingConducts() {
  return kCarryConducts;
}

}  // namespace soarbox::sim
