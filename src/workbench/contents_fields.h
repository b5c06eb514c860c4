// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "debugger/fields.h"
#include "workbench/contents.h"

namespace soarbox::workbench {

/// The fields of contents in JSON (debugger/json_fields.h). The page's types and docs/workbench.md are generated from
/// these lists.

void Fields(auto& visit, const Moment& at) {
  visit.Type("Time", "The tick that the picture and the panels show, and the ticks that they can show.");
  visit("first_tick", at.first_tick, "the oldest tick that can be shown");
  visit("shown_tick", at.shown_tick, "the tick that is shown");
  visit("last_tick", at.last_tick, "the newest tick");
  visit("step_s", at.step_s, "length of a tick in seconds");
  visit("turn_ticks", at.turn_ticks, "ticks in a turn of a game");
  visit("is_recording", at.is_recording, "whether the run is a recording");
  visit("is_live", at.is_live, "whether the newest tick is shown, and new ones are followed");
  visit("can_go_back", at.can_go_back, "whether the run has a history");
  visit("can_resume", at.can_resume, "whether the run can continue from a past tick");
  visit("resume_refusal", at.resume_refusal, "why it cannot; empty if it can");
  visit("branch_tick", at.branch_tick, "the tick at which the run last left its old future");
  visit("branches", at.branches, "how often it went back and continued from there");
  visit("changed_tick", at.changed_tick, "the tick at which the user last changed rules; null: never");
}

void Fields(auto& visit, const ProblemRow& row) {
  visit.Type("RunProblem", "An error or a warning of the run.");
  debugger::DiagnosticFields(visit, row.diagnostic);
  visit("agent", row.agent, "empty: the world");
  visit("tick", row.tick, "when it occurred");
  visit("time_s", row.time_s, "the same in seconds");
  visit("cause", sim::CauseName(row.cause),
        "`broken`, `slip`, `endless`, `refused`, `furthest`, `awaits`, `stalled`, `waiting` or `symptom`");
}

/// The number of dropped PDUs for a reason.
struct DroppedPdus {
  std::string why;
  std::uint64_t count = 0;
};
void Fields(auto& visit, const DroppedPdus& dropped) {
  visit.Type("DroppedPdus", "PDUs that were dropped for the same reason.");
  visit("why", dropped.why, "the reason");
  visit("count", dropped.count, "their number");
}
void Fields(auto& visit, const ExerciseContents::Entity& entity) {
  visit.Type("Entity", "An entity of an exercise.");
  visit("id", entity.id, "\"7:8:9\"");
  visit("agent", entity.agent, "the agent that represents it here; empty if it is too far away to have one");
  visit("marking", entity.marking, "its marking");
  visit("team", entity.team, "its team");
  visit("body", entity.body, "its body here");
  visit("type", entity.type, "its type");
  visit("silent_s", entity.silent_s, "seconds since its last PDU");
}
void Fields(auto& visit, const ExerciseContents& exercise) {
  const auto tenths = [](double value) { return std::round(value * 10) / 10; };
  std::vector<DroppedPdus> dropped;
  for (const auto& [why, count] : exercise.dropped) dropped.push_back({why, count});
  visit.Type("ExerciseState", "The exercise of other simulations (DIS) that a run takes part in.");
  visit("number", exercise.exercise, "its number");
  visit("address", exercise.address, "\"239.1.2.3:3000\"");
  visit("this_machine_only", exercise.is_of_this_machine, "whether PDUs stay on this machine");
  visit("as", exercise.as, "site and application: \"1:1\"");
  visit("listens_only", exercise.listens_only, "whether nothing is sent");
  visit("takes_orders", exercise.takes_orders, "whether a manager can freeze the run");
  visit("is_frozen", exercise.is_frozen, "whether a manager has done so");
  visit("sent", exercise.sent, "number of PDUs that were sent");
  visit("sent_per_s", tenths(exercise.sent_per_s), "the same per second");
  visit("not_sent", exercise.not_sent, "number of PDUs that could not be sent");
  visit("received", exercise.received, "number of PDUs that were received");
  visit("received_per_s", tenths(exercise.received_per_s), "the same per second");
  visit("dropped", dropped, "received, but not used");
  visit("entity_count", exercise.entity_count, "number of all entities");
  visit("entities", exercise.entities, "the first 200 of them");
}

void Fields(auto& visit, const CheckRow& row) {
  visit.Type("Check", "A check of the run's mission.");
  visit("name", row.name, "its name");
  visit("expected", row.expected, "\"scout should be at gate by 30 s\"");
  visit("was", row.was, "the value found instead; empty if there is none to report");
  visit("agent", row.agent, "the agent whose behaviour decided it; empty if there is none");
  visit("is_marker", row.is_marker, "whether it marks a moment instead of being required");
  visit("state", row.state, "`open`, `true`, `false`, `untested` or `undecided`");
  visit("tick", row.tick, "when it was decided");
  visit("time_s", row.time_s, "the same in seconds");
}
void Fields(auto& visit, const LessonContents& lesson) {
  visit.Type("Lesson", "The lesson that the world belongs to.");
  visit("name", lesson.name, "the name that opens it");
  visit("title", lesson.title, "its title");
  visit("idea", lesson.idea, "what it teaches");
  visit("task", lesson.task, "what to do");
  visit("panel", lesson.panel, "the panel to look at");
  visit("new_panels", lesson.new_panels, "the panels that it is about");
  visit("hints", lesson.hints, "hints that were asked for");
  visit("hint_count", lesson.hint_count, "number of all hints");
  visit("is_tried", lesson.is_tried, "whether the learner has changed something, or had it graded");
  visit("is_passed", lesson.is_passed, "whether it is solved");
  visit("is_graded", lesson.is_graded, "whether it is being graded");
  visit("grade", lesson.grade, "the result, line by line");
  visit("next", lesson.next, "the next lesson; empty if this is the last");
}
void Fields(auto& visit, const LessonOffer& offer) {
  visit.Type("LessonOffer", "A lesson that can be opened.");
  visit("name", offer.name, "the name that opens it");
  visit("title", offer.title, "its title");
  visit("is_passed", offer.is_passed, "whether it is solved");
}

void Fields(auto& visit, const OpenFile& file) {
  visit.Type("OpenFile", "A file that was opened to be edited.");
  visit("file", file.file, "the file");
  visit("is_changed", file.is_changed, "whether it differs from what runs");
  visit("is_unsaved", file.is_unsaved, "whether it differs from the file on the disk");
  visit("failure", file.failure, "why it could not be saved; empty if it could");
}
void Fields(auto& visit, const EditContents& edit) {
  visit.Type("EditText", "The file that the editor shows.");
  visit("file", edit.file, "empty: none");
  visit("is_rules", edit.is_rules, "whether it has rules; otherwise it is a script");
  visit("version", edit.version, "grows when the text comes from elsewhere than the editor");
  visit("text", edit.text, "its text");
  visit("problems", edit.problems, "of the text that was last checked or applied");
  visit("notice", edit.notice, "the result of the last request");
  visit("reload_count", edit.reload_count, "grows when the run has reloaded the text");
  visit("is_changed", edit.is_changed, "whether it differs from what runs");
  visit("is_unsaved", edit.is_unsaved, "whether it differs from the file on the disk");
  visit("go_to_line", edit.go_to_line, "the line to scroll to; 0: none");
  visit("go_to_count", edit.go_to_count, "grows with each request to scroll");
  visit("can_stop", edit.can_stop, "whether it is a script that can stop at lines");
  visit("stops", edit.stops, "the lines at which it stops");
  visit("stop_conditions", edit.stop_conditions, "the condition of each of them; empty: always");
  visit("stopped_line", edit.stopped_line, "the line at which it is stopped; 0: it is not");
}

/// The script that is stopped, and the place of its innermost call in a file.
struct StoppedPlace {
  std::string script, reason, error;
  std::optional<std::string> file;
  std::optional<int> line;
  std::uint64_t count = 0;
};
void Fields(auto& visit, const StoppedPlace& stopped) {
  visit.Type("StoppedScript", "The script that is stopped in the middle of a tick.");
  visit("script", stopped.script, "the agent that it belongs to; `sandbox`");
  visit("reason", stopped.reason, "`breakpoint`, `step` or `error`");
  visit("error", stopped.error, "the error, or why the condition of the stop has no value");
  visit.Known("file", stopped.file, "where it is stopped");
  visit.Known("line", stopped.line, "the line in that file");
  visit("count", stopped.count, "how often a script has stopped so far");
}
/// The variables of a call of the stopped script.
struct ScriptVariables {
  std::vector<debugger::ScriptRow> locals, upvalues, globals;
};
void Fields(auto& visit, const ScriptVariables& variables) {
  visit.Type("ScriptVariables", "The variables of a call of the stopped script.");
  visit("locals", variables.locals, "of the function");
  visit("upvalues", variables.upvalues, "of functions around it");
  visit("globals", variables.globals, "of the script");
}
/// A watched expression. While no script is stopped, it has no value.
struct ScriptWatchRow {
  std::string what;
  std::optional<debugger::ScriptRow> value;
  std::string fault;
};
void Fields(auto& visit, const ScriptWatchRow& watch) {
  visit.Type("ScriptWatch", "A watched expression; without a value while no script is stopped.");
  visit("what", watch.what, "the expression");
  visit.Known("value", watch.value, "its value");
  visit.If(watch.value.has_value(), "fault", watch.fault, "why it has no value; empty if it has one");
}

void Fields(auto& visit, const FuturesContents& futures) {
  const record::Comparison& comparison = futures.comparison;
  visit.Type("FuturesState", "A comparison of the old future with the new one.");
  visit("branch_tick", futures.branch_tick, "where the new future begins");
  visit("now_tick", futures.now_tick, "the newest tick");
  visit("old_is_known", futures.old_is_known, "whether the old future has this tick");
  visit("first_tick", comparison.first_tick, "of the comparison");
  visit("last_tick", comparison.last_tick, "of the comparison");
  visit("percepts", comparison.percepts, "percepts that differ first: \"path: old, new\"");
  visit("course", comparison.course, "the difference over time");
}

void Fields(auto& visit, const WatchRow::Cell& cell) {
  visit.Type("WatchCell", "A watched value of an agent.");
  visit("agent", cell.agent, "the agent");
  visit("text", cell.text, "the present value");
  visit("is_new", cell.is_new, "whether it changed in the last decision");
  visit("is_error", cell.is_error, "whether it is an error");
  visit("tick", cell.tick, "the tick of the last change");
}
void Fields(auto& visit, const WatchRow& row) {
  visit.Type("WatchRow", "A watch with its value for each agent.");
  visit("what", row.what, "what is watched");
  visit("cells", row.cells, "one for each agent");
}
void Fields(auto& visit, const MindColumn& column) {
  visit.Type("MindColumn", "One of several minds side by side.");
  visit("agent", column.agent, "the agent");
  visit("note", column.note, "why the column is empty; empty if it is not");
  visit("stack", column.stack, "as in `mind`");
  visit("operators", column.operators, "as in `mind`");
  visit("command", column.command, "the last command that the mind gave");
}

inline constexpr std::string_view kPlaceKinds[] = {"rule", "file", "memory", "trace", "message"};
void Fields(auto& visit, const FoundPlace& place) {
  visit.Type("FoundPlace", "A match of the text that is searched everywhere.");
  visit("kind", place.kind, kPlaceKinds, "what it is");
  visit("title", place.title, "the matching line");
  visit("detail", place.detail, "where it is: \"fighter.soar:12\", \"0:03.20\"");
  visit("agent", place.agent, "the agent that it belongs to");
  visit("file", place.file, "the file");
  visit("line", place.line, "the line in that file");
  visit("tick", place.tick, "when it happened");
  visit("id", place.id, "the identifier in working memory");
}
void Fields(auto& visit, const ScenarioOffer& offer) {
  visit.Type("ScenarioOffer", "A world that can be opened.");
  visit("name", offer.name, "the name or path that opens it");
  visit("about", offer.about, "its description");
}

void Fields(auto& visit, const GhostBody& ghost) {
  const auto numbers = [](const world::Vec3& at) { return std::array{at.x, at.y, at.z}; };
  visit.Type("GhostBody", "A figure without a body: an agent in another future, or an object that an agent remembers.");
  visit("name", ghost.name, "the agent, or the object");
  visit("agent_id", ghost.agent_id, "the agent whose figure is drawn; 0: none");
  visit("kind", ghost.kind, "of that agent");
  visit("team", ghost.team, "of that agent");
  visit("position", numbers(ghost.position), "of its centre, in metres");
  visit("forward", numbers(ghost.forward), "where it looks");
  visit("radius_m", ghost.radius_m, "its radius");
  visit("height_m", ghost.height_m, "its height");
}

}  // namespace soarbox::workbench
