// SPDX-License-Identifier: BSD-2-Clause
#include "sim/scenario.h"

#include <algorithm>
#include <cctype>
#include <system_error>

namespace soarbox::sim {
namespace fs = std::filesystem;
namespace {

constexpr const char* kSandboxScript = "Sandbox.lua";

bool IsFile(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

bool IsFolder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

bool EqualIgnoringCase(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

/// Names of the entries of a folder in a stable order; empty if it cannot be read.
std::vector<fs::path> Entries(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    entries.push_back(it->path());
  std::sort(entries.begin(), entries.end());
  return entries;
}

Diagnostic NotFound(std::string_view argument, const DataFolders& data) {
  Diagnostic problem;
  problem.message = "there is no scenario '" + std::string(argument) + "': neither a folder with " + kSandboxScript +
                    ", nor a Lua file, nor a scenario that comes with the program";
  const std::vector<std::string> names = ListScenarios(data);
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  if (const std::string_view near = Suggest(argument, candidates); !near.empty()) {
    problem.hint = "did you mean '" + std::string(near) + "'?";
  } else if (!names.empty()) {
    problem.hint = "there are:";
    for (const std::string& name : names) problem.hint += " " + name;
  }
  return problem;
}

}  // namespace

fs::path FindInFolders(std::string_view name, const std::vector<fs::path>& folders) {
  const fs::path wanted(name);
  if (wanted.is_absolute()) return IsFile(wanted) ? wanted : fs::path{};
  for (const fs::path& folder : folders) {
    if (IsFile(folder / wanted)) return folder / wanted;
    const fs::path parent = (folder / wanted).parent_path();
    for (const fs::path& entry : Entries(parent)) {
      if (EqualIgnoringCase(entry.filename().string(), wanted.filename().string()) && IsFile(entry)) return entry;
    }
  }
  return {};
}

std::vector<std::string> ListScenarios(const DataFolders& data) {
  std::vector<std::string> names;
  for (const fs::path& entry : Entries(data.scenarios)) {
    if (IsFile(entry / kSandboxScript)) names.push_back(entry.filename().string());
  }
  return names;
}

Result<Scenario> FindScenario(std::string_view argument, const DataFolders& data, const std::vector<fs::path>& extra) {
  Scenario scenario;
  const fs::path given(argument);
  const fs::path builtin = data.scenarios / given;
  if (argument.empty()) {
    return NotFound(argument, data);
  } else if (IsFile(given)) {
    scenario.script = given;
  } else if (IsFile(given / kSandboxScript)) {
    scenario.script = given / kSandboxScript;
  } else if (IsFolder(given) && given.has_parent_path()) {
    Diagnostic problem;
    problem.file = given.string();
    problem.message = std::string("this folder holds no ") + kSandboxScript + ", the script that sets up a world";
    problem.hint = "name the folder of a scenario or its Lua file; --path adds folders for scripts and rules";
    return problem;
  } else if (given.is_relative() && IsFile(builtin / kSandboxScript)) {
    scenario.script = builtin / kSandboxScript;
  } else if (given.is_relative() && IsFile(builtin)) {
    scenario.script = builtin;
  } else {
    return NotFound(argument, data);
  }

  const fs::path own = scenario.script.has_parent_path() ? scenario.script.parent_path() : fs::path(".");
  std::error_code error;
  const fs::path canonical = fs::canonical(own, error);
  scenario.name = (error ? own : canonical).filename().string();
  if (scenario.script.filename() != kSandboxScript) scenario.name += "/" + scenario.script.stem().string();
  scenario.script_folders = {own};
  scenario.script_folders.insert(scenario.script_folders.end(), extra.begin(), extra.end());
  scenario.rule_folders = scenario.script_folders;
  // What a scenario does not have itself comes from the Lua library, and agents and rules from the thesis' world.
  scenario.script_folders.push_back(data.media / "scripts");
  const fs::path fallback = data.scenarios / "thesis";
  if (!fs::equivalent(own, fallback, error)) {
    scenario.script_folders.push_back(fallback);
    scenario.rule_folders.push_back(fallback);
  }
  return scenario;
}

}  // namespace soarbox::sim
