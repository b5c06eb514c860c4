// SPDX-License-Identifier: BSD-2-Clause
#include "app/own_world.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string_view>
#include <utility>

#include "app/run_session.h"
#include "diagnostics/problem.h"
#include "diagnostics/read_text.h"
#include "explain/rule_text.h"
#include "mission/check_sentences.h"
#include "mission/read_mission.h"
#include "mission/scenario_names.h"
#include "mission/testing.h"
#include "sim/check.h"
#include "sim/scenario_file.h"

namespace soarbox::app {
namespace {

namespace fs = std::filesystem;

/// Seeds of the runs of a world.
constexpr std::uint64_t kOwnWorldSeeds[] = {1, 2};
/// Maximum number of rules that are tried, because each costs a run with each seed.
constexpr std::size_t kMostRules = 100;

/// The name of a rule in a text, with its begin and end.
struct RuleSpan {
  std::string name;
  std::size_t begin = 0, end = 0;
};

/// Returns the index after the brace that closes the one at `open`. Ignores braces between bars.
std::size_t EndOfBraces(std::string_view text, std::size_t open) {
  int depth = 0;
  bool in_bars = false;
  for (std::size_t at = open; at < text.size(); ++at) {
    if (text[at] == '\\' && in_bars) {
      ++at;
    } else if (text[at] == '|') {
      in_bars = !in_bars;
    } else if (!in_bars && text[at] == '{') {
      ++depth;
    } else if (!in_bars && text[at] == '}' && --depth == 0) {
      return at + 1;
    }
  }
  return text.size();
}

std::vector<RuleSpan> RuleSpansIn(const std::string& original) {
  const std::string text = explain::BlankComments(original);
  std::vector<RuleSpan> spans;
  for (std::size_t at = 0; at < text.size(); at = std::min(text.find('\n', at), text.size() - 1) + 1) {
    const std::size_t word = text.find_first_not_of(" \t", at);
    if (word == std::string::npos) break;
    const std::string_view head = std::string_view(text).substr(word, 2);
    const std::size_t open = text.find_first_not_of(" \t\n", word + 2);
    if ((head != "sp" && head != "gp") || open == std::string::npos || text[open] != '{') continue;
    const std::size_t begin = text.find_first_not_of(" \t\n", open + 1);
    if (begin == std::string::npos) break;
    const std::size_t end = std::min(text.find_first_of(" \t\n(", begin), text.size());
    spans.push_back({text.substr(begin, end - begin), word, EndOfBraces(text, open)});
    at = spans.back().end - 1;
  }
  return spans;
}

/// A folder below the one for temporary files, removed at the end.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::error_code error;
    std::string pattern = (fs::temp_directory_path(error) / "soarbox-world-XXXXXX").string();
    if (!error && mkdtemp(pattern.data()) != nullptr) path_ = pattern;
  }
  ~ScratchFolder() {
    std::error_code error;
    if (!path_.empty()) fs::remove_all(path_, error);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

bool IsPartOfWorld(const fs::path& file) {
  return file.extension() == ".toml" || file.extension() == ".soar" || file.extension() == ".lua";
}

/// Copies the files of a world, without links.
bool CopyWorld(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::create_directories(to, error);
  for (fs::recursive_directory_iterator it(from, error), end; !error && it != end; it.increment(error)) {
    std::error_code of_one;
    if (it->is_symlink(of_one) || !it->is_regular_file(of_one) || !IsPartOfWorld(it->path())) continue;
    const fs::path copy = to / it->path().lexically_relative(from);
    fs::create_directories(copy.parent_path(), error);
    if (!error) fs::copy_file(it->path(), copy, fs::copy_options::overwrite_existing, error);
    if (error) return false;
  }
  return !error;
}

/// The files of rules of a world, sorted by name.
std::vector<fs::path> RuleFilesOf(const fs::path& world) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator it(world, error), end; !error && it != end; it.increment(error)) {
    std::error_code of_one;
    if (it->path().extension() == ".soar" && it->is_regular_file(of_one) && !it->is_symlink(of_one))
      files.push_back(it->path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// The result of a world's checks: empty if all pass, else a sentence about the first that fails.
struct CheckedWorld {
  bool holds = false;
  std::string failed;  ///< Its name.
  std::string text;    ///< "seed 1, 12.4 s: it should ...; it was ..."
};

CheckedWorld RunChecks(const fs::path& world, const sim::DataFolders& data, bool with_rules) {
  CheckedWorld checked;
  std::vector<Diagnostic> problems;
  const mission::LoadedMission loaded = mission::LoadMission(world / "scenario.toml", data, problems);
  if (!problems.empty()) {
    checked.failed = "the world";
    checked.text = problems.front().message;
    return checked;
  }
  mission::TestSettings settings;
  settings.seeds.assign(std::begin(kOwnWorldSeeds), std::end(kOwnWorldSeeds));
  settings.empty_minds = !with_rules;
  settings.errors_fail = with_rules;
  settings.ends_endless = true;
  const Result<mission::MissionOutcome> outcome = mission::TestMission(
      loaded, settings, [](const mission::RunResult&) {}, [] { return !WasInterrupted(); });
  if (!outcome) {
    checked.failed = "the world";
    checked.text = outcome.error().message;
    return checked;
  }
  for (const mission::RunResult& run : outcome->runs) {
    if (run.passed) continue;
    const std::vector<mission::Check>& checks = loaded.mission.checks;
    for (std::size_t i = 0; i < checks.size() && i < run.checks.size(); ++i) {
      const mission::CheckResult& check = run.checks[i];
      if (checks[i].marker || check.verdict.state == mission::State::kTrue) continue;
      checked.failed = "\"" + checks[i].name + "\"";
      checked.text = checks[i].name + ", seed " + std::to_string(run.seed) + ", " +
                     mission::SecondsText(check.verdict.time_s) + ": " + check.expected + "; " + check.verdict.was;
      return checked;
    }
    checked.failed = run.outcome == "ok" ? "an error of the run" : "a run that " + run.outcome;
    checked.text = "seed " + std::to_string(run.seed) + ": " +
                   (!run.error.empty()     ? run.error
                    : run.problems.empty() ? run.outcome
                                           : run.problems.front());
    return checked;
  }
  checked.holds = true;
  return checked;
}

/// "2 agents", "1 agent"
std::string Counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

OwnWorldPoint CountPoint(const std::string& what, std::size_t count, std::size_t needed, const std::string& advice) {
  OwnWorldPoint point{what + "s", count >= needed, Counted(count, what), {}, {}};
  if (point.is_met) return point;
  point.text += ", at least " + std::to_string(needed) + " are asked for";
  point.advice = "There " + std::string(count == 1 ? "is " : "are ") + Counted(count, what) + ": " + advice;
  return point;
}

/// Grades one world step by step.
class WorldGrader {
 public:
  WorldGrader(const OwnWorldRules& rules, const fs::path& world, const sim::DataFolders& data,
              const std::function<void(std::size_t, std::size_t)>& on_run)
      : rules_(rules), world_(world), data_(data), on_run_(on_run) {}

  OwnWorldGrade Grade() {
    if (!Read() || !Count()) return std::move(grade_);
    std::vector<fs::path> files = RuleFilesOf(world_);
    std::size_t rules = 0;
    for (const fs::path& file : files) rules += RuleNamesIn(ReadText(file).value_or("")).size();
    if (rules > kMostRules) {
      grade_.problems.push_back(NewProblem(
          "this world has " + std::to_string(rules) + " rules; it is graded up to " + std::to_string(kMostRules),
          "leave some agents out"));
      return std::move(grade_);
    }
    of_ = rules + 2;
    if (!TryWhole() || !TryEmpty()) return std::move(grade_);
    for (const fs::path& file : files)
      if (!TryRulesOf(file)) break;
    return std::move(grade_);
  }

 private:
  /// Reads the files; false if they contain errors.
  bool Read() {
    const auto check = [this](const fs::path& file, std::vector<Diagnostic>& found) {
      return file.filename() != "lesson.toml" && mission::CheckMissionFile(file, &data_, found);
    };
    for (Diagnostic& problem : sim::CheckFiles({world_}, check)) {
      problem.file = fs::path(problem.file).filename().string();
      (problem.severity == Severity::kError ? grade_.problems : grade_.warnings).push_back(std::move(problem));
    }
    return grade_.problems.empty();
  }

  bool Count() {
    std::vector<Diagnostic> problems;
    const fs::path file = world_ / "scenario.toml";
    const std::string text = ReadText(file).value_or("");
    const sim::ScenarioFile scenario = sim::ParseScenarioFile(text, file, problems);
    const mission::Mission mission = mission::ParseMission(text, file, true, problems);
    std::size_t agents = 0;
    for (const sim::ScenarioFile::Agent& agent : scenario.agents) agents += static_cast<std::size_t>(agent.count);
    const auto obstacles =
        static_cast<std::size_t>(std::ranges::count(scenario.things, false, &sim::ScenarioFile::Thing::is_item));
    const auto checks = static_cast<std::size_t>(std::ranges::count(mission.checks, false, &mission::Check::marker));
    grade_.points = {CountPoint("agent", agents, rules_.agents, "add an [[agent]] with rules of its own."),
                     CountPoint("obstacle", obstacles, rules_.obstacles, "add an [[obstacle]]."),
                     CountPoint("check", checks, rules_.checks, "add a [[check]] about what the agents do.")};
    return grade_.Missing() == nullptr;
  }

  /// Reports progress; false after Ctrl-C.
  bool GoesOn() {
    grade_.cancelled = WasInterrupted();
    if (!grade_.cancelled && on_run_) on_run_(done_, of_);
    ++done_;
    return !grade_.cancelled;
  }

  bool TryWhole() {
    if (!GoesOn()) return false;
    const CheckedWorld checked = RunChecks(world_, data_, true);
    grade_.points.push_back({"checks hold",
                             checked.holds,
                             checked.holds ? "all checks hold" : "a check fails",
                             checked.holds ? "" : "A check fails. " + checked.text,
                             {}});
    return checked.holds;
  }

  bool TryEmpty() {
    if (!GoesOn()) return false;
    const CheckedWorld checked = RunChecks(world_, data_, false);
    OwnWorldPoint point{"checks fail", !checked.holds, "a check fails for agents without rules", {}, {}};
    if (checked.holds) {
      point.text = "all checks hold for agents without rules";
      point.advice = "All checks hold, even if no agent has rules: they test nothing. Which of them should fail then?";
    }
    grade_.points.push_back(std::move(point));
    return !checked.holds;
  }

  /// Leaves out each rule of a file in turn.
  bool TryRulesOf(const fs::path& file) {
    const std::string text = ReadText(file).value_or(""), name = file.filename().string();
    const std::vector<std::string> rules = RuleNamesIn(text);
    OwnWorldPoint point{name, false, {}, {}, {}};
    std::size_t noticed = 0;
    for (const std::string& rule : rules) {
      if (!GoesOn()) return false;
      const ScratchFolder scratch;
      const fs::path broken = scratch.path() / "world";
      if (scratch.path().empty() || !CopyWorld(world_, broken) ||
          !(std::ofstream(broken / name, std::ios::binary) << WithoutRule(text, rule))) {
        grade_.problems.push_back(
            NewProblem("a copy of your world cannot be written", "check the folder for temporary files ($TMPDIR)"));
        return false;
      }
      const CheckedWorld checked = RunChecks(broken, data_, true);
      noticed += checked.holds ? 0 : 1;
      point.details.push_back("without " + rule + ": " +
                              (checked.holds ? std::string("nobody notices") : "noticed by " + checked.failed));
    }
    const auto share = static_cast<double>(noticed) / static_cast<double>(std::max<std::size_t>(1, rules.size()));
    point.is_met = rules.empty() || share >= rules_.noticed;
    point.text =
        name + ": " + std::to_string(noticed) + " of " + Counted(rules.size(), "rule") + " noticed when left out";
    if (!point.is_met)
      point.advice = "Your checks notice " + std::to_string(noticed) + " of " + Counted(rules.size(), "rule") + " of " +
                     name +
                     " when they are left out. What does such a rule do, and which check would notice that it "
                     "is gone?";
    grade_.points.push_back(std::move(point));
    return true;
  }

  const OwnWorldRules& rules_;
  const fs::path& world_;
  const sim::DataFolders& data_;
  const std::function<void(std::size_t, std::size_t)>& on_run_;
  OwnWorldGrade grade_;
  std::size_t done_ = 0, of_ = 0;
};

}  // namespace

const OwnWorldPoint* OwnWorldGrade::Missing() const {
  const auto at = std::ranges::find(points, false, &OwnWorldPoint::is_met);
  return at == points.end() ? nullptr : &*at;
}

std::vector<std::string> RuleNamesIn(const std::string& text) {
  std::vector<std::string> names;
  for (RuleSpan& span : RuleSpansIn(text)) names.push_back(std::move(span.name));
  return names;
}

std::string WithoutRule(const std::string& text, const std::string& name) {
  for (const RuleSpan& span : RuleSpansIn(text))
    if (span.name == name) return text.substr(0, span.begin) + text.substr(span.end);
  return text;
}

OwnWorldGrade GradeOwnWorld(const OwnWorldRules& rules, const fs::path& world, const sim::DataFolders& data,
                            const std::function<void(std::size_t, std::size_t)>& on_run) {
  return WorldGrader(rules, world, data, on_run).Grade();
}

}  // namespace soarbox::app
