// SPDX-License-Identifier: BSD-2-Clause
#include "sim/sourced_files.h"

#include <algorithm>
#include <sstream>
#include <string>
#include <system_error>

#include "diagnostics/read_text.h"
#include "explain/rule_text.h"
#include "sim/scenario.h"

namespace soarbox::sim {
namespace {

namespace fs = std::filesystem;

bool MayBeRead(const fs::path& file, std::span<const fs::path> readable) {
  std::error_code error;
  return readable.empty() ? fs::is_regular_file(file, error) : IsPlainFileBelow(file, readable);
}

void AddSourced(const fs::path& file, std::span<const fs::path> readable, std::set<fs::path>& found) {
  constexpr std::size_t kMostFiles = 500;
  if (found.size() >= kMostFiles || !found.insert(file).second) return;
  std::istringstream lines(explain::BlankComments(ReadText(file).value_or("")));
  for (std::string line; std::getline(lines, line);) {
    const std::string name = NameSourcedBy(line);
    if (name.empty()) continue;
    // A file names its neighbours by their own names, wherever it is sourced from.
    const fs::path sourced = file.parent_path() / name;
    if (MayBeRead(sourced, readable)) AddSourced(sourced, readable, found);
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

std::set<fs::path> WithSourcedFiles(const fs::path& rules, std::span<const fs::path> readable) {
  std::set<fs::path> found;
  AddSourced(rules, readable, found);
  return found;
}

std::vector<fs::path> ReadableRuleFolders(const Scenario& scenario) {
  if (scenario.rule_folders.empty()) return {};
  // The rules that come with the program are read as well: agents whose scenario names none get them.
  std::vector<fs::path> folders = scenario.rule_folders;
  folders.insert(folders.end(), scenario.fallback_rule_folders.begin(), scenario.fallback_rule_folders.end());
  return folders;
}

}  // namespace soarbox::sim
