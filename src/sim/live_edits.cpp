// SPDX-License-Identifier: BSD-2-Clause
#include "sim/live_edits.h"

#include <algorithm>
#include <cctype>
#include <chrono>
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

/// Why a file can no longer be read.
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

/// Removes a byte order mark and normalizes line ends.
std::string WithPlainLines(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  std::string plain;
  plain.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] != '\r' || i + 1 == text.size() || text[i + 1] != '\n') plain += text[i];
  return plain;
}

/// The files that a text sources directly, with the lines of the commands.
std::map<fs::path, int> SourcedBy(const fs::path& file, const std::string& text) {
  std::map<fs::path, int> sourced;
  std::istringstream lines(explain::BlankComments(text));
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const std::string name = NameSourcedBy(line);
    if (!name.empty() && IsPlainFile(file.parent_path() / name)) sourced.emplace(file.parent_path() / name, number);
  }
  return sourced;
}

/// Reports changed commands outside rules, because they are executed only when a file is loaded.
void TellOtherCommands(const fs::path& file, const std::string& before, const std::string& after,
                       std::vector<Diagnostic>& told) {
  const auto commands = [](const std::string& text) {
    std::vector<std::pair<std::string, int>> found;
    std::istringstream lines(SplitRules(text).outside);
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
      ++number;
      const std::size_t begin = line.find_first_not_of(" \t\r;");
      if (begin == std::string::npos || !NameSourcedBy(line).empty()) continue;
      found.emplace_back(line.substr(begin, line.find_last_not_of(" \t\r;") + 1 - begin), number);
    }
    return found;
  };
  const auto old = commands(before), now = commands(after);
  const auto differs = std::ranges::find_if(now, [&](const auto& one) {
    return std::ranges::none_of(old, [&](const auto& other) { return other.first == one.first; });
  });
  const bool is_gone = std::ranges::any_of(old, [&](const auto& one) {
    return std::ranges::none_of(now, [&](const auto& other) { return other.first == one.first; });
  });
  if (differs == now.end() && !is_gone) return;
  Diagnostic news =
      EditNews(Severity::kWarning, file, "a command outside of the rules has changed: the run goes on without it",
               "start the run again (Ctrl+R), or type the command into the console");
  if (differs != now.end()) {
    news.message = "the command " + differs->first + " is not carried out: an edit reloads rules only";
    news.line = differs->second;
  }
  told.push_back(std::move(news));
}

/// Names of the rules that are new or changed.
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
  const std::string text = explain::BlankComments(WithPlainLines(given));
  split.only_rules.reserve(text.size());
  for (const char c : text) split.only_rules += c == '\n' ? '\n' : ' ';
  split.outside = text;
  for (std::size_t at = 0; at < text.size();) {
    at = std::min(text.find_first_not_of(" \t;", at), text.size());
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
    for (std::size_t i = at; i <= end; ++i)
      if (text[i] != '\n') split.outside[i] = ' ';
    at = end + 1;
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
    then.time = {};  // Any present version is newer.
  }
  Watch();
}

/// Updates the list of files, because agents are created and destroyed. New files are taken as they are now.
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
  // Editors replace files by new ones, so that a file may be missing for a moment.
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

void SubmitEdit(Simulation& simulation, const WatchedFile& file, const std::string& before, const std::string& after,
                const std::set<std::string>& elsewhere) {
  if (!file.is_rules) {
    const script::Reload reload{file.script, script::UnchangedVariables(before, after)};
    simulation.Submit(ScriptInput{file.agent, script::WithReload(after, reload)});
    return;
  }
  SplitText old = SplitRules(before);
  const SplitText now = SplitRules(after);
  std::erase_if(old.rules,
                [&](const auto& rule) { return elsewhere.contains(rule.first) && !now.rules.contains(rule.first); });
  for (const std::string& edit : EditsBetween(old, now)) simulation.Submit(CommandInput{file.agent, edit});
}

bool IsEmptied(const std::string& before, const std::string& after) {
  constexpr const char* kBlanks = " \t\r\n";
  return after.find_first_not_of(kBlanks) == std::string::npos &&
         before.find_first_not_of(kBlanks) != std::string::npos;
}

std::set<std::string> LiveEdits::RulesElsewhere(const WatchedFile& file) const {
  std::set<std::string> names;
  if (!file.is_rules) return names;
  for (const WatchedFile& other : files_) {
    const auto version = versions_.find(other.file);
    if (other.agent != file.agent || other.file == file.file || !other.is_rules || version == versions_.end()) continue;
    for (const auto& [name, text] : SplitRules(version->second.text).rules) names.insert(name);
  }
  return names;
}

bool LiveEdits::IsWhole(const WatchedFile& file, const Version& version, const std::string& text,
                        bool is_refused) const {
  constexpr std::chrono::milliseconds kSettled(400);
  const auto age = fs::file_time_type::clock::now() - version.time;
  if (age > kSettled || age < -kSettled) return true;
  if (is_refused || !file.is_rules) return !is_refused;
  const SplitText after = SplitRules(text);
  return std::ranges::all_of(SplitRules(version.text).rules,
                             [&](const auto& rule) { return after.rules.contains(rule.first); });
}

void LiveEdits::FollowSources(const WatchedFile& changed, const std::string& before, const std::string& after,
                              std::vector<Diagnostic>& told) {
  const std::map<fs::path, int> old = SourcedBy(changed.file, before), now = SourcedBy(changed.file, after);
  for (const auto& [file, line] : now) {
    if (old.contains(file)) continue;
    const std::set<fs::path> all = WithSourcedFiles(file);
    if (all.contains(changed.file)) {
      Diagnostic circle = EditNews(Severity::kWarning, changed.file, "this file sources itself: the line does nothing",
                                   "remove this line");
      circle.line = line;
      told.push_back(std::move(circle));
      continue;
    }
    // None of these rules run yet: the next check treats all of them as new.
    for (const fs::path& one : all) versions_[one] = {};
  }
  files_ = WithSourced(simulation_.Files());
  for (const auto& [file, line] : old) {
    if (now.contains(file)) continue;
    for (const fs::path& one : WithSourcedFiles(file)) {
      const bool is_still_sourced =
          std::ranges::any_of(files_, [&](const WatchedFile& other) { return other.file == one; });
      const auto version = versions_.find(one);
      if (is_still_sourced || version == versions_.end()) continue;
      for (const WatchedFile& top : simulation_.Files())
        if (top.is_rules && (top.file == changed.file || WithSourcedFiles(top.file).contains(changed.file)))
          SubmitEdit(simulation_, {top.agent, one, true}, version->second.text, "",
                     RulesElsewhere({top.agent, one, true}));
      told.push_back(EditNews(Severity::kNote, one, "no longer sourced: its rules are excised"));
      versions_.erase(version);
    }
  }
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
  const std::vector<WatchedFile> files = files_;  // An edit may add files.
  for (const WatchedFile& changed : files) {
    const auto known = versions_.find(changed.file);
    if (known == versions_.end() || !looked_at.insert(changed.file).second) continue;
    Version& version = known->second;
    const std::optional<std::string> text = TakeChange(changed.file, version, told);
    if (!text) continue;
    std::vector<Diagnostic> problems =
        changed.is_rules ? VetRuleFile(*text, changed.file) : CheckScriptText(*text, changed.file.string());
    const bool is_refused = HasError(problems), is_emptied = IsEmptied(version.text, *text);
    if (!IsWhole(changed, version, *text, is_refused || is_emptied)) {
      version.time = {};  // Check again.
      continue;
    }
    if (is_emptied) {
      told.push_back(EditNews(Severity::kWarning, changed.file, "this file is empty: nothing was changed",
                              std::string(kKeepsRunning) + "; leave a comment in it to remove everything"));
      continue;
    }
    told.insert(told.end(), std::make_move_iterator(problems.begin()), std::make_move_iterator(problems.end()));
    // The next valid version is compared with the running version, not with the refused one.
    if (is_refused) {
      told.push_back(EditNews(Severity::kNote, changed.file, std::string("nothing was changed; ") + kKeepsRunning));
      continue;
    }
    for (const WatchedFile& file : files)
      if (file.file == changed.file) SubmitEdit(simulation_, file, version.text, *text, RulesElsewhere(file));
    if (changed.is_rules) edited_.push_back({changed.agent, ChangedRules(version.text, *text), simulation_.tick()});
    const std::string before = std::exchange(version.text, *text);
    version.earlier.emplace_back(simulation_.tick(), before);
    told.push_back(EditNews(Severity::kNote, changed.file, "reloaded"));
    if (!changed.is_rules) continue;
    TellOtherCommands(changed.file, before, *text, told);
    FollowSources(changed, before, *text, told);
  }
  return told;
}

}  // namespace soarbox::sim
