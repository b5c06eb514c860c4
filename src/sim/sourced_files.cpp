// SPDX-License-Identifier: BSD-2-Clause
#include "sim/sourced_files.h"

#include <algorithm>
#include <string>
#include <system_error>

#include "diagnostics/read_text.h"
#include "explain/rule_text.h"
#include "sim/scenario.h"
#include "sim/source_graph.h"

namespace soarbox::sim {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFiles = 10'000;

bool MayBeRead(const fs::path& file, std::span<const fs::path> readable) {
  std::error_code error;
  return readable.empty() ? fs::is_regular_file(file, error) : IsPlainFileBelow(file, readable);
}

void AddSourced(const fs::path& file, std::span<const fs::path> readable, std::vector<fs::path>& found,
                std::set<fs::path>& known) {
  if (found.size() >= kMostFiles || !known.insert(file.lexically_normal()).second) return;
  found.push_back(file);
  // Paths in a file are relative to its folder, whichever file sources it.
  for (const SourcedFile& one : SourcedIn(explain::BlankComments(ReadText(file).value_or("")))) {
    const fs::path sourced = file.parent_path() / one.file;
    if (MayBeRead(sourced, readable)) AddSourced(sourced, readable, found, known);
  }
}

}  // namespace

std::string NameSourcedBy(std::string_view line) {
  constexpr std::string_view kSource = "source", kBlanks = " \t\r";
  line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
  if (!line.starts_with(kSource)) return {};
  line.remove_prefix(kSource.size());
  const std::size_t begin = line.find_first_not_of(kBlanks);
  if (begin == 0 || begin == std::string_view::npos) return {};
  line.remove_prefix(begin);
  const char closing = line.front() == '"' ? '"' : line.front() == '{' ? '}' : '\0';
  if (closing == '\0') return std::string(line.substr(0, line.find_first_of(" \t\r;")));
  const std::size_t end = line.rfind(closing);
  return end == 0 || end == std::string_view::npos ? std::string() : std::string(line.substr(1, end - 1));
}

std::vector<fs::path> FilesOfProgram(const fs::path& rules, std::span<const fs::path> readable) {
  std::vector<fs::path> found;
  std::set<fs::path> known;
  AddSourced(rules, readable, found, known);
  return found;
}

std::set<fs::path> WithSourcedFiles(const fs::path& rules, std::span<const fs::path> readable) {
  const std::vector<fs::path> files = FilesOfProgram(rules, readable);
  return {files.begin(), files.end()};
}

std::vector<fs::path> ReadableRuleFolders(const Scenario& scenario) {
  if (scenario.rule_folders.empty()) return {};
  // The rules that come with the program can also be read, because agents without named rules use them.
  std::vector<fs::path> folders = scenario.rule_folders;
  folders.insert(folders.end(), scenario.fallback_rule_folders.begin(), scenario.fallback_rule_folders.end());
  return folders;
}

}  // namespace soarbox::sim
