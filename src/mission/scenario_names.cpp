// SPDX-License-Identifier: BSD-2-Clause
#include "mission/scenario_names.h"

#include <toml++/toml.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <system_error>

#include "diagnostics/nearest_hint.h"
#include "diagnostics/read_text.h"
#include "mission/conditions.h"
#include "mission/read_mission.h"
#include "vocabulary/vocabulary.h"

namespace soarbox::mission {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostRuleFiles = 500;

void ReadRuleWords(const fs::path& folder, Cast& cast) {
  std::error_code error;
  std::size_t count = 0;
  for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const bool is_script = it->path().extension() == ".lua";
    if ((it->path().extension() != ".soar" && !is_script) || ++count > kMostRuleFiles) continue;
    const std::string text = ReadText(it->path()).value_or("");
    std::string word;
    bool is_rule = false;
    for (std::size_t i = 0; i <= text.size(); ++i) {
      const char c = i < text.size() ? text[i] : ' ';
      if (std::isalnum(static_cast<unsigned char>(c)) != 0 ||
          (c != '\0' && std::string_view("_-*/:!?%&$").find(c) != std::string_view::npos)) {
        word += c;
        continue;
      }
      if (!word.empty()) {
        cast.all_words.insert(word);
        if (is_script) {
          word.clear();
          continue;
        }
        if (is_rule) cast.rules.insert(word);
        is_rule = word == "sp" && (c == '{' || c == ' ');
        cast.rule_words.insert(std::move(word));
        word.clear();
      }
    }
  }
}

bool IsAmong(const std::vector<std::string>& list, const std::string& word) {
  return std::any_of(list.begin(), list.end(), [&](const std::string& name) { return MatchesPattern(word, name); });
}

class NameChecker {
 public:
  NameChecker(const Cast& cast, std::vector<Diagnostic>& problems) : cast_(cast), problems_(problems) {}

  void Look(const Check& check, bool takes_any_attribute = false) {
    for (const std::string& agent : check.agents) Need(check, check.line, "agent", agent, cast_.agents);
    if (!check.team.empty()) Need(check, check.line, "team", check.team, cast_.teams);
    if (!check.item.empty()) Need(check, check.line, "item", check.item, cast_.items);
    for (const Condition& condition : check.conditions) {
      for (const std::string& word : condition.words) Look(check, condition, word);
      if (!takes_any_attribute) LookAtParts(check, condition);
    }
    if (check.who == Who::kSome) CountSubjects(check);
  }

 private:
  /// Reports a check that requires more agents than it refers to. Such a check never becomes true.
  void CountSubjects(const Check& check) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < cast_.agents.size(); ++i) {
      const bool is_named = std::any_of(check.agents.begin(), check.agents.end(),
                                        [&](const std::string& name) { return MatchesPattern(name, cast_.agents[i]); });
      count += is_named || (!check.team.empty() && cast_.team_of[i] == check.team) ? 1 : 0;
    }
    if (count == 0 || static_cast<std::size_t>(check.some) <= count) return;
    Tell(check, check.line,
         "'who' asks for " + std::to_string(check.some) + " in one tick, and this check is about " +
             std::to_string(count));
  }

  /// Checks parameters, reasons and paths. Without this, a misspelt one would only make the check false.
  void LookAtParts(const Check& check, const Condition& condition) {
    if (condition.row->key == Key::kElement) {
      if (cast_.has_script) return;  // The script may add any percept.
      for (const std::string& path : condition.words) LookAtPath(check, condition, path);
      return;
    }
    std::vector<std::string> known(cast_.all_words.begin(), cast_.all_words.end());
    if (condition.row->key == Key::kCommand) {
      bool takes_place = false, is_known = true;
      for (const std::string& word : condition.words) {
        const vocabulary::CommandRow* row = vocabulary::FindCommand(word);
        is_known &= row != nullptr;
        if (row == nullptr) continue;
        for (const vocabulary::ParameterRow& parameter : row->parameters) known.emplace_back(parameter.name);
        takes_place |= row->place != vocabulary::TakesPlace::kNo;
      }
      if (takes_place || !is_known)
        for (const vocabulary::ParameterRow& parameter : vocabulary::PlaceParameters())
          known.emplace_back(parameter.name);
      if (!condition.reason.empty()) {
        std::vector<std::string> reasons = known;
        for (const vocabulary::ReasonRow& row : vocabulary::Reasons()) reasons.emplace_back(row.name);
        Need(check, condition.line, "reason", condition.reason, reasons);
      }
    }
    if (condition.row->key == Key::kMessage) known.emplace_back("to");
    if (condition.row->key == Key::kImpasse) known = {"operator"};
    for (const auto& [name, value] : condition.with) Need(check, condition.line, "attribute", name, known);
  }

  void LookAtPath(const Check& check, const Condition& condition, std::string_view path) {
    std::vector<std::string> known(cast_.all_words.begin(), cast_.all_words.end());
    for (const vocabulary::PerceptRow& row : vocabulary::Percepts()) known.emplace_back(row.Attribute());
    for (const vocabulary::CommandRow& row : vocabulary::Commands()) known.emplace_back(row.name);
    for (const char* own : {"io",     "input-link", "output-link", "reward-link", "reward",  "value",   "operator",
                            "name",   "superstate", "substate",    "smem",        "epmem",   "command", "result",
                            "status", "reason",     "type",        "success",     "failure", "svs"})
      known.emplace_back(own);
    while (true) {
      const std::size_t dot = path.find('.');
      Need(check, condition.line, "attribute", std::string(path.substr(0, dot)), known);
      if (dot == std::string_view::npos) return;
      path.remove_prefix(dot + 1);
    }
  }

  void Look(const Check& check, const Condition& condition, const std::string& word) {
    const auto need = [&](const char* what, const std::vector<std::string>& known) {
      Need(check, condition.line, what, word, known);
    };
    switch (condition.row->names) {
      case Names::kWaypoint:
        return need("waypoint", cast_.waypoints);
      case Names::kRegion:
        return need("region", cast_.regions);
      case Names::kTeam:
        return need("team", cast_.teams);
      case Names::kEnd:
        if (cast_.has_script) return;  // The script may define any end (Sandbox.End).
        return need("end or goal", cast_.ends);
      case Names::kItem:
        return need("item", cast_.items);
      case Names::kAgent:
        return need("agent", cast_.agents);
      case Names::kPlace: {
        std::vector<std::string> known = cast_.agents;
        known.insert(known.end(), cast_.items.begin(), cast_.items.end());
        known.insert(known.end(), cast_.waypoints.begin(), cast_.waypoints.end());
        return need("agent, item or waypoint", known);
      }
      case Names::kThing: {
        if (word == "any" || word == "friend" || word == "enemy") return;
        std::vector<std::string> known = cast_.agents;
        known.insert(known.end(), cast_.things.begin(), cast_.things.end());
        return need("agent or thing", known);
      }
      case Names::kImpasse:
        return need("impasse",
                    {"tie", "conflict", "constraint-failure", "state-no-change", "operator-no-change", "any"});
      case Names::kMemory:
        return need("memory", {"semantic", "episodic", "any"});
      case Names::kSeverity:
        return need("severity", {"error", "warning", "any"});
      case Names::kCommand: {
        std::vector<std::string> known(cast_.rule_words.begin(), cast_.rule_words.end());
        for (const vocabulary::CommandRow& row : vocabulary::Commands()) known.emplace_back(row.name);
        return Need(check, condition.line, "command", word, known);
      }
      case Names::kTopic:
        return Need(check, condition.line, "message in the rules about", word,
                    {cast_.all_words.begin(), cast_.all_words.end()});
      case Names::kOperator:
      case Names::kRule: {
        const bool is_rule = condition.row->names == Names::kRule;
        const std::set<std::string>& words = is_rule ? cast_.rules : cast_.rule_words;
        return Need(check, condition.line, is_rule ? "rule" : "operator in the rules", word,
                    {words.begin(), words.end()});
      }
      default:
        return;
    }
  }

  void Need(const Check& check, int line, const char* what, const std::string& word,
            const std::vector<std::string>& known) {
    if (IsAmong(known, word)) return;
    Diagnostic& problem = Tell(check, line, std::string("there is no ") + what + " '" + word + "'");
    const std::vector<std::string_view> candidates(known.begin(), known.end());
    std::string all = known.empty() ? "the scenario has none" : known.size() <= 12 ? "there are:" : "";
    for (std::size_t i = 0; known.size() <= 12 && i < known.size(); ++i) all += " " + known[i];
    problem.hint = NearestHint(word, candidates, std::move(all));
  }

  Diagnostic& Tell(const Check& check, int line, std::string message) {
    Diagnostic& problem = problems_.emplace_back();
    problem.file = check.file;
    problem.line = line;
    problem.message = std::move(message);
    return problem;
  }

  const Cast& cast_;
  std::vector<Diagnostic>& problems_;
};

}  // namespace

Cast CastOf(const sim::ScenarioFile& file) {
  Cast cast;
  for (const sim::ScenarioFile::Agent& agent : file.agents) {
    // Names agents as scenario_build.cpp does.
    std::string stem = agent.name;
    if (stem.empty()) stem = agent.rules.empty() ? "agent" : fs::path(agent.rules).stem().string();
    for (int i = 0; i < agent.count; ++i) {
      std::string name = agent.count > 1 ? stem + "-" + std::to_string(i + 1) : stem;
      for (int other = 2; std::find(cast.agents.begin(), cast.agents.end(), name) != cast.agents.end(); ++other)
        name = stem + "-" + std::to_string(other);
      cast.agents.push_back(std::move(name));
    }
    const auto team = agent.options.find("team");
    const std::string* named = team == agent.options.end() ? nullptr : std::get_if<std::string>(&team->second);
    const std::string own = named != nullptr ? *named : "team1";
    cast.team_of.resize(cast.agents.size(), own);
    if (std::find(cast.teams.begin(), cast.teams.end(), own) == cast.teams.end()) cast.teams.push_back(own);
  }
  for (const sim::ScenarioFile::Thing& thing : file.things)
    (thing.is_item ? cast.items : cast.things).push_back(thing.name);
  cast.things.insert(cast.things.end(), cast.items.begin(), cast.items.end());
  for (const sim::Waypoint& waypoint : file.waypoints) cast.waypoints.push_back(waypoint.name);
  for (const sim::Region& region : file.regions) cast.regions.push_back(region.name);
  cast.has_script = !file.script.empty();
  for (const sim::ScenarioFile::Condition& condition : file.conditions) cast.ends.push_back(condition.name);
  ReadRuleWords(file.file.has_parent_path() ? file.file.parent_path() : fs::path("."), cast);
  return cast;
}

void CheckNames(const Mission& mission, const Cast& cast, std::vector<Diagnostic>& problems) {
  NameChecker checker(cast, problems);
  for (const Check& check : mission.checks) checker.Look(check);
  // Mistakes are about wrong rules, which may make any attribute.
  for (const Check& check : mission.mistakes) checker.Look(check, true);
}

bool HasLine(std::string_view text, std::string_view begin) {
  for (std::size_t at = text.find(begin); at != std::string_view::npos; at = text.find(begin, at + 1))
    if (at == 0 || text[at - 1] == '\n') return true;
  return false;
}

bool IsSweepText(std::string_view text) {
  return HasLine(text, "[[variant]]") || HasLine(text, "[[metric]]") || HasLine(text, "[tournament]");
}

bool IsMissionText(std::string_view text) {
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    const std::size_t begin = line.find_first_not_of(" \t");
    if (begin == std::string::npos) continue;
    if (line[begin] == '[') return false;
    if (line.compare(begin, 8, "scenario") == 0) return true;
  }
  return false;
}

bool CheckMissionFile(const fs::path& file, const sim::DataFolders* data, std::vector<Diagnostic>& problems) {
  const std::string text = ReadText(file).value_or("");
  const bool is_mission = IsMissionText(text);
  std::vector<Diagnostic> found, others;
  const Mission mission = ParseMission(text, file, !is_mission, found);
  if (!is_mission && !found.empty()) {
    // Errors of TOML are reported with the scenario.
    sim::ParseScenarioFile(text, file, others);
    std::erase_if(found, [&](const Diagnostic& problem) {
      return std::ranges::any_of(others, [&](const Diagnostic& other) {
        return problem.line == other.line && problem.column == other.column && problem.message == other.message;
      });
    });
  }
  const bool is_faulty = !found.empty() || !others.empty();
  problems.insert(problems.end(), found.begin(), found.end());
  if (is_faulty || mission.checks.empty()) return !is_mission;
  fs::path scenario = file;
  if (is_mission) {
    scenario = file.parent_path() / mission.scenario;
    std::error_code error;
    if (fs::is_directory(scenario, error)) {
      scenario /= "scenario.toml";
    } else if (!fs::exists(scenario, error) && data != nullptr) {
      // A scenario that comes with the program, by its name.
      const Result<sim::Scenario> named = sim::FindScenario(mission.scenario, *data);
      if (!named) {
        Diagnostic& problem = problems.emplace_back(named.error());
        problem.file = file.string();
        problem.line = mission.scenario_line;
        return false;
      }
      scenario = named->definition;
    }
    if (scenario.extension() != ".toml" || !fs::is_regular_file(scenario, error)) return false;
  }
  const sim::ScenarioFile read = sim::ParseScenarioFile(ReadText(scenario).value_or(""), scenario, others);
  if (!others.empty()) return !is_mission;
  CheckNames(mission, CastOf(read), problems);
  CheckTimes(mission, mission.seconds.value_or(read.seconds.value_or(60)), problems);
  return !is_mission;
}

}  // namespace soarbox::mission
