// SPDX-License-Identifier: BSD-2-Clause
#include "app/data_folders.h"

#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <vector>

namespace soarbox::app {
namespace fs = std::filesystem;

Result<sim::DataFolders> FindDataFolders() {
  std::vector<fs::path> places;
  std::error_code error;
  if (const char* named = std::getenv("SOARBOX_DATA"); named != nullptr && *named != '\0') {
    places.emplace_back(named);
  } else {
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    if (!error) places.push_back(program.parent_path().parent_path() / "share" / "soarbox");
    places.emplace_back(SOARBOX_SOURCE_DIR);
  }
  for (const fs::path& place : places) {
    if (fs::is_directory(place / "media", error) && fs::is_directory(place / "scenarios", error)) {
      return sim::DataFolders{place / "scenarios", place / "media"};
    }
  }
  Diagnostic problem;
  problem.message = "the program's scenarios and media are not in";
  for (const fs::path& place : places) problem.message += " " + place.string();
  problem.hint = "set SOARBOX_DATA to the folder that holds scenarios/ and media/";
  return problem;
}

}  // namespace soarbox::app
