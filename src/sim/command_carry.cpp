// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <utility>

#include "sim/arena.h"
#include "sim/conduct.h"
#include "sim/directions.h"

// Taking things, putting them down and handing them over.
namespace soarbox::sim {
namespace {

StepResult PickUp(Actor& actor, Running& command) {
  Places& places = actor.arena().places();
  const std::string name = command.Word("object");
  const world::EntityId id = actor.arena().FindObjectNamed(name);
  const world::Object* object = actor.world().FindObject(id);
  if (object == nullptr) return StepResult::Failed("no-such-object");
  const auto item = places.items.find(id);
  if (item == places.items.end()) return StepResult::Failed("not-an-item");
  if (FlatDistance(actor.body().Position(), object->Position()) > kArmsReach_m)
    return StepResult::Failed("out-of-reach");
  if (item->second.gives == "ammunition" && actor.weapon()) {
    actor.weapon()->AddReserve(static_cast<int>(item->second.amount));
  } else if (item->second.gives == "health") {
    actor.body().SetHealth(std::min(actor.kind().health, actor.body().Health() + item->second.amount));
  } else {
    actor.carried().push_back({name, item->second});
  }
  actor.arena().Tell(actor.id(), "takes", name);
  actor.world().RemoveObject(id);
  places.items.erase(item);
  places.object_names.erase(id);
  return StepResult::Done();
}

std::vector<CarriedThing>::iterator FindCarried(Actor& actor, const std::string& name) {
  return std::find_if(actor.carried().begin(), actor.carried().end(),
                      [&](const CarriedThing& thing) { return thing.name == name; });
}

StepResult Drop(Actor& actor, Running& command) {
  const auto carried = FindCarried(actor, command.Word("object"));
  if (carried == actor.carried().end()) return StepResult::Failed("not-carried");
  // Before its feet, or beneath them where something is in the way.
  constexpr float kBefore_m = 0.6f;
  world::Vec3 place = actor.body().Position();
  const world::Vec3 ahead = place + actor.body().Forward() * (actor.body().Radius() + kBefore_m);
  if (!actor.world().RayCast(place, ahead)) place = ahead;
  place.y -= actor.body().Height() / 2;
  if (!actor.arena().PutDown(*carried, place)) return StepResult::Failed("no-room");
  actor.arena().Tell(actor.id(), "drops", carried->name);
  actor.carried().erase(carried);
  return StepResult::Done();
}

StepResult Give(Actor& actor, Running& command) {
  const auto carried = FindCarried(actor, command.Word("object"));
  if (carried == actor.carried().end()) return StepResult::Failed("not-carried");
  const world::EntityId id = actor.arena().FindAgentNamed(command.Word("to"));
  if (id == actor.id()) return StepResult::Failed("itself");
  Actor* other = actor.arena().Find(id);
  if (other == nullptr) return StepResult::Failed("no-such-agent");
  if (!other->IsAlive()) return StepResult::Failed("target-dead");
  // From hand to hand: the reach of both, between their skins.
  const float apart_m =
      FlatDistance(actor.body().Position(), other->body().Position()) - actor.body().Radius() - other->body().Radius();
  if (apart_m > kArmsReach_m) return StepResult::Failed("out-of-reach");
  actor.arena().Tell(actor.id(), "gives", carried->name + " to " + other->body().name());
  other->carried().push_back(std::move(*carried));
  actor.carried().erase(carried);
  return StepResult::Done();
}

constexpr Conduct kCarryConducts[] = {{"pick-up", PickUp}, {"drop", Drop}, {"give", Give}};

}  // namespace

std::span<const Conduct> CarryingConducts() {
  return kCarryConducts;
}

}  // namespace soarbox::sim
