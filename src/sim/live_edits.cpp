// SPDX-License-Identifier: BSD-2-Clause
#include "sim/live_edits.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>
#include <system_error>

#include "diagnostics/read_text.h"
#include "explain/rule_text.h"
#include "script/keep_state.h"
#include "sim/check.h"
#include "sim/simulation.h"
#include "sim/sourced_files.h"
#include "sim/vet_rules.h"

namespace soarbox::sim {
namespace {

namespace fs = std::filesystem;

bool IsPlainFile(const fs::path& file) {
  std::error_code error;
  return fs::is_regular_file(file, error);
}

/// What is the matter with a file that cannot be read any more.
std::string WhyUnreadable(const fs::path& file) {
  std::error_code error;
  if (fs::is_directory(file, error)) return "this is a folder now";
  return IsPlainFile(file) ? "this file can no longer be read" : "this is no longer a plain file";
}

Diagnostic EditNews(Severity severity, const fs::path& file, std::string message, std::string hint = {}) {
  Diagnostic told;
  told.severity = severity;
  told.file = file.string();
  told.message = std::move(message);
  told.hint = std::move(hint);
  return told;
}

constexpr const char* kKeepsRunning = "the previous version keeps running";

/// Names of the rules that are new or differ.
std::set<std::string> ChangedRules(const std::string& before, const std::string& after) {
  const SplitText old = SplitRules(before);
  std::set<std::string> names;
  for (const auto& [name, text] : SplitRules(after).rules) {
    const auto at = old.rules.find(name);
    if (at == old.rules.end() || at->second != text) names.insert(name);
  }
  return names;
}

}  // namespace

std::vector<WatchedFile> WithSourced(const std::vector<WatchedFile>& files) {
  std::vector<WatchedFile> all;
  for (const WatchedFile& file : files) {
    all.push_back(file);
    if (!file.is_rules) continue;
    for (const fs::path& one : WithSourcedFiles(file.file))
      if (one != file.file) all.push_back({file.agent, one, true});
  }
  return all;
}

SplitText SplitRules(std::string_view given) {
  SplitText split;
  const std::string text = explain::BlankComments(std::string(given));
  split.only_rules.reserve(text.size());
  for (const char c : text) split.only_rules += c == '\n' ? '\n' : ' ';
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t line_end = std::min(text.find('\n', at), text.size());
    const bool begins = (text.compare(at, 2, "sp") == 0 || text.compare(at, 2, "gp") == 0) &&
                        text.find_first_not_of(" \t", at + 2) != std::string::npos &&
                        text[text.find_first_not_of(" \t", at + 2)] == '{';
    if (!begins) {
      at = line_end + 1;
      continue;
    }
    const std::size_t open = text.find('{', at);
    std::size_t name_begin = open + 1;
    while (name_begin < text.size() && std::isspace(static_cast<unsigned char>(text[name_begin])) != 0) ++name_begin;
    std::size_t name_end = name_begin;
    while (name_end < text.size() && std::isspace(static_cast<unsigned char>(text[name_end])) == 0 &&
           text[name_end] != '(')
      ++name_end;
    const std::string name = text.substr(name_begin, name_end - name_begin);
    int depth = 0;
    bool quoted = false;
    std::size_t end = open;
    for (; end < text.size(); ++end) {
      if (text[end] == '|') quoted = !quoted;
      if (quoted) continue;
      if (text[end] == '{') ++depth;
      if (text[end] == '}' && --depth == 0) break;
    }
    if (end >= text.size()) {
      split.rules.clear();
      split.unclosed = name;
      return split;
    }
    split.rules[name] = text.substr(at, end + 1 - at);
    split.only_rules.replace(at, end + 1 - at, split.rules[name]);
    at = std::min(text.find('\n', end), text.size() - 1) + 1;
  }
  return split;
}

std::vector<std::string> EditsBetween(const SplitText& before, const SplitText& after) {
  std::vector<std::string> edits;
  for (const auto& [name, text] : before.rules)
    if (!after.rules.contains(name)) edits.push_back("excise " + name);
  for (const auto& [name, text] : after.rules) {
    const auto old = before.rules.find(name);
    if (old == before.rules.end() || old->second != text) edits.push_back(text);
  }
  return edits;
}

LiveEdits::LiveEdits(Simulation& simulation) : simulation_(simulation) {
  Watch();
}

LiveEdits::LiveEdits(Simulation& simulation, const LiveEdits& earlier) : simulation_(simulation) {
  for (const auto& [file, version] : earlier.versions_) {
    Version& then = versions_[file];
    then = version;
    const auto held = std::find_if(then.earlier.begin(), then.earlier.end(),
                                   [&](const auto& text) { return simulation.tick() <= text.first; });
    if (held == then.earlier.end()) continue;
    then.text = held->second;
    then.earlier.erase(held, then.earlier.end());
    then.time = {};  // Whatever is there now is newer.
  }
  Watch();
}

/// Agents come and go; files that are new are taken as they are now.
void LiveEdits::Watch() {
  files_ = WithSourced(simulation_.Files());
  for (const WatchedFile& file : files_) {
    const auto [at, is_new] = versions_.try_emplace(file.file);
    if (!is_new) continue;
    std::error_code error;
    at->second.time = fs::last_write_time(file.file, error);
    at->second.text = ReadText(file.file).value_or("");
  }
}

std::optional<std::string> LiveEdits::TakeChange(const fs::path& file, Version& version,
                                                 std::vector<Diagnostic>& told) {
  std::error_code error;
  const auto time = fs::last_write_time(file, error);
  // Editors put a new file in the place of the old one: a moment without any is nothing to report.
  if (error) {
    if (++version.missed == 2) told.push_back(EditNews(Severity::kWarning, file, "this file is gone", kKeepsRunning));
    return std::nullopt;
  }
  version.missed = 0;
  if (time == version.time) return std::nullopt;
  version.time = time;
  std::optional<std::string> text = IsPlainFile(file) ? ReadText(file) : std::nullopt;
  if (!text) told.push_back(EditNews(Severity::kWarning, file, WhyUnreadable(file), kKeepsRunning));
  if (!text || *text == version.text) return std::nullopt;
  return text;
}

void LiveEdits::Submit(const WatchedFile& file, const std::string& before, const std::string& after) {
  if (!file.is_rules) {
    simulation_.Submit(ScriptInput{file.agent, script::WithKept(after, script::UnchangedVariables(before, after))});
    return;
  }
  for (const std::string& edit : EditsBetween(SplitRules(before), SplitRules(after)))
    simulation_.Submit(CommandInput{file.agent, edit});
}

void LiveEdits::TellSlips(std::vector<Diagnostic>& told) {
  std::erase_if(edited_, [&](const Edited& edited) {
    if (simulation_.tick() <= edited.tick) return false;
    for (Diagnostic& slip : simulation_.SlipsOf(edited.agent, edited.rules)) told.push_back(std::move(slip));
    return true;
  });
}

std::vector<Diagnostic> LiveEdits::Poll() {
  std::vector<Diagnostic> told;
  TellSlips(told);
  Watch();
  std::set<fs::path> looked_at;
  for (const WatchedFile& changed : files_) {
    if (!looked_at.insert(changed.file).second) continue;
    Version& version = versions_[changed.file];
    const std::optional<std::string> text = TakeChange(changed.file, version, told);
    if (!text) continue;
    std::vector<Diagnostic> problems =
        changed.is_rules ? VetRuleFile(*text, changed.file) : CheckScriptText(*text, changed.file.string());
    const bool is_refused = HasError(problems);
    told.insert(told.end(), std::make_move_iterator(problems.begin()), std::make_move_iterator(problems.end()));
    // The next good version is compared with what runs, not with what never did.
    if (is_refused) {
      told.push_back(EditNews(Severity::kNote, changed.file, std::string("nothing was changed; ") + kKeepsRunning));
      continue;
    }
    for (const WatchedFile& file : files_)
      if (file.file == changed.file) Submit(file, version.text, *text);
    if (changed.is_rules) edited_.push_back({changed.agent, ChangedRules(version.text, *text), simulation_.tick()});
    version.earlier.emplace_back(simulation_.tick(), std::exchange(version.text, *text));
    told.push_back(EditNews(Severity::kNote, changed.file, "reloaded"));
  }
  return told;
}

}  // namespace soarbox::sim
