// SPDX-License-Identifier: BSD-2-Clause
// Carries out the requests of users.
#include <algorithm>
#include <filesystem>
#include <utility>

#include "debugger/watch.h"
#include "workbench/desk.h"

namespace soarbox::workbench {

struct Desk::Visitor {
  Desk& desk;
  Surroundings& surroundings;

  void operator()(const SelectRequest& request) const { desk.wanted_agent_ = request.agent; }
  void operator()(const LookRequest& request) const { desk.visible_ = request.panels; }
  void operator()(const OpenFileRequest& request) const {
    if (const Result<void> opened = surroundings.OpenInEditor(request.file, request.line); !opened)
      desk.NoteProblem(opened.error(), {});
  }
  void operator()(const ConsoleRequest& request) const { desk.consoles_.Type(request); }
  void operator()(const CompleteRequest& request) const { desk.consoles_.Complete(request); }
  void operator()(const KeepLineRequest& request) const { desk.consoles_.Keep(request); }
  void operator()(const ClearConsoleRequest&) const { desk.consoles_.Clear(desk.agent_); }
  void operator()(const ClearProblemsRequest&) const {
    desk.problems_.clear();
    desk.findings_.Clear();
  }
  void operator()(const SeekRequest& request) const {
    surroundings.Pause();
    desk.past_.Seek(request.tick);
    desk.sought_at_ = Clock::now();
  }
  void operator()(const LiveRequest&) const { desk.past_.GoLive(); }
  void operator()(const ResumeRequest&) const { desk.Resume(); }
  void operator()(const SpeedRequest& request) const { surroundings.SetSpeed(request.speed); }
  void operator()(const TellRequest& request) const { surroundings.Tell(request.text); }
  void operator()(const SavePictureRequest&) const { surroundings.SavePicture(); }
  void operator()(const TraceRequest& request) const {
    desk.trace_filter_.most = request.level;
    desk.trace_filter_.text = request.text;
    desk.traces_selected_ = !request.agent.empty();
  }
  void operator()(const StateRequest& request) const { desk.state_ = request.state; }
  void operator()(const ObjectRequest& request) const {
    constexpr std::size_t kMostOpen = 200;
    if (!request.is_open) {
      desk.open_objects_.erase(request.id);
    } else if (desk.open_objects_.size() < kMostOpen) {
      desk.open_objects_.insert(request.id);
    }
  }
  void operator()(const ElementRequest& request) const {
    desk.timetag_ = request.timetag;
    desk.elements_.GoTo(request.timetag);
  }
  void operator()(const SearchMemoryRequest& request) const { desk.search_ = request.text; }
  void operator()(const RuleRequest& request) const { desk.rule_ = request.rule; }
  void operator()(const SearchKnownRequest& request) const { desk.known_search_ = request.text; }
  void operator()(const EpisodeRequest& request) const { desk.episode_ = request.number; }
  void operator()(const LearnedRuleRequest& request) const { desk.learned_rule_ = request.rule; }
  void operator()(const CurveRequest& request) const {
    // There are as many colors as curves; a new curve replaces the oldest.
    std::erase(desk.curves_, request.rule);
    if (request.is_on && desk.curves_.size() >= kMostCurves) desk.curves_.erase(desk.curves_.begin());
    if (request.is_on) desk.curves_.push_back(request.rule);
    desk.has_chosen_curves_ = !desk.curves_.empty();
  }
  void operator()(const CoverageRequest&) const { desk.wants_coverage_ = true; }
  void operator()(const WhyRequest& request) const { desk.why_ = request; }
  void operator()(const ImagineRequest& request) const { desk.imagined_ = request; }
  void operator()(const PlotRequest& request) const {
    if (request.is_on) {
      if (desk.models_.plots.Plot(request.agent, request.what))
        desk.histories_.emplace_back(request.agent, request.what);
    } else {
      desk.models_.plots.Remove(request.agent, request.what);
    }
  }
  void operator()(const EditRequest& request) const { desk.files_.Edit(request, desk.agent_); }
  void operator()(const EditTextRequest& request) const { desk.files_.Change(request); }
  void operator()(const SaveAllRequest&) const { desk.files_.SaveAll(); }
  void operator()(const WatchRequest& request) const {
    desk.watch_fault_ = request.is_on ? debugger::WatchFault(request.what) : std::string();
    if (!desk.watch_fault_.empty()) return;
    Put(desk.watches_, request.what, request.is_on);
  }
  void operator()(const BesideRequest& request) const {
    // The selected mind is shown together with the first added mind.
    if (request.is_on && desk.beside_.empty() && !desk.agent_.empty()) Put(desk.beside_, desk.agent_, true);
    Put(desk.beside_, request.agent, request.is_on);
  }
  static void Put(std::vector<std::string>& list, const std::string& what, bool is_on) {
    constexpr std::size_t kMost = 40;
    const auto found = std::find(list.begin(), list.end(), what);
    if (!is_on && found != list.end()) list.erase(found);
    if (is_on && found == list.end() && list.size() < kMost) list.push_back(what);
  }
  void operator()(const OpenRunRequest& request) const { Open(request.what, {}); }
  void Open(const std::string& what, const std::string& lesson) const {
    const Result<void> opened = surroundings.OpenRun(what, lesson);
    if (opened) return;
    desk.NoteProblem(opened.error(), {});
    const std::string& message = opened.error().message;
    surroundings.Tell(message.substr(0, message.find(": ")));  // The panel Problems shows the rest.
  }
  void operator()(const LessonRequest& request) const {
    using What = LessonRequest::What;
    Lessons* const lessons = surroundings.lessons();
    if (lessons == nullptr) return;
    if (request.what == What::kHint) return lessons->Hint();
    if (request.what == What::kCancel) return lessons->Cancel();
    if (request.what == What::kGrade) {
      if (desk.files_.HasUnsaved()) surroundings.Tell("Only saved rules are graded: press Save in Edit first");
      if (const Result<void> begun = lessons->Grade(); !begun) desk.NoteProblem(begun.error(), {});
      return;
    }
    const Result<Lessons::Opened> opened = lessons->Open(request.lesson);
    if (!opened) return desk.NoteProblem(opened.error(), {});
    Open(opened->folder, opened->lesson);
  }
  void operator()(const FlowRequest&) const {}  // The program around the desk does it.
  void operator()(const SearchRequest& request) const { desk.searched_ = request.text; }
  void operator()(const OfferRequest& request) const { desk.offers_ = request.is_on; }
  void operator()(const BreakRequest& request) const {
    if (desk.run_ == nullptr) return surroundings.Tell("Breakpoints stop a run, not a recording");
    if (const Result<int> set = desk.breakpoints_.Set(request.kind, request.agent, request.what); !set)
      desk.NoteProblem(set.error(), request.agent);
  }
  void operator()(const LineStopRequest& request) const { desk.scripts_.Obey(request); }
  void operator()(const ErrorStopRequest& request) const { desk.scripts_.Obey(request); }
  void operator()(const ScriptGoRequest& request) const {
    if (!desk.scripts_.is_stopped()) return surroundings.Tell("No script is stopped");
    desk.scripts_.GoOn(request.how);
  }
  void operator()(const ScriptCallRequest& request) const { desk.scripts_.Obey(request); }
  void operator()(const ScriptValueRequest& request) const { desk.scripts_.Obey(request); }
  void operator()(const ScriptWatchRequest& request) const { desk.scripts_.Obey(request); }
  void operator()(const ChangeBreakRequest& request) const {
    using What = ChangeBreakRequest::What;
    if (request.what == What::kClear) {
      desk.breakpoints_.Clear(request.number);
    } else {
      desk.breakpoints_.Enable(request.number, request.what == What::kEnable);
    }
  }
};

void Desk::Obey(const Request& request) {
  std::visit(Visitor{*this, surroundings_}, request);
  is_stale_ |= !std::holds_alternative<SelectRequest>(request) && !std::holds_alternative<LookRequest>(request);
}

void Desk::NoteChangedRules() {
  if (!files_.TakeApplied()) return;
  changed_tick_ = past_.last_tick();
  if (Lessons* const lessons = surroundings_.lessons()) lessons->NoteTried();
  is_stale_ = true;
}

void Desk::Resume() {
  // If the tick is still being rebuilt, the run continues when it is ready.
  resume_at_.reset();
  if (past_.rebuilt().world() == nullptr && !past_.is_live() && past_.rebuilt().IsPossible()) {
    resume_at_ = past_.shown_tick();
    return;
  }
  std::unique_ptr<sim::Simulation> simulation = past_.Resume();
  if (simulation == nullptr || run_ == nullptr) return;
  run_->GoOnWith(std::move(simulation), past_.parting()->record, past_.parting()->inputs);
  files_.EndPast(true);
  scripts_.Observe();
  noted_agent_.clear();
  hits_.clear();
  // The run continues at once, so that the user sees the result.
  surroundings_.GoOn();
}

}  // namespace soarbox::workbench
