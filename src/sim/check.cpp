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
#include "sim/game_rules.h"
#include "sim/live_edits.h"
#include "sim/scenario_file.h"
#include "sim/soar_host.h"
#include "sim/source_graph.h"
#include "sim/sourced_files.h"
#include "sml_Client.h"
#include "vocabulary/vocabulary.h"

namespace soarbox::sim {
namespace {

namespace fs = std::filesystem;

/// A hint with a similar name for a file of rules that does not exist.
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

/// The folder of the scenario that contains a file, directly or in a subfolder; empty if there is none.
fs::path ScenarioFolderOf(const fs::path& file) {
  constexpr int kDeepest = 4;
  std::error_code error;
  fs::path folder = fs::absolute(file, error).lexically_normal().parent_path();
  for (int i = 0; i < kDeepest && folder.has_relative_path(); ++i, folder = folder.parent_path()) {
    for (const char* name : {"scenario.toml", "Sandbox.lua", "mission.toml"})
      if (fs::exists(folder / name, error)) return folder;
  }
  return {};
}

/// A key that is the same for all paths of a file.
fs::path KeyOf(const fs::path& file) {
  std::error_code error;
  fs::path key = fs::canonical(file, error);
  return error ? fs::absolute(file, error).lexically_normal() : key;
}

/// The names of the rules that begin in a text: "sp {name".
std::set<std::string, std::less<>> NamesOfRules(std::string_view text) {
  std::set<std::string, std::less<>> names;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string_view line = text.substr(at, end - at);
    at = end + 1;
    line.remove_prefix(std::min(line.find_first_not_of(" \t;"), line.size()));
    if (!line.starts_with("sp") && !line.starts_with("gp")) continue;
    const std::size_t brace = line.find_first_not_of(" \t", 2);
    if (brace == std::string_view::npos || line[brace] != '{') continue;
    // The name can be on the next line.
    const std::size_t begin =
        text.find_first_not_of(" \t\r\n", static_cast<std::size_t>(line.data() - text.data()) + brace + 1);
    if (begin != std::string_view::npos)
      names.emplace(text.substr(begin, text.find_first_of(" \t\r\n(", begin) - begin));
  }
  return names;
}

class Checker {
 public:
  std::vector<Diagnostic> problems;
  fs::path library;  ///< Folder of modules that scripts load from the program; empty: not known.

  /// `given`: the paths to check. Files of scenarios and of folders can read only files in them. A file of rules that
  /// the user names and that belongs to no scenario is the user's own: it can source what the user may read.
  Checker(const std::vector<fs::path>& given, const CheckToml& check_toml) : check_toml_(check_toml) {
    std::error_code error;
    for (const fs::path& path : given) {
      if (fs::is_directory(path, error)) {
        folders_.push_back(path);
        continue;
      }
      const fs::path scenario = ScenarioFolderOf(path);
      folders_.push_back(scenario.empty() ? fs::absolute(path, error).lexically_normal().parent_path() : scenario);
      if (const fs::path target = fs::canonical(path, error); !error) folders_.push_back(target.parent_path());
    }
  }

  void Check(const fs::path& file) {
    std::error_code error;
    if (fs::is_directory(file, error)) return CheckFolder(file);
    if (fs::exists(file, error) && !fs::is_regular_file(file, error)) {
      problems.push_back(ProblemIn(file, "this is not a plain file", "pipes and devices are not read"));
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
          ProblemIn(file, "this is not a file of rules, script or scenario", "they end in .soar, .lua and .toml"));
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
    // Files of a folder can read only within it. Each file is checked as part of the programs that load it.
    SourceGraph graph;
    for (const fs::path& file : files)
      if (file.extension() == ".soar" && IsPlainFileBelow(file, folders_))
        graph.Add(KeyOf(file), ReadText(file).value_or(""));
    for (const fs::path& file : files)
      if (file.extension() == ".soar") names_[KeyOf(file)] = file;
    const Look before = std::exchange(look_, Look{&graph, false});
    for (const fs::path& file : files) Check(file);
    look_ = before;
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
    std::vector<Diagnostic> slips = script::CheckNames(text, file.string());
    problems.insert(problems.end(), slips.begin(), slips.end());
    script::GlobalNames known;
    if (!FindGlobals(file, text, known)) return;
    slips = script::CheckCalls(text, file.string(), known);
    problems.insert(problems.end(), slips.begin(), slips.end());
  }

  /// Collects the globals of all scripts that may run in the same machine: those of its folder, those of the scenario's
  /// folder, and the modules that they load. Returns false if a module was not found, because the globals are then not
  /// known.
  bool FindGlobals(const fs::path& file, const std::string& text, script::GlobalNames& known) const {
    constexpr std::size_t kMostScripts = 500;
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    const fs::path scenario = ScenarioFolderOf(file);
    std::vector<fs::path> folders = {folder};
    if (!scenario.empty()) folders.push_back(scenario);
    std::set<fs::path> read;
    std::vector<std::string> texts = {text};
    std::error_code error;
    for (const fs::path& one : folders)
      for (fs::directory_iterator at(one, error), end; !error && at != end; at.increment(error))
        if (at->path().extension() == ".lua" && read.size() < kMostScripts && IsPlainFileBelow(at->path(), folders) &&
            read.insert(KeyOf(at->path())).second)
          texts.push_back(ReadText(at->path()).value_or(""));
    if (!library.empty()) folders.push_back(library);
    for (std::size_t i = 0; i < texts.size(); ++i) {
      script::AddGlobalsOf(texts[i], known);
      for (const std::string& module : script::ModulesOf(texts[i])) {
        const fs::path found = FindInFolders(module + ".lua", folders);
        if (found.empty()) return false;
        if (read.size() < kMostScripts && read.insert(KeyOf(found)).second)
          texts.push_back(ReadText(found).value_or(""));
      }
    }
    return true;
  }

  const explain::Surroundings& Around(const fs::path& folder) {
    const auto [at, is_new] = around_.try_emplace(folder);
    if (is_new) at->second = explain::LookAround(folder, folders_);
    return at->second;
  }

  /// Of the scenario files in a folder or the one above. A script there may add further places.
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

  /// A problem in a program of rules. A program is a file that no other file sources, with all files that it sources.
  struct Found {
    fs::path file;  ///< Key of the file.
    Diagnostic problem;
  };
  struct CheckedProgram {
    fs::path root;
    std::set<fs::path> files;     ///< Keys of the files.
    std::vector<Found> problems;  ///< Errors and warnings of the kernel, duplicates and odd characters.
    std::vector<Found> slips;     ///< Slips that need all rules of the program.
  };
  /// What is being checked.
  struct Look {
    const SourceGraph* graph = nullptr;  ///< Graph of the named folder; null if a file was named.
    bool is_own = false;                 ///< The user's rights apply, without a fence.
  };

  /// Checks a file as part of the programs that load it. A slip is reported only if all of these programs have it,
  /// because another program may contain what one program lacks.
  void CheckRules(const fs::path& file) {
    constexpr std::size_t kMostPrograms = 4;
    const fs::path key = KeyOf(file);
    names_.try_emplace(key, file);
    Look look = look_;
    SourceGraph around;
    if (look.graph == nullptr) {
      look.is_own = ScenarioFolderOf(file).empty();
      around = GraphBelow(FolderOfProgram(key), Readable(look));
      if (!around.Contains(key)) around.Add(key, ReadText(file).value_or(""));
      look.graph = &around;
    }
    std::vector<const CheckedProgram*> programs;
    for (const fs::path& root : look.graph->RootsOf(key)) {
      if (programs.size() == kMostPrograms) break;
      const CheckedProgram& program = ProgramFrom(names_.contains(root) ? names_[root] : root, root, look);
      if (program.files.contains(key)) programs.push_back(&program);
    }
    if (programs.empty()) programs.push_back(&ProgramFrom(file, key, look));
    // For a folder, each file reports its own problems. For a named file, problems of all files that it loads are
    // reported.
    std::set<fs::path> told = {key};
    if (look_.graph == nullptr) told = look.graph->ReachedFrom(key);
    for (const CheckedProgram* program : programs) {
      // Problems that belong to no file of the program are reported with its root.
      const auto is_told = [&](const Found& found) {
        return told.contains(found.file) || (program->root == key && !program->files.contains(found.file));
      };
      for (const Found& found : program->problems)
        if (is_told(found)) problems.push_back(found.problem);
      for (const Found& slip : program->slips) {
        const auto has_it = [&](const CheckedProgram* other) {
          return !other->files.contains(slip.file) || std::ranges::any_of(other->slips, [&](const Found& same) {
            return same.file == slip.file && same.problem.line == slip.problem.line &&
                   same.problem.message == slip.problem.message;
          });
        };
        if (is_told(slip) && std::ranges::all_of(programs, has_it)) problems.push_back(slip.problem);
      }
    }
  }

  std::vector<fs::path> Readable(const Look& look) const { return look.is_own ? std::vector<fs::path>{"/"} : folders_; }

  /// The program with this root. Messages use `name` for it.
  const CheckedProgram& ProgramFrom(const fs::path& name, const fs::path& root, const Look& look) {
    const auto [at, is_new] = programs_.try_emplace({root, look.is_own});
    if (is_new) at->second = Load(name, look);
    return at->second;
  }

  CheckedProgram Load(const fs::path& file, const Look& look) {
    CheckedProgram program;
    program.root = KeyOf(file);
    program.files.insert(program.root);
    std::vector<Diagnostic> told;
    LoadInto(program, file, look, told);
    for (Diagnostic& problem : told) program.problems.push_back(Keyed(std::move(problem)));
    return program;
  }

  void LoadInto(CheckedProgram& program, const fs::path& file, const Look& look, std::vector<Diagnostic>& told) {
    std::unique_ptr<SoarHost>& host = look.is_own ? own_host_ : host_;
    if (host == nullptr) {
      Result<std::unique_ptr<SoarHost>> made = SoarHost::Create(LookingOver(Readable(look)));
      if (!made) return told.push_back(made.error());
      host = std::move(*made);
    }
    const std::string agent = "check-" + std::to_string(++count_);
    Result<SoarHost::Loaded> loaded = host->CreateAgent(agent, file);
    if (!loaded) return told.push_back(loaded.error());
    told = std::move(loaded->problems);
    for (Diagnostic& problem : told) problem.file = NameOf(problem.file).string();
    {
      explain::MindReasons reasons(*loaded->agent);
      const bool complete = std::none_of(
          told.begin(), told.end(), [](const Diagnostic& problem) { return problem.severity == Severity::kError; });
      if (scene_kinds_.commands.empty() && explain::MentionsScenes(reasons.rules()))
        scene_kinds_ = explain::ReadSceneKinds(loaded->agent->ExecuteCommandLine("svs commands all"));
      Lint(file, Readable(look), reasons.rules(), complete, program, told);
    }
    host->DestroyAgent(agent);
  }

  static Found Keyed(Diagnostic problem) {
    fs::path key = KeyOf(problem.file);
    return {std::move(key), std::move(problem)};
  }

  /// The path as the user wrote it, if the file was named or is in a named folder.
  fs::path NameOf(const fs::path& file) const {
    const auto known = names_.find(KeyOf(file));
    return known == names_.end() ? file : known->second;
  }

  void Lint(const fs::path& root, const std::vector<fs::path>& readable, const std::vector<explain::RuleText>& rules,
            bool complete, CheckedProgram& program, std::vector<Diagnostic>& told) {
    std::vector<explain::RuleFile> files;
    for (const fs::path& file : FilesOfProgram(root, readable)) {
      files.push_back({NameOf(file), explain::BlankComments(ReadText(file).value_or(""))});
      program.files.insert(KeyOf(file));
    }
    for (Diagnostic& twice : explain::FindDuplicates(files)) told.push_back(std::move(twice));
    std::set<std::string> loaded;
    for (const explain::RuleText& rule : rules) loaded.insert(rule.name);
    std::map<std::string, const explain::RuleFile*, std::less<>> file_of;
    for (const explain::RuleFile& file : files) {
      for (const std::string& name : NamesOfRules(file.text)) file_of[name] = &file;
      for (Diagnostic& warning : explain::FindOddCharacters(file))
        if (loaded.contains(warning.rule)) told.push_back(std::move(warning));
    }
    explain::KnownWords words = WordsFor(root, complete);
    // A file without a scenario may be for a game of the program, such as TankSoar.
    if (ScenarioFolderOf(root).empty() && AreForGame(rules, library)) words.own_world = true;
    for (const explain::Slip& slip : explain::FindSlips(rules, words)) {
      const auto file = file_of.find(slip.rule);
      if (file != file_of.end())
        program.slips.push_back(Keyed(explain::PlaceSlip(slip, file->second->file, file->second->text)));
    }
  }

  const CheckToml& check_toml_;
  std::vector<fs::path> folders_;
  std::unique_ptr<SoarHost> host_, own_host_;  ///< With the fence, and with the user's rights.
  int count_ = 0;
  Look look_;
  std::map<fs::path, fs::path> names_;                            ///< By key: paths as the user wrote them.
  std::map<std::pair<fs::path, bool>, CheckedProgram> programs_;  ///< By root and rights.
  explain::SceneKinds scene_kinds_;                               ///< Filled in when a file mentions scenes.
  std::map<fs::path, explain::Surroundings> around_;
  std::map<fs::path, explain::KnownPlaces> places_;
  std::set<fs::path> games_;  ///< Folders of rules for agents of a world with a script.
};

}  // namespace

std::vector<Diagnostic> CheckRuleText(const std::string& text, const std::string& name) {
  // Kernels report lines only for files.
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

std::vector<explain::RuleText> RulesOf(const fs::path& file) {
  Result<std::unique_ptr<SoarHost>> host = SoarHost::Create(LookingOver({file.parent_path()}));
  if (!host) return {};
  Result<SoarHost::Loaded> loaded = (*host)->CreateAgent("read", file);
  if (!loaded) return {};
  const char* printed = loaded->agent->ExecuteCommandLine("print --all --full");
  return explain::ReadRules(printed == nullptr ? "" : printed);
}

explain::KnownWords WordsAround(const fs::path& rules) {
  const CheckToml no_missions;
  return Checker({rules}, no_missions).WordsFor(rules, true);
}

std::vector<Diagnostic> CheckScriptText(const std::string& text, const std::string& name) {
  if (const auto problem = script::CheckSyntax(text, name)) return {*problem};
  return {};
}

std::vector<Diagnostic> CheckFiles(const std::vector<fs::path>& files, const CheckToml& check_toml,
                                   const fs::path& library) {
  Checker checker(files, check_toml);
  checker.library = library;
  for (const fs::path& file : files) checker.Check(file);
  // Files that source each other are read more than once.
  std::vector<Diagnostic> distinct;
  std::set<std::string> told;
  for (Diagnostic& problem : checker.problems)
    if (told.insert(Format(problem)).second) distinct.push_back(std::move(problem));
  return distinct;
}

}  // namespace soarbox::sim
