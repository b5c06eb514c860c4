// SPDX-License-Identifier: BSD-2-Clause
#include "app/data_folders.h"

#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <vector>

#include "diagnostics/problem.h"

namespace soarbox::app {
namespace fs = std::filesystem;
namespace {

bool IsWithin(const fs::path& file, const fs::path& folder) {
  std::error_code error;
  const fs::path real = fs::weakly_canonical(folder, error);
  const fs::path relative = file.lexically_relative(real);
  return !error && !relative.empty() && *relative.begin() != "..";
}

}  // namespace

Result<sim::DataFolders> FindDataFolders() {
  std::vector<fs::path> places;
  std::error_code error;
  if (const char* named = std::getenv("SOARBOX_DATA"); named != nullptr && *named != '\0') {
    places.emplace_back(named);
  } else {
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    if (error) {
      // Without /proc the program cannot find its own path; its package installs the folders here.
      places.emplace_back("/usr/share/soarbox");
    } else {
      places.push_back(program.parent_path().parent_path() / "share" / "soarbox");
    }
    // Only a program that was not installed uses the source tree.
    if (IsWithin(program, SOARBOX_BUILD_DIR)) places.emplace_back(SOARBOX_SOURCE_DIR);
  }
  for (const fs::path& place : places) {
    if (fs::is_directory(place / "media", error) && fs::is_directory(place / "scenarios", error)) {
      return sim::DataFolders{place / "scenarios", place / "media"};
    }
  }
  std::string message = "the program's scenarios and media are not in";
  for (const fs::path& place : places) message += " " + place.string();
  return NewProblem(std::move(message), "set SOARBOX_DATA to the folder that holds scenarios/ and media/");
}

fs::path PageFolder(const sim::DataFolders& data) {
  const fs::path root = data.scenarios.parent_path();
  std::error_code error;
  // In the source tree, npm builds it in this folder.
  return fs::is_directory(root / "web", error) ? root / "web" / "dist" / "page" : root / "page";
}

}  // namespace soarbox::app
