// SPDX-License-Identifier: BSD-2-Clause
#include <cmath>

#include "sim/arena.h"
#include "sim/conduct.h"
#include "sim/directions.h"

// Commands: turn, posture, speech and wait.
namespace soarbox::sim {
namespace {

constexpr float kFaced_deg = 3;

StepResult Face(Actor& actor, Running& command) {
  std::string_view reason;
  world::Vec3 towards;
  if (command.Get("heading") != nullptr) {
    towards = AlongHeading(static_cast<float>(command.Number("heading", 0)));
  } else {
    auto place = actor.FindPlace(command, reason);
    if (!place && reason == "no-place" && actor.target() != world::kNoEntity) {
      if (const auto seen = actor.Find(actor.target(), reason)) place = Actor::Place{seen->position};
    }
    if (!place) return StepResult::Failed(reason);
    towards = Flat(place->position - actor.body().Position());
  }
  if (world::LengthSquared(towards) < 1e-6f) return StepResult::Done();
  actor.Look(towards);
  const float off_deg = std::abs(WrapDegrees(HeadingOf(towards) - HeadingOf(actor.body().Forward())));
  if (off_deg <= kFaced_deg && command.Word("keep") != "yes") return StepResult::Done();
  return StepResult::Going(1 - off_deg / 180);
}

StepResult SetSpeed(Actor& actor, Running& command) {
  actor.SetWalkSpeed(static_cast<float>(command.Number("speed", 0)));
  return StepResult::Done();
}

StepResult Stance(Actor& actor, Running& command) {
  actor.SetStance(command.Word("as"));
  return StepResult::Done();
}

StepResult SetTarget(Actor& actor, Running& command) {
  const std::string name = command.Word("agent");
  const world::EntityId id = name == "none" ? world::kNoEntity : actor.arena().FindAgentNamed(name);
  if (id == world::kNoEntity && name != "none") return StepResult::Failed("no-such-agent");
  if (id == actor.id()) return StepResult::Failed("itself");
  actor.SetTarget(id);
  return StepResult::Done();
}

StepResult Post(Actor& actor, Running& command, world::EntityId to) {
  world::Message message;
  message.from = actor.id();
  message.to = to;
  message.team = actor.body().Team();
  message.about = command.Word("about");
  for (const vocabulary::Percept& field : command.said.parameters) {
    if (field.IsObject() || vocabulary::HoldsWord("to about status reason parameter progress", field.attribute))
      continue;
    world::Message::Value value;
    if (const auto* text = field.Text()) {
      value = *text;
    } else if (const auto* integer = std::get_if<std::int64_t>(&field.value)) {
      value = *integer;
    } else {
      value = std::get<double>(field.value);
    }
    message.fields.push_back({field.attribute, std::move(value)});
  }
  std::string heard = to == world::kNoEntity ? "team " + message.team : actor.world().FindAgent(to)->name();
  const std::string said = vocabulary::Describe(command.said.parameters);
  actor.arena().Tell(actor.id(), "says", "to " + heard + ": " + said, Speech{heard, message.about, said});
  actor.arena().board().Post(std::move(message), actor.world().tick());
  return StepResult::Done();
}

StepResult Say(Actor& actor, Running& command) {
  const world::EntityId to = actor.arena().FindAgentNamed(command.Word("to"));
  if (to == world::kNoEntity) return StepResult::Failed("no-such-agent");
  return Post(actor, command, to);
}

StepResult Broadcast(Actor& actor, Running& command) {
  return Post(actor, command, world::kNoEntity);
}

StepResult Wait(Actor& actor, Running& command) {
  const double seconds = command.Number("seconds", 0);
  const double passed = static_cast<double>(command.ticks) * static_cast<double>(actor.world().settings().step_s);
  if (passed >= seconds) return StepResult::Done();
  return StepResult::Going(static_cast<float>(passed / seconds));
}

constexpr Conduct kOtherConducts[] = {
    {"face", Face}, {"set-speed", SetSpeed},  {"stance", Stance}, {"set-target", SetTarget},
    {"say", Say},   {"broadcast", Broadcast}, {"wait", Wait},
};

}  // namespace

std::span<const Conduct> OtherConducts() {
  return kOtherConducts;
}

}  // namespace soarbox::sim
