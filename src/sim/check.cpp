// SPDX-License-Identifier: BSD-2-Clause
#include "sim/check.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <system_error>

#include "diagnostics/plain_text.h"
#include "diagnostics/read_text.h"
#include "script/check_names.h"
#include "script/check_syntax.h"
#include "sim/reasons.h"
#include "sim/rule_slips.h"
#include "sim/scenario_file.h"
#include "sim/soar_host.h"
#include "sim/vocabulary.h"
#include "sml_Client.h"

namespace soarbox::sim {
namespace {

namespace fs = std::filesystem;

Diagnostic Problem(const fs::path& file, std::string message, std::string hint = {}) {
  Diagnostic problem;
  problem.file = file.string();
  problem.message = std::move(message);
  problem.hint = std::move(hint);
  return problem;
}

std::string LineOf(const std::string& text, int number) {
  std::istringstream in(text);
  std::string line;
  while (number-- > 0 && std::getline(in, line)) {
  }
  return line;
}

/// Where a rule's body holds a word after ^ or a dot.
struct Place {
  int line = 0, column = 0;
  std::string excerpt;
};
Place FindInRule(const std::string& text, const std::string& rule, const std::string& word, bool is_attribute) {
  Place place;
  std::size_t begin = 0;
  for (std::size_t at = text.find(rule); at != std::string::npos; at = text.find(rule, at + 1)) {
    const std::size_t end = at + rule.size();
    const bool whole = end >= text.size() || std::isspace(static_cast<unsigned char>(text[end])) != 0;
    if (at > 0 && whole && (text[at - 1] == '{' || std::isspace(static_cast<unsigned char>(text[at - 1])) != 0)) {
      begin = at;
      break;
    }
  }
  std::size_t found = begin;
  const auto is_name = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' || c == '*';
  };
  for (std::size_t at = text.find(word, begin); at != std::string::npos; at = text.find(word, at + 1)) {
    const char before = at > 0 ? text[at - 1] : ' ';
    const char after = at + word.size() < text.size() ? text[at + word.size()] : ' ';
    if (is_name(after) || (is_attribute ? before != '^' && before != '.' : is_name(before))) continue;
    found = at;
    break;
  }
  place.line = 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(found), '\n'));
  const std::size_t line_begin =
      text.rfind('\n', found) == std::string::npos || found == 0 ? 0 : text.rfind('\n', found - 1) + 1;
  const std::size_t start = text.rfind('\n', found == 0 ? 0 : found - 1) == std::string::npos ? 0 : line_begin;
  place.column = static_cast<int>(found - start) + 1;
  place.excerpt = text.substr(start, std::min(text.find('\n', start), text.size()) - start);
  return place;
}

Diagnostic Warn(const fs::path& file, const std::string& text, const std::string& rule, const std::string& word,
                bool is_attribute, std::string message, std::string hint) {
  Diagnostic warning = Problem(file, std::move(message), std::move(hint));
  warning.severity = Severity::kWarning;
  const Place place = FindInRule(text, rule, word, is_attribute);
  warning.line = place.line;
  warning.column = place.column;
  warning.excerpt = place.excerpt;
  warning.excerpt_length = static_cast<int>(word.size());
  return warning;
}

/// What stands around a file of rules: words in Lua scripts beside it may be percepts and commands of their own.
struct Surroundings {
  std::set<std::string> lua_words;
  std::set<std::string> made_by_rules;  ///< By all rules of the same folder: messages carry attributes.
  bool has_lua_body = false;
};

std::set<std::string> WordsOf(const std::string& text) {
  std::set<std::string> words;
  std::string word;
  for (const char c : text + " ") {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-') {
      word += c;
    } else if (!word.empty()) {
      words.insert(std::exchange(word, {}));
    }
  }
  return words;
}

class Checker {
 public:
  std::vector<Diagnostic> problems;

  void Check(const fs::path& file) {
    std::error_code error;
    if (fs::is_directory(file, error)) return CheckFolder(file);
    if (!fs::is_regular_file(file, error)) {
      problems.push_back(Problem(file, "there is no such file",
                                 "name files of rules (.soar), scripts (.lua), scenarios (.toml) or folders"));
    } else if (const std::string why = WhyNoPlainText(ReadText(file).value_or("")); !why.empty()) {
      problems.push_back(Problem(file, why));
    } else if (file.extension() == ".soar") {
      CheckRules(file);
    } else if (file.extension() == ".lua") {
      CheckLua(file);
    } else if (file.extension() == ".toml") {
      CheckScenario(file);
    } else {
      problems.push_back(
          Problem(file, "this is no file of rules, script or scenario", "they end in .soar, .lua and .toml"));
    }
  }

 private:
  void CheckFolder(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
      const fs::path extension = it->path().extension();
      if (extension == ".soar" || extension == ".lua" || extension == ".toml") files.push_back(it->path());
    }
    std::sort(files.begin(), files.end());
    if (files.empty()) problems.push_back(Problem(folder, "this folder holds no rules, scripts or scenarios"));
    for (const fs::path& file : files) Check(file);
  }

  void CheckScenario(const fs::path& file) {
    const ScenarioFile read = ParseScenarioFile(ReadText(file).value_or(""), file, problems);
    for (const ScenarioFile::Agent& agent : read.agents) {
      if (agent.rules.empty() || agent.rules == kGivenRules) continue;
      const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
      if (!FindInFolders(agent.rules, {folder}).empty()) continue;
      problems.push_back(
          Problem(file, "there are no rules '" + agent.rules + "' beside this scenario", "check the name"));
      problems.back().line = agent.line;
    }
  }

  void CheckLua(const fs::path& file) {
    const std::string text = ReadText(file).value_or("");
    if (const auto error = script::CheckSyntax(text, file.string())) {
      problems.push_back(*error);
      if (error->line > 0) problems.back().excerpt = LineOf(text, error->line);
      return;
    }
    const std::vector<Diagnostic> slips = script::CheckNames(text, file.string());
    problems.insert(problems.end(), slips.begin(), slips.end());
  }

  const Surroundings& Around(const fs::path& folder) {
    const auto [at, is_new] = around_.try_emplace(folder);
    if (!is_new) return at->second;
    std::error_code error;
    std::vector<fs::path> files;
    for (fs::directory_iterator it(folder.empty() ? fs::path(".") : folder, error), end; !error && it != end;
         it.increment(error))
      files.push_back(it->path());
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) {
      if (file.extension() == ".lua") {
        const std::string text = ReadText(file).value_or("");
        at->second.has_lua_body |= text.find("Agent_Update") != std::string::npos;
        const std::set<std::string> words = WordsOf(text);
        at->second.lua_words.insert(words.begin(), words.end());
      } else if (file.extension() == ".soar") {
        // Attributes that right-hand sides make are found rule by rule; this only knows that a word follows a ^.
        const std::string text = BlankComments(ReadText(file).value_or(""));
        for (std::size_t arrow = text.find("-->"); arrow != std::string::npos; arrow = text.find("-->", arrow + 3)) {
          const std::size_t end = std::min(text.find("\nsp", arrow), text.size());
          const std::string side = text.substr(arrow, end - arrow);
          for (std::size_t i = side.find('^'); i != std::string::npos; i = side.find('^', i + 1)) {
            const std::size_t stop = std::min(side.find_first_of(" \t\n()", i), side.size());
            at->second.made_by_rules.insert(side.substr(i + 1, stop - i - 1));
          }
        }
      }
    }
    return at->second;
  }

  void CheckRules(const fs::path& file) {
    if (host_ == nullptr) {
      Result<std::unique_ptr<SoarHost>> made = SoarHost::Create({});
      if (!made) return problems.push_back(made.error());
      host_ = std::move(*made);
    }
    Result<SoarHost::Loaded> loaded = host_->CreateAgent("check-" + std::to_string(++count_), file);
    if (!loaded) return problems.push_back(loaded.error());
    problems.insert(problems.end(), loaded->problems.begin(), loaded->problems.end());
    MindReasons reasons(*loaded->agent);
    const bool complete = std::none_of(loaded->problems.begin(), loaded->problems.end(),
                                       [](const Diagnostic& problem) { return problem.severity == Severity::kError; });
    Lint(file, BlankComments(ReadText(file).value_or("")), reasons.rules(), complete);
  }

  void Lint(const fs::path& file, const std::string& text, const std::vector<RuleText>& rules, bool complete) {
    const Surroundings& around = Around(file.parent_path());
    FindDuplicates(file, text);
    const KnownWords known{around.made_by_rules, around.lua_words, complete};
    for (const auto& slips : {FindSlipsOfForm(rules), FindSlipsOfMeaning(rules, known)}) {
      for (const Slip& slip : slips) {
        if (text.find(slip.rule) == std::string::npos) continue;  // From a file that this one sources.
        const std::string& word = slip.word.empty() ? slip.rule : slip.word;
        problems.push_back(Warn(file, text, slip.rule, word, slip.is_attribute, slip.message, slip.hint));
      }
    }
  }

  /// A rule's name that stands twice in a file: the later one takes the place of the earlier.
  void FindDuplicates(const fs::path& file, const std::string& text) {
    std::map<std::string, int> lines;
    int number = 0;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
      ++number;
      std::istringstream words(line);
      std::string begin, name;
      words >> begin;
      if (begin == "sp" && words >> name && name.starts_with('{')) {
        if (name == "{") words >> name;
        while (name.starts_with('{')) name.erase(0, 1);
      } else if (begin.starts_with("sp{")) {
        name = begin.substr(3);
      }
      name = name.substr(0, name.find('('));
      if (name.empty()) continue;
      const auto [at, is_new] = lines.try_emplace(name, number);
      if (is_new) continue;
      Diagnostic warning = Problem(
          file, "rule " + name + " stands in line " + std::to_string(at->second) + " already: this one takes its place",
          "give each rule a name of its own");
      warning.severity = Severity::kWarning;
      warning.line = number;
      warning.column = static_cast<int>(line.find(name)) + 1;
      warning.excerpt = line;
      warning.excerpt_length = static_cast<int>(name.size());
      problems.push_back(std::move(warning));
    }
  }

  std::unique_ptr<SoarHost> host_;
  int count_ = 0;
  std::map<fs::path, Surroundings> around_;
};

}  // namespace

std::vector<Diagnostic> CheckRuleText(const std::string& text, const std::string& name) {
  Result<std::unique_ptr<SoarHost>> host = SoarHost::Create({});
  if (!host) return {host.error()};
  // Kernels tell lines of files only.
  static std::atomic<int> number = 0;
  std::error_code error;
  const fs::path file = fs::temp_directory_path(error) /
                        ("soarbox-" + std::to_string(getpid()) + "-" + std::to_string(++number) + ".soar");
  if (!(std::ofstream(file, std::ios::binary) << text).flush())
    return {Problem(file, "this file cannot be written, so that the rules cannot be checked")};
  Result<SoarHost::Loaded> loaded = (*host)->CreateAgent("check", file);
  fs::remove(file, error);
  std::vector<Diagnostic> problems = loaded ? std::move(loaded->problems) : std::vector<Diagnostic>{loaded.error()};
  for (Diagnostic& problem : problems) problem.file = name;
  return problems;
}

std::vector<Diagnostic> CheckScriptText(const std::string& text, const std::string& name) {
  if (const auto problem = script::CheckSyntax(text, name)) return {*problem};
  return {};
}

std::vector<Diagnostic> CheckFiles(const std::vector<fs::path>& files) {
  Checker checker;
  for (const fs::path& file : files) checker.Check(file);
  // Files that source each other are read more than once.
  std::vector<Diagnostic> distinct;
  std::set<std::string> told;
  for (Diagnostic& problem : checker.problems)
    if (told.insert(Format(problem)).second) distinct.push_back(std::move(problem));
  return distinct;
}

}  // namespace soarbox::sim
