// SPDX-License-Identifier: BSD-2-Clause
// Script: the lines at which scripts stop; of a stopped script its calls, its text, its variables and watched values.
#include <algorithm>
#include <filesystem>
#include <utility>

#include "workbench/document/build.h"
#include "workbench/document/panels.h"

namespace soarbox::workbench::document {
namespace {

using debugger::LineStop;
using debugger::ScriptRow;
using debugger::StoppedScript;
using How = ScriptGoRequest::How;

std::string NameOf(const std::string& file) {
  return std::filesystem::path(file).filename().string();
}

std::string ScriptPlace(const std::string& file, int line) {
  return NameOf(file) + ":" + std::to_string(line);
}

Line Steps() {
  Line line;
  const auto add = [&](const char* label, How how, const char* hint) {
    line.nodes.push_back(Button{label, Action{ScriptGoRequest{how}}, hint});
  };
  add("Continue", How::kOn, "To the next stop");
  add("Step over", How::kOver, "Execute this line");
  add("Step into", How::kInto, "Into the function that this line calls");
  add("Step out", How::kOut, "To the end of this function");
  return line;
}

Table Calls(const Contents& contents, const StoppedScript& stopped) {
  Table table{"calls", {{"Call", false, false, true}, {"Line", false, false, true}}};
  table.press = RowAction{{ScriptCallRequest{}}, "call"};
  for (std::size_t i = 0; i < stopped.calls.size(); ++i) {
    const script::ScriptFrame& call = stopped.calls[i];
    Cell place;
    if (!call.file.empty())
      place.spans.push_back(FileLink(contents, call.file, call.line, ScriptPlace(call.file, call.line)));
    table.Add(std::to_string(i), {TextCell(call.function, Role::kName), std::move(place)}).is_chosen =
        i == stopped.call;
  }
  return table;
}

/// The lines around the place, each with a button that sets or removes a stop.
Table Source(const ScriptContents& script, const script::ScriptFrame& call) {
  Table table{"source", {{""}, {"", true}, {"", false, false, true}}};
  table.has_heads = false;
  for (const ScriptContents::Line& line : script.lines) {
    const bool stops = std::ranges::find(script.stops, LineStop{call.file, line.number}) != script.stops.end();
    const Span stop{stops ? "\xe2\x97\x8f" : "\xe2\x97\x8b", stops ? Role::kBad : Role::kQuiet,
                    Action{LineStopRequest{call.file, line.number, !stops}},
                    stops ? "Remove the stop at this line" : "Stop at this line"};
    const std::string number = std::to_string(line.number);
    table
        .Add(number,
             {{{stop}}, TextCell(number, Role::kQuiet), TextCell(line.text.empty() ? " " : line.text, Role::kCode)})
        .is_chosen = line.number == call.line;
  }
  return table;
}

TreeRow RowOfVariable(const ScriptRow& variable) {
  TreeRow row;
  row.key = variable.key;
  row.spans = {{variable.name, Role::kName},
               {" = " + variable.value, variable.type == "number" ? Role::kNumber : Role::kCode}};
  row.folds = variable.folds;
  row.is_open = variable.is_open;
  if (variable.folds) row.arguments = {variable.key};
  for (const ScriptRow& below : variable.below) row.below.push_back(RowOfVariable(below));
  return row;
}

void AddVariables(const char* key, const char* title, const std::vector<ScriptRow>& variables, Nodes& nodes) {
  if (variables.empty()) return;
  nodes.push_back(Heading(title));
  Tree tree{key, title, {}};
  tree.unfold = RowAction{{ScriptValueRequest{}}, "key", 1};
  for (const ScriptRow& variable : variables) tree.rows.push_back(RowOfVariable(variable));
  nodes.push_back(std::move(tree));
}

void AddWatches(const ScriptContents& script, Nodes& nodes) {
  nodes.push_back(Heading("Watch"));
  Form form = LineForm("watch", ScriptWatchRequest{},
                       {Field::Kind::kLine, "what",
                        "An expression of Lua that changes nothing: variables, fields, operators, functions that read",
                        "agent:GetPosition().x > 3"},
                       "Watch");
  form.clears = form.repeats = true;
  nodes.push_back(std::move(form));
  if (script.watches.empty()) return;
  Tree tree{"watches", "Watch", {}};
  tree.unfold = RowAction{{ScriptValueRequest{}}, "key", 1};
  for (std::size_t i = 0; i < script.watches.size(); ++i) {
    const std::string& what = script.watches[i];
    TreeRow row;
    if (script.stopped && i < script.stopped->watches.size()) {
      const debugger::ScriptWatch& watch = script.stopped->watches[i];
      if (watch.fault.empty()) {
        row = RowOfVariable(watch.value);
      } else {
        row.spans = {{what, Role::kName}, {"  " + watch.fault, Role::kBad}};
      }
    } else {
      row.spans = {{what, Role::kName}};
    }
    row.key = "watches/" + what;
    row.spans.insert(row.spans.begin(),
                     {Span{kRemove, Role::kTag, Action{ScriptWatchRequest{what, false}}, "No longer watch it"}, {" "}});
    tree.rows.push_back(std::move(row));
  }
  nodes.push_back(std::move(tree));
}

void AddStops(const Contents& contents, Nodes& nodes) {
  const ScriptContents& script = contents.script;
  nodes.push_back(Heading("Stop scripts at"));
  if (!script.files.empty()) {
    Form form{"stop", {LineStopRequest{}}, {}, "Add"};
    form.clears = true;
    Field file{Field::Kind::kChoice, "file", "Script"};
    for (const std::string& each : script.files) file.options.emplace_back(each, NameOf(each));
    form.fields.push_back(std::move(file));
    form.fields.push_back({Field::Kind::kLine, "line", "The number of a line", "line"});
    form.fields.back().is_needed = true;
    form.fields.push_back({Field::Kind::kLine, "condition",
                           "Stop only if this expression of Lua is true. It changes nothing: variables, fields, "
                           "operators, functions that read",
                           "only if: agent:GetHealth() < 50"});
    nodes.push_back(std::move(form));
  }
  Button errors{"Stop at errors", Action{ErrorStopRequest{!script.at_errors}},
                "Stop where a script fails and does not catch it"};
  errors.is_on = script.at_errors;
  nodes.push_back(Line{{std::move(errors)}});
  if (script.stops.empty()) {
    nodes.push_back(Text("No lines yet. Add one here, or click beside a line in Edit.", Role::kQuiet));
    return;
  }
  Table table{"stops", {{"Line", false, false, true}, {""}}};
  table.has_heads = false;
  for (const LineStop& stop : script.stops) {
    const std::string place = ScriptPlace(stop.file, stop.line);
    Spans spans{FileLink(contents, stop.file, stop.line, place)};
    if (!stop.condition.empty()) spans.push_back({" if " + stop.condition, Role::kCode});
    table.Add(place, {{std::move(spans)}, ButtonCell(kRemove, LineStopRequest{stop.file, stop.line, false}, "Remove")});
  }
  nodes.push_back(std::move(table));
}

}  // namespace

Nodes ScriptDocument(const Contents& contents) {
  const ScriptContents& script = contents.script;
  if (contents.moment.is_recording)
    return {Empty("Scripts stop in a run, not in a recording.",
                  "Open the recording in your editor: its debugger (soarbox dap) runs the scripts again.")};
  if (!script.can_stop)
    return {Empty("Scripts cannot stop here.",
                  "They stop in a run in a window, on a server's page, and in an editor (soarbox dap).")};
  Nodes nodes;
  if (script.stopped) {
    const StoppedScript& stopped = *script.stopped;
    const script::ScriptFrame call =
        stopped.calls.empty() ? script::ScriptFrame() : stopped.calls[std::min(stopped.call, stopped.calls.size() - 1)];
    nodes.push_back(Text(Spans{{"stopped", Role::kTag},
                               {" "},
                               {stopped.script, Role::kStrong},
                               {" in " + call.function + ", "},
                               FileLink(contents, call.file, call.line, ScriptPlace(call.file, call.line))}));
    if (!stopped.error.empty()) nodes.push_back(Text(stopped.error, Role::kBad));
    nodes.push_back(Steps());
    AddVariables("locals", "Local variables", stopped.locals, nodes);
    AddVariables("upvalues", "Variables of enclosing functions", stopped.upvalues, nodes);
    AddWatches(script, nodes);
    nodes.push_back(Heading("Calls"));
    nodes.push_back(Calls(contents, stopped));
    if (!script.lines.empty()) {
      nodes.push_back(Heading("Text"));
      nodes.push_back(Source(script, call));
    }
    AddVariables("globals", "Global variables", stopped.globals, nodes);
  } else {
    AddWatches(script, nodes);
  }
  AddStops(contents, nodes);
  return nodes;
}

}  // namespace soarbox::workbench::document
