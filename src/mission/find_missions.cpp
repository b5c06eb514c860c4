// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "diagnostics/problem.h"
#include "diagnostics/read_text.h"
#include "mission/read_mission.h"
#include "mission/scenario_names.h"
#include "mission/testing.h"
#include "sim/scenario_file.h"

namespace soarbox::mission {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestFile = 4u << 20;  ///< Limit for missions, as for scenarios.

bool IsFile(const fs::path& file) {
  std::error_code error;
  return fs::is_regular_file(file, error);
}

/// Whether a .toml file has checks and is not a sweep.
bool HasChecks(const fs::path& file) {
  std::error_code error;
  if (fs::file_size(file, error) > kLargestFile || error) return false;
  const std::string text = ReadText(file).value_or("");
  return (IsMissionText(text) || HasLine(text, "[[check]]")) && !IsSweepText(text);
}

/// Parses the scenario file that the mission's scenario is read from. Ignores its errors.
sim::ScenarioFile ReadDefinition(const fs::path& definition) {
  std::vector<Diagnostic> others;
  return sim::ParseScenarioFile(ReadText(definition).value_or(""), definition, others);
}

}  // namespace

fs::path StateFolder(std::string_view what) {
  fs::path state;
  if (const char* folder = std::getenv("XDG_STATE_HOME"); folder != nullptr && *folder != '\0') {
    state = folder;
  } else if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0') {
    state = fs::path(home) / ".local" / "state";
  } else {
    return {};
  }
  return state / "soarbox" / what;
}

std::vector<fs::path> FindMissionFiles(const fs::path& path, const sim::DataFolders& data) {
  std::error_code error;
  if (IsFile(path)) return {path};
  fs::path folder = path;
  if (!fs::is_directory(folder, error)) {
    folder = data.scenarios / path;
    if (!path.is_relative() || !fs::is_directory(folder, error)) return {};
  }
  std::vector<fs::path> files;
  const auto options = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator it(folder, options, error), end; !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    if (it->is_directory(error) && (name.starts_with('.') || name == "build" || name.ends_with(".sweep"))) {
      it.disable_recursion_pending();
    } else if (name.ends_with(".toml") && IsFile(it->path()) && HasChecks(it->path())) {
      files.push_back(it->path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

fs::path MissionFileOf(const sim::Scenario& scenario) {
  if (scenario.definition.empty()) return {};
  if (HasChecks(scenario.definition)) return scenario.definition;
  const fs::path beside = scenario.definition.parent_path() / "mission.toml";
  return IsFile(beside) && HasChecks(beside) ? beside : fs::path();
}

LoadedMission LoadMission(const fs::path& file, const sim::DataFolders& data, std::vector<Diagnostic>& problems) {
  LoadedMission loaded;
  const auto refused = [&](std::string message, std::string hint = {}, int line = 0) {
    problems.push_back(ProblemIn(file, std::move(message), std::move(hint)));
    problems.back().line = line;
    return std::move(loaded);
  };
  const std::optional<std::string> text = ReadText(file);
  if (!text) return refused("this mission cannot be read");
  if (IsSweepText(*text))
    return refused("this is a sweep, not a mission", "soarbox sweep " + file.string() + " runs it");
  const std::size_t before = problems.size();
  const bool is_mission = IsMissionText(*text);
  loaded.mission = ParseMission(*text, file, !is_mission, problems);
  Mission& mission = loaded.mission;
  if (problems.size() > before) return loaded;
  std::error_code error;
  if (mission.checks.empty()) return refused("nothing is checked here", "write [[check]] tables: docs/missions.md");
  if (!is_mission) mission.scenario = file.string();
  fs::path beside = file.parent_path() / mission.scenario;
  if (mission.scenario == ".") beside = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (is_mission && fs::exists(beside, error)) mission.scenario = beside.lexically_normal().string();
  Result<sim::Scenario> scenario = sim::FindScenario(mission.scenario, data);
  if (!scenario) return refused(scenario.error().message, scenario.error().hint, mission.scenario_line);
  loaded.scenario = std::move(*scenario);
  const bool is_plain = file.filename() == "mission.toml" || file.filename() == "scenario.toml";
  mission.name =
      (is_plain ? fs::absolute(file, error).lexically_normal().parent_path().filename() : file.stem()).string();
  if (!loaded.scenario.definition.empty()) {
    const sim::ScenarioFile definition = ReadDefinition(loaded.scenario.definition);
    if (loaded.scenario.rules.empty()) CheckNames(mission, CastOf(definition), problems);
    loaded.seconds = definition.seconds.value_or(60);
    if (mission.seeds.empty() && definition.seed) mission.seeds = {*definition.seed};
  }
  loaded.seconds = mission.seconds.value_or(loaded.seconds);
  CheckTimes(mission, loaded.seconds, problems);
  return loaded;
}

}  // namespace soarbox::mission
