// SPDX-License-Identifier: BSD-2-Clause
#include "workbench/contents_json.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "debugger/facts_text.h"
#include "workbench/document/panels.h"

namespace soarbox::workbench {
namespace {

/// Maximum number of the newest items in lists that grow with a run, and of ticks in the timeline.
constexpr std::size_t kMostLines = 500;
constexpr std::uint64_t kTimelineTicks = 900;

/// Converts the elements of a list with a function.
template <typename List, typename Each>
Json ListOf(const List& list, Each each) {
  Json json = Json::array();
  for (const auto& one : list) json.push_back(each(one));
  return json;
}

/// Converts elements that have a JSON form.
template <typename List>
Json ListOf(const List& list) {
  return ListOf(list, [](const auto& one) -> Json { return debugger::ToJson(one); });
}

template <typename Value>
Json OrNull(const std::optional<Value>& value) {
  return value ? Json(debugger::ToJson(*value)) : Json();
}

/// The end of a long list.
template <typename List>
auto Newest(const List& list) {
  const auto first = list.size() > kMostLines ? list.end() - static_cast<std::ptrdiff_t>(kMostLines) : list.begin();
  return std::vector(first, list.end());
}

Json MomentJson(const Moment& at) {
  Json json;
  json["first_tick"] = at.first_tick;
  json["shown_tick"] = at.shown_tick;
  json["last_tick"] = at.last_tick;
  json["step_s"] = at.step_s;
  json["turn_ticks"] = at.turn_ticks;
  json["is_recording"] = at.is_recording;
  json["is_live"] = at.is_live;
  json["can_go_back"] = at.can_go_back;
  json["can_resume"] = at.can_resume;
  json["resume_refusal"] = at.resume_refusal;
  json["branch_tick"] = at.branch_tick ? Json(*at.branch_tick) : Json();
  json["branches"] = at.branches;
  json["changed_tick"] = at.changed_tick ? Json(*at.changed_tick) : Json();
  return json;
}

Json ProblemJson(const ProblemRow& row) {
  Json json = debugger::ToJson(row.diagnostic);
  json["agent"] = row.agent;
  json["tick"] = row.tick;
  json["time_s"] = row.time_s;
  json["cause"] = sim::CauseName(row.cause);
  return json;
}

/// Rounds to one decimal.
double Tenths(double value) {
  return std::round(value * 10) / 10;
}

Json ExerciseJson(const ExerciseContents& exercise) {
  Json json{{"number", exercise.exercise},
            {"address", exercise.address},
            {"this_machine_only", exercise.is_of_this_machine},
            {"as", exercise.as},
            {"listens_only", exercise.listens_only},
            {"takes_orders", exercise.takes_orders},
            {"is_frozen", exercise.is_frozen},
            {"sent", exercise.sent},
            {"sent_per_s", Tenths(exercise.sent_per_s)},
            {"not_sent", exercise.not_sent},
            {"received", exercise.received},
            {"received_per_s", Tenths(exercise.received_per_s)}};
  json["dropped"] = ListOf(exercise.dropped, [](const auto& reason) -> Json {
    return {{"why", reason.first}, {"count", reason.second}};
  });
  json["entity_count"] = exercise.entity_count;
  json["entities"] = ListOf(exercise.entities, [](const ExerciseContents::Entity& one) -> Json {
    return {{"id", one.id},     {"agent", one.agent}, {"marking", one.marking},  {"team", one.team},
            {"body", one.body}, {"type", one.type},   {"silent_s", one.silent_s}};
  });
  return json;
}

Json CheckJson(const CheckRow& row) {
  return {{"name", row.name},           {"expected", row.expected}, {"was", row.was},   {"agent", row.agent},
          {"is_marker", row.is_marker}, {"state", row.state},       {"tick", row.tick}, {"time_s", row.time_s}};
}

Json LessonJson(const LessonContents& lesson) {
  return {{"name", lesson.name},
          {"title", lesson.title},
          {"idea", lesson.idea},
          {"task", lesson.task},
          {"panel", lesson.panel},
          {"new_panels", lesson.new_panels},
          {"hints", lesson.hints},
          {"hint_count", lesson.hint_count},
          {"is_tried", lesson.is_tried},
          {"is_passed", lesson.is_passed},
          {"is_graded", lesson.is_graded},
          {"grade", lesson.grade},
          {"next", lesson.next}};
}

Json EditJson(const EditContents& edit) {
  return {{"file", edit.file},
          {"is_rules", edit.is_rules},
          {"version", edit.version},
          {"text", edit.text},
          {"problems", ListOf(edit.problems)},
          {"notice", edit.notice},
          {"is_changed", edit.is_changed},
          {"is_unsaved", edit.is_unsaved},
          {"go_to_line", edit.go_to_line},
          {"go_to_count", edit.go_to_count},
          {"can_stop", edit.can_stop},
          {"stops", edit.stops},
          {"stop_conditions", edit.stop_conditions},
          {"stopped_line", edit.stopped_line}};
}

Json StoppedJson(const ScriptContents& script) {
  if (!script.stopped) return {};
  Json json{{"script", script.stopped->script}, {"reason", script.stopped->reason}, {"error", script.stopped->error}};
  for (const script::ScriptFrame& call : script.stopped->calls) {
    if (call.file.empty()) continue;
    json["file"] = call.file;
    json["line"] = call.line;
    break;
  }
  json["count"] = script.count;
  return json;
}

Json CallsJson(const ScriptContents& script) {
  if (!script.stopped) return Json::array();
  return ListOf(script.stopped->calls, [](const script::ScriptFrame& call) -> Json {
    return {{"function", call.function}, {"file", call.file}, {"line", call.line}};
  });
}

Json ScriptRowJson(const debugger::ScriptRow& row) {
  Json json{{"key", row.key}, {"name", row.name}, {"value", row.value}, {"type", row.type}, {"folds", row.folds}};
  if (row.is_open) json["below"] = ListOf(row.below, ScriptRowJson);
  return json;
}

Json VariablesJson(const ScriptContents& script) {
  if (!script.stopped) return {};
  return {{"locals", ListOf(script.stopped->locals, ScriptRowJson)},
          {"upvalues", ListOf(script.stopped->upvalues, ScriptRowJson)},
          {"globals", ListOf(script.stopped->globals, ScriptRowJson)}};
}

Json ScriptWatchesJson(const ScriptContents& script) {
  if (!script.stopped) return ListOf(script.watches, [](const std::string& what) -> Json { return {{"what", what}}; });
  return ListOf(script.stopped->watches, [](const debugger::ScriptWatch& watch) -> Json {
    return {{"what", watch.what}, {"value", ScriptRowJson(watch.value)}, {"fault", watch.fault}};
  });
}

Json WatchJson(const WatchRow& row) {
  Json json;
  json["what"] = row.what;
  json["cells"] = ListOf(row.cells, [](const WatchRow::Cell& cell) -> Json {
    return {{"agent", cell.agent},
            {"text", cell.text},
            {"is_new", cell.is_new},
            {"is_error", cell.is_error},
            {"tick", cell.tick}};
  });
  return json;
}

Json ColumnJson(const MindColumn& column) {
  return {{"agent", column.agent},
          {"note", column.note},
          {"stack", debugger::ToJson(column.stack)},
          {"operators", debugger::ToJson(column.operators)},
          {"command", column.command}};
}

Json PlaceJson(const FoundPlace& place) {
  constexpr std::string_view kKinds[] = {"rule", "file", "memory", "trace", "message"};
  return {{"kind", std::string(kKinds[static_cast<std::size_t>(place.kind)])},
          {"title", place.title},
          {"detail", place.detail},
          {"agent", place.agent},
          {"file", place.file},
          {"line", place.line},
          {"tick", place.tick},
          {"id", place.id}};
}

Json GhostJson(const GhostBody& ghost) {
  const auto place = [](const world::Vec3& at) { return Json::array({at.x, at.y, at.z}); };
  return {{"name", ghost.name},         {"agent_id", ghost.agent_id},        {"kind", ghost.kind},
          {"team", ghost.team},         {"position", place(ghost.position)}, {"forward", place(ghost.forward)},
          {"radius_m", ghost.radius_m}, {"height_m", ghost.height_m}};
}

Json FuturesJson(const FuturesContents& futures) {
  const record::Comparison& comparison = futures.comparison;
  Json json;
  json["branch_tick"] = futures.branch_tick;
  json["now_tick"] = futures.now_tick;
  json["old_is_known"] = futures.old_is_known;
  json["first_tick"] = comparison.first_tick;
  json["last_tick"] = comparison.last_tick;
  json["percepts"] = comparison.percepts;
  json["course"] = ListOf(comparison.course, [](const record::Comparison::Moment& at) -> Json {
    return {{"time_s", at.time_s},
            {"mean_distance_m", at.mean_distance_m},
            {"greatest_distance_m", at.greatest_distance_m},
            {"farthest", at.farthest},
            {"health_old", at.health_a},
            {"health_new", at.health_b},
            {"alive_old", at.alive_a},
            {"alive_new", at.alive_b}};
  });
  return json;
}

Json ActivitiesJson(const Contents& c) {
  Json json = Json::object();
  for (const auto& [id, doing] : c.activities) json[std::to_string(id)] = doing;
  return json;
}

Json ObjectsJson(const Contents& c) {
  Json json = Json::object();
  for (const auto& [id, object] : c.objects) json[id] = debugger::ToJson(object);
  return json;
}

Json TimelineJson(const Contents& c) {
  if (c.timeline == nullptr) return {};
  const std::uint64_t last = c.moment.shown_tick, first = last > kTimelineTicks ? last - kTimelineTicks : 0;
  return debugger::ToJson(*c.timeline, c.agent, first, last);
}

Json TraceJson(const Contents& c) {
  std::vector<const debugger::TraceLine*> lines;
  if (c.trace != nullptr) {
    const auto& all = c.trace->lines();
    for (auto line = all.rbegin(); line != all.rend() && lines.size() < kMostLines; ++line)
      if (line->tick <= c.moment.shown_tick) lines.push_back(&*line);
    std::reverse(lines.begin(), lines.end());
  }
  return debugger::ToJson(lines);
}

Json MessagesJson(const Contents& c) {
  return debugger::ToJson(c.messages == nullptr ? std::vector<debugger::MessageRow>() : Newest(c.messages->rows()));
}

Json ConsoleJson(const Contents& c) {
  if (c.console == nullptr) return Json::array();
  const auto newest = Newest(c.console->lines());
  return debugger::ToJson(std::deque<debugger::ConsoleLine>(newest.begin(), newest.end()));
}

Json RecallsJson(const Contents& c) {
  return c.recalls == nullptr ? Json::array() : ListOf(Newest(c.recalls->recalls()));
}

/// All fields of all contents.
constexpr ContentField kFields[] = {
    {"moment", "agent", "", "the agent that most contents are about; empty: none is selected",
     [](const Contents& c) -> Json { return c.agent; }},
    {"moment", "has_mind", "", "whether it has a Soar mind", [](const Contents& c) -> Json { return c.has_mind; }},
    {"moment", "time", "",
     "`first_tick`, `shown_tick`, `last_tick`, `step_s`, `turn_ticks`, `is_recording`, `is_live`, `can_go_back`, "
     "`can_resume` (else "
     "`resume_refusal`), `branch_tick` (null: none), `branches`, `changed_tick` (at which the user last changed rules; "
     "null: "
     "never)",
     [](const Contents& c) { return MomentJson(c.moment); }},
    {"moment", "not_available", "", "why the mind's contents are not shown; empty: they are shown",
     [](const Contents& c) -> Json { return c.not_available; }},
    {"moment", "past_note", "", "the progress of simulating a recorded moment again, or why this is impossible",
     [](const Contents& c) -> Json { return c.past_note; }},
    {"moment", "not_recorded", "", "not empty: contents come from a recording, which does not hold the mind's memory",
     [](const Contents& c) -> Json { return c.not_recorded; }},

    {"agents", "agents", "agents", "all agents", [](const Contents& c) { return debugger::ToJson(c.agents); }},
    {"agents", "activities", "", "what bodies do now, by the number of the agent: \"move-to gate\"", ActivitiesJson},

    {"mind", "stack", "stack", "the goal stack", [](const Contents& c) { return debugger::ToJson(c.stack); }},
    {"mind", "operators", "operators", "candidates, preferences, and why the winner won",
     [](const Contents& c) { return debugger::ToJson(c.operators); }},

    {"mind", "shown", "",
     "what the agent's script shows of its state: `rows`, each with `depth`, `name`, `value`, `active` and `since` (s)",
     [](const Contents& c) { return debugger::ToJson(c.shown); }},

    {"memory", "stack", "stack", "the goal stack: where the tree begins",
     [](const Contents& c) { return debugger::ToJson(c.stack); }},
    {"memory", "objects", "", "objects that are unfolded, by identifier, each as `inspect --view \"memory ID\"` has it",
     ObjectsJson},
    {"memory", "element", "", "the selected element, as `inspect --view \"memory TIMETAG\"` has it; or null",
     [](const Contents& c) { return OrNull(c.story); }},
    {"memory", "found", "", "elements with the text that is searched",
     [](const Contents& c) { return ListOf(c.found); }},

    {"rules", "rules", "rules", "all rules, with firings and matches",
     [](const Contents& c) { return debugger::ToJson(c.rules); }},
    {"rules", "rule", "rule", "the selected rule: its source, and how far it matches; or null",
     [](const Contents& c) { return OrNull(c.rule); }},
    {"rules", "rule_text", "", "that rule as its author wrote it; empty if no file contains it",
     [](const Contents& c) -> Json { return c.rule_text; }},
    {"rules", "rule_file", "", "the file that contains it", [](const Contents& c) -> Json { return c.rule_file; }},
    {"rules", "rule_line", "", "and the line", [](const Contents& c) -> Json { return c.rule_line; }},
    {"rules", "coverage", "coverage", "which rules fired, and where the others stop; after `coverage` was asked for",
     [](const Contents& c) { return debugger::ToJson(c.coverage); }},

    {"why", "question", "", "\"Why does scout do what it does?\"",
     [](const Contents& c) -> Json { return c.why.question; }},
    {"why", "answer", "why",
     "a tree of reasons: `text`, `kind`, `link`, `time` (in seconds, of a moment that has passed), `below`; null: none",
     [](const Contents& c) { return OrNull(c.why.answer); }},

    {"links", "io", "io", "input link, output link and commands",
     [](const Contents& c) { return debugger::ToJson(c.io); }},

    {"messages", "messages", "messages", "the newest messages", MessagesJson},

    {"timeline", "timeline", "timeline", "operators, impasses, commands and events of the last 900 ticks",
     TimelineJson},

    {"trace", "lines", "trace", "the newest lines of what happened", TraceJson},

    {"plots", "plots", "plots", "numbers over ticks",
     [](const Contents& c) { return c.plots == nullptr ? Json::array() : debugger::ToJson(*c.plots); }},
    {"plots", "plottable", "", "what can be plotted of the selected agent",
     [](const Contents& c) -> Json { return c.plottable; }},

    {"console", "lines", "console", "the newest lines of the selected agent's console", ConsoleJson},
    {"console", "completed_line", "", "the line that `complete` asked for last",
     [](const Contents& c) -> Json { return c.completed_line; }},
    {"console", "completion", "",
     "possible completions: `begin` of its last word, `words`, and their `common` beginning",
     [](const Contents& c) -> Json {
       return {{"begin", c.completion.begin}, {"words", c.completion.words}, {"common", c.completion.common}};
     }},
    {"console", "begun_line", "", "a line that was typed and not sent",
     [](const Contents& c) -> Json { return c.begun_line; }},

    {"edit", "files", "", "what the selected agent was made from: `agent`, `file`, `is_rules`",
     [](const Contents& c) {
       return ListOf(c.files, [](const sim::WatchedFile& file) -> Json {
         return {{"agent", file.agent}, {"file", file.file.string()}, {"is_rules", file.is_rules}};
       });
     }},
    {"edit", "open_files", "", "files that were opened to be edited: `file`, `is_changed`, `is_unsaved`, `failure`",
     [](const Contents& c) {
       return ListOf(c.open_files, [](const OpenFile& file) -> Json {
         return {{"file", file.file},
                 {"is_changed", file.is_changed},
                 {"is_unsaved", file.is_unsaved},
                 {"failure", file.failure}};
       });
     }},
    {"edit", "edit", "",
     "the file that is shown: `file` (empty: none), `text`, `version` (grows when the text comes from elsewhere), "
     "`problems`, `notice`, `is_changed`, `is_unsaved`, `go_to_line`, `go_to_count`, `can_stop`: it is a script that "
     "can "
     "stop at lines, `stops`: these lines, `stop_conditions`: their conditions, `stopped_line`: the line where it is "
     "stopped, or 0",
     [](const Contents& c) { return EditJson(c.edit); }},
    {"edit", "stopped", "",
     "the script that is stopped: `script`, `reason`, `file`, `line`, `count` of stops so far; or null",
     [](const Contents& c) { return StoppedJson(c.script); }},

    {"breakpoints", "breakpoints", "", "`number`, `kind`, `agent`, `what`, `enabled`, `hits`",
     [](const Contents& c) { return debugger::ToJson(c.breakpoints); }},
    {"breakpoints", "hits", "", "why the world is paused: `number`, `agent`, `tick`, `why`",
     [](const Contents& c) {
       return ListOf(c.hits, [](const debugger::BreakHit& hit) -> Json {
         return {{"number", hit.number}, {"agent", hit.agent}, {"tick", hit.tick}, {"why", hit.why}};
       });
     }},

    {"script", "stops", "", "the lines at which scripts stop: `file`, `line`, `condition` (empty: always)",
     [](const Contents& c) {
       return ListOf(c.script.stops, [](const debugger::LineStop& stop) -> Json {
         return {{"file", stop.file}, {"line", stop.line}, {"condition", stop.condition}};
       });
     }},
    {"script", "at_errors", "", "whether they stop at errors, too",
     [](const Contents& c) -> Json { return c.script.at_errors; }},
    {"script", "stopped", "", "as in `edit`", [](const Contents& c) { return StoppedJson(c.script); }},
    {"script", "calls", "", "its calls, the innermost first: `function`, `file`, `line`",
     [](const Contents& c) { return CallsJson(c.script); }},
    {"script", "call", "", "the number of the call whose variables are shown",
     [](const Contents& c) -> Json { return c.script.stopped ? c.script.stopped->call : 0; }},
    {"script", "variables", "",
     "`locals`, `upvalues` and `globals`: lists of `key`, `name`, `value`, `type`, `folds`, and `below` if it is "
     "unfolded",
     [](const Contents& c) { return VariablesJson(c.script); }},
    {"script", "watches", "", "watched expressions: `what`, `value`, `fault`",
     [](const Contents& c) { return ScriptWatchesJson(c.script); }},

    {"futures", "futures", "", "the old future next to the new one; null: the run never went back",
     [](const Contents& c) { return c.futures ? FuturesJson(*c.futures) : Json(); }},

    {"problems", "problems", "",
     "what went wrong, the cause first: a diagnostic with `agent`, `tick`, `time_s`, `cause` (`broken`, `slip`, "
     "`endless`, `refused`, `furthest`, `awaits`, `stalled`, `waiting`, `symptom`)",
     [](const Contents& c) { return ListOf(c.problems, ProblemJson); }},

    {"watch", "agents", "", "the agents with minds shown side by side",
     [](const Contents& c) -> Json { return c.beside; }},
    {"watch", "rows", "", "`what` is watched, and a cell for each agent: `text`, `is_new`, `is_error`, `tick`",
     [](const Contents& c) { return ListOf(c.watches, WatchJson); }},

    {"minds", "minds", "", "minds side by side: `agent`, `note`, `stack`, `operators`, `command`",
     [](const Contents& c) { return ListOf(c.minds, ColumnJson); }},

    {"mission", "checks", "",
     "checks of the run: `name`, `expected`, `was`, `agent`, `is_marker`, `state`, `tick`, `time_s`",
     [](const Contents& c) { return ListOf(c.checks, CheckJson); }},
    {"mission", "lesson", "", "the lesson that the world belongs to; null: none",
     [](const Contents& c) { return c.lesson ? LessonJson(*c.lesson) : Json(); }},
    {"mission", "lessons", "", "all lessons: `name`, `title`, `is_passed`",
     [](const Contents& c) {
       return ListOf(c.lessons, [](const LessonOffer& offer) -> Json {
         return {{"name", offer.name}, {"title", offer.title}, {"is_passed", offer.is_passed}};
       });
     }},

    {"longterm", "long_term", "longterm", "what the agent knows and remembers; `inspect` adds `recalls`",
     [](const Contents& c) { return debugger::ToJson(c.long_term); }},
    {"longterm", "known_search", "", "the text that all objects in it have",
     [](const Contents& c) -> Json { return c.known_search; }},
    {"longterm", "episode", "", "the selected episode, as `inspect --view \"longterm #EPISODE\"` has it",
     [](const Contents& c) { return debugger::ToJson(c.episode); }},
    {"longterm", "recalls", "", "what was recalled last, and why", RecallsJson},

    {"learning", "learning", "learning", "learned rules, and values learned from reward; `inspect` adds `episodes`",
     [](const Contents& c) { return debugger::ToJson(c.learning); }},
    {"learning", "episodes", "", "what was earned in each episode that has ended, the newest last",
     [](const Contents& c) {
       return c.learning_log == nullptr ? Json::array() : debugger::ToJson(c.learning_log->episodes());
     }},
    {"learning", "rule", "", "the selected learned rule, as `inspect --view \"learning #RULE\"` has it",
     [](const Contents& c) { return debugger::ToJson(c.learned_rule); }},
    {"learning", "curves", "", "rules with learned values that are drawn",
     [](const Contents& c) { return Json(c.learning_curves); }},

    {"exercise", "exercise", "",
     "the exercise (DIS): `number`, `address`, `this_machine_only`, `as`, `listens_only`, `takes_orders`, `is_frozen`, "
     "PDUs `sent`, `sent_per_s`, `not_sent`, `received`, `received_per_s`, `dropped` (`why`, `count`), `entity_count`, "
     "the first 200 `entities` (`id`, `agent`, `marking`, `team`, `body`, `type`, `silent_s`); null: none",
     [](const Contents& c) { return c.exercise ? ExerciseJson(*c.exercise) : Json(); }},

    {"imagery", "imagery", "imagery", "the scene of each state, what its rules ask, and the answers",
     [](const Contents& c) { return debugger::ToJson(c.imagery); }},
    {"imagery", "state", "",
     "the state with the scene that is drawn over the world; empty: what the agent made up in any state",
     [](const Contents& c) -> Json { return c.imagined_state; }},
    {"imagery", "record", "", "the answer that is drawn; empty: none",
     [](const Contents& c) -> Json { return c.imagined_record; }},

    {"offers", "scenarios", "", "worlds that can be opened: `name`, `about`",
     [](const Contents& c) {
       return ListOf(c.scenarios, [](const ScenarioOffer& offer) -> Json {
         return {{"name", offer.name}, {"about", offer.about}};
       });
     }},
    {"offers", "recent", "", "what was opened before, the newest first",
     [](const Contents& c) -> Json { return c.recent; }},
    {"offers", "files", "", "all files that the world was made from",
     [](const Contents& c) -> Json { return c.all_files; }},
    {"offers", "searched", "", "the text that is searched everywhere",
     [](const Contents& c) -> Json { return c.searched; }},
    {"offers", "places", "",
     "where the text was found: `kind`, `title`, `detail`, `agent`, `file`, `line`, `tick`, `id`",
     [](const Contents& c) { return ListOf(c.places, PlaceJson); }},

    {"ghosts", "ghosts", "",
     "figures without a body: `name`, `agent_id`, `kind`, `team`, `position`, `forward`, `radius_m`, `height_m`",
     [](const Contents& c) { return ListOf(c.ghosts, GhostJson); }},
    {"ghosts", "shapes", "",
     "what the selected agent imagines: `name`, `state`, `kind` (`made-up`, `sensed`, `remembered`), `points` (x, y, z "
     "of each, in metres of the world), `edges` and `faces` (two and three numbers of points each)",
     [](const Contents& c) { return ListOf(c.shapes); }},
    {"ghosts", "answer", "",
     "what shows the reason of the selected answer: `text`, `lines` (`from`, `to`, `is_crossed`)",
     [](const Contents& c) -> Json {
       return {{"text", c.answer_lines.text}, {"lines", ListOf(c.answer_lines.lines)}};
     }},
};

}  // namespace

std::span<const ContentField> ContentFields() {
  return kFields;
}

std::vector<std::string_view> ContentNames() {
  std::vector<std::string_view> names;
  for (const ContentField& field : kFields)
    if (names.empty() || names.back() != field.content) names.push_back(field.content);
  return names;
}

std::vector<std::string_view> ContentNames(const PanelSet& panels, const Contents& contents) {
  std::vector<std::string_view> names = ContentNames();
  std::erase_if(names, [&](std::string_view name) {
    // Ghosts are always sent, so that a page learns that they are gone.
    if (name == "moment" || name == "ghosts") return false;
    if (name == "offers") return contents.scenarios.empty() && contents.places.empty();
    return !panels.Has(*FindPanel(name));
  });
  return names;
}

Json ToJson(const Contents& contents, std::string_view name) {
  Json json;
  for (const ContentField& field : kFields)
    if (field.content == name) json[std::string(field.name)] = field.value(contents);
  return json;
}

Json PageJson(const Contents& contents, std::string_view name) {
  const std::optional<PanelId> panel = FindPanel(name);
  if (!panel || !document::HasDocument(*panel)) return ToJson(contents, name);
  Json json{{"document", document::ToJson(document::DocumentOf(*panel, contents))}};
  if (const std::string badge = document::BadgeOf(*panel, contents); !badge.empty()) json["badge"] = badge;
  // A page also selects an agent by the checks, and shows the lessons on its start page.
  if (*panel == PanelId::kMission) json.update(ToJson(contents, name));
  return json;
}

}  // namespace soarbox::workbench
