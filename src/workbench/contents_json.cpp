// SPDX-License-Identifier: BSD-2-Clause
#include "workbench/contents_json.h"

#include <algorithm>
#include <deque>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <type_traits>

#include "debugger/view_fields.h"
#include "workbench/contents_fields.h"
#include "workbench/document/panels.h"

namespace soarbox::workbench {
namespace {

/// Maximum number of the newest items in lists that grow with a run, and of ticks in the timeline.
constexpr std::size_t kMostLines = 500;
constexpr std::uint64_t kTimelineTicks = 900;

/// The end of a long list.
template <typename List>
auto Newest(const List& list) {
  const auto first = list.size() > kMostLines ? list.end() - static_cast<std::ptrdiff_t>(kMostLines) : list.begin();
  return std::vector(first, list.end());
}

std::optional<std::vector<debugger::TrackRow>> TracksOf(const Contents& c) {
  if (c.timeline == nullptr) return std::nullopt;
  const std::uint64_t last = c.moment.shown_tick, first = last > kTimelineTicks ? last - kTimelineTicks : 0;
  return debugger::TracksWithin(*c.timeline, c.agent, first, last);
}

std::vector<const debugger::TraceLine*> TraceOf(const Contents& c) {
  std::vector<const debugger::TraceLine*> lines;
  if (c.trace != nullptr) {
    const auto& all = c.trace->lines();
    for (auto line = all.rbegin(); line != all.rend() && lines.size() < kMostLines; ++line)
      if (line->tick <= c.moment.shown_tick) lines.push_back(&*line);
    std::reverse(lines.begin(), lines.end());
  }
  return lines;
}

std::optional<StoppedPlace> StoppedOf(const Contents& c) {
  const std::optional<debugger::StoppedScript>& stopped = c.script.stopped;
  if (!stopped) return std::nullopt;
  StoppedPlace place{stopped->script, stopped->reason, stopped->error, {}, {}, c.script.count};
  const auto call = std::ranges::find_if(stopped->calls, [](const auto& each) { return !each.file.empty(); });
  if (call == stopped->calls.end()) return place;
  place.file = call->file;
  place.line = call->line;
  return place;
}

std::optional<ScriptVariables> VariablesOf(const Contents& c) {
  if (!c.script.stopped) return std::nullopt;
  return ScriptVariables{c.script.stopped->locals, c.script.stopped->upvalues, c.script.stopped->globals};
}

std::vector<ScriptWatchRow> ScriptWatchesOf(const Contents& c) {
  std::vector<ScriptWatchRow> rows;
  if (!c.script.stopped)
    for (const std::string& what : c.script.watches) rows.push_back({what, {}, {}});
  else
    for (const debugger::ScriptWatch& watch : c.script.stopped->watches)
      rows.push_back({watch.what, watch.value, watch.fault});
  return rows;
}

/// A field with a value that `kGet` returns: a member of Contents, or a function.
template <auto kGet>
constexpr ContentField FieldRow(std::string_view content, std::string_view name, std::string_view view,
                                std::string_view about) {
  using Value = std::remove_cvref_t<std::invoke_result_t<decltype(kGet), const Contents&>>;
  return {content,
          name,
          view,
          about,
          [](const Contents& c) { return debugger::JsonOf<Value>(std::invoke(kGet, c)); },
          [](debugger::TypeLister& lister) { return lister.TypeOf<Value>(); }};
}

using C = Contents;

/// All fields of all contents.
constexpr ContentField kFields[] = {
    FieldRow<&C::agent>("moment", "agent", "", "the agent that most contents are about; empty: none is selected"),
    FieldRow<&C::has_mind>("moment", "has_mind", "", "whether it has a Soar mind"),
    FieldRow<&C::moment>("moment", "time", "", "the tick that is shown"),
    FieldRow<&C::not_available>("moment", "not_available", "",
                                "why the mind's contents are not shown; empty: they are shown"),
    FieldRow<&C::past_note>("moment", "past_note", "",
                            "the progress of simulating a recorded moment again, or why this is impossible"),
    FieldRow<&C::not_recorded>("moment", "not_recorded", "",
                               "not empty: contents come from a recording, which does not hold the mind's memory"),

    FieldRow<&C::agents>("agents", "agents", "agents", "all agents"),
    FieldRow<&C::activities>("agents", "activities", "",
                             "what bodies do now, by the number of the agent: \"move-to gate\""),

    FieldRow<&C::stack>("mind", "stack", "stack", "the goal stack"),
    FieldRow<&C::operators>("mind", "operators", "operators", "candidates, preferences, and why one was selected"),
    FieldRow<&C::shown>(
        "mind", "shown", "",
        "what the agent's script shows of its state: `rows`, each with `depth`, `name`, `value`, `active` "
        "and `since` (s)"),

    FieldRow<&C::stack>("memory", "stack", "stack", "the goal stack: where the tree begins"),
    FieldRow<&C::objects>("memory", "objects", "",
                          "objects that are unfolded, by identifier, each as `inspect --view \"memory ID\"` has it"),
    FieldRow<&C::story>("memory", "element", "", "the selected element, as `inspect --view \"memory TIMETAG\"` has it"),
    FieldRow<&C::found>("memory", "found", "", "elements with the text that is searched"),

    FieldRow<&C::rules>("rules", "rules", "rules", "all rules, with firings and matches"),
    FieldRow<&C::rule>("rules", "rule", "rule", "the selected rule: its source, and how far it matches"),
    FieldRow<&C::rule_text>("rules", "rule_text", "", "that rule as its author wrote it; empty if no file contains it"),
    FieldRow<&C::rule_file>("rules", "rule_file", "", "the file that contains it"),
    FieldRow<&C::rule_line>("rules", "rule_line", "", "and the line"),
    FieldRow<&C::coverage>("rules", "coverage", "coverage",
                           "which rules fired, and where the others stop; after `coverage` was asked for"),

    FieldRow<[](const C& c) { return c.why.question; }>("why", "question", "", "\"Why does scout do what it does?\""),
    FieldRow<[](const C& c) { return c.why.answer; }>("why", "answer", "why", "a tree of reasons; null: none"),

    FieldRow<&C::io>("links", "io", "io", "input link, output link and commands"),

    FieldRow<[](const C& c) {
      return c.messages == nullptr ? std::vector<debugger::MessageRow>() : Newest(c.messages->rows());
    }>("messages", "messages", "messages", "the newest messages"),

    FieldRow<&TracksOf>("timeline", "timeline", "timeline",
                        "operators, impasses, commands and events of the last 900 ticks"),

    FieldRow<&TraceOf>("trace", "lines", "trace", "the newest lines of what happened"),

    FieldRow<[](const C& c) { return c.plots == nullptr ? std::vector<debugger::PlotSeries>() : *c.plots; }>(
        "plots", "plots", "plots", "numbers over ticks"),
    FieldRow<&C::plottable>("plots", "plottable", "", "what can be plotted of the selected agent"),

    FieldRow<[](const C& c) {
      return c.console == nullptr ? std::vector<debugger::ConsoleLine>() : Newest(c.console->lines());
    }>("console", "lines", "console", "the newest lines of the selected agent's console"),
    FieldRow<&C::completed_line>("console", "completed_line", "", "the line that `complete` asked for last"),
    FieldRow<&C::completion>("console", "completion", "", "possible completions of its last word"),
    FieldRow<&C::begun_line>("console", "begun_line", "", "a line that was typed and not sent"),

    FieldRow<&C::files>("edit", "files", "", "what the selected agent was made from"),
    FieldRow<&C::open_files>("edit", "open_files", "", "files that were opened to be edited"),
    FieldRow<&C::edit>("edit", "edit", "", "the file that is shown"),
    FieldRow<&StoppedOf>("edit", "stopped", "", "the script that is stopped"),

    FieldRow<&C::breakpoints>("breakpoints", "breakpoints", "", "all breakpoints"),
    FieldRow<&C::hits>("breakpoints", "hits", "", "why the world is paused"),

    FieldRow<[](const C& c) { return c.script.stops; }>("script", "stops", "", "the lines at which scripts stop"),
    FieldRow<[](const C& c) { return c.script.at_errors; }>("script", "at_errors", "",
                                                            "whether they stop at errors, too"),
    FieldRow<&StoppedOf>("script", "stopped", "", "as in `edit`"),
    FieldRow<[](const C& c) {
      return c.script.stopped ? c.script.stopped->calls : std::vector<script::ScriptFrame>();
    }>("script", "calls", "", "its calls, the innermost first"),
    FieldRow<[](const C& c) { return c.script.stopped ? c.script.stopped->call : 0; }>(
        "script", "call", "", "the number of the call whose variables are shown"),
    FieldRow<&VariablesOf>("script", "variables", "", "the variables of that call"),
    FieldRow<&ScriptWatchesOf>("script", "watches", "", "watched expressions"),

    FieldRow<&C::futures>("futures", "futures", "",
                          "the old future next to the new one; null: the run never went back"),

    FieldRow<&C::problems>("problems", "problems", "", "what went wrong, the cause first"),

    FieldRow<&C::beside>("watch", "agents", "", "the agents with minds shown side by side"),
    FieldRow<&C::watches>("watch", "rows", "", "what is watched, and a cell for each agent"),

    FieldRow<&C::minds>("minds", "minds", "", "minds side by side"),

    FieldRow<&C::checks>("mission", "checks", "", "checks of the run"),
    FieldRow<&C::lesson>("mission", "lesson", "", "the lesson that the world belongs to; null: none"),
    FieldRow<&C::lessons>("mission", "lessons", "", "all lessons"),

    FieldRow<&C::long_term>("longterm", "long_term", "longterm",
                            "what the agent knows and remembers; `inspect` adds `recalls`"),
    FieldRow<&C::known_search>("longterm", "known_search", "", "the text that all objects in it have"),
    FieldRow<&C::episode>("longterm", "episode", "",
                          "the selected episode, as `inspect --view \"longterm #EPISODE\"` has it"),
    FieldRow<[](const C& c) {
      return c.recalls == nullptr ? std::vector<debugger::Recall>() : Newest(c.recalls->recalls());
    }>("longterm", "recalls", "", "what was recalled last, and why"),

    FieldRow<&C::learning>("learning", "learning", "learning",
                           "learned rules, and values learned from reward; `inspect` adds `episodes`"),
    FieldRow<[](const C& c) {
      return c.learning_log == nullptr ? std::deque<debugger::RewardEpisode>() : c.learning_log->episodes();
    }>("learning", "episodes", "", "what was earned in each episode that has ended, the newest last"),
    FieldRow<&C::learned_rule>("learning", "rule", "",
                               "the selected learned rule, as `inspect --view \"learning #RULE\"` has it"),
    FieldRow<&C::learning_curves>("learning", "curves", "", "rules with learned values that are drawn"),

    FieldRow<&C::exercise>("exercise", "exercise", "", "the exercise (DIS); null: none"),

    FieldRow<&C::imagery>("imagery", "imagery", "imagery",
                          "the scene of each state, what its rules ask, and the answers"),
    FieldRow<&C::imagined_state>(
        "imagery", "state", "",
        "the state with the scene that is drawn over the world; empty: what the agent made up in any state"),
    FieldRow<&C::imagined_record>("imagery", "record", "", "the answer that is drawn; empty: none"),

    FieldRow<&C::scenarios>("offers", "scenarios", "", "worlds that can be opened"),
    FieldRow<&C::recent>("offers", "recent", "", "what was opened before, the newest first"),
    FieldRow<&C::all_files>("offers", "files", "", "all files that the world was made from"),
    FieldRow<&C::searched>("offers", "searched", "", "the text that is searched everywhere"),
    FieldRow<&C::places>("offers", "places", "", "where the text was found"),

    FieldRow<&C::ghosts>("ghosts", "ghosts", "", "figures without a body"),
    FieldRow<&C::shapes>("ghosts", "shapes", "", "what the selected agent imagines"),
    FieldRow<&C::answer_lines>("ghosts", "answer", "", "what shows the reason of the selected answer"),
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
