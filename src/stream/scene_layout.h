// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include "stream/quantise.h"
#include "world/math.h"
#include "world/overlay_snapshot.h"
#include "world/scene_snapshot.h"

namespace soarbox::stream {

/// The records of a scene's stream: their values in order, how each is rounded, and its name in a page. SceneEncoder
/// writes them, and the page's reader (web/src/format/scene_records.ts) is generated from these lists. A record has:
///
///   Type         the name of the record, and what it is; first
///   Number       a whole number, 0 or more
///   Steps        a number in steps of 1 / the last argument
///   Share        a part of 1 in such steps, as a byte
///   Float, Floats  one number, or three of a vector, as they are
///   Flag, Flags  one byte: whether it is so; or a bit for each of several
///   IsZero       a byte that is 0 if it is so
///   Words        a byte: which of these words
///   Color, Word, Turn  as in docs/dev/stream.md
///   Place        a vector in steps of 1 / the last argument
///   PlaceIf      a flag, and a place in millimetres if it is set
///   Point        a place in millimetres, as the difference to the point before, also of earlier records
///   Moment       the time of an event, from its age, in 1/100 s

using Flag = std::pair<std::string_view, bool>;
using FlagList = std::initializer_list<Flag>;

/// A precision of decimetres is enough for marks on the ground, and they change less often.
inline constexpr double kPerSign = 10;

void Layout(auto& visit, const world::LightSnapshot& light) {
  visit.Type("Light", "A light.");
  visit.Number("id", light.id);
  visit.IsZero("directional", static_cast<std::uint8_t>(light.kind));
  visit.Flag("castsShadows", light.casts_shadows);
  visit.Floats("place", light.position);
  visit.Floats("direction", light.direction);
  visit.Floats("diffuse", light.diffuse);
  visit.Floats("specular", light.specular);
  visit.Float("range", light.range_m);
  visit.Floats("attenuation", {light.attenuation[0], light.attenuation[1], light.attenuation[2]});
}

/// The camera, and the number of its moves that scripts ordered.
struct MovedCamera {
  std::uint64_t moves = 0;
  world::CameraSnapshot camera;
};
void Layout(auto& visit, const MovedCamera& moved) {
  visit.Type("Camera", "The camera.");
  visit.Number("moves", moved.moves);
  visit.Place("place", moved.camera.position, kPerMetre);
  visit.Turn("turn", moved.camera.orientation);
  visit.Float("fovDeg", moved.camera.vertical_fov_deg);
}

/// What seldom changes of an agent.
struct AgentLooks {
  const world::AgentSnapshot& agent;
};
void Layout(auto& visit, const AgentLooks& looks) {
  const world::AgentSnapshot& agent = looks.agent;
  visit.Type("AgentLooks", "What seldom changes of an agent.");
  visit.Word("name", agent.name);
  visit.Word("kind", agent.kind);
  visit.Word("script", agent.script);
  visit.Word("team", agent.team);
  visit.Float("radius", agent.radius_m);
  visit.Float("height", agent.height_m);
}
/// How an agent is.
struct AgentState {
  const world::AgentSnapshot& agent;
};
void Layout(auto& visit, const AgentState& state) {
  const world::AgentSnapshot& agent = state.agent;
  visit.Type("AgentState", "How an agent is.");
  visit.Steps("health", agent.health, 10);
  visit.Flags({{"alive", agent.alive}, {"failed", agent.failed}});
  visit.Word("lastCommand", agent.last_command);
}

void Layout(auto& visit, const world::ParticleSnapshot& particle) {
  visit.Type("Particle", "An effect of particles.");
  visit.Number("id", particle.id);
  visit.Word("effect", particle.effect);
  visit.Flags({{"visible", particle.visible}, {"directed", particle.has_direction}});
  visit.Number("restarts", particle.restarts);
  visit.Place("place", particle.position, kPerMetre);
  visit.Place("direction", particle.has_direction ? particle.direction : world::Rotate(particle.orientation, {0, 0, 1}),
              kPerDirection);
}

void Layout(auto& visit, const world::SoundSnapshot& sound) {
  visit.Type("Sound", "A sound that began in the last second.");
  visit.Number("id", sound.id);
  visit.Word("file", sound.file);
  visit.Float("volume", sound.volume);
  visit.PlaceIf(sound.in_world, "place", sound.position);
}

void Layout(auto& visit, const world::LineSnapshot& line) {
  visit.Type("Line", "A line.");
  visit.Point("from", line.from);
  visit.Point("to", line.to);
  visit.Color("color", line.color);
}
void Layout(auto& visit, const world::CircleSnapshot& circle) {
  visit.Type("Circle", "A circle on the ground.");
  visit.Point("center", circle.center);
  visit.Steps("radius", circle.radius_m, kPerMetre);
  visit.Color("color", circle.color);
}
void Layout(auto& visit, const world::TriangleSnapshot& triangle) {
  visit.Type("Triangle", "A triangle.");
  visit.Point("a", triangle.a);
  visit.Point("b", triangle.b);
  visit.Point("c", triangle.c);
  visit.Color("color", triangle.color);
}

void Layout(auto& visit, const world::ContactSnapshot& contact) {
  visit.Type("Contact", "Another agent, as an agent remembers it.");
  visit.Number("agent", contact.agent_id);
  visit.Place("place", contact.position, kPerSign);
  visit.Flags({{"visible", contact.visible}, {"heard", contact.heard}, {"alive", contact.alive}});
  visit.Share("forgotten", contact.memory_s > 0 ? contact.age_s / contact.memory_s : 1, 20);
}

void Layout(auto& visit, const world::ShotSnapshot& shot) {
  visit.Type("Shot", "A shot.");
  visit.Place("from", shot.from, kPerMetre);
  visit.Place("to", shot.to, kPerMetre);
  visit.Number("shooter", shot.shooter_id);
  visit.Number("hit", shot.hit_agent_id);
  visit.Moment("time", shot.age_s);
}
void Layout(auto& visit, const world::SpeechSnapshot& speech) {
  visit.Type("Speech", "What an agent says to another.");
  visit.Number("from", speech.from_id);
  visit.Number("to", speech.to_id);
  visit.Word("text", speech.text);
  visit.Moment("time", speech.age_s);
}

inline constexpr std::string_view kNamedPlaces[] = {"waypoint", "region", "item", "thing"};
void Layout(auto& visit, const world::PlaceSnapshot& place) {
  visit.Type("NamedPlace", "A place with a name.");
  visit.Words("kind", static_cast<std::uint8_t>(place.kind), kNamedPlaces);
  visit.Word("name", place.name);
  visit.Place("place", place.position, 100);
}

void Layout(auto& visit, const world::PushSnapshot& push) {
  visit.Type("Push", "A force that a script or a command applied to a body in the last step.");
  visit.Number("owner", push.owner_id);
  visit.Place("place", push.position, kPerMetre);
  visit.Floats("force", push.force_n);
  visit.Float("mass", push.mass_kg);
}

/// Generates web/src/format/scene_records.ts.
std::string SceneRecords();

}  // namespace soarbox::stream
