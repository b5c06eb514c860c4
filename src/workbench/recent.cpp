// SPDX-License-Identifier: BSD-2-Clause
#include "workbench/recent.h"

#include <algorithm>
#include <fstream>
#include <system_error>

#include "workbench/drafts.h"

namespace soarbox::workbench {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMostRecent = 12;

/// Next to the drafts; empty if there is no home directory.
fs::path ListFile() {
  const fs::path drafts = Drafts::Folder();
  return drafts.empty() ? fs::path() : drafts.parent_path() / "recent.txt";
}

std::vector<std::string> ReadList() {
  std::vector<std::string> list;
  std::ifstream in(ListFile());
  for (std::string line; std::getline(in, line) && list.size() < kMostRecent;)
    if (!line.empty()) list.push_back(line);
  return list;
}

}  // namespace

std::vector<std::string> RecentRuns() {
  std::vector<std::string> list = ReadList();
  std::error_code error;
  // Names of scenarios that come with the program are not paths.
  std::erase_if(list, [&](const std::string& what) { return what.starts_with('/') && !fs::exists(what, error); });
  return list;
}

void NoteRecentRun(const std::string& what) {
  const fs::path file = ListFile();
  if (file.empty() || what.empty()) return;
  std::error_code error;
  std::string name = what;
  if (fs::exists(what, error)) name = fs::weakly_canonical(fs::absolute(what, error), error).string();
  std::vector<std::string> list = ReadList();
  std::erase(list, name);
  list.insert(list.begin(), name);
  if (list.size() > kMostRecent) list.resize(kMostRecent);
  fs::create_directories(file.parent_path(), error);
  const fs::path half = fs::path(file).concat(".new");
  {
    std::ofstream out(half, std::ios::trunc);
    for (const std::string& line : list) out << line << '\n';
    if (!out.flush()) return;  // The only loss is an entry in a menu.
  }
  fs::rename(half, file, error);
}

}  // namespace soarbox::workbench
