// SPDX-License-Identifier: BSD-2-Clause
#include "workbench/script_desk.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <sstream>

#include "diagnostics/problem.h"
#include "diagnostics/read_text.h"
#include "sim/simulation.h"

namespace soarbox::workbench {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostOpen = 200, kMostWatches = 40;
constexpr int kLinesAround = 6;  ///< Lines of the text that are shown before and after the place of a stop.

bool IsScript(const fs::path& file) {
  return file.extension() == ".lua";
}

fs::path Plain(const fs::path& file) {
  std::error_code failed;
  fs::path plain = fs::weakly_canonical(file, failed);
  return failed ? file.lexically_normal() : plain;
}

script::ScriptStep StepOf(ScriptGoRequest::How how) {
  using How = ScriptGoRequest::How;
  return how == How::kInto   ? script::ScriptStep::kInto
         : how == How::kOver ? script::ScriptStep::kOver
         : how == How::kOut  ? script::ScriptStep::kOut
                             : script::ScriptStep::kGo;
}

/// The name that the run uses for a file: of the file with this path, or with this name if it is no path. Scripts
/// choose the names of the chunks that they load, so the name may be that of no file of the run.
std::string FileOfScript(const std::set<std::string>& files, const std::string& file) {
  if (files.contains(file)) return file;
  const fs::path wanted(file), name = wanted.filename();
  for (const std::string& each : files)
    if (fs::path(each).filename() == name && (wanted == name || Plain(each) == Plain(wanted))) return each;
  return file;
}

std::vector<ScriptContents::Line> LinesAround(const std::string& text, int line) {
  std::vector<ScriptContents::Line> lines;
  std::istringstream in(text);
  std::string one;
  for (int number = 1; number <= line + kLinesAround && std::getline(in, one); ++number)
    if (number >= line - kLinesAround) lines.push_back({number, one});
  return lines;
}

}  // namespace

void ScriptDesk::SetWait(std::function<void()> wait) {
  wait_ = std::move(wait);
  Observe();
}

bool ScriptDesk::CanStop() const {
  return common_.run != nullptr && wait_ != nullptr && sim::MayObserveScripts();
}

void ScriptDesk::Observe() {
  if (CanStop()) sim::ObserveScripts(common_.run->simulation(), &stops_.observer());
}

void ScriptDesk::Bring(const Belongings& belongings) {
  stops_.Bring(belongings.stops);
  stops_.SetAtErrors(belongings.at_errors);
  watches_ = belongings.watches;
}

std::set<std::string> ScriptDesk::FilesOfRun() const {
  std::set<std::string> files;
  if (sim::Simulation* const live = common_.Live())
    for (const sim::WatchedFile& each : live->Files())
      if (!each.is_rules) files.insert(each.file.string());
  return files;
}

void ScriptDesk::Wait() {
  ++count_;
  call_ = 0;
  has_news_ = true;
  place_ = stops_.Place();
  const std::set<std::string> files = FilesOfRun();
  place_.file = FileOfScript(files, place_.file);
  if (files.contains(place_.file)) files_.Edit(EditRequest{place_.file, place_.line}, {});
  is_in_tick_ = true;
  wait_();
  is_in_tick_ = false;
  // The function returned although the script is stopped: the script continues.
  if (is_stopped()) Leave();
  has_news_ = true;
}

std::string ScriptDesk::Refusal(const Request& request) {
  const bool is_refused = std::holds_alternative<ConsoleRequest>(request) ||
                          std::holds_alternative<SeekRequest>(request) ||
                          std::holds_alternative<ResumeRequest>(request);
  if (!is_refused) return {};
  return "A script is stopped at " + fs::path(place_.file).filename().string() + ":" + std::to_string(place_.line) +
         ", in the middle of a tick. Let it continue first";
}

void ScriptDesk::GoOn(ScriptGoRequest::How how) {
  stops_.GoOn(StepOf(how));
}

bool ScriptDesk::ObeyInTick(Flow flow, Pace& pace) {
  switch (flow) {
    case Flow::kTogglePause:
      pace.Resume();
      GoOn();
      return true;
    case Flow::kStepTick:
    case Flow::kStepTurn:
      pace.Pause();  // At the end of this tick.
      GoOn();
      return true;
    case Flow::kStepDecision:
    case Flow::kStepPhase:
    case Flow::kStepChange:
      common_.surroundings.Tell("A script is stopped in the middle of a tick. Let it continue first");
      return true;
    case Flow::kFaster:
    case Flow::kSlower:
    case Flow::kNormalSpeed:
    case Flow::kUnlimited:
      pace.Obey(flow);
      return true;
    case Flow::kReset:
    case Flow::kNextSeed:
    case Flow::kQuit:
      Leave();
      return false;
  }
  return true;
}

void ScriptDesk::Obey(const LineStopRequest& request) {
  if (!CanStop())
    return common_.surroundings.Tell("Scripts cannot stop here: they stop in a run in a window or on a server's page");
  const std::set<std::string> files = FilesOfRun();
  const std::string file = FileOfScript(files, request.file);
  if (!request.is_on) return stops_.Clear(file, request.line);
  if (!IsScript(file))
    return common_.note_problem(ProblemIn(file, "this is not a script", "name a file in Lua that the run uses"), {});
  const std::optional<std::string> text = files_.TextOf(file);
  if (!text && !files.contains(file))
    return common_.note_problem(ProblemIn(file, "the run does not use this script", "name one of its scripts"), {});
  const Result<int> set = stops_.Set(file, text ? *text : ReadText(file).value_or(""), request.line, request.condition);
  if (!set) {
    common_.surroundings.Tell("No stop at line " + std::to_string(request.line) + ": " + set.error().hint);
    return common_.note_problem(set.error(), {});
  }
  if (*set != request.line)
    common_.surroundings.Tell("No function executes line " + std::to_string(request.line) + ": the stop is at line " +
                              std::to_string(*set));
}

void ScriptDesk::Obey(const ScriptCallRequest& request) {
  call_ = request.call;
}

void ScriptDesk::Obey(const ScriptValueRequest& request) {
  if (!request.is_open) {
    open_.erase(request.key);
  } else if (open_.size() < kMostOpen) {
    open_.insert(request.key);
  }
}

void ScriptDesk::Obey(const ScriptWatchRequest& request) {
  const auto found = std::ranges::find(watches_, request.what);
  if (!request.is_on && found != watches_.end()) watches_.erase(found);
  if (request.is_on && found == watches_.end() && !request.what.empty() && watches_.size() < kMostWatches)
    watches_.push_back(request.what);
}

void ScriptDesk::Fill(Contents& contents, bool is_visible) {
  ScriptContents& shown = contents.script;
  shown = {};
  shown.can_stop = CanStop();
  EditContents& edit = contents.edit;
  edit.can_stop = shown.can_stop && IsScript(edit.file);
  edit.stops.clear();
  edit.stop_conditions.clear();
  edit.stopped_line = 0;
  if (!shown.can_stop) return;
  shown.stops.assign(stops_.list().begin(), stops_.list().end());
  for (const debugger::LineStop& stop : shown.stops) {
    if (stop.file != edit.file) continue;
    edit.stops.push_back(stop.line);
    edit.stop_conditions.push_back(stop.condition);
  }
  shown.at_errors = stops_.at_errors();
  shown.watches = watches_;
  shown.count = count_;
  if (!is_visible && !is_stopped()) return;
  const std::set<std::string> files = FilesOfRun();
  if (is_visible) std::ranges::copy_if(files, std::back_inserter(shown.files), IsScript);
  if (!is_stopped()) return;
  shown.stopped = stops_.Look(call_, open_, watches_);
  for (script::ScriptFrame& call : shown.stopped->calls)
    call.file = call.file.empty() ? "" : FileOfScript(files, call.file);
  if (shown.stopped->calls.empty()) return;
  const script::ScriptFrame& call = shown.stopped->calls[shown.stopped->call];
  if (files.contains(call.file)) {
    const std::optional<std::string> text = files_.TextOf(call.file);
    shown.lines = LinesAround(text ? *text : ReadText(call.file).value_or(""), call.line);
  }
  if (call.file == edit.file) edit.stopped_line = call.line;
}

}  // namespace soarbox::workbench
