// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/edit.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "sim/check.h"
#include "sim/live_edits.h"

namespace soarbox::debugger {
namespace {

Diagnostic Problem(const std::filesystem::path& file, std::string message, std::string hint) {
  Diagnostic problem;
  problem.file = file.string();
  problem.message = std::move(message);
  problem.hint = std::move(hint);
  return problem;
}

bool HasError(const std::vector<Diagnostic>& problems) {
  return std::ranges::any_of(problems, [](const Diagnostic& p) { return p.severity == Severity::kError; });
}

/// The text without the lines that source files which are there: those are edited and checked by themselves, and stand
/// beside the file, not beside the copy that is checked. Lines keep their numbers.
std::string WithoutSourced(const std::string& text, const std::filesystem::path& file) {
  std::istringstream lines(text);
  std::string rest;
  for (std::string line; std::getline(lines, line); rest += '\n') {
    std::istringstream words(line);
    std::string command, name;
    std::error_code error;
    if (words >> command >> name && command == "source") {
      std::erase(name, '"');
      if (std::filesystem::is_regular_file(file.parent_path() / name, error)) continue;
    }
    rest += line;
  }
  return rest;
}

}  // namespace

Result<Edit> Edit::Open(const sim::WatchedFile& file) {
  std::ifstream in(file.file, std::ios::binary);
  std::ostringstream text;
  if (!in || !(text << in.rdbuf()))
    return Problem(file.file, "this file cannot be read", "check that it is there and its permissions");
  Edit edit;
  edit.file_ = file;
  edit.text_ = edit.running_ = edit.saved_ = text.str();
  std::error_code error;
  edit.written_ = std::filesystem::last_write_time(file.file, error);
  return edit;
}

std::vector<Diagnostic> Edit::Check() const {
  const std::string name = file_.file.string();
  if (!file_.is_rules) return sim::CheckScriptText(text_, name);
  const sim::SplitText split = sim::SplitRules(text_);
  if (split.unclosed.empty()) return sim::CheckRuleText(WithoutSourced(text_, file_.file), name);
  Diagnostic problem =
      Problem(file_.file, "the rule " + split.unclosed + " is not closed", "a rule ends with a brace: }");
  problem.line = LineOf(split.unclosed);
  return {problem};
}

std::vector<Diagnostic> Edit::Apply(sim::Simulation& simulation) {
  std::vector<Diagnostic> problems = Check();
  if (HasError(problems)) return problems;
  const std::vector<std::string> lines = file_.is_rules
                                             ? sim::EditsBetween(sim::SplitRules(running_), sim::SplitRules(text_))
                                             : std::vector<std::string>();
  std::vector<std::string> agents;
  for (const sim::WatchedFile& file : sim::WithSourced(simulation.Files()))
    if (file.file == file_.file && file.is_rules == file_.is_rules) agents.push_back(file.agent);
  if (agents.empty()) agents.push_back(file_.agent);
  for (const std::string& agent : agents) {
    if (!file_.is_rules) simulation.Submit(sim::ScriptInput{agent, text_});
    for (const std::string& line : lines) simulation.Submit(sim::CommandInput{agent, line});
  }
  running_ = text_;
  return problems;
}

Result<void> Edit::Save() {
  std::ofstream out(file_.file, std::ios::binary);
  if (!out || !(out << text_).flush())
    return Problem(file_.file, "this file cannot be written", "check the folder and its permissions");
  saved_ = text_;
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
  saved_ = running_ = now->text_;
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
  std::vector<sim::WatchedFile> own = simulation.Files();
  if (!agent.empty()) std::erase_if(own, [&](const sim::WatchedFile& file) { return file.agent != agent; });
  std::vector<sim::WatchedFile> files;
  for (sim::WatchedFile& file : sim::WithSourced(own)) {
    const bool is_there =
        std::ranges::any_of(files, [&](const sim::WatchedFile& known) { return known.file == file.file; });
    if (!is_there) files.push_back(std::move(file));
  }
  return files;
}

}  // namespace soarbox::debugger
