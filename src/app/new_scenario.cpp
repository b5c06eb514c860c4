// SPDX-License-Identifier: BSD-2-Clause
#include "app/new_scenario.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "app/data_folders.h"
#include "app/exit_codes.h"
#include "app/lesson.h"
#include "app/refuse.h"
#include "diagnostics/problem.h"
#include "diagnostics/read_text.h"
#include "diagnostics/result.h"

namespace soarbox::app {
namespace {

namespace fs = std::filesystem;

bool IsGoodName(const std::string& name) {
  return !name.empty() && name.size() <= 60 && std::isalpha(static_cast<unsigned char>(name[0])) != 0 &&
         std::all_of(name.begin(), name.end(),
                     [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; });
}

/// Some systems do not distinguish capital letters in names of files.
bool IsSameOnAnySystem(const std::string& a, const std::string& b) {
  return std::ranges::equal(
      a, b, {}, [](unsigned char c) { return std::tolower(c); }, [](unsigned char c) { return std::tolower(c); });
}

/// A scenario that is copied, and the name in its files that the new scenario's name replaces.
struct Starter {
  fs::path folder;
  std::string name;

  std::string Renamed(std::string text, const std::string& to) const {
    for (std::size_t at = 0; (at = text.find(name, at)) != std::string::npos; at += to.size())
      text.replace(at, name.size(), to);
    return text;
  }
};

Starter StarterFor(const NewOptions& options, const sim::DataFolders& data) {
  if (options.lua) return {data.media / "starters" / "stroller", "stroller"};
  if (options.team) return {data.media / "starters" / "two_teams", "two_teams"};
  // This lesson begins with the same files.
  return {ShippedLessons(data) / "24-own-world", "keeper"};
}

/// A file of the new scenario.
struct NewFile {
  std::string name, text;
  std::string from;  ///< Its name in the starter.
};

/// The starter's files for a scenario with this name; an error if one cannot be read, or if two get the same name.
Result<std::vector<NewFile>> FilesOf(const Starter& starter, const std::string& scenario) {
  std::error_code error;
  std::vector<fs::path> paths;
  for (fs::directory_iterator it(starter.folder, error), end; !error && it != end; it.increment(error))
    if (it->is_regular_file(error) && it->path().filename() != "lesson.toml") paths.push_back(it->path());
  if (error) return ProblemIn(starter.folder.string(), "this folder cannot be read: " + error.message());
  std::ranges::sort(paths);
  std::vector<NewFile> files;
  for (const fs::path& path : paths) {
    const std::optional<std::string> text = ReadText(path);
    if (!text) return ProblemIn(path.string(), "this file cannot be read");
    const std::string from = path.filename().string();
    NewFile file{starter.Renamed(from, scenario), starter.Renamed(*text, scenario), from};
    for (const NewFile& other : files)
      if (IsSameOnAnySystem(other.name, file.name))
        return NewProblem("'" + scenario + "' cannot be the scenario's name: its files '" + other.from + "' and '" +
                              file.from + "' would both become '" + file.name + "'",
                          "choose another name");
    files.push_back(std::move(file));
  }
  return files;
}

/// Prints the next commands. SOARBOX_CALLED_AS is the command by which the program was called.
void TellNextSteps(const fs::path& folder) {
  const char* called = std::getenv("SOARBOX_CALLED_AS");
  const std::string command = called != nullptr && *called != '\0' ? called : "soarbox";
  std::cout << "\nrun it:   " << command << " run " << folder.string() << "\ncheck it: " << command << " check "
            << folder.string() << "\ntest it:  " << command << " test " << folder.string() << '\n';
}

}  // namespace

int NewScenario(const NewOptions& options) {
  const fs::path folder(options.name);
  const std::string name = folder.filename().string();
  if (!IsGoodName(name))
    return Refuse("'" + name + "' is not a name for a scenario",
                  "use letters, digits, - and _, and begin with a letter");
  const Result<sim::DataFolders> data = FindDataFolders();
  if (!data) return Refuse(data.error());
  std::error_code error;
  if (fs::exists(folder, error)) return Refuse("this is there already", "choose another name", folder.string());
  // Everything is read before anything is written, so that a refusal leaves no folder.
  const Result<std::vector<NewFile>> files = FilesOf(StarterFor(options, *data), name);
  if (!files) return Refuse(files.error());
  fs::create_directories(folder, error);
  if (error) return Refuse("this folder cannot be made: " + error.message(), "check the path", folder.string());
  for (const NewFile& file : *files) {
    const fs::path path = folder / file.name;
    std::ofstream out(path, std::ios::binary);
    out << file.text;
    out.close();
    if (!out) return Refuse("this file cannot be written", "check that the folder may be written to", path.string());
    std::cout << path.string() << '\n';
  }
  TellNextSteps(folder);
  return kOk;
}

}  // namespace soarbox::app
