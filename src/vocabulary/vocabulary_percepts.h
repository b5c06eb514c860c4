// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>

#include "vocabulary/vocabulary.h"

namespace soarbox::vocabulary {

inline constexpr PerceptRow Object(std::string_view path, std::string_view sense, std::string_view meaning) {
  return {path, sense, ValueType::kObject, {}, 0, 0, 0, {}, meaning};
}
inline constexpr PerceptRow Number(std::string_view path, std::string_view sense, std::string_view unit, double min,
                                   double max, double step, std::string_view meaning) {
  return {path, sense, ValueType::kNumber, unit, min, max, step, {}, meaning};
}
inline constexpr PerceptRow Integer(std::string_view path, std::string_view sense, std::string_view unit, double min,
                                    double max, std::string_view meaning) {
  return {path, sense, ValueType::kInteger, unit, min, max, 1, {}, meaning};
}
inline constexpr PerceptRow Word(std::string_view path, std::string_view sense, std::string_view words,
                                 std::string_view meaning) {
  return {path, sense, ValueType::kWord, {}, 0, 0, 0, words, meaning};
}

inline constexpr double kFar_m = 1e6;

/// The table of percepts. Each row follows the row of its parent object.
inline constexpr PerceptRow kPerceptTable[] = {
    Number("distance", "distance", "m^2", 0, 0, 0,
           "The thesis' percept: the squared distance between the centres of the agent and its target or leader"),

    Number("time", "time", "s", 0, 0, 0.1, "Simulated time since the run began"),

    Object("self", "self", "The agent itself"),
    Word("self.name", "self", "", "Its name, as other agents see it"),
    Word("self.team", "self", "", "Its team"),
    Object("self.position", "self", "Its position on the ground"),
    Number("self.position.x", "self", "m", -kFar_m, kFar_m, 0.1, "To the east"),
    Number("self.position.z", "self", "m", -kFar_m, kFar_m, 0.1, "To the south"),
    Integer("self.heading", "self", "deg", 0, 359, "The direction it faces: 0 is along z, 90 along x"),
    Number("self.speed", "self", "m/s", 0, 100, 0.1, "Its speed over the ground"),
    Integer("self.health", "self", "", 0, 1000, "Its remaining health; it dies at 0"),
    Word("self.stance", "self", "standing crouching prone", "Its posture"),
    Word("self.weapon", "self", "none ready cooling reloading empty", "The state of its weapon"),
    Integer("self.ammunition", "self", "", 0, 10000, "Rounds in the magazine"),
    Integer("self.reserve", "self", "", 0, 10000, "Further rounds that it carries"),
    Word("self.target", "self", "", "The agent that its last set-target command named; absent until then"),
    Word("self.leader", "self", "", "The agent that it follows; absent if there is none"),
    Word("self.carries", "self", "", "The name of an item that it carries; once per item"),

    Object("agent", "agents", "Another agent that it sees, hears or remembers; one per agent"),
    Word("agent.name", "agents", "", "Its name"),
    Word("agent.team", "agents", "", "Its team"),
    Word("agent.relation", "agents", "friend enemy", "friend: in the same team"),
    Word("agent.foreign", "agents", "yes", "yes: another simulation moves it; absent for all others"),
    Word("agent.kind", "agents", "", "The kind of body of a foreign agent; absent for all others"),
    Word("agent.visible", "agents", "yes no", "Whether it is in view now"),
    Word("agent.known-by", "agents", "sight hearing memory", "How it knows of the other agent"),
    Number("agent.range", "agents", "m", 0, kFar_m, 0.1, "Distance to where it is or was last noticed"),
    Integer("agent.bearing", "agents", "deg", -180, 180,
            "Direction to it: 0 is straight ahead, positive is to the left"),
    Word("agent.nearest", "agents", "yes no", "yes: the nearest of the friends or enemies that are alive and in view"),
    Object("agent.position", "agents", "Where it is or was last noticed"),
    Number("agent.position.x", "agents", "m", -kFar_m, kFar_m, 0.1, "To the east"),
    Number("agent.position.z", "agents", "m", -kFar_m, kFar_m, 0.1, "To the south"),
    Number("agent.speed", "agents", "m/s", 0, 100, 0.1, "Its speed when it was last noticed"),
    Integer("agent.facing", "agents", "deg", 0, 180,
            "How far it would have to turn to face this agent: 0 means that it faces it"),
    Word("agent.alive", "agents", "yes no", "no: it is dead"),
    Number("agent.last-seen", "agents", "s", 0, 1000, 0.5, "Time since it was last noticed; 0 while it is noticed"),
    Number("agent.confidence", "agents", "", 0, 1, 0.1, "1 in view, less when heard, falling to 0 as the memory ages"),

    Object("object", "objects", "A thing that it sees, or saw and remembers; one per thing"),
    Word("object.name", "objects", "", "Its name in the scenario, or its kind and a number"),
    Word("object.kind", "objects", "box capsule mesh sphere item", "What it is"),
    Word("object.visible", "objects", "yes no", "Whether it is in view now"),
    Number("object.last-seen", "objects", "s", 0, 1000, 0.5, "Time since it was last in view; 0 while it is"),
    Word("object.nearest", "objects", "yes no", "yes: the nearest of its kind that is in view"),
    Number("object.range", "objects", "m", 0, kFar_m, 0.1, "Distance to its centre"),
    Integer("object.bearing", "objects", "deg", -180, 180,
            "Direction to it: 0 is straight ahead, positive is to the left"),
    Object("object.position", "objects", "Where its centre is"),
    Number("object.position.x", "objects", "m", -kFar_m, kFar_m, 0.1, "To the east"),
    Number("object.position.z", "objects", "m", -kFar_m, kFar_m, 0.1, "To the south"),
    Number("object.radius", "objects", "m", 0, kFar_m, 0.1, "Half its longest diagonal"),
    Word("object.moves", "objects", "yes no", "no: fixed to the ground"),

    Object("path", "path", "Its current movement"),
    Word("path.status", "path", "none moving arrived blocked", "The state of its last movement command"),
    Word("path.command", "path", "", "The name of that command; absent if there was none"),
    Number("path.remaining", "path", "m", 0, kFar_m, 0.5, "Distance still to go; absent if there is no destination"),
    Word("path.free-ahead", "path", "yes no", "Whether the next 3 m straight ahead are free"),

    Object("waypoint", "waypoints", "A waypoint of the scenario; one per waypoint"),
    Word("waypoint.name", "waypoints", "", "Its name"),
    Integer("waypoint.index", "waypoints", "", 1, 10000, "Its number in the scenario's order, from 1"),
    Number("waypoint.range", "waypoints", "m", 0, kFar_m, 0.5, "Distance to it"),
    Integer("waypoint.bearing", "waypoints", "deg", -180, 180, "Direction to it; positive is to the left"),
    Word("waypoint.here", "waypoints", "yes no", "Whether the agent is within 1.5 m of it"),

    Object("region", "regions", "A region of the scenario; one per region"),
    Word("region.name", "regions", "", "Its name"),
    Word("region.inside", "regions", "yes no", "Whether the agent is in it"),
    Number("region.range", "regions", "m", 0, kFar_m, 0.5, "Distance to its centre"),
    Integer("region.bearing", "regions", "deg", -180, 180, "Direction to its centre; positive is to the left"),

    Object("message", "messages", "A message to this agent; stays for 3 s"),
    Word("message.from", "messages", "", "Who sent it"),
    Word("message.about", "messages", "", "What it is about: the parameter of `say` or `broadcast`"),
    Number("message.time", "messages", "s", 0, 0, 0.1, "When it was sent"),

    Object("event", "events", "Something that happened to this agent; stays for 1 s"),
    Word("event.type", "events", "hit collision shot-heard", "What happened"),
    Word("event.by", "events", "", "Who or what did it, if it is known"),
    Integer("event.bearing", "events", "deg", -180, 180, "Direction that it came from; positive is to the left"),
    Number("event.damage", "events", "", 0, 1000, 1, "Health lost to a hit"),
    Number("event.time", "events", "s", 0, 0, 0.1, "When it happened"),

    Object("order", "orders", "The last order that this agent got from a leader: a message with ^about order"),
    Word("order.from", "orders", "", "Who gave it"),
    Word("order.action", "orders", "", "What to do; the message's other parameters are beside it"),
    Number("order.time", "orders", "s", 0, 0, 0.1, "When it was given"),
};

/// The row of a path. An unknown path is a compile-time error.
consteval const PerceptRow& RowOf(std::string_view path) {
  for (const PerceptRow& row : kPerceptTable) {
    if (row.path == path) return row;
  }
  throw "there is no such percept";
}

}  // namespace soarbox::vocabulary
