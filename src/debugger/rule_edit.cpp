// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/rule_edit.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

#include "diagnostics/problem.h"
#include "sim/check.h"
#include "sim/live_edits.h"
#include "sim/scenario_file.h"
#include "sim/vet_rules.h"

namespace soarbox::debugger {
namespace {

bool IsScenario(const sim::WatchedFile& file) {
  return file.file.extension() == ".toml";
}

}  // namespace

bool Edit::is_scenario() const {
  return IsScenario(file_);
}

Result<Edit> Edit::Open(const sim::WatchedFile& file) {
  std::ifstream in(file.file, std::ios::binary);
  std::ostringstream text;
  if (!in || !(text << in.rdbuf()))
    return ProblemIn(file.file, "this file cannot be read", "check that it is there and its permissions");
  Edit edit;
  edit.file_ = file;
  edit.text_ = edit.running_ = edit.saved_ = text.str();
  std::error_code error;
  edit.written_ = std::filesystem::last_write_time(file.file, error);
  return edit;
}

std::vector<Diagnostic> Edit::Check() const {
  const std::string name = file_.file.string();
  if (is_scenario()) {
    std::vector<Diagnostic> problems;
    sim::ParseScenarioFile(text_, file_.file, problems);
    return problems;
  }
  if (!file_.is_rules) return sim::CheckScriptText(text_, name);
  return sim::VetRuleFile(text_, file_.file);
}

std::vector<Diagnostic> Edit::Apply(sim::Simulation& simulation, bool is_past) {
  std::vector<Diagnostic> problems = Check();
  if (sim::IsEmptied(InUse(), text_))
    problems.push_back(ProblemIn(file_.file, "the text is empty", "leave a comment in it to remove everything"));
  if (sim::HasError(problems) || is_scenario()) return problems;
  std::vector<sim::WatchedFile> running;
  for (const sim::WatchedFile& file : sim::WithSourced(simulation.Files()))
    if (file.file == file_.file && file.is_rules == file_.is_rules) running.push_back(file);
  if (running.empty()) running.push_back(file_);
  for (const sim::WatchedFile& file : running) sim::SubmitEdit(simulation, file, InUse(), text_);
  if (is_past) {
    past_ = text_;
  } else {
    running_ = text_;
  }
  return problems;
}

bool Edit::EndPast(bool continues) {
  const std::optional<std::string> past = std::exchange(past_, std::nullopt);
  if (!past || !continues) return false;
  running_ = *past;
  return true;
}

Result<void> Edit::Save() {
  // Writes a second file and renames it, so that a full disk does not destroy the old file.
  namespace fs = std::filesystem;
  std::error_code error, ignored;
  fs::path target = fs::canonical(file_.file, error);
  if (error) target = file_.file;
  const fs::path half = fs::path(target).concat(".soarbox-new");
  std::ofstream out(half, std::ios::binary | std::ios::trunc);
  const bool is_written = out && (out << text_).flush();
  out.close();
  const auto permissions = fs::status(target, ignored).permissions();
  const bool may_write = access(target.c_str(), W_OK) == 0 || !fs::exists(target, ignored);
  error.clear();
  if (is_written && may_write) {
    if (permissions != fs::perms::unknown) fs::permissions(half, permissions, ignored);
    fs::rename(half, target, error);
  }
  if (!is_written || !may_write || error) {
    fs::remove(half, ignored);
    return ProblemIn(file_.file, "this file cannot be written", "check the folder and its permissions");
  }
  saved_ = text_;
  // The running world loads a saved file, unless it has errors.
  if (!is_scenario() && !sim::HasError(Check())) running_ = text_;
  written_ = fs::last_write_time(file_.file, ignored);
  return {};
}

Edit::Disk Edit::LookAtDisk() {
  std::error_code error;
  const auto written = std::filesystem::last_write_time(file_.file, error);
  if (error || written == written_) return Disk::kSame;
  const Result<Edit> now = Open(file_);
  if (!now) return Disk::kSame;
  written_ = written;
  if (now->text_ == saved_) return Disk::kSame;
  const bool is_own = is_unsaved();
  saved_ = now->text_;
  // The running world does not load a file with errors.
  if (!is_scenario() && !sim::HasError(now->Check())) running_ = saved_;
  if (is_own) return Disk::kDiffers;
  text_ = saved_;
  return Disk::kTaken;
}

int Edit::LineOf(std::string_view rule) const {
  std::size_t at = 0;
  while ((at = text_.find(rule, at)) != std::string::npos) {
    const std::size_t open = text_.find_last_not_of(" \t\r\n", at == 0 ? 0 : at - 1);
    const char after = at + rule.size() < text_.size() ? text_[at + rule.size()] : ' ';
    const bool is_whole = after == ' ' || after == '\n' || after == '\r' || after == '\t' || after == '(';
    if (open != std::string::npos && text_[open] == '{' && is_whole)
      return 1 + static_cast<int>(std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(open), '\n'));
    at += rule.size();
  }
  return 0;
}

std::vector<sim::WatchedFile> FilesOf(sim::Simulation& simulation, std::string_view agent) {
  constexpr bool kWithScenario = true;
  std::vector<sim::WatchedFile> own = simulation.Files(kWithScenario);
  if (!agent.empty())
    std::erase_if(own, [&](const sim::WatchedFile& file) { return file.agent != agent && !IsScenario(file); });
  std::vector<sim::WatchedFile> files;
  for (sim::WatchedFile& file : sim::WithSourced(own)) {
    const bool is_there =
        std::ranges::any_of(files, [&](const sim::WatchedFile& known) { return known.file == file.file; });
    if (!is_there) files.push_back(std::move(file));
  }
  return files;
}

}  // namespace soarbox::debugger
