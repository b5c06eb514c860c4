// SPDX-License-Identifier: BSD-2-Clause
#include "sim/sourced_files.h"

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
    std::istringstream words(line);
    std::string command, name;
    if (!(words >> command >> name) || command != "source") continue;
    if (name.size() > 1 && name.front() == '"') name = name.substr(1, name.size() - 2);
    // A file names its neighbours by their own names, wherever it is sourced from.
    const fs::path sourced = file.parent_path() / name;
    if (MayBeRead(sourced, readable)) AddSourced(sourced, readable, found);
  }
}

}  // namespace

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
