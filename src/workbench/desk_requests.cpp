// SPDX-License-Identifier: BSD-2-Clause
// What the user asks for in panels.
#include <algorithm>
#include <filesystem>
#include <utility>

#include "sim/vet_rules.h"
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
  void operator()(const ConsoleRequest& request) const { desk.Type(request); }
  void operator()(const CompleteRequest& request) const {
    desk.completed_line_ = request.line;
    desk.completion_ = {};
    if (sim::Simulation* world = desk.Looked()) {
      if (const auto mind = world->Inspect(request.agent)) desk.completion_ = debugger::Complete(*mind, request.line);
    }
  }
  void operator()(const KeepLineRequest& request) const {
    desk.unsent_lines_[request.agent] = {.text = request.line, .has_draft = true};
  }
  void operator()(const ClearConsoleRequest&) const { desk.ConsoleOf(desk.agent_).Clear(); }
  void operator()(const ClearProblemsRequest&) const { desk.problems_.clear(); }
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
  void operator()(const StateRequest& request) const { desk.state_ = request.state; }
  void operator()(const ObjectRequest& request) const {
    constexpr std::size_t kMostOpen = 200;
    if (!request.is_open) {
      desk.open_objects_.erase(request.id);
    } else if (desk.open_objects_.size() < kMostOpen) {
      desk.open_objects_.insert(request.id);
    }
  }
  void operator()(const ElementRequest& request) const { desk.timetag_ = request.timetag; }
  void operator()(const SearchMemoryRequest& request) const { desk.search_ = request.text; }
  void operator()(const RuleRequest& request) const { desk.rule_ = request.rule; }
  void operator()(const SearchKnownRequest& request) const { desk.known_search_ = request.text; }
  void operator()(const EpisodeRequest& request) const { desk.episode_ = request.number; }
  void operator()(const LearnedRuleRequest& request) const { desk.learned_rule_ = request.rule; }
  void operator()(const CoverageRequest&) const { desk.wants_coverage_ = true; }
  void operator()(const WhyRequest& request) const { desk.why_ = request; }
  void operator()(const PlotRequest& request) const {
    if (request.is_on) {
      if (desk.models_.plots.Plot(request.agent, request.what))
        desk.histories_.emplace_back(request.agent, request.what);
    } else {
      desk.models_.plots.Remove(request.agent, request.what);
    }
  }
  void operator()(const EditRequest& request) const { desk.OpenEdit(request); }
  void operator()(const EditTextRequest& request) const { desk.ChangeText(request); }
  void operator()(const SaveAllRequest&) const {
    for (auto& [name, file] : desk.open_files_) {
      if (file.edit.is_unsaved()) desk.SaveEdit(file);
    }
  }
  void operator()(const WatchRequest& request) const { Put(desk.watches_, request.what, request.is_on); }
  void operator()(const BesideRequest& request) const {
    // Who adds another mind wants to see it beside the one that is looked at.
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
    surroundings.Tell(message.substr(0, message.find(": ")));  // Problems has the rest.
  }
  void operator()(const LessonRequest& request) const {
    using What = LessonRequest::What;
    Lessons* const lessons = surroundings.lessons();
    if (lessons == nullptr) return;
    if (request.what == What::kHint) return lessons->Hint();
    if (request.what == What::kGrade) {
      const bool is_unsaved =
          std::ranges::any_of(desk.open_files_, [](const auto& named) { return named.second.edit.is_unsaved(); });
      if (is_unsaved) surroundings.Tell("Only saved rules are graded: press Save in Edit first");
      if (const Result<void> begun = lessons->Grade(); !begun) desk.NoteProblem(begun.error(), {});
      return;
    }
    const Result<Lessons::Opened> opened = lessons->Open(request.lesson);
    if (!opened) return desk.NoteProblem(opened.error(), {});
    Open(opened->folder, opened->lesson);
  }
  void operator()(const SearchRequest& request) const { desk.searched_ = request.text; }
  void operator()(const OfferRequest& request) const { desk.offers_ = request.is_on; }
  void operator()(const BreakRequest& request) const {
    if (desk.run_ == nullptr) return surroundings.Tell("Nothing stops a recording: breakpoints are for a run");
    if (const Result<int> set = desk.breakpoints_.Set(request.kind, request.agent, request.what); !set)
      desk.NoteProblem(set.error(), request.agent);
  }
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

void Desk::Type(const ConsoleRequest& request) {
  sim::Simulation* world = Looked();
  if (world == nullptr) {
    ConsoleOf(request.agent).Refuse(request.line, past_.PastNote());
    ++console_lines_;
    return;
  }
  ConsoleOf(request.agent).Run(*world, request.line);
  if (recording_ != nullptr) past_.Spoil();
  ++console_lines_;
}

void Desk::Resume() {
  // What is still being rebuilt goes on as soon as it is there.
  resume_at_.reset();
  if (past_.past() == nullptr && !past_.is_live() && past_.CanBeRebuilt()) {
    resume_at_ = past_.shown_tick();
    return;
  }
  std::unique_ptr<sim::Simulation> simulation = past_.Resume();
  if (simulation == nullptr || run_ == nullptr) return;
  run_->GoOnWith(std::move(simulation), past_.branch_record(), past_.Inputs());
  noted_agent_.clear();
  hits_.clear();
  // Who goes back wants to see it happen.
  surroundings_.GoOn();
}

void Desk::OpenEdit(const EditRequest& request) {
  std::vector<sim::WatchedFile> files;
  if (sim::Simulation* live = Live()) files = debugger::FilesOf(*live, {});
  const std::filesystem::path wanted(request.file);
  const auto found = std::find_if(files.begin(), files.end(), [&](const sim::WatchedFile& file) {
    return file.file == wanted || file.file.filename() == wanted;
  });
  sim::WatchedFile file{agent_, wanted, wanted.extension() == ".soar"};
  if (found != files.end()) file = *found;
  const std::string name = file.file.string();
  if (found == files.end() && !surroundings_.MayBrowse()) {
    Diagnostic problem;
    problem.file = name;
    problem.message = "the run was not made from this file";
    problem.hint = "only files of the run can be edited here";
    return NoteProblem(std::move(problem), agent_);
  }
  if (!open_files_.contains(name)) {
    Result<debugger::Edit> opened = debugger::Edit::Open(file);
    if (!opened) {
      NoteProblem(opened.error(), agent_);
      return;
    }
    EditContents contents;
    contents.file = name;
    contents.is_rules = file.is_rules;
    contents.version = ++edit_version_;
    contents.text = opened->text();
    std::optional<std::string> waiting;
    if (const std::optional<std::string> draft = drafts_.Find(name)) {
      if (*draft == opened->text()) {
        drafts_.Drop(name);
      } else {
        waiting = draft;
      }
    }
    open_files_.emplace(name, OpenFile{std::move(*opened), std::move(contents)}).first->second.draft = waiting;
  }
  edited_file_ = name;
  OpenFile& edited = *Edited();
  edited.contents.go_to_line = request.rule.empty() ? request.line : edited.edit.LineOf(request.rule);
  ++edited.contents.go_to_count;
}

void Desk::Apply(OpenFile& file) {
  file.apply_at.reset();
  if (sim::Simulation* world = Looked()) {
    file.contents.problems = file.edit.Apply(*world);
    file.contents.notice = sim::HasError(file.contents.problems)
                               ? "Nothing was changed: the previous version keeps running."
                               : "Reloaded: it takes effect in the next tick.";
  } else {
    if (past_.CanBeRebuilt()) file.apply_at = past_.shown_tick();
    file.contents.notice = past_.PastNote();
  }
}

void Desk::ApplyAwaited() {
  for (auto& [name, file] : open_files_) {
    if (!file.apply_at) continue;
    if (!past_.is_live() && past_.shown_tick() == *file.apply_at) {
      Apply(file);
    } else {
      file.apply_at.reset();
      file.contents.notice = "Not applied: you went to another moment.";
    }
    is_stale_ |= !file.apply_at;
  }
}

void Desk::ChangeText(const EditTextRequest& request) {
  OpenFile* const file = Edited();
  if (file == nullptr) return;
  debugger::Edit& edit = file->edit;
  using What = EditTextRequest::What;
  EditContents& shown = file->contents;
  edit.text() = request.text;
  shown.text = request.text;
  file->has_draft = true;
  if (file->apply_at) shown.notice.clear();
  file->apply_at.reset();
  if (request.what == What::kType) return;
  shown.notice.clear();
  switch (request.what) {
    case What::kType:
      break;
    case What::kCheck:
      shown.problems = edit.Check();
      if (!sim::HasError(shown.problems)) shown.notice = "No errors.";
      break;
    case What::kApply:
      Apply(*file);
      break;
    case What::kSave:
      SaveEdit(*file);
      break;
    case What::kRevert:
      edit.Revert();
      shown.text = edit.text();
      shown.problems.clear();
      shown.version = ++edit_version_;
      break;
  }
}

void Desk::ShowDraft() {
  OpenFile* const file = Edited();
  if (file == nullptr || !file->draft) return;
  file->edit.text() = file->contents.text = *std::exchange(file->draft, std::nullopt);
  file->contents.version = ++edit_version_;
  file->contents.notice = "This is your draft: you typed it and did not save it. Undo or Revert goes back to the file.";
  is_stale_ = true;
}

bool Desk::SaveEdit(OpenFile& file) {
  EditContents& shown = file.contents;
  const Result<void> saved = file.edit.Save();
  file.failure = saved ? std::string{} : saved.error().message + ": " + saved.error().hint;
  file.has_draft = true;
  if (!saved) {
    shown.problems = {saved.error()};
    return false;
  }
  shown.notice = "Saved.";
  return true;
}

void Desk::LookAtDisk() {
  constexpr auto kEvery = std::chrono::milliseconds(500);
  OpenFile* const file = Edited();
  if (file == nullptr || Clock::now() - looked_at_disk_ < kEvery) return;
  looked_at_disk_ = Clock::now();
  switch (file->edit.LookAtDisk()) {
    case debugger::Edit::Disk::kSame:
      return;
    case debugger::Edit::Disk::kTaken:
      file->contents.text = file->edit.text();
      file->contents.version = ++edit_version_;
      file->contents.problems.clear();
      file->contents.notice = "Another program has written this file: this is what it wrote.";
      break;
    case debugger::Edit::Disk::kDiffers:
      file->contents.notice = "Another program has written this file: Revert takes that over, Save writes over it.";
      break;
  }
  is_stale_ = true;
}

}  // namespace soarbox::workbench
