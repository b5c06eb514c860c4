// SPDX-License-Identifier: BSD-2-Clause
#include "sim/check.h"

#include <stdlib.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <system_error>

#include "diagnostics/plain_text.h"
#include "diagnostics/problem.h"
#include "diagnostics/read_text.h"
#include "explain/odd_characters.h"
#include "explain/reasons.h"
#include "explain/rule_slips.h"
#include "explain/rule_surroundings.h"
#include "script/check_names.h"
#include "script/check_syntax.h"
#include "script/lua_hints.h"
#include "sim/live_edits.h"
#include "sim/scenario_file.h"
#include "sim/soar_host.h"
#include "sim/sourced_files.h"
#include "sml_Client.h"
#include "vocabulary/vocabulary.h"

namespace soarbox::sim {
namespace {

namespace fs = std::filesystem;

/// What may have been meant by a file of rules that is not there.
std::string HintForRules(const std::string& name, const fs::path& folder) {
  std::vector<std::string> files;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
    if (at->path().extension() == ".soar") files.push_back(at->path().filename().string());
  std::sort(files.begin(), files.end());
  const std::string_view near = Suggest(name, {files.begin(), files.end()});
  if (!near.empty()) return "did you mean '" + std::string(near) + "'?";
  if (files.size() == 1) return "there is " + files.front();
  return "check the name";
}

std::string LineOf(const std::string& text, int number) {
  std::istringstream in(text);
  std::string line;
  while (number-- > 0 && std::getline(in, line)) {
  }
  return line;
}

SoarSettings LookingOver(const std::vector<fs::path>& folders) {
  SoarSettings settings;
  settings.folders = folders;
  settings.rules_only = true;
  settings.threads = 1;
  return settings;
}

/// The folder of the scenario that a file belongs to, if it lies in one or in a folder below; else its own folder.
fs::path ScenarioFolderOf(const fs::path& file) {
  constexpr int kDeepest = 4;
  std::error_code error;
  const fs::path own = fs::absolute(file, error).lexically_normal().parent_path();
  fs::path folder = own;
  for (int i = 0; i < kDeepest && folder.has_relative_path(); ++i, folder = folder.parent_path()) {
    for (const char* name : {"scenario.toml", "Sandbox.lua"})
      if (fs::exists(folder / name, error)) return folder;
  }
  return own;
}

class Checker {
 public:
  std::vector<Diagnostic> problems;

  /// `given`: what is to be looked over. Nothing outside of these folders, and of those that the files lie in, is read.
  Checker(const std::vector<fs::path>& given, const CheckToml& check_toml) : check_toml_(check_toml) {
    std::error_code error;
    for (const fs::path& path : given) {
      if (fs::is_directory(path, error)) {
        folders_.push_back(path);
        continue;
      }
      folders_.push_back(ScenarioFolderOf(path));
      if (const fs::path target = fs::canonical(path, error); !error) folders_.push_back(target.parent_path());
    }
  }

  void Check(const fs::path& file) {
    std::error_code error;
    if (fs::is_directory(file, error)) return CheckFolder(file);
    if (fs::exists(file, error) && !fs::is_regular_file(file, error)) {
      problems.push_back(ProblemIn(file, "this is no plain file", "pipes and devices are not read"));
    } else if (!fs::is_regular_file(file, error)) {
      problems.push_back(ProblemIn(file, "there is no such file",
                                   "name files of rules (.soar), scripts (.lua), scenarios (.toml) or folders"));
    } else if (const std::string why = WhyNoPlainText(ReadText(file).value_or("")); !why.empty()) {
      problems.push_back(ProblemIn(file, why));
    } else if (file.extension() == ".soar") {
      CheckRules(file);
    } else if (file.extension() == ".lua") {
      CheckLua(file);
    } else if (file.extension() == ".toml") {
      CheckScenario(file);
    } else {
      problems.push_back(
          ProblemIn(file, "this is no file of rules, script or scenario", "they end in .soar, .lua and .toml"));
    }
  }

  explain::KnownWords WordsFor(const fs::path& file, bool complete) {
    const explain::Surroundings& around = Around(file.parent_path());
    explain::KnownWords words{around.made_by_rules, around.lua_words, PlacesBeside(file.parent_path()),
                              around.has_database, complete};
    words.made_values = around.made_values;
    words.own_world = games_.contains(file.parent_path());
    words.scene = scene_kinds_;
    return words;
  }

 private:
  void CheckFolder(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
      const fs::path extension = it->path().extension();
      if (extension != ".soar" && extension != ".lua" && extension != ".toml") continue;
      if (it->is_symlink(error) && it->exists(error) && !it->is_directory(error) &&
          !IsPlainFileBelow(it->path(), folders_)) {
        problems.push_back(ProblemIn(it->path(), "this link leads out of the folder", "what it leads to is not read"));
      } else {
        files.push_back(it->path());
      }
    }
    std::sort(files.begin(), files.end());
    if (files.empty()) problems.push_back(ProblemIn(folder, "this folder holds no rules, scripts or scenarios"));
    for (const fs::path& file : files) Check(file);
  }

  void CheckScenario(const fs::path& file) {
    if (check_toml_ && !check_toml_(file, problems)) return;
    const ScenarioFile read = ParseScenarioFile(ReadText(file).value_or(""), file, problems);
    for (const ScenarioFile::Agent& agent : read.agents) {
      if (agent.rules.empty() || agent.rules == kGivenRules) continue;
      const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
      if (!FindInFolders(agent.rules, {folder}).empty()) continue;
      problems.push_back(ProblemIn(file, "there are no rules '" + agent.rules + "' beside this scenario",
                                   HintForRules(agent.rules, folder)));
      problems.back().line = agent.line_of_rules;
    }
    if (std::ranges::any_of(problems, [&](const Diagnostic& one) { return one.file == file.string(); })) return;
    if (!read.has_exercise && read.agents.empty()) {
      problems.push_back(ProblemIn(file, "this scenario has no agents",
                                   "add one: [[agent]], and below it name = \"scout\" and rules = \"scout.soar\""));
      problems.back().severity = Severity::kWarning;
      problems.back().line = 1;
    }
    std::map<std::string, int> lines;
    for (const ScenarioFile::Agent& agent : read.agents) {
      const auto [first, is_new] = lines.try_emplace(agent.name, agent.line);
      if (is_new || agent.name.empty()) continue;
      problems.push_back(
          ProblemIn(file, "there is another agent named '" + agent.name + "' in line " + std::to_string(first->second),
                    "give each its own name, or write count = 2: this one is called " + agent.name + "-2"));
      problems.back().severity = Severity::kWarning;
      problems.back().line = agent.line;
    }
  }

  void CheckLua(const fs::path& file) {
    const std::string text = ReadText(file).value_or("");
    if (const auto error = script::CheckSyntax(text, file.string())) {
      problems.push_back(*error);
      if (error->line > 0) problems.back().excerpt = LineOf(text, error->line);
      problems.back().hint = script::HintForLua(error->message, problems.back().excerpt);
      return;
    }
    const std::vector<Diagnostic> slips = script::CheckNames(text, file.string());
    problems.insert(problems.end(), slips.begin(), slips.end());
  }

  const explain::Surroundings& Around(const fs::path& folder) {
    const auto [at, is_new] = around_.try_emplace(folder);
    if (is_new) at->second = explain::LookAround(folder, folders_);
    return at->second;
  }

  /// Of the scenario files in a folder, or in the one above; a script beside them may make further places.
  const explain::KnownPlaces& PlacesBeside(const fs::path& folder) {
    const auto [at, is_new] = places_.try_emplace(folder);
    if (!is_new) return at->second;
    std::error_code error;
    for (const fs::path& looked : {folder.empty() ? fs::path(".") : folder, folder / ".."}) {
      bool has_script = false, has_faulty = false;
      for (fs::directory_iterator it(looked, error), end; !error && it != end; it.increment(error)) {
        has_script |= it->path().extension() == ".lua";
        if (it->path().extension() != ".toml" || !IsPlainFileBelow(it->path(), folders_)) continue;
        std::vector<Diagnostic> ignored;
        const ScenarioFile read = ParseScenarioFile(ReadText(it->path()).value_or(""), it->path(), ignored);
        for (const Waypoint& waypoint : read.waypoints) at->second.waypoints.insert(waypoint.name);
        for (const Region& region : read.regions) at->second.regions.insert(region.name);
        at->second.is_known = true;
        if (std::ranges::any_of(read.agents, [](const auto& agent) { return agent.options.contains("by"); }))
          games_.insert(folder);
        has_faulty |= !ignored.empty();
      }
      if (has_script || has_faulty) at->second = {};
      if (has_script || at->second.is_known) break;
    }
    return at->second;
  }

  void CheckRules(const fs::path& file) {
    if (host_ == nullptr) {
      Result<std::unique_ptr<SoarHost>> made = SoarHost::Create(LookingOver(folders_));
      if (!made) return problems.push_back(made.error());
      host_ = std::move(*made);
    }
    Result<SoarHost::Loaded> loaded = host_->CreateAgent("check-" + std::to_string(++count_), file);
    if (!loaded) return problems.push_back(loaded.error());
    problems.insert(problems.end(), loaded->problems.begin(), loaded->problems.end());
    explain::MindReasons reasons(*loaded->agent);
    const bool complete = std::none_of(loaded->problems.begin(), loaded->problems.end(),
                                       [](const Diagnostic& problem) { return problem.severity == Severity::kError; });
    if (scene_kinds_.commands.empty() && explain::MentionsScenes(reasons.rules()))
      scene_kinds_ = explain::ReadSceneKinds(loaded->agent->ExecuteCommandLine("svs commands all"));
    Lint(file, explain::BlankComments(ReadText(file).value_or("")), reasons.rules(), complete);
  }

  void Lint(const fs::path& file, const std::string& text, const std::vector<explain::RuleText>& rules, bool complete) {
    std::vector<explain::RuleFile> files = {{file, text}};
    for (const fs::path& one : WithSourcedFiles(file, folders_))
      if (one != file) files.push_back({one, explain::BlankComments(ReadText(one).value_or(""))});
    for (Diagnostic& twice : explain::FindDuplicates(files)) problems.push_back(std::move(twice));
    std::set<std::string> loaded;
    for (const explain::RuleText& rule : rules) loaded.insert(rule.name);
    for (auto& [rule, warning] : explain::FindOddCharacters({file, text}))
      if (loaded.contains(rule)) problems.push_back(std::move(warning));
    for (const explain::Slip& slip : explain::FindSlips(rules, WordsFor(file, complete))) {
      if (text.find(slip.rule) == std::string::npos) continue;  // From a file that this one sources.
      problems.push_back(explain::PlaceSlip(slip, file, text));
    }
  }

  const CheckToml& check_toml_;
  std::vector<fs::path> folders_;
  std::unique_ptr<SoarHost> host_;
  int count_ = 0;
  explain::SceneKinds scene_kinds_;  ///< Once a file mentions scenes.
  std::map<fs::path, explain::Surroundings> around_;
  std::map<fs::path, explain::KnownPlaces> places_;
  std::set<fs::path> games_;  ///< Folders of rules for agents that a world's script serves.
};

}  // namespace

std::vector<Diagnostic> CheckRuleText(const std::string& text, const std::string& name) {
  // Kernels tell lines of files only.
  std::error_code error;
  std::string folder = (fs::temp_directory_path(error) / "soarbox-check-XXXXXX").string();
  if (mkdtemp(folder.data()) == nullptr)
    return {ProblemIn(folder, "this folder cannot be made, so that the rules cannot be checked")};
  const fs::path file = fs::path(folder) / "rules.soar";
  Result<std::unique_ptr<SoarHost>> host = SoarHost::Create(LookingOver({folder}));
  if (!host) return {host.error()};
  if (!(std::ofstream(file, std::ios::binary) << text).flush())
    return {ProblemIn(file, "this file cannot be written, so that the rules cannot be checked")};
  Result<SoarHost::Loaded> loaded = (*host)->CreateAgent("check", file);
  fs::remove_all(folder, error);
  std::vector<Diagnostic> problems = loaded ? std::move(loaded->problems) : std::vector<Diagnostic>{loaded.error()};
  for (Diagnostic& problem : problems) problem.file = name;
  return problems;
}

std::vector<Diagnostic> WarningsOfRules(const fs::path& rules, const std::vector<fs::path>& folders) {
  Result<std::unique_ptr<SoarHost>> host = SoarHost::Create(LookingOver(folders));
  if (!host) return {};
  Result<SoarHost::Loaded> loaded = (*host)->CreateAgent("check", rules);
  if (!loaded) return {};
  std::erase_if(loaded->problems, [](const Diagnostic& problem) { return problem.severity != Severity::kWarning; });
  return std::move(loaded->problems);
}

explain::KnownWords WordsAround(const fs::path& rules) {
  const CheckToml no_missions;
  return Checker({rules}, no_missions).WordsFor(rules, true);
}

std::vector<Diagnostic> CheckScriptText(const std::string& text, const std::string& name) {
  if (const auto problem = script::CheckSyntax(text, name)) return {*problem};
  return {};
}

std::vector<Diagnostic> CheckFiles(const std::vector<fs::path>& files, const CheckToml& check_toml) {
  Checker checker(files, check_toml);
  for (const fs::path& file : files) checker.Check(file);
  // Files that source each other are read more than once.
  std::vector<Diagnostic> distinct;
  std::set<std::string> told;
  for (Diagnostic& problem : checker.problems)
    if (told.insert(Format(problem)).second) distinct.push_back(std::move(problem));
  return distinct;
}

}  // namespace soarbox::sim
