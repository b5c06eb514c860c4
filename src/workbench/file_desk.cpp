// SPDX-License-Identifier: BSD-2-Clause
#include "workbench/file_desk.h"

#include <algorithm>
#include <filesystem>

#include "diagnostics/problem.h"
#include "sim/vet_rules.h"

namespace soarbox::workbench {

FileDesk::Belongings FileDesk::Take() {
  return {std::exchange(files_, {}), looked_, version_};
}

void FileDesk::Bring(Belongings belongings) {
  files_ = std::move(belongings.files);
  for (auto& [name, file] : files_) file.edit.BeginAgain();
  looked_ = std::move(belongings.looked);
  version_ = belongings.version;
}

void FileDesk::Edit(const EditRequest& request, const std::string& agent) {
  std::vector<sim::WatchedFile> files;
  if (sim::Simulation* live = common_.Live()) files = debugger::FilesOf(*live, {});
  const std::filesystem::path wanted(request.file);
  const auto found = std::find_if(files.begin(), files.end(), [&](const sim::WatchedFile& file) {
    return file.file == wanted || file.file.filename() == wanted;
  });
  sim::WatchedFile file{agent, wanted, wanted.extension() == ".soar"};
  if (found != files.end()) file = *found;
  const std::string name = file.file.string();
  if (found == files.end() && !common_.surroundings.MayBrowse() && !common_.surroundings.IsOwn(wanted)) {
    Diagnostic problem;
    problem.file = name;
    problem.message = "the run was not made from this file";
    problem.hint = "only files of the run, and your own files next to them, can be edited here";
    return common_.note_problem(std::move(problem), agent);
  }
  if (!files_.contains(name)) {
    Result<debugger::Edit> opened = debugger::Edit::Open(file);
    if (!opened) {
      common_.note_problem(opened.error(), agent);
      return;
    }
    EditContents contents;
    contents.file = name;
    contents.is_rules = file.is_rules;
    contents.version = ++version_;
    contents.text = opened->text();
    std::optional<std::string> waiting;
    if (const std::optional<std::string> draft = drafts_.Find(name)) {
      if (*draft == opened->text()) {
        drafts_.Drop(name);
      } else {
        waiting = draft;
      }
    }
    files_.emplace(name, Open{std::move(*opened), std::move(contents)}).first->second.draft = waiting;
  }
  looked_ = name;
  Open& edited = *Looked();
  edited.contents.go_to_line = request.rule.empty() ? request.line : edited.edit.LineOf(request.rule);
  ++edited.contents.go_to_count;
}

void FileDesk::Apply(Open& file) {
  file.apply_at.reset();
  if (sim::Simulation* world = common_.Looked()) {
    const bool is_past = world != common_.Live();
    file.contents.problems = file.edit.Apply(*world, is_past);
    file.contents.notice =
        sim::HasError(file.contents.problems) ? "Nothing was changed: the previous version keeps running."
        : file.edit.is_scenario() ? "No errors. Save it and begin again: a world is built from this file only once."
                                  : "Reloaded: it takes effect in the next tick.";
    if (sim::HasError(file.contents.problems) || file.edit.is_scenario()) return;
    ++file.contents.reload_count;
    if (is_past) {
      changed_past_ = common_.past.shown_tick();
      if (common_.run == nullptr) common_.past.rebuilt().Spoil();
    } else {
      common_.forget_problems(file.contents.file);
      has_applied_ = true;
    }
  } else {
    if (common_.past.rebuilt().IsPossible()) file.apply_at = common_.past.shown_tick();
    file.contents.notice = common_.past.rebuilt().Note();
  }
}

void FileDesk::EndPast(bool continues) {
  changed_past_.reset();
  for (auto& [name, file] : files_)
    if (file.edit.EndPast(continues)) common_.forget_problems(name);
}

void FileDesk::GoOn() {
  if (changed_past_ && (common_.past.is_live() || common_.past.shown_tick() != *changed_past_)) EndPast(false);
  for (auto& [name, file] : files_) {
    if (!file.apply_at) continue;
    if (!common_.past.is_live() && common_.past.shown_tick() == *file.apply_at) {
      Apply(file);
    } else {
      file.apply_at.reset();
      file.contents.notice = "Not applied: you went to another moment.";
    }
    has_news_ |= !file.apply_at;
  }
  LookAtDisk();
}

void FileDesk::Change(const EditTextRequest& request) {
  Open* const file = Looked();
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
      Save(*file);
      break;
    case What::kRevert:
      edit.Revert();
      shown.text = edit.text();
      shown.problems.clear();
      shown.version = ++version_;
      break;
  }
}

void FileDesk::ShowDraft() {
  Open* const file = Looked();
  if (file == nullptr || !file->draft) return;
  file->edit.text() = file->contents.text = *std::exchange(file->draft, std::nullopt);
  file->contents.version = ++version_;
  file->contents.notice = "This is your draft: you typed it and did not save it. Undo or Revert goes back to the file.";
  has_news_ = true;
}

void FileDesk::Save(Open& file) {
  EditContents& shown = file.contents;
  const Result<void> saved =
      common_.surroundings.MayWrite(shown.file)
          ? file.edit.Save()
          : Result<void>(ProblemIn(shown.file, "you may not write this file",
                                   "Apply uses your change in the running world; it is kept as your draft"));
  file.failure = saved ? std::string{} : saved.error().message + ": " + saved.error().hint;
  file.has_draft = true;
  if (!saved) {
    shown.problems = {saved.error()};
  } else {
    shown.notice = "Saved.";
  }
}

void FileDesk::LookAtDisk() {
  constexpr auto kEvery = std::chrono::milliseconds(500);
  Open* const file = Looked();
  if (file == nullptr || Clock::now() - looked_at_disk_ < kEvery) return;
  looked_at_disk_ = Clock::now();
  switch (file->edit.LookAtDisk()) {
    case debugger::Edit::Disk::kSame:
      return;
    case debugger::Edit::Disk::kTaken:
      file->contents.text = file->edit.text();
      file->contents.version = ++version_;
      file->contents.problems.clear();
      file->contents.notice = "Another program has written this file: this is what it wrote.";
      break;
    case debugger::Edit::Disk::kDiffers:
      file->contents.notice = "Another program has written this file: Revert takes that over, Save writes over it.";
      break;
  }
  has_news_ = true;
}

void FileDesk::SaveAll() {
  for (auto& [name, file] : files_)
    if (file.edit.is_unsaved()) Save(file);
}

bool FileDesk::HasUnsaved() const {
  return std::ranges::any_of(files_, [](const auto& named) { return named.second.edit.is_unsaved(); });
}

std::optional<std::string> FileDesk::TextOf(const std::string& file) const {
  const auto found = files_.find(file);
  return found == files_.end() ? std::nullopt : std::optional(found->second.edit.text());
}

void FileDesk::KeepDrafts() {
  for (auto& [name, file] : files_) {
    if (!std::exchange(file.has_draft, false)) continue;
    if (!file.edit.is_unsaved()) {
      drafts_.Drop(name);
    } else if (const Result<void> kept = drafts_.Keep(name, file.edit.text()); !kept) {
      common_.note_problem(kept.error(), {});
    }
  }
}

void FileDesk::Fill(Contents& contents) const {
  contents.edit = {};
  contents.open_files.clear();
  for (const auto& [name, file] : files_)
    contents.open_files.push_back({name, file.edit.is_changed(), file.edit.is_unsaved(), file.failure});
  const auto looked = files_.find(looked_);
  if (looked == files_.end()) return;
  contents.edit = looked->second.contents;
  contents.edit.is_changed = looked->second.edit.is_changed();
  contents.edit.is_unsaved = looked->second.edit.is_unsaved();
}

const debugger::Edit* FileDesk::FindRunning(const std::string& file) const {
  const auto found = files_.find(file);
  return found == files_.end() || found->second.edit.is_changed() ? nullptr : &found->second.edit;
}

}  // namespace soarbox::workbench
