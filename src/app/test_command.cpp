// SPDX-License-Identifier: BSD-2-Clause
#include "app/test_command.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <map>
#include <set>
#include <thread>

#include "app/data_folders.h"
#include "app/diagnostic_json.h"
#include "app/exit_codes.h"
#include "app/junit.h"
#include "app/refuse.h"
#include "app/run_session.h"
#include "diagnostics/problem.h"
#include "dis/dis_settings.h"
#include "mission/check_sentences.h"
#include "mission/read_mission.h"
#include "mission/statistics.h"
#include "mission/testing.h"
#include "sim/replaced_rules.h"

namespace soarbox::app {
namespace {

namespace fs = std::filesystem;
using mission::CheckResult;
using mission::RunResult;
using mission::State;

std::string Quoted(const std::string& text) {
  const bool is_plain = std::all_of(text.begin(), text.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("/._-+~").find(c) != std::string_view::npos;
  });
  if (is_plain) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

char Mark(const RunResult& run) {
  if (run.outcome == "crashed") return 'C';
  if (run.outcome == "hung") return 'H';
  if (run.outcome != "ok") return 'E';
  if (run.IsUndecided()) return '?';
  return run.passed ? '.' : 'F';
}

Json ToJson(const mission::Mission& mission, const RunResult& run) {
  Json checks = Json::array();
  for (std::size_t i = 0; i < mission.checks.size() && i < run.checks.size(); ++i) {
    const CheckResult& check = run.checks[i];
    Json& made = checks.emplace_back(Json{{"name", mission.checks[i].name},
                                          {"state", std::string(mission::NameOf(check.verdict.state))},
                                          {"time", check.verdict.time_s}});
    if (!check.verdict.agent.empty()) made["agent"] = check.verdict.agent;
    if (!check.expected.empty()) made["expected"] = check.expected;
    if (!check.verdict.was.empty()) made["was"] = check.verdict.was;
    if (!check.reasons.empty()) made["reasons"] = check.reasons;
  }
  Json json{{"event", "run"},
            {"mission", mission.name},
            {"seed", run.seed},
            {"outcome", run.outcome},
            {"passed", run.passed},
            {"seconds", run.seconds},
            {"cpu_s", run.cpu_s},
            {"state_hash", fmt::format("{:016x}", run.state_hash)},
            {"checks", std::move(checks)}};
  if (!run.problems.empty()) json["problems"] = run.problems;
  if (!run.error.empty()) json["error"] = run.error;
  if (!run.recording.empty()) json["recording"] = run.recording;
  return json;
}

/// Prints lines about runs in the order of their seeds, as soon as all earlier ones have been printed.
class LinesInOrder {
 public:
  explicit LinesInOrder(std::vector<std::uint64_t> seeds) : seeds_(std::move(seeds)) {}

  void Add(std::uint64_t seed, std::string line) {
    waiting_.emplace(seed, std::move(line));
    for (auto at = waiting_.end(); next_ < seeds_.size() && (at = waiting_.find(seeds_[next_])) != waiting_.end();
         ++next_)
      Print(at);
    std::cout << std::flush;
  }
  /// Prints the remaining lines, also if runs between them are missing because of an interrupt.
  void Finish() {
    for (; next_ < seeds_.size(); ++next_)
      if (const auto at = waiting_.find(seeds_[next_]); at != waiting_.end()) Print(at);
    std::cout << std::flush;
  }

 private:
  using Waiting = std::multimap<std::uint64_t, std::string>;
  void Print(Waiting::iterator at) {
    std::cout << at->second << '\n';
    waiting_.erase(at);
  }

  std::vector<std::uint64_t> seeds_;
  std::size_t next_ = 0;
  Waiting waiting_;
};

/// Errors that failed runs reported themselves, each once: rules that cannot be read, loops, stopped scripts.
template <typename Head>
void PrintProblems(const mission::MissionOutcome& outcome, const std::string& margin, const Head& head) {
  std::vector<std::string> told;
  for (const RunResult& run : outcome.runs) {
    if (run.passed) continue;
    for (const std::string& problem : run.problems) {
      if (std::ranges::find(told, problem) != told.end()) continue;
      if (told.empty()) {
        head("reported");
        std::cout << "seed " << run.seed << ": " << problem << '\n';
      } else {
        std::cout << margin << problem << '\n';
      }
      told.push_back(problem);
    }
  }
}

/// Prints the failures: each check once, with the first seed that failed it.
void PrintFailures(const TestedMission& tested) {
  const mission::Mission& mission = tested.loaded.mission;
  std::size_t width = 8;
  for (std::size_t i = 0; i < mission.checks.size(); ++i)
    if (!CheckPassed(tested, i)) width = std::max(width, std::min<std::size_t>(24, mission.checks[i].name.size()));
  const std::string margin(width + 4, ' ');
  const auto head = [&](const std::string& name) {
    std::cout << "  " << name << std::string(name.size() < width ? width - name.size() : 0, ' ') << "  ";
  };
  for (std::size_t i = 0; i < mission.checks.size(); ++i) {
    if (mission.checks[i].marker || tested.outcome.check_true[i] == tested.outcome.runs.size()) continue;
    if (mission.checks[i].pass && CheckPassed(tested, i)) continue;
    std::size_t more = 0;
    for (const RunResult& run : tested.outcome.runs) {
      if (run.outcome != "ok" || run.IsTrue(i)) continue;
      if (more++ > 0) continue;
      const CheckResult& check = run.checks[i];
      head(mission.checks[i].name);
      std::cout << "seed " << run.seed << ", " << mission::SecondsText(check.verdict.time_s) << ": " << check.expected
                << "; " << (check.verdict.state == State::kUntested ? "not tested: " : "") << check.verdict.was << '\n';
      for (const std::string& reason : check.reasons) std::cout << margin << reason << '\n';
      if (!run.recording.empty()) {
        std::cout << margin << "soarbox replay " << Quoted(run.recording) << " --from "
                  << mission::NumberText(std::max(0.0, std::floor(check.verdict.time_s - 1)));
        if (!check.verdict.agent.empty()) std::cout << " --select " << Quoted(check.verdict.agent);
        std::cout << '\n';
      }
      if (!mission.checks[i].hint.empty()) std::cout << margin << mission.checks[i].hint << '\n';
    }
    if (more > 1) std::cout << margin << "and with " << more - 1 << " other seeds\n";
  }
  PrintProblems(tested.outcome, margin, head);
  for (const RunResult& run : tested.outcome.runs) {
    if (run.outcome == "ok" && run.error.empty()) continue;
    head(run.outcome == "ok" ? "note" : run.outcome);
    std::cout << "seed " << run.seed << ": " << run.error << (run.error.ends_with('\n') ? "" : "\n");
    if (run.outcome == "refused") break;
  }
}

/// The agent to which the first failed check of a run refers; empty if there is none, or several.
std::string AgentOfFailure(const mission::Mission& mission, const RunResult& run) {
  for (std::size_t i = 0; i < mission.checks.size() && i < run.checks.size(); ++i) {
    const mission::State state = run.checks[i].verdict.state;
    if (mission.checks[i].marker || state == mission::State::kTrue || state == mission::State::kUndecided) continue;
    if (!run.checks[i].verdict.agent.empty()) return run.checks[i].verdict.agent;
    if (mission.checks[i].agents.size() == 1) return mission.checks[i].agents.front();
  }
  return {};
}

/// The cause of a mission's failure: simulates the first failed run again and queries the mind of the agent to which
/// the first failed check refers. Empty if there is no such agent, or no certain cause.
std::string CauseOf(const TestedMission& tested, const mission::TestSettings& settings) {
  const mission::Mission& mission = tested.loaded.mission;
  const auto failed = std::ranges::find_if(tested.outcome.runs, [](const RunResult& run) {
    return run.outcome == "ok" && !run.passed && !run.IsUndecided();
  });
  if (failed == tested.outcome.runs.end() || settings.empty_minds) return {};
  mission::TestSettings again;
  again.seeds = {failed->seed};
  again.account.agent = AgentOfFailure(mission, *failed);
  if (!again.account.IsAsked()) return {};
  const Result<mission::MissionOutcome> outcome = mission::TestMission(
      tested.loaded, again, [](const RunResult&) {}, [] { return !WasInterrupted(); });
  if (!outcome || outcome->runs.empty() || outcome->runs.front().account.empty()) return {};
  // If the agent always had something to do, rules that never fire are not errors.
  const std::vector<sim::Finding>& found = outcome->runs.front().account;
  const bool was_idle = std::ranges::any_of(found, [](const sim::Finding& finding) {
    return finding.cause == mission::Cause::kStalled || finding.cause == mission::Cause::kSymptom;
  });
  return was_idle || found.front().cause <= mission::Cause::kRefused ? found.front().text : std::string();
}

/// Whether the scenario of a mission joins an exercise of other simulations.
bool JoinsAnExercise(const fs::path& scenario) {
  if (scenario.empty()) return false;
  const Result<std::optional<dis::Settings>> exercise = dis::ReadSettings(scenario, {});
  return exercise && exercise->has_value();
}

void TellOfExercise(const fs::path& file, std::string_view said) {
  Remark(Severity::kNote, ProblemIn(file, std::string(said), "docs/dis.md says how to check a run that takes part"));
}

class Tester {
 public:
  Tester(const TestOptions& options, const sim::DataFolders& data)
      : options_(options), data_(data), is_terminal_(isatty(STDOUT_FILENO) != 0) {}

  /// Runs all missions once; returns an exit code.
  int Round(const std::vector<fs::path>& files) {
    std::vector<TestedMission> tested;
    bool refused = false, failed = false, broken = false;
    std::size_t runs = 0;
    double wall_s = 0;
    for (const fs::path& file : files) {
      if (WasInterrupted()) break;
      std::vector<Diagnostic> problems;
      TestedMission each;
      each.file = file;
      each.loaded = mission::LoadMission(file, data_, problems);
      for (const Diagnostic& problem : problems) std::cerr << Format(problem);
      if (!problems.empty()) {
        refused = true;
        continue;
      }
      if (const Result<void> replaced = sim::ReplaceRules(each.loaded.scenario, options_.rules); !replaced) {
        std::cerr << Format(replaced.error());
        refused = true;
        continue;
      }
      if (const fs::path& scenario = each.loaded.scenario.definition; JoinsAnExercise(scenario))
        TellOfExercise(scenario, "a test joins no exercise of other simulations: this world runs on its own");
      const Result<void> done = Run(each);
      if (!done) {
        std::cerr << Format(done.error());
        refused = true;
        continue;
      }
      refused |= each.outcome.IsRefused();
      broken |= each.outcome.HasBroken();
      failed |= !each.outcome.Passed(each.loaded.mission) && !each.outcome.IsRefused();
      runs += each.outcome.runs.size();
      wall_s += each.outcome.wall_s;
      tested.push_back(std::move(each));
    }
    const auto bad =
        static_cast<std::size_t>(std::count_if(tested.begin(), tested.end(), [](const TestedMission& each) {
          return !each.outcome.Passed(each.loaded.mission) && !each.outcome.IsOpen(each.loaded.mission);
        }));
    const bool is_open = WasInterrupted();
    if (!options_.json) {
      const std::size_t unusable = files.size() - tested.size();
      const std::string came = bad > 0          ? std::to_string(bad) + " failed"
                               : tested.empty() ? std::string("none was run")
                               : is_open        ? std::string("interrupted")
                                                : std::string("all passed");
      std::cout << tested.size() << (tested.size() == 1 ? " mission, " : " missions, ") << came << ", ";
      if (unusable > 0 && !WasInterrupted()) std::cout << unusable << " cannot be used, ";
      std::cout << runs << (runs == 1 ? " run, " : " runs, ") << mission::SecondsText(wall_s) << '\n';
    }
    if (!options_.junit.empty()) {
      if (const Result<void> written = WriteJunit(options_.junit, tested); !written) {
        std::cerr << Format(written.error());
        refused = true;
      }
    }
    std::cout.flush();
    if (WasInterrupted()) return kTestInterrupted;
    if (refused) return kTestRefused;
    // Broken runs fail their mission. If there are no other failures, they determine the exit code.
    bool only_broken = broken;
    for (const TestedMission& each : tested)
      for (const RunResult& run : each.outcome.runs)
        only_broken &= run.outcome != "ok" || run.passed || run.IsUndecided();
    if (failed && !only_broken) return kProblems;
    return broken ? static_cast<int>(kTestBroken) : static_cast<int>(failed ? kProblems : kOk);
  }

 private:
  Result<void> Run(TestedMission& tested) {
    const mission::Mission& mission = tested.loaded.mission;
    mission::TestSettings settings;
    settings.jobs = options_.jobs;
    settings.empty_minds = options_.empty;
    settings.errors_fail = !options_.empty;
    settings.keep = options_.no_keep        ? fs::path()
                    : options_.keep.empty() ? mission::StateFolder("test")
                                            : options_.keep;
    if (!options_.seeds.empty())
      settings.seeds = mission::ParseSeeds(options_.seeds).value_or(std::vector<std::uint64_t>{});
    const std::vector<std::uint64_t> seeds = mission::SeedsOf(mission, settings);
    const std::size_t count = seeds.size();
    LinesInOrder lines(seeds);
    const std::string head = mission.name + std::string(mission.name.size() < 22 ? 22 - mission.name.size() : 1, ' ') +
                             std::to_string(count) + (count == 1 ? " seed   " : " seeds  ");
    const bool shows = !options_.json && is_terminal_;
    if (shows) std::cout << head << std::flush;
    std::size_t shown = 0;
    Result<mission::MissionOutcome> outcome = mission::TestMission(
        tested.loaded, settings,
        [&](const RunResult& run) {
          if (shows && ++shown <= 60) std::cout << Mark(run) << std::flush;
          if (options_.json) lines.Add(run.seed, JsonText(ToJson(mission, run)));
        },
        [] { return !WasInterrupted(); });
    lines.Finish();
    if (!outcome) return outcome.error();
    tested.outcome = std::move(*outcome);
    const mission::MissionOutcome& came = tested.outcome;
    const bool passed = came.Passed(mission);
    const bool is_open = came.IsOpen(mission);
    const std::string cause = passed || is_open ? std::string() : CauseOf(tested, settings);
    if (options_.json) {
      Json json{{"event", "mission"},
                {"mission", mission.name},
                {"file", tested.file.string()},
                {"passed", passed},
                {"interrupted", came.IsInterrupted()},
                {"runs", came.runs.size()},
                {"runs_passed", came.passed},
                {"needed", came.needed},
                {"wall_s", came.wall_s}};
      if (!cause.empty()) json["cause"] = cause;
      std::cout << JsonText(json) << '\n';
      return {};
    }
    if (shows) std::cout << '\r';
    std::cout << head;
    for (std::size_t i = 0; i < came.runs.size() && i < 60; ++i) std::cout << Mark(came.runs[i]);
    std::cout << "  " << came.passed << " of " << came.runs.size();
    if (came.needed != came.asked) std::cout << ", " << came.needed << " needed";
    if (came.IsInterrupted()) std::cout << ", interrupted after " << came.runs.size() << " of " << came.asked;
    std::cout << (passed || is_open ? "" : "   FAILED") << "   " << mission::SecondsText(came.wall_s) << '\n';
    if (!cause.empty()) std::cout << "  " << cause << "\n";
    PrintFailures(tested);
    PrintNotes(tested);
    return {};
  }

  void PrintNotes(const TestedMission& tested) const {
    const mission::MissionOutcome& came = tested.outcome;
    if (came.runs.empty()) return;
    if (!options_.empty) {
      for (const std::size_t check : came.runs.front().idle_checks)
        std::cout << "  warning: \"" << tested.loaded.mission.checks[check].name
                  << "\" holds before anybody acted: it tests nothing\n";
    }
    if (came.passed == came.runs.size() || came.runs.size() < 5) return;
    const mission::Interval interval = mission::WilsonInterval(came.passed, came.runs.size());
    const auto percent = [](double share) { return std::to_string(static_cast<int>(std::lround(100 * share))); };
    std::cout << "  " << came.passed << " of " << came.runs.size() << " is "
              << percent(static_cast<double>(came.passed) / static_cast<double>(came.runs.size()))
              << " % (95 % confidence: " << percent(interval.low) << " to " << percent(interval.high) << " %)\n";
  }

  const TestOptions& options_;
  const sim::DataFolders& data_;
  bool is_terminal_;
};

/// Returns the missions that the command line specifies, in its order.
Result<std::vector<fs::path>> FindAll(const TestOptions& options, const sim::DataFolders& data) {
  std::vector<fs::path> files;
  for (const fs::path& path : options.paths.empty() ? std::vector<fs::path>{"."} : options.paths) {
    std::vector<fs::path> found = mission::FindMissionFiles(path, data);
    std::error_code error;
    if (found.empty()) {
      return NewProblem(fs::exists(path, error) || fs::exists(data.scenarios / path, error)
                            ? "there is no mission in " + (path == "." ? std::string("this folder") : path.string())
                            : "there is no file, folder or scenario '" + path.string() + "'",
                        "a mission is a scenario.toml with [[check]] tables, or a mission.toml: docs/missions.md");
    }
    for (fs::path& file : found) {
      if (file != path && JoinsAnExercise(file)) {
        TellOfExercise(file, "left out, because it takes part in an exercise of other simulations");
      } else {
        files.push_back(std::move(file));
      }
    }
  }
  return files;
}

/// The folders with the files of these missions: the given ones, the missions' own and their scenarios'.
std::set<fs::path> WatchedFolders(const TestOptions& options, const std::vector<fs::path>& missions,
                                  const sim::DataFolders& data) {
  std::set<fs::path> folders;
  std::error_code error;
  const auto add = [&](const fs::path& file) { folders.insert(file.has_parent_path() ? file.parent_path() : "."); };
  if (options.paths.empty()) folders.insert(".");
  for (const fs::path& path : options.paths) {
    if (fs::is_directory(path, error)) folders.insert(path);
    if (path.extension() == ".toml") add(path);
  }
  for (const fs::path& file : missions) {
    add(file);
    std::vector<Diagnostic> problems;  // The round reports them.
    const mission::LoadedMission loaded = mission::LoadMission(file, data, problems);
    if (!loaded.scenario.definition.empty()) add(loaded.scenario.definition);
    for (const fs::path& folder : loaded.scenario.rule_folders) folders.insert(folder);
  }
  return folders;
}

using FileTimes = std::map<fs::path, fs::file_time_type>;

/// Times of the last changes in these folders, to detect a saved file.
FileTimes TimesOf(const std::set<fs::path>& folders) {
  FileTimes times;
  constexpr auto kOptions = fs::directory_options::skip_permission_denied;
  for (const fs::path& folder : folders) {
    std::error_code error;
    for (fs::recursive_directory_iterator it(folder, kOptions, error), end; !error && it != end; it.increment(error)) {
      std::error_code gone;  // An editor may have removed it meanwhile.
      const std::string name = it->path().filename().string();
      if (it->is_directory(gone) && (name.starts_with('.') || name == "build" || name.ends_with(".sweep")))
        it.disable_recursion_pending();
      const fs::path extension = it->path().extension();
      if (extension != ".soar" && extension != ".lua" && extension != ".toml") continue;
      const fs::file_time_type written = fs::last_write_time(it->path(), gone);
      if (!gone) times[it->path()] = written;
    }
  }
  return times;
}

/// Tests again whenever a file is saved, until interrupted; returns the code of the last completed round.
int Watch(const TestOptions& options, const sim::DataFolders& data, Tester& tester, std::vector<fs::path> files) {
  int code = kOk;
  while (true) {
    const std::set<fs::path> folders = WatchedFolders(options, files, data);
    // Files that are saved while missions run are detected, too.
    const FileTimes before = TimesOf(folders);
    const int came = tester.Round(files);
    if (WasInterrupted()) return came;
    code = came;
    std::cout << "waiting for a file to be saved; Ctrl-C ends it\n" << std::flush;
    while (!WasInterrupted() && TimesOf(folders) == before) std::this_thread::sleep_for(std::chrono::milliseconds(300));
    if (WasInterrupted()) return code;
    // There may be new missions.
    Result<std::vector<fs::path>> found = FindAll(options, data);
    if (found) {
      files = std::move(*found);
    } else {
      std::cerr << Format(found.error());
      files.clear();
    }
  }
}

}  // namespace

int Test(const TestOptions& options) {
  const Result<sim::DataFolders> data = FindDataFolders();
  if (!data) return Refuse(data.error());
  if (!options.seeds.empty() && !mission::ParseSeeds(options.seeds)) {
    std::cerr << "soarbox: error: --seeds takes 1..20 or 1,4,7\n";
    return kUsage;
  }
  const Result<std::vector<fs::path>> files = FindAll(options, *data);
  if (!files) {
    std::cerr << Format(files.error());
    return kTestNone;
  }
  CatchInterrupts();
  Tester tester(options, *data);
  return options.watch ? Watch(options, *data, tester, *files) : tester.Round(*files);
}

}  // namespace soarbox::app
