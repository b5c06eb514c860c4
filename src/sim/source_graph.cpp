// SPDX-License-Identifier: BSD-2-Clause
#include "sim/source_graph.h"

#include <algorithm>
#include <optional>
#include <system_error>

#include "diagnostics/read_text.h"
#include "sim/sourced_files.h"

namespace soarbox::sim {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBlanks = " \t\r";

fs::path Normal(const fs::path& path) {
  std::error_code error;
  return fs::absolute(path, error).lexically_normal();
}

/// The word after `command`, without quotes and braces, if the line is that command; else nothing.
std::optional<std::string> WordAfter(std::string_view command, std::string_view line) {
  if (!line.starts_with(command)) return std::nullopt;
  line.remove_prefix(command.size());
  if (!line.empty() && kBlanks.find(line.front()) == std::string_view::npos && line.front() != ';') return std::nullopt;
  // NameSourcedBy parses words after its own command.
  return NameSourcedBy("source" + std::string(line));
}

/// Follows the commands of a file that change the current folder.
class Folders {
 public:
  const fs::path& current() const { return folders_.back(); }

  void Take(std::string_view line) {
    if (const auto pushed = WordAfter("pushd", line)) {
      if (!pushed->empty()) folders_.push_back(folders_.back() / *pushed);
    } else if (const auto changed = WordAfter("cd", line)) {
      if (!changed->empty()) folders_.back() /= *changed;
    } else if (WordAfter("popd", line)) {
      if (folders_.size() > 1) folders_.pop_back();
    }
  }

 private:
  std::vector<fs::path> folders_ = {""};
};

/// Parses "file x.soar" after `load`.
std::string NameLoadedBy(std::string_view line) {
  if (!line.starts_with("load")) return {};
  line.remove_prefix(4);
  const std::size_t at = line.find_first_not_of(kBlanks);
  if (at == 0 || at == std::string_view::npos) return {};
  return WordAfter("file", line.substr(at)).value_or("");
}

bool IsScenarioFolder(const fs::path& folder) {
  std::error_code error;
  return std::ranges::any_of(std::initializer_list<const char*>{"scenario.toml", "Sandbox.lua", "mission.toml"},
                             [&](const char* name) { return fs::exists(folder / name, error); });
}

/// Whether a file directly in `above` sources a file below `folder`.
bool SourcesBelow(const fs::path& above, const fs::path& folder) {
  constexpr int kMostLooked = 2'000;
  std::error_code error;
  int looked = 0;
  for (fs::directory_iterator it(above, error), end; !error && it != end && looked < kMostLooked;
       it.increment(error), ++looked) {
    if (it->path().extension() != ".soar") continue;
    for (const SourcedFile& one : SourcedIn(ReadText(it->path()).value_or(""))) {
      const fs::path target = (above / one.file).lexically_normal();
      if (std::ranges::mismatch(folder, target).in1 == folder.end()) return true;
    }
  }
  return false;
}

}  // namespace

std::vector<SourcedFile> SourcedIn(std::string_view text) {
  std::vector<SourcedFile> found;
  Folders folders;
  int number = 0;
  for (std::size_t at = 0; at < text.size();) {
    ++number;
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string_view line = text.substr(at, end - at);
    at = end + 1;
    line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
    // Most lines belong to rules.
    while (!line.empty() && (line[0] == 's' || line[0] == 'l' || line[0] == 'p' || line[0] == 'c')) {
      std::string name = NameSourcedBy(line);
      if (name.empty()) name = NameLoadedBy(line);
      if (name.empty()) {
        folders.Take(line);
      } else {
        found.push_back({name, (folders.current() / name).lexically_normal(), number});
      }
      // Further commands on the line.
      const std::size_t next = line.find(';');
      if (next == std::string_view::npos) break;
      line.remove_prefix(next + 1);
      line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
    }
  }
  return found;
}

void SourceGraph::Add(const fs::path& file, const std::vector<SourcedFile>& sourced) {
  Remove(file);
  std::set<std::string>& sources = sources_[file.native()];
  for (const SourcedFile& one : sourced) {
    const std::string target = (file.parent_path() / one.file).lexically_normal().native();
    sources.insert(target);
    sourced_by_[target].insert(file.native());
  }
}

void SourceGraph::Remove(const fs::path& file) {
  const auto known = sources_.find(file.native());
  if (known == sources_.end()) return;
  for (const std::string& target : known->second) sourced_by_[target].erase(file.native());
  sources_.erase(known);
}

std::vector<fs::path> SourceGraph::RootsOf(const fs::path& file) const {
  std::set<std::string> seen = {file.native()}, roots;
  std::vector<std::string> waiting = {file.native()};
  while (!waiting.empty()) {
    const std::string next = std::move(waiting.back());
    waiting.pop_back();
    const auto by = sourced_by_.find(next);
    if (by == sourced_by_.end() || by->second.empty()) {
      roots.insert(next);
      continue;
    }
    for (const std::string& one : by->second)
      if (seen.insert(one).second) waiting.push_back(one);
  }
  if (roots.empty()) return {file};
  return {roots.begin(), roots.end()};
}

std::set<fs::path> SourceGraph::ReachedFrom(const fs::path& file) const {
  std::set<fs::path> reached = {file};
  std::vector<std::string> waiting = {file.native()};
  while (!waiting.empty()) {
    const auto from = sources_.find(waiting.back());
    waiting.pop_back();
    if (from == sources_.end()) continue;
    for (const std::string& one : from->second)
      if (reached.insert(one).second) waiting.push_back(one);
  }
  return reached;
}

fs::path FolderOfProgram(const fs::path& file) {
  constexpr int kAbove = 4;
  const fs::path own = Normal(file).parent_path();
  fs::path at = own;
  for (int i = 0; i <= kAbove && at.has_relative_path(); ++i, at = at.parent_path())
    if (IsScenarioFolder(at)) return at;
  fs::path folder = own;
  at = own;
  for (int i = 0; i < kAbove && at.has_relative_path(); ++i) {
    at = at.parent_path();
    if (SourcesBelow(at, folder)) folder = at;
  }
  return folder;
}

FoundRules FindRulesBelow(const fs::path& folder, std::size_t most) {
  constexpr int kDeepest = 12;
  constexpr int kMostEntries = 200'000;
  FoundRules found;
  std::error_code error;
  int entries = 0;
  for (fs::recursive_directory_iterator it(Normal(folder), fs::directory_options::skip_permission_denied, error), end;
       !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    if (it.depth() >= kDeepest || name.starts_with('.') || name == "node_modules") it.disable_recursion_pending();
    if (it->path().extension() == ".soar") {
      if (found.files.size() == most) found.is_cut = true;
      if (found.files.size() < most) found.files.push_back(it->path().lexically_normal());
    }
    if (++entries > kMostEntries) found.is_cut = true;
    if (found.is_cut) break;
  }
  std::ranges::sort(found.files);
  return found;
}

SourceGraph GraphBelow(const fs::path& folder, std::span<const fs::path> readable) {
  constexpr std::size_t kMostFiles = 10'000;
  SourceGraph graph;
  for (const fs::path& file : FindRulesBelow(folder, kMostFiles).files)
    if (IsPlainFileBelow(file, readable)) graph.Add(file, ReadText(file).value_or(""));
  return graph;
}

}  // namespace soarbox::sim
