// SPDX-License-Identifier: BSD-2-Clause
#include "sim/scenario.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <system_error>

#include "diagnostics/problem.h"
#include "sim/client_world.h"
#include "sim/scenario_file.h"

namespace soarbox::sim {
namespace fs = std::filesystem;
namespace {

constexpr const char* kSandboxScript = "Sandbox.lua";
constexpr const char* kScenarioFile = "scenario.toml";
/// The world of a scenario without a script, and of a scenario that is only rules; in media/.
constexpr const char* kPlainWorld = "scripts/SoarWorld.lua";
constexpr const char* kRulesWorld = "worlds/field.toml";

bool IsFile(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

bool IsFolder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

/// Whether a file, after resolving links, is below a folder.
bool IsBelow(const fs::path& path, const fs::path& folder) {
  std::error_code error;
  const fs::path inside = fs::canonical(path, error);
  if (error) return false;
  const fs::path above = fs::canonical(folder, error);
  return !error && std::mismatch(above.begin(), above.end(), inside.begin(), inside.end()).first == above.end();
}

bool EqualIgnoringCase(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

/// The entries of a folder, sorted by name; empty if it cannot be read.
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
  problem.message = "there is no scenario '" + std::string(argument) + "': neither a folder with " + kScenarioFile +
                    " or " + kSandboxScript +
                    ", nor a scenario, Lua or rules file, nor a scenario that comes with the program";
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

const fs::path* Scenario::ReplacementFor(std::string_view agent) const {
  constexpr std::string_view kFirst = "-1";
  for (const auto& [name, file] : replaced_rules)
    if (name == agent) return &file;
  if (!agent.ends_with(kFirst)) return nullptr;
  for (const auto& [name, file] : replaced_rules)
    if (name == agent.substr(0, agent.size() - kFirst.size())) return &file;
  return nullptr;
}

fs::path Scenario::Original(const fs::path& file) const {
  for (const auto& [stand_in, original] : stand_ins) {
    const auto [at, rest] = std::mismatch(stand_in.begin(), stand_in.end(), file.begin(), file.end());
    if (at != stand_in.end()) continue;
    fs::path path = original;
    for (auto part = rest; part != file.end(); ++part) path /= *part;
    return path;
  }
  return file;
}

fs::path FindInFolders(std::string_view name, const std::vector<fs::path>& folders) {
  const fs::path wanted(name);
  if (wanted.is_absolute() || std::find(wanted.begin(), wanted.end(), "..") != wanted.end()) return {};
  for (const fs::path& folder : folders) {
    if (IsFile(folder / wanted)) return IsBelow(folder / wanted, folder) ? folder / wanted : fs::path{};
    const fs::path parent = (folder / wanted).parent_path();
    for (const fs::path& entry : Entries(parent)) {
      if (EqualIgnoringCase(entry.filename().string(), wanted.filename().string()) && IsFile(entry))
        return IsBelow(entry, folder) ? entry : fs::path{};
    }
  }
  return {};
}

std::vector<std::string> ListScenarios(const DataFolders& data) {
  std::vector<std::string> names;
  for (const fs::path& entry : Entries(data.scenarios)) {
    if (IsFile(entry / kScenarioFile) || IsFile(entry / kSandboxScript)) names.push_back(entry.filename().string());
  }
  return names;
}

std::string DescribeScenario(const std::string& name, const DataFolders& data) {
  const fs::path folder = data.scenarios / name;
  if (IsFile(folder / kScenarioFile)) {
    Result<ScenarioFile> file = ReadScenarioFile(folder / kScenarioFile);
    return file ? file->description : "(faulty: " + file.error().message + ")";
  }
  // The first sentence of the comment at the beginning of the script, which can have several lines.
  std::ifstream script(folder / kSandboxScript);
  std::string about;
  for (std::string line; std::getline(script, line) && line.starts_with("--");) {
    const std::size_t begin = line.find_first_not_of("- ");
    if (begin == std::string::npos) break;
    if (line.find("SPDX") != std::string::npos) continue;
    about += (about.empty() ? "" : " ") + line.substr(begin);
    if (const std::size_t end = about.find(". "); end != std::string::npos) return about.substr(0, end + 1);
  }
  return about;
}

namespace {

/// Whether a .toml file names a scenario and is therefore not a scenario itself, like missions and sweeps.
bool NamesScenario(const fs::path& file) {
  std::error_code error;
  if (constexpr std::uintmax_t kMostBytes = 4u << 20; fs::file_size(file, error) > kMostBytes || error) return false;
  std::ifstream text(file);
  for (std::string line; std::getline(text, line);) {
    const std::size_t begin = line.find_first_not_of(" \t");
    if (begin == std::string::npos) continue;
    if (line[begin] == '[') return false;  // Top-level keys come before the first table.
    const std::size_t end = std::min(line.find_first_of(" \t=", begin), line.size());
    const std::string_view key = std::string_view(line).substr(begin, end - begin);
    if (key == "scenario" || key == "mission") return true;
  }
  return false;
}

/// Whether a script belongs to an agent: it defines an agent's functions and none of a sandbox, and loads no file that
/// may define them.
bool IsScriptOfAgent(const fs::path& file) {
  std::error_code error;
  if (constexpr std::uintmax_t kMostBytes = 4u << 20; fs::file_size(file, error) > kMostBytes || error) return false;
  std::ifstream text(file);
  bool is_agents = false;
  for (std::string line; std::getline(text, line);) {
    const std::string_view code = std::string_view(line).substr(0, line.find("--"));
    for (const char* word : {"Sandbox_", "require", "dofile", "loadfile"})
      if (code.find(word) != std::string_view::npos) return false;
    for (const char* name : {"Agent_Initialize", "Agent_Update"})
      is_agents = is_agents || code.find(name) != std::string_view::npos;
  }
  return is_agents;
}

/// The file that an argument refers to; empty if there is none.
fs::path FindMain(const fs::path& given, const DataFolders& data) {
  if (given == kClientWorld) return data.media / "worlds" / kClientWorld / kScenarioFile;
  for (const fs::path& place : {given, data.scenarios / given}) {
    if (given.is_absolute() && place != given) break;
    if (IsFile(place)) return place;
    for (const char* main : {kScenarioFile, kSandboxScript}) {
      if (IsFile(place / main)) return place / main;
    }
    // The extension can be omitted: "scout" for scout.soar.
    for (const char* ending : {".toml", ".soar"}) {
      fs::path file = place;
      file += ending;
      if (IsFile(file) && (file.extension() != ".toml" || !NamesScenario(file))) return file;
    }
    // A folder with a path of several parts is not the name of a scenario that comes with the program.
    if (IsFolder(given) && given.has_parent_path()) break;
  }
  return {};
}

}  // namespace

namespace {

/// A hint that names runnable files in a folder that is not a scenario.
std::string HintForFolder(const fs::path& folder) {
  std::string scenarios, rules;
  for (const fs::path& entry : Entries(folder)) {
    const std::string name = entry.filename().string();
    for (const char* main : {kScenarioFile, kSandboxScript})
      if (EqualIgnoringCase(name, main)) return "rename " + name + " to " + main;
    if (IsFile(entry / kScenarioFile) || IsFile(entry / kSandboxScript))
      scenarios += (scenarios.empty() ? "" : ", ") + entry.string();
    if (entry.extension() == ".soar" && rules.empty()) rules = entry.string();
  }
  if (!scenarios.empty()) return "there are scenarios in it: " + scenarios;
  if (!rules.empty()) return "soarbox run " + rules + " runs these rules in a world that comes with the program";
  return "name the folder of a scenario or its file; --path adds folders for scripts and rules";
}

/// The script that a scenario file names for its world; empty if there is none, or if the file has errors, which are
/// reported when it is read.
fs::path ScriptNamedIn(const fs::path& definition) {
  if (definition.empty()) return {};
  const Result<ScenarioFile> read = ReadScenarioFile(definition);
  return read ? fs::path(read->script) : fs::path();
}

}  // namespace

Result<Scenario> FindScenario(std::string_view argument, const DataFolders& data, const std::vector<fs::path>& extra) {
  Scenario scenario;
  const fs::path given(argument);
  if (argument.empty()) return NotFound(argument, data);
  const fs::path main = FindMain(given, data);
  if (main.empty() && IsFolder(given) && given.has_parent_path()) {
    return ProblemIn(given.string(),
                     std::string("this folder holds neither ") + kScenarioFile + " nor " + kSandboxScript,
                     HintForFolder(given));
  }
  if (main.empty()) return NotFound(argument, data);

  const fs::path kind = main.extension();
  if (kind != ".toml" && kind != ".soar" && kind != ".lua") {
    return ProblemIn(main.string(), "this is not a file of rules, script or scenario",
                     "they end in .soar, .lua and .toml");
  }

  if (kind == ".lua" && main.filename() != kSandboxScript && IsScriptOfAgent(main)) {
    Diagnostic problem;
    problem.file = main.string();
    problem.message = "this is the script of an agent, not of a world: it has no Sandbox_Initialize";
    problem.hint =
        "write a Sandbox.lua beside it that makes the agent: function Sandbox_Initialize(sandbox) "
        "Sandbox.CreateAgent(sandbox, \"" +
        main.filename().string() + "\"); end";
    return problem;
  }

  const fs::path own = main.has_parent_path() ? main.parent_path() : fs::path(".");
  std::error_code error;
  const fs::path canonical = fs::canonical(own, error);
  scenario.name = (error ? own : canonical).filename().string();
  if (main.filename() != kSandboxScript && main.filename() != kScenarioFile)
    scenario.name += "/" + main.stem().string();
  scenario.script_folders = {own};
  scenario.script_folders.insert(scenario.script_folders.end(), extra.begin(), extra.end());
  scenario.rule_folders = scenario.script_folders;
  scenario.script = main;
  if (main.extension() == ".toml") {
    scenario.definition = main;
    scenario.script = data.media / kPlainWorld;
  } else if (main.extension() == ".soar") {
    scenario.rules = main;
    scenario.definition = data.media / kRulesWorld;
    scenario.script = data.media / kPlainWorld;
  }
  const fs::path named_script = ScriptNamedIn(scenario.definition);
  // Scripts that the scenario does not have come from the Lua library; agents and rules come from the thesis' world.
  scenario.script_folders.push_back(data.media / "scripts");
  const fs::path fallback = data.scenarios / "thesis";
  if (!fs::equivalent(own, fallback, error)) {
    scenario.script_folders.push_back(fallback);
    scenario.fallback_rule_folders.push_back(fallback);
  }
  if (!named_script.empty()) {
    scenario.script = FindInFolders(named_script.string(), scenario.script_folders);
    if (scenario.script.empty())
      return ProblemIn(main.string(), "there is no script '" + named_script.string() + "'",
                       "'script' names a Lua file in the scenario's folder, or one of the Lua library");
  }
  return scenario;
}

}  // namespace soarbox::sim
