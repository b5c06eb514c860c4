// SPDX-License-Identifier: BSD-2-Clause
#include "sim/live_edits.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <set>
#include <sstream>
#include <system_error>

#include "diagnostics/read_text.h"
#include "script/check_syntax.h"
#include "script/keep_state.h"
#include "sim/rule_text.h"
#include "sim/simulation.h"

namespace soarbox::sim {
namespace {

namespace fs = std::filesystem;

/// The files that a file of rules sources, with all below them.
void AddSourced(const fs::path& file, std::set<fs::path>& found) {
  constexpr std::size_t kMostFiles = 500;
  if (found.size() >= kMostFiles || !found.insert(file).second) return;
  std::istringstream lines(BlankComments(ReadText(file).value_or("")));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string command, name;
    if (!(words >> command >> name) || command != "source") continue;
    if (name.size() > 1 && name.front() == '"') name = name.substr(1, name.size() - 2);
    std::error_code error;
    // A file names its neighbours by their own names, wherever it is sourced from.
    const fs::path sourced = file.parent_path() / name;
    if (fs::is_regular_file(sourced, error)) AddSourced(sourced, found);
  }
}

bool IsPlainFile(const fs::path& file) {
  std::error_code error;
  return fs::is_regular_file(file, error);
}

/// What is the matter with a file that cannot be read any more: "this ...".
std::string WhyUnreadable(const fs::path& file) {
  std::error_code error;
  if (fs::is_directory(file, error)) return "is a folder now";
  return IsPlainFile(file) ? "file cannot be read any more" : "is no plain file any more";
}

std::string NoteOfEarlier(const WatchedFile& file) {
  return std::string("\n   note: the ") + (file.is_rules ? "rules" : "script") + " before that stay" +
         (file.is_rules ? "\n" : "s\n");
}

}  // namespace

std::vector<WatchedFile> WithSourced(const std::vector<WatchedFile>& files) {
  std::vector<WatchedFile> all;
  for (const WatchedFile& file : files) {
    all.push_back(file);
    if (!file.is_rules) continue;
    std::set<fs::path> found;
    AddSourced(file.file, found);
    for (const fs::path& one : found)
      if (one != file.file) all.push_back({file.agent, one, true});
  }
  return all;
}

SplitText SplitRules(std::string_view given) {
  SplitText split;
  const std::string text = BlankComments(std::string(given));
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

bool LiveEdits::Edit(const WatchedFile& file, const std::string& before, const std::string& after,
                     std::vector<std::string>& told) {
  if (!file.is_rules) {
    if (const auto problem = script::CheckSyntax(after, file.file.string())) {
      told.push_back(Format(*problem) + "   note: the script before this edit stays\n");
      return false;
    }
    simulation_.Submit(ScriptInput{file.agent, script::WithKept(after, script::UnchangedVariables(before, after))});
    return true;
  }
  const SplitText now = SplitRules(after);
  if (!now.unclosed.empty()) {
    told.push_back(file.file.string() + ": error: the rule " + now.unclosed +
                   " is not closed\n   note: the rules before this edit stay\n");
    return false;
  }
  const std::vector<std::string> edits = EditsBetween(SplitRules(before), now);
  for (const std::string& edit : edits) simulation_.Submit(CommandInput{file.agent, edit});
  return !edits.empty();
}

std::vector<std::string> LiveEdits::Poll() {
  std::vector<std::string> told;
  Watch();
  std::set<fs::path> changed, failed, missing;
  std::map<fs::path, std::string> before;
  for (const WatchedFile& file : files_) {
    Version& version = versions_[file.file];
    if (!changed.contains(file.file)) {
      std::error_code error;
      const auto time = fs::last_write_time(file.file, error);
      // Editors put a new file in the place of the old one: a moment without any is nothing to tell.
      if (!error) version.missed = 0;
      if (error && missing.insert(file.file).second && ++version.missed == 2)
        told.push_back(file.file.string() + ": warning: this file is gone" + NoteOfEarlier(file));
      if (error || time == version.time) continue;
      version.time = time;
      std::optional<std::string> text = IsPlainFile(file.file) ? ReadText(file.file) : std::nullopt;
      if (!text)
        told.push_back(file.file.string() + ": warning: this " + WhyUnreadable(file.file) + NoteOfEarlier(file));
      if (!text || *text == version.text) continue;
      before[file.file] = std::exchange(version.text, std::move(*text));
      version.earlier.emplace_back(simulation_.tick(), before[file.file]);
      changed.insert(file.file);
    }
    if (failed.contains(file.file)) continue;
    if (!Edit(file, before[file.file], version.text, told)) {
      failed.insert(file.file);
      // The next good version is compared with what runs, not with what never did.
      if (!told.empty()) {
        version.text = before[file.file];
        version.earlier.pop_back();
      }
    }
  }
  for (const fs::path& file : changed)
    if (!failed.contains(file))
      told.push_back("soarbox: " + file.string() + " was edited; the world goes on with it\n");
  return told;
}

}  // namespace soarbox::sim
