// SPDX-License-Identifier: BSD-2-Clause
#include "app/lesson.h"

#include <toml++/toml.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

#include "app/run_session.h"
#include "diagnostics/nearest_hint.h"
#include "diagnostics/problem.h"
#include "diagnostics/read_text.h"
#include "explain/rule_text.h"
#include "mission/check_sentences.h"
#include "mission/conditions.h"
#include "mission/read_mission.h"
#include "mission/scenario_names.h"
#include "sim/check.h"
#include "sim/scenario_file.h"
#include "sim/table_reader.h"
#include "workbench/panel_id.h"

namespace soarbox::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kUsualSeeds = 10;

/// Replaces {time}, {was}, {what} and {agent} in a hint by the values of the run.
std::string Filled(std::string hint, const mission::Verdict& verdict) {
  const auto put = [&hint](std::string_view mark, const std::string& text) {
    for (std::size_t at = hint.find(mark); at != std::string::npos; at = hint.find(mark, at + text.size()))
      hint.replace(at, mark.size(), text);
  };
  put("{time}", mission::SecondsText(verdict.time_s));
  put("{was}", verdict.was);
  constexpr std::string_view kItWas = "it was ";
  put("{what}", verdict.was.starts_with(kItWas) ? verdict.was.substr(kItWas.size()) : verdict.was);
  put("{agent}", verdict.agent);
  return hint;
}

/// Returns the rules of a text by name, without insignificant blanks.
std::map<std::string, std::string> RulesOf(const std::string& text) {
  std::map<std::string, std::string> rules;
  std::istringstream words(explain::BlankComments(text));
  std::string* rule = nullptr;
  for (std::string word; words >> word;) {
    if (word == "sp" || word == "gp") {
      words >> word;
      if (word == "{") words >> word;
      rule = &rules[word.substr(word.starts_with('{') ? 1 : 0)];
    } else if (rule != nullptr) {
      *rule += word + " ";
    }
  }
  // Commands after a rule are not part of it.
  for (auto& [name, text] : rules) text.resize(std::min(text.size(), text.rfind('}') + 1));
  return rules;
}

/// The learner's rules, and which of them came from the lesson.
struct LearnersRules {
  std::map<std::string, std::string> all;
  std::set<std::string> given;
  std::vector<explain::RuleText> own;
  std::set<std::string> proposed;  ///< Operators that any rule of the file proposes.
  bool proposes_own = false;       ///< A rule that the learner wrote proposes an operator.
  bool proposes_nameless = false;  ///< A rule that the learner wrote proposes an operator without a ^name.

  LearnersRules(const Lesson& lesson, const fs::path& file) : all(RulesOf(ReadText(file).value_or(""))) {
    for (const auto& [name, text] : RulesOf(ReadText(lesson.folder / lesson.rules).value_or(""))) {
      const auto at = all.find(name);
      if (at != all.end() && at->second == text) given.insert(name);
    }
    own = sim::RulesOf(file);
    for (const explain::RuleText& rule : own) proposed.insert(rule.proposes.begin(), rule.proposes.end());
    std::erase_if(own, [&](const explain::RuleText& rule) { return given.contains(rule.name); });
    proposes_own = std::ranges::any_of(own, [](const explain::RuleText& rule) { return !rule.proposes.empty(); });
    proposes_nameless = std::ranges::any_of(own, explain::ProposesWithoutName);
  }

  /// True if a rule that the learner wrote matches the pattern.
  bool Fit(const mission::RulePattern& pattern) const {
    return std::ranges::any_of(own, [&](const explain::RuleText& rule) { return pattern.Fits(rule); });
  }
  /// True if a warning is about a rule that came from the lesson. Exception: the rule tests an attribute that no rule
  /// makes, and a rule of the learner makes a similar attribute that no rule of the learner tests. Then the learner's
  /// rule has the mistake.
  bool IsAboutGiven(const Diagnostic& problem) const {
    if (problem.topic == Topic::kUnmade && !problem.meant.empty()) {
      const auto has = [&](const std::vector<explain::RuleAttribute>& side) {
        return std::ranges::find(side, problem.meant, &explain::RuleAttribute::attribute) != side.end();
      };
      const bool is_made = std::ranges::any_of(own, [&](const auto& rule) { return has(rule.actions); });
      const bool is_tested = std::ranges::any_of(own, [&](const auto& rule) { return has(rule.conditions); });
      if (is_made && !is_tested) return false;
    }
    return given.contains(problem.rule);
  }
};

/// Returns the folders of lessons directly below a folder, by name.
std::vector<fs::path> LessonsBelow(const fs::path& folder) {
  std::vector<fs::path> folders;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    if (fs::is_regular_file(it->path() / "lesson.toml", error)) folders.push_back(it->path());
  std::sort(folders.begin(), folders.end());
  return folders;
}

/// Returns the lessons in the course.toml of a folder, as paths relative to the folder; if it lists none, those below
/// the folder.
std::vector<fs::path> CourseLessons(const fs::path& folder, std::vector<Diagnostic>& problems) {
  std::vector<fs::path> folders;
  const fs::path file = folder / "course.toml";
  constexpr const char* kHint = "write lessons = [\"../01-a-rule\", \"1-mine\"]: folders of lessons";
  sim::TableReader reader(file.string(), "docs/teach.md", problems);
  try {
    const toml::table root = toml::parse(ReadText(file).value_or(""));
    reader.CheckKeys(root, "a course", {"lessons", "about"});
    const toml::array* lessons = root["lessons"].as_array();
    if (!root.contains("lessons") && root.contains("about")) return LessonsBelow(folder);
    if (lessons == nullptr) reader.Problem(root, "this course lists no lessons", kHint);
    for (std::size_t i = 0; lessons != nullptr && i < lessons->size(); ++i) {
      const toml::node& node = (*lessons)[i];
      const fs::path lesson = (folder / node.value_or(std::string())).lexically_normal();
      std::error_code error;
      if (node.is_string() && fs::is_regular_file(lesson / "lesson.toml", error))
        folders.push_back(lesson);
      else
        reader.Problem(node, "'" + node.value_or(std::string()) + "' is not a folder of a lesson", kHint);
    }
  } catch (const toml::parse_error& error) {
    problems.push_back(ProblemIn(file, std::string(error.description()), kHint));
    problems.back().line = static_cast<int>(error.source().begin.line);
  }
  return folders;
}

/// [own] of a lesson: the requirements for the learner's own world.
std::optional<OwnWorldRules> OwnWorldOf(const toml::table& root, const mission::Mission& mission,
                                        std::vector<Diagnostic>& problems) {
  const toml::node* node = root.get("own");
  if (node == nullptr) return std::nullopt;
  sim::TableReader reader(mission.file.string(), "docs/teach.md", problems);
  OwnWorldRules rules;
  const toml::table* own = node->as_table();
  if (own == nullptr) {
    reader.Problem(*node, "'own' is a table", "write [own], and below it agents = 2");
    return rules;
  }
  if (!mission.checks.empty() || !mission.mistakes.empty())
    reader.Problem(*node, "a lesson with [own] has no [[check]] and no [[mistake]]", "the learner's world has checks");
  reader.CheckKeys(*own, "[own]", {"agents", "obstacles", "checks", "noticed"});
  for (const auto& [key, value] : *own) {
    const std::optional<double> number = value.value<double>();
    std::size_t* const count = key == "agents"      ? &rules.agents
                               : key == "obstacles" ? &rules.obstacles
                               : key == "checks"    ? &rules.checks
                                                    : nullptr;
    if (count != nullptr && value.is_integer() && *number >= 1 && *number <= 100)
      *count = static_cast<std::size_t>(*number);
    else if (count != nullptr)
      reader.Problem(value, "'" + std::string(key.str()) + "' is a whole number from 1 to 100", "write agents = 2");
    else if (key == "noticed" && number && *number >= 0 && *number <= 1)
      rules.noticed = *number;
    else if (key == "noticed")
      reader.Problem(value, "'noticed' is a share from 0 to 1", "write noticed = 0.5 for half of the rules");
  }
  return rules;
}

/// The rank of a known mistake among the causes. A mistake that something never happened, or lasted long, has a low
/// rank, because it has many possible causes.
mission::Cause CauseOf(const mission::Check& mistake) {
  if (!mistake.written.empty() || !mistake.unwritten.empty()) return mission::Cause::kMistake;
  const bool is_few = mistake.mode == mission::Mode::kTimes && mistake.times.max && !mistake.times.min;
  // An element that exists for long counts as something that happened, because the agent created it.
  const bool is_made = std::ranges::any_of(mistake.conditions, [](const mission::Condition& condition) {
    return condition.row->key == mission::Key::kElement;
  });
  const bool is_absence = mistake.mode == mission::Mode::kNever || (mistake.for_s && !is_made) || is_few;
  return is_absence ? mission::Cause::kMissing : mission::Cause::kHappened;
}

/// True if the mistake says that an operator was never selected, but the learner gave the operator no name, or another
/// one, and no check requires this name. Then the operator may have been selected.
bool HasOtherName(const mission::Mission& mission, const mission::Check& mistake, const LearnersRules& written) {
  const auto asks_for = [](const mission::Check& check, const std::string& name) {
    return std::ranges::any_of(check.conditions, [&](const mission::Condition& condition) {
      return condition.row->key == mission::Key::kOperator &&
             std::ranges::find(condition.words, name) != condition.words.end();
    });
  };
  if (mistake.mode != mission::Mode::kNever || !written.proposes_own) return false;
  const bool is_about_operator = std::ranges::any_of(mistake.conditions, [](const mission::Condition& condition) {
    return condition.row->key == mission::Key::kOperator;
  });
  if (is_about_operator && written.proposes_nameless) return true;
  if (written.proposed.contains("")) return false;
  for (const mission::Condition& condition : mistake.conditions) {
    if (condition.row->key != mission::Key::kOperator) continue;
    return std::ranges::none_of(condition.words, [&](const std::string& name) {
      return name == "any" || written.proposed.contains(name) ||
             std::ranges::any_of(mission.checks, [&](const mission::Check& check) { return asks_for(check, name); });
    });
  }
  return false;
}

/// Returns the index of the lesson's first known mistake that a run shows; past the end: none.
std::size_t FindMistake(const mission::Mission& mission, const mission::RunResult& run, const LearnersRules& written) {
  for (std::size_t i = 0; i < mission.mistakes.size(); ++i) {
    const mission::Check& mistake = mission.mistakes[i];
    if (!mistake.conditions.empty() && !run.IsTrue(mission.checks.size() + i)) continue;
    if (mistake.unless != mission::kNoCheck && run.IsTrue(mistake.unless)) continue;
    if (!mistake.written.empty() && !written.Fit(mistake.written)) continue;
    if (!mistake.unwritten.empty() && written.Fit(mistake.unwritten)) continue;
    if (HasOtherName(mission, mistake, written)) continue;
    return i;
  }
  return mission.mistakes.size();
}

/// Returns findings about the learner's rules from a failed run: simulates it again and queries its mind.
std::vector<sim::Finding> AccountOf(const mission::LoadedMission& loaded, const Lesson& lesson,
                                    const LearnersRules& rules, std::uint64_t seed) {
  mission::TestSettings settings;
  settings.seeds = {seed};
  settings.ends_endless = true;
  settings.account.file = lesson.rules;
  settings.account.given = rules.given;
  Result<mission::MissionOutcome> outcome = mission::TestMission(
      loaded, settings, [](const mission::RunResult&) {}, [] { return !WasInterrupted(); });
  if (!outcome || outcome->runs.empty()) return {};
  return std::move(outcome->runs.front().account);
}

/// Finds the errors in a failed run, the cause first.
void Explain(const mission::LoadedMission& loaded, const Lesson& lesson, const LearnersRules& written, Grade& grade) {
  using mission::Cause;
  const mission::Mission& mission = lesson.loaded.mission;
  const mission::RunResult& failed = grade.outcome.runs[grade.example];
  std::vector<sim::Finding>& findings = grade.findings;
  for (const Diagnostic& warning : grade.warnings)
    findings.push_back(
        {.cause = sim::CauseOf(warning), .text = sim::OneLine(warning), .rule = warning.rule, .topic = warning.topic});
  const bool is_endless = failed.outcome == "endless";
  if (failed.outcome == "ok" || is_endless) {
    for (sim::Finding& finding : AccountOf(loaded, lesson, written, failed.seed))
      if (std::ranges::find(findings, finding.text, &sim::Finding::text) == findings.end())
        findings.push_back(std::move(finding));
  }
  // Removes warnings that a rule writes repeatedly if the rule never fired.
  std::set<std::string> unfired;
  for (const sim::Finding& finding : findings)
    if (finding.topic == Topic::kUnfired) unfired.insert(finding.rule);
  std::erase_if(findings, [&](const sim::Finding& finding) {
    return finding.topic == Topic::kRepeatedWrite && unfired.contains(finding.rule);
  });
  const auto is_told = [&](Cause cause) {
    return std::ranges::find(findings, cause, &sim::Finding::cause) != findings.end();
  };
  if (is_endless && !is_told(Cause::kEndless)) findings.push_back({Cause::kEndless, failed.error});
  if (failed.outcome != "ok" && !is_endless)
    findings.push_back({Cause::kEndless, "This run " + failed.outcome + ": " + failed.error});
  // If a run was ended early, its checks do not show a mistake.
  const std::size_t mistake = FindMistake(mission, failed, written);
  if (mistake < mission.mistakes.size() && failed.outcome == "ok") {
    const mission::Check& known = mission.mistakes[mistake];
    grade.mistake = known.name;
    findings.push_back({CauseOf(known), Filled(known.hint, failed.checks[mission.checks.size() + mistake].verdict)});
  }
  if (findings.empty())
    findings.push_back(
        {Cause::kSymptom,
         "The lesson has no hint for this mistake. Look at the first check that failed: which rule should make it "
         "come true, and when does this rule fire?"});
  sim::RankByCause(findings);
  // Rules that only waited for their operator are a consequence if something before that is known.
  if (findings.front().cause <= Cause::kHappened)
    std::erase_if(findings, [](const sim::Finding& finding) {
      return finding.cause == Cause::kWaiting && finding.topic == Topic::kUnfired;
    });
}

}  // namespace

fs::path ShippedLessons(const sim::DataFolders& data) {
  return data.scenarios.parent_path() / "lessons";
}

std::vector<fs::path> LessonFolders(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_regular_file(folder / "course.toml", error)) return LessonsBelow(folder);
  std::vector<Diagnostic> problems;  // ReadLessons reports them.
  return CourseLessons(folder, problems);
}

std::string AboutCourse(const fs::path& folder) {
  try {
    return toml::parse(ReadText(folder / "course.toml").value_or(""))["about"].value_or(std::string());
  } catch (const toml::parse_error&) {
    return {};  // ReadLessons reports it.
  }
}

std::vector<std::string> CoursesIn(const fs::path& folder) {
  std::vector<std::string> courses;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    std::error_code of_one;
    if (it->is_directory(of_one) && !fs::is_regular_file(it->path() / "lesson.toml", of_one) &&
        !LessonFolders(it->path()).empty())
      courses.push_back(it->path().filename().string());
  }
  std::sort(courses.begin(), courses.end());
  return courses;
}

fs::path LessonOf(const fs::path& folder, const sim::DataFolders& data) {
  std::error_code error;
  if (fs::is_regular_file(folder / "lesson.toml", error)) return folder;
  const fs::path shipped = ShippedLessons(data), name = fs::absolute(folder, error).lexically_normal().filename();
  std::vector<fs::path> places = {shipped};
  for (const std::string& course : CoursesIn(shipped)) places.push_back(shipped / course);
  for (const fs::path& place : places)
    if (fs::is_regular_file(place / name / "lesson.toml", error)) return place / name;
  return {};
}

fs::path LessonsFolder() {
  const char* home = std::getenv("HOME");
  return fs::path(home != nullptr && *home != '\0' ? home : ".") / "soarbox-lessons";
}

Result<void> PrepareLesson(const Lesson& lesson, const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  for (fs::directory_iterator it(lesson.folder, error), end; !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    std::error_code of_one;
    if (!it->is_regular_file(of_one) || name == "lesson.toml") continue;
    const fs::path to = folder / name;
    if (!fs::exists(to, of_one)) fs::copy_file(it->path(), to, error);
    if (error) break;
  }
  if (!error) return {};
  return ProblemIn(folder.string(), "the lesson's files cannot be written: " + error.message(),
                   "name another folder with --folder");
}

std::optional<Lesson> ReadLesson(const fs::path& folder, const sim::DataFolders& data,
                                 std::vector<Diagnostic>& problems) {
  Lesson lesson;
  lesson.folder = folder;
  lesson.name = folder.filename().string();
  const std::size_t before = problems.size();
  const std::string text = ReadText(folder / "lesson.toml").value_or("");
  lesson.loaded.mission = mission::ParseChecksBeside(text, folder / "lesson.toml", problems, "a lesson",
                                                     {"title", "idea", "task", "panel", "also", "rules", "hints",
                                                      "seeds", "pass", "seconds", "wall", "check", "mistake", "own"});
  if (problems.size() > before) return std::nullopt;
  const toml::table root = toml::parse(text);
  lesson.title = root["title"].value_or(lesson.name);
  lesson.idea = root["idea"].value_or(std::string());
  lesson.task = root["task"].value_or(std::string());
  const auto panel_named = [&](const toml::node& node) {
    const std::string title = node.value_or(std::string());
    if (workbench::FindPanelByTitle(title) != nullptr) return title;
    std::vector<std::string_view> titles;
    for (const workbench::PanelInfo& info : workbench::kPanelInfos) titles.push_back(info.title);
    sim::TableReader(lesson.loaded.mission.file.string(), "docs/window.md", problems)
        .Problem(node, "there is no panel '" + title + "'",
                 NearestHint(title, titles, "write a title of docs/window.md, such as panel = \"Mind\""));
    return title;
  };
  if (const toml::node* panel = root.get("panel")) lesson.panel = panel_named(*panel);
  if (const toml::array* also = root["also"].as_array())
    for (const toml::node& panel : *also) lesson.also.push_back(panel_named(panel));
  lesson.rules = root["rules"].value_or(std::string());
  if (const toml::array* hints = root["hints"].as_array())
    for (const toml::node& hint : *hints) lesson.hints.push_back(hint.value_or(std::string()));
  lesson.own = OwnWorldOf(root, lesson.loaded.mission, problems);
  if (problems.size() > before) return std::nullopt;
  mission::Mission& mission = lesson.loaded.mission;
  mission.name = lesson.name;
  Result<sim::Scenario> scenario = sim::FindScenario(folder.string(), data);
  std::error_code error;
  if (!scenario || scenario->definition.empty()) {
    problems.push_back(ProblemIn(folder / "lesson.toml", "this lesson has no scenario.toml beside it"));
    return std::nullopt;
  }
  if (lesson.rules.empty() || !fs::is_regular_file(folder / lesson.rules, error)) {
    problems.push_back(ProblemIn(folder / "lesson.toml", "'rules' names no file of this lesson",
                                 "write rules = \"porter.soar\": the file that the learner edits"));
    return std::nullopt;
  }
  lesson.loaded.scenario = std::move(*scenario);
  mission.scenario = folder.string();
  const sim::ScenarioFile file =
      sim::ParseScenarioFile(ReadText(folder / "scenario.toml").value_or(""), folder / "scenario.toml", problems);
  mission::CheckNames(mission, mission::CastOf(file), problems);
  lesson.loaded.seconds = mission.seconds.value_or(file.seconds.value_or(60));
  mission::CheckTimes(mission, lesson.loaded.seconds, problems);
  if (mission.seeds.empty())
    for (std::size_t seed = 1; seed <= kUsualSeeds; ++seed) mission.seeds.push_back(seed);
  if (problems.size() > before) return std::nullopt;
  return lesson;
}

std::vector<Lesson> ReadLessons(const fs::path& folder, const sim::DataFolders& data,
                                std::vector<Diagnostic>& problems) {
  std::vector<Lesson> lessons;
  std::error_code error;
  if (fs::is_regular_file(folder / "course.toml", error)) CourseLessons(folder, problems);
  for (const fs::path& each : LessonFolders(folder))
    if (std::optional<Lesson> lesson = ReadLesson(each, data, problems)) lessons.push_back(std::move(*lesson));
  return lessons;
}

Result<Grade> GradeRules(const Lesson& lesson, const fs::path& rules_folder, std::size_t seeds, const OnSeed& on_seed) {
  Grade grade;
  const fs::path rules = rules_folder / lesson.rules;
  // Refuses links out of the folder. Otherwise a folder from somebody else could show any file of the user in messages.
  std::error_code error;
  if (const fs::path real = fs::canonical(rules, error);
      !error && real.parent_path() != fs::canonical(rules_folder, error)) {
    grade.problems.push_back(
        ProblemIn(lesson.rules, "this is a link to a file outside the lesson's folder", "put the file itself there"));
    return grade;
  }
  const LearnersRules written(lesson, rules);
  for (Diagnostic& problem : sim::CheckFiles({rules})) {
    // Removes the path of the learner's folder, because other users may read the page.
    problem.file = fs::path(problem.file).filename().string();
    if (problem.severity == Severity::kError) {
      grade.problems.push_back(std::move(problem));
    } else if (problem.severity == Severity::kWarning && !written.IsAboutGiven(problem)) {
      grade.warnings.push_back(std::move(problem));
    }
  }
  if (!grade.problems.empty()) return grade;
  // The world and the other rules come from the lesson; only this file is the learner's.
  mission::LoadedMission loaded = lesson.loaded;
  if (rules.extension() == ".lua") {
    loaded.scenario.script_folders.insert(loaded.scenario.script_folders.begin(), rules_folder);
    if (loaded.scenario.script.filename() == lesson.rules) loaded.scenario.script = rules;
  } else {
    loaded.scenario.rule_folders.insert(loaded.scenario.rule_folders.begin(), rules_folder);
  }
  mission::TestSettings settings;
  settings.seeds = lesson.loaded.mission.seeds;
  settings.ends_endless = true;
  if (seeds > 0 && seeds < settings.seeds.size()) settings.seeds.resize(seeds);
  std::size_t done = 0;
  Result<mission::MissionOutcome> outcome = mission::TestMission(
      loaded, settings,
      [&](const mission::RunResult&) {
        if (on_seed) on_seed(++done, settings.seeds.size());
      },
      [] { return !WasInterrupted(); });
  if (!outcome) return outcome.error();
  grade.outcome = std::move(*outcome);
  grade.cancelled = WasInterrupted();
  grade.passed = !grade.cancelled && grade.outcome.Passed(lesson.loaded.mission) && !grade.outcome.runs.empty();
  if (grade.passed || grade.cancelled) return grade;
  const auto failed = std::find_if(grade.outcome.runs.begin(), grade.outcome.runs.end(),
                                   [](const mission::RunResult& run) { return !run.passed; });
  if (failed == grade.outcome.runs.end()) return grade;
  grade.example = static_cast<std::size_t>(failed - grade.outcome.runs.begin());
  Explain(loaded, lesson, written, grade);
  grade.cancelled = WasInterrupted();
  return grade;
}

}  // namespace soarbox::app
