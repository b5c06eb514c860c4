// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "debugger/breakpoints.h"
#include "debugger/console.h"
#include "debugger/imagery_rows.h"
#include "debugger/json_fields.h"
#include "debugger/line_stops.h"
#include "debugger/scene_shapes.h"
#include "debugger/timeline.h"
#include "debugger/why.h"
#include "record/compare.h"
#include "sim/live_edits.h"

namespace soarbox::debugger {

/// The fields of a debugger's values in JSON (json_fields.h).

inline constexpr std::string_view kSeverities[] = {"note", "warning", "error"};

void DiagnosticFields(auto& visit, const Diagnostic& d) {
  visit("severity", d.severity, kSeverities, "how bad it is");
  visit.Known("file", d.file, "the file that it is in");
  visit.Known("line", d.line, "from 1");
  visit.Known("column", d.column, "from 1");
  visit("message", d.message, "what is wrong");
  visit.Known("excerpt", d.excerpt, "that line of the file");
  visit.Known("hint", d.hint, "what to do");
  visit.Known("more", d.more, "number of further places with the same error");
}
void Fields(auto& visit, const Diagnostic& d) {
  visit.Type("Problem", "An error or a warning that the user should correct.");
  DiagnosticFields(visit, d);
}

inline constexpr std::string_view kConsoleKinds[] = {"input", "output", "error", "hint"};
void Fields(auto& visit, const ConsoleLine& line) {
  visit.Type("ConsoleLine", "A line of a console.");
  visit("tick", line.tick, "when it was printed");
  visit("kind", line.kind, kConsoleKinds, "what it is");
  visit("text", line.text, "without its line end");
}
void Fields(auto& visit, const Completion& completion) {
  visit.Type("Completion", "Completions of the last word of a line.");
  visit("begin", completion.begin, "where that word begins");
  visit("words", completion.words, "possible words");
  visit("common", completion.common, "their common beginning");
}

inline constexpr std::string_view kSpanKinds[] = {"operator", "state"};
void Fields(auto& visit, const TimelineSpan& span) {
  visit.Type("Span", "The time during which a state exists or an operator is selected.");
  visit("kind", span.is_state, kSpanKinds, "what it is");
  visit("level", span.level, "of the goal stack, from 1");
  visit("id", span.id, "\"O3\", \"S2\"");
  visit("text", span.text, "the operator's name, or the impasse");
  visit("first_tick", span.first_tick, "when it began");
  visit("last_tick", span.last_tick, "when it ended, or the newest tick");
  visit("open", span.open, "whether it has not ended");
}
void Fields(auto& visit, const TimelineMark& mark) {
  visit.Type("Mark", "An event in one tick.");
  visit("tick", mark.tick, "when it happened");
  visit("kind", NameOf(mark.kind), "`command`, `outcome`, `message`, `event`, `error`, `edit` or `learned`");
  visit("text", mark.text, "what happened");
}
void Fields(auto& visit, const TrackRow& track) {
  visit.Type("Track", "What an agent did in some ticks.");
  visit("agent", track.agent, "empty: the world");
  visit("spans", track.spans, "in the order in which they began");
  visit("marks", track.marks, "in the order of their ticks");
}

void Fields(auto& visit, const Breakpoint& point) {
  visit.Type("Breakpoint", "A breakpoint.");
  visit("number", point.number, "its number");
  visit("kind", NameOf(point.kind), "what it waits for, as in the request `break`");
  visit("agent", point.agent, "the agent that it is about; empty: any");
  visit("what", point.what, "as in the request `break`");
  visit("enabled", point.enabled, "whether it is on");
  visit("hits", point.hits, "how often it stopped the world");
}
void Fields(auto& visit, const BreakHit& hit) {
  visit.Type("BreakHit", "Why the world is paused.");
  visit("number", hit.number, "of the breakpoint");
  visit("agent", hit.agent, "the agent that it happened to");
  visit("tick", hit.tick, "when it happened");
  visit("why", hit.why, "\"breakpoint 2: scout: rule attack*enemy fired\"");
}

void Fields(auto& visit, const LineStop& stop) {
  visit.Type("LineStop", "A line at which scripts stop.");
  visit("file", stop.file, "the script");
  visit("line", stop.line, "the line");
  visit("condition", stop.condition, "an expression of Lua that must be true; empty: always");
}
void Fields(auto& visit, const script::ScriptFrame& call) {
  visit.Type("ScriptCall", "A call of a stopped script.");
  visit("function", call.function, "the function that is called");
  visit("file", call.file, "empty for a function of the sandbox");
  visit("line", call.line, "the line that is executed");
}
void Fields(auto& visit, const ScriptRow& row) {
  visit.Type("ScriptRow", "A variable of a stopped script, or a field of it.");
  visit("key", row.key, "its path: \"locals/self/memory\"");
  visit("name", row.name, "its name");
  visit("value", row.value, "its value, as text");
  visit("type", row.type, "the type of its value");
  visit("folds", row.folds, "whether it has fields");
  visit.If(row.is_open, "below", row.below, "its fields, if it is unfolded");
}
void Fields(auto& visit, const WhyNode& node) {
  visit.Type("Reason", "A step of an answer to why.");
  visit("text", node.text, "a sentence");
  visit("kind", KindWord(node.kind), "what it is about");
  visit.Known("link", node.link, "the name of the agent, operator or rule, or the time tag of the element");
  visit.Known("time", node.time_s, "in seconds, of a moment that has passed");
  visit.Known("below", node.below, "the steps that it depends on");
}

/// Rounds to millimetres.
inline ScenePoint Rounded(const ScenePoint& point) {
  ScenePoint rounded{};
  for (std::size_t i = 0; i < point.size(); ++i) rounded[i] = std::round(point[i] * 1000) / 1000;
  return rounded;
}
/// The numbers of all elements, one after another.
template <typename Number, typename List>
std::vector<Number> NumbersOf(const List& list) {
  std::vector<Number> numbers;
  for (const auto& one : list) numbers.insert(numbers.end(), one.begin(), one.end());
  return numbers;
}
inline std::vector<double> RoundedNumbers(const std::vector<ScenePoint>& points) {
  std::vector<double> numbers;
  for (const ScenePoint& point : points)
    for (const double number : Rounded(point)) numbers.push_back(number);
  return numbers;
}

void Fields(auto& visit, const SceneLine& line) {
  visit.Type("SceneLine", "A line that shows why a value of a scene is what it is.");
  visit("from", Rounded(line.from), "in metres");
  visit("to", Rounded(line.to), "in metres");
  visit("is_crossed", line.is_crossed, "whether it is a sight line that an object blocks");
}
void Fields(auto& visit, const SceneNodeRow& node) {
  visit.Type("SceneNode", "A node of an imagined scene.");
  visit("name", node.name, "its name");
  visit("parent", node.parent, "empty for the root");
  visit("depth", node.depth, "number of nodes above it");
  visit("shape", node.shape, "`group`, `hull` or `ball`");
  visit("at", node.at, "its origin in the world, in metres");
  visit("turn", node.turn, "x, y, z, w");
  visit("scale", node.scale, "in its own coordinates");
  visit.If(node.shape == "ball", "radius", node.radius, "of a ball, before scaling");
  visit.Known("points", node.points, "corners of a hull, in its own coordinates");
  visit("tags", node.tags, "its tags");
}
void Fields(auto& visit, const SceneValueRow& value) {
  visit.Type("SceneValue", "A value that an extract found.");
  visit("record", value.record, "its identifier in working memory");
  visit("value", value.text, "as text");
  visit("why", value.why, "from what it was computed");
  visit("nodes", value.nodes, "the nodes that it is about");
  visit("lines", value.lines, "lines that show why it is so");
}
void Fields(auto& visit, const SceneExtractRow& extract) {
  visit.Type("SceneExtract", "A command to a scene, and its answer.");
  visit("id", extract.id, "the identifier of the command");
  visit("command", extract.command, "its name");
  visit("rule", extract.rule, "the rule that gave it");
  visit("filter", extract.filter, "empty if it changes the scene");
  visit("status", extract.status, "of the command");
  visit.Known("problem", extract.problem, "what is wrong with it");
  visit.If(!extract.problem.empty(), "hint", extract.hint, "and what to do");
  visit("count", extract.count, "number of all values");
  visit("values", extract.values, "the first 40 of them");
}
void Fields(auto& visit, const SceneView& scene) {
  visit.Type("ImaginedScene", "The scene of a state.");
  visit("state", scene.state, "\"S1\"");
  visit("nodes", scene.nodes, "each before its children");
  visit("extracts", scene.extracts, "what rules ask, and the answers");
}
void Fields(auto& visit, const ImageryView& view) {
  visit.Type("Scenes", "The scenes of a mind, from the top state down.");
  visit("note", view.note, "why there is none; empty if there is one");
  visit("scenes", view.scenes, "one for each state");
}

void Fields(auto& visit, const sim::WatchedFile& file) {
  visit.Type("AgentFile", "A file that an agent was made from.");
  visit("agent", file.agent, "empty: the world");
  visit("file", file.file, "the file");
  visit("is_rules", file.is_rules, "whether it has rules; otherwise it is a script");
}
void Fields(auto& visit, const record::Comparison::Moment& at) {
  visit.Type("FuturesMoment", "How two futures differ at one moment.");
  visit("time_s", at.time_s, "the moment");
  visit("mean_distance_m", at.mean_distance_m, "mean distance between an agent in one future and in the other");
  visit("greatest_distance_m", at.greatest_distance_m, "the greatest of these distances");
  visit("farthest", at.farthest, "the agent with that distance");
  visit("health_old", at.health_a, "health of all agents in the old future");
  visit("health_new", at.health_b, "the same in the new one");
  visit("alive_old", at.alive_a, "number of living agents in the old future");
  visit("alive_new", at.alive_b, "the same in the new one");
}

inline constexpr std::string_view kShapeKinds[] = {"made-up", "sensed", "remembered"};
void Fields(auto& visit, const SceneShape& shape) {
  visit.Type("ImaginedShape", "A node of an imagined scene, as it is drawn.");
  visit("name", shape.name, "its name");
  visit("state", shape.state, "the state of its scene");
  visit("kind", shape.kind, kShapeKinds, "where it comes from");
  visit("points", RoundedNumbers(shape.points), "x, y and z of each, in metres of the world");
  visit("edges", NumbersOf<std::uint32_t>(shape.edges), "two numbers of points each, from 0");
  visit("faces", NumbersOf<std::uint32_t>(shape.faces), "three numbers of points each, from 0");
}
void Fields(auto& visit, const AnswerLines& answer) {
  visit.Type("AnswerLines", "What shows the reason of the selected answer.");
  visit("text", answer.text, "the answer");
  visit("lines", answer.lines, "lines in the picture");
}

}  // namespace soarbox::debugger
