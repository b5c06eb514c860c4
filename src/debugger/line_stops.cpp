// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/line_stops.h"

#include <algorithm>

#include "diagnostics/problem.h"

namespace soarbox::debugger {
namespace {

constexpr std::size_t kMostStops = 200;
constexpr int kDeepestField = 12;  ///< Maximum depth of unfolded fields.

}  // namespace

Result<int> LineStops::Set(const std::string& file, std::string_view text, int line, const std::string& condition) {
  const std::vector<int> lines = script::LinesOfScript(text, script::ScriptLines::kInFunctions);
  if (lines.empty())
    return ProblemIn(file, "scripts cannot stop in this file",
                     "it cannot be read, it does not compile, or it has no function");
  const auto found = std::ranges::lower_bound(lines, line);
  if (found == lines.end()) {
    Diagnostic problem = ProblemIn(file, "scripts cannot stop at line " + std::to_string(line),
                                   "no function executes this line or a line after it");
    problem.line = line;
    return problem;
  }
  if (stops_.size() >= kMostStops && !stops_.contains({file, *found}))
    return ProblemIn(file, "there are " + std::to_string(kMostStops) + " stops already", "remove some of them");
  // A click above a line is about that line, and keeps its condition.
  if (const auto known = stops_.find({file, *found}); known != stops_.end()) {
    if (condition.empty() && *found != line) return *found;
    stops_.erase(known);
  }
  stops_.insert({file, *found, condition});
  Apply(file);
  return *found;
}

void LineStops::Clear(const std::string& file, int line) {
  stops_.erase({file, line});
  Apply(file);
}

void LineStops::Bring(const std::set<LineStop>& stops) {
  stops_ = stops;
  for (const LineStop& stop : stops_) Apply(stop.file);
}

void LineStops::Apply(const std::string& file) {
  std::vector<script::ScriptBreakpoint> marks;
  for (const LineStop& stop : stops_)
    if (stop.file == file) marks.push_back({stop.line, stop.condition, script::MayCall::kReading});
  debugger_.SetBreakpoints(file, std::move(marks));
}

void LineStops::Stop() {
  is_stopped_ = true;
  wait_();
  is_stopped_ = false;
}

void LineStops::GoOn(script::ScriptStep step) {
  if (!std::exchange(is_stopped_, false)) return;
  debugger_.SetStep(step);
}

void LineStops::Leave() {
  GoOn(script::ScriptStep::kGo);
  debugger_.SetEnabled(false);
}

LineStop LineStops::Place() {
  const std::vector<script::ScriptFrame> calls = debugger_.view().Frames();
  for (const script::ScriptFrame& call : calls)
    if (!call.file.empty()) return {call.file, call.line};
  return {};
}

ScriptRow LineStops::RowOf(const script::ScriptVariable& variable, const std::string& parent,
                           const std::set<std::string>& open, int depth) {
  ScriptRow row{parent + "/" + variable.name, variable.name, variable.value, variable.type};
  row.folds = variable.reference > 0 && depth < kDeepestField;
  row.is_open = row.folds && open.contains(row.key);
  if (row.is_open) row.below = RowsOf(debugger_.view().Fields(variable.reference), row.key, open, depth + 1);
  return row;
}

std::vector<ScriptRow> LineStops::RowsOf(const std::vector<script::ScriptVariable>& variables,
                                         const std::string& parent, const std::set<std::string>& open, int depth) {
  std::vector<ScriptRow> rows;
  for (const script::ScriptVariable& variable : variables) rows.push_back(RowOf(variable, parent, open, depth));
  return rows;
}

StoppedScript LineStops::Look(std::size_t call, const std::set<std::string>& open,
                              const std::vector<std::string>& watches) {
  script::ScriptView& view = debugger_.view();
  StoppedScript shown;
  if (!view.is_paused()) return shown;
  const std::uint32_t owner = view.owner();
  for (const script::ScriptView::Machine& machine : view.Machines())
    if (machine.owner == owner) shown.script = machine.name;
  shown.reason = view.reason();
  shown.error = view.error();
  shown.calls = view.Frames();
  shown.call = shown.calls.empty() ? 0 : std::min(call, shown.calls.size() - 1);
  shown.locals = RowsOf(view.Locals(shown.call), "locals", open);
  shown.upvalues = RowsOf(view.Upvalues(shown.call), "upvalues", open);
  shown.globals = RowsOf(view.Globals(owner), "globals", open);
  for (const std::string& what : watches) {
    const Result<script::ScriptVariable> value = view.Evaluate(shown.call, what, script::MayCall::kReading);
    if (value) {
      shown.watches.push_back({what, RowOf(*value, "watches", open, 0)});
    } else {
      shown.watches.push_back({what, {}, value.error().message});
    }
  }
  view.DropReferences();
  return shown;
}

}  // namespace soarbox::debugger
