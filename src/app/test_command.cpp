// SPDX-License-Identifier: BSD-2-Clause
#include "app/test_command.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <map>
#include <thread>

#include "app/data_folders.h"
#include "app/diagnostic_json.h"
#include "app/exit_codes.h"
#include "app/junit.h"
#include "app/run_session.h"
#include "mission/read_mission.h"
#include "mission/sentences.h"
#include "mission/statistics.h"
#include "mission/test_missions.h"

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
            {"state_hash", std::to_string(run.state_hash)},
            {"checks", std::move(checks)}};
  if (!run.error.empty()) json["error"] = run.error;
  if (!run.recording.empty()) json["recording"] = run.recording;
  return json;
}

/// Prints what went wrong: each check once, with the first seed that failed it.
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
  for (const RunResult& run : tested.outcome.runs) {
    if (run.outcome == "ok" && run.error.empty()) continue;
    head(run.outcome == "ok" ? "note" : run.outcome);
    std::cout << "seed " << run.seed << ": " << run.error << (run.error.ends_with('\n') ? "" : "\n");
    if (run.outcome == "refused") break;
  }
}

class Tester {
 public:
  Tester(const TestOptions& options, const sim::DataFolders& data)
      : options_(options), data_(data), is_terminal_(isatty(STDOUT_FILENO) != 0) {}

  /// One round over all missions; an exit code.
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
          return !each.outcome.Passed(each.loaded.mission);
        }));
    if (!options_.json) {
      std::cout << tested.size() << (tested.size() == 1 ? " mission, " : " missions, ")
                << (bad == 0 ? std::string("all passed") : std::to_string(bad) + " failed") << ", " << runs
                << (runs == 1 ? " run, " : " runs, ") << mission::SecondsText(wall_s) << '\n';
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
    // Runs that broke fail their mission; if that is all, they are what is told.
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
    settings.keep = options_.no_keep        ? fs::path()
                    : options_.keep.empty() ? mission::StateFolder("test")
                                            : options_.keep;
    if (!options_.seeds.empty())
      settings.seeds = mission::ParseSeeds(options_.seeds).value_or(std::vector<std::uint64_t>{});
    const std::size_t count = mission::SeedsOf(mission, settings).size();
    const std::string head = mission.name + std::string(mission.name.size() < 22 ? 22 - mission.name.size() : 1, ' ') +
                             std::to_string(count) + (count == 1 ? " seed   " : " seeds  ");
    const bool shows = !options_.json && is_terminal_;
    if (shows) std::cout << head << std::flush;
    std::size_t shown = 0;
    Result<mission::MissionOutcome> outcome = mission::TestMission(
        tested.loaded, settings,
        [&](const RunResult& run) {
          if (shows && ++shown <= 60) std::cout << Mark(run) << std::flush;
          if (options_.json) std::cout << ToLine(ToJson(mission, run)) << '\n' << std::flush;
        },
        [] { return !WasInterrupted(); });
    if (!outcome) return outcome.error();
    tested.outcome = std::move(*outcome);
    const mission::MissionOutcome& came = tested.outcome;
    const bool passed = came.Passed(mission);
    if (options_.json) {
      std::cout << ToLine(Json{{"event", "mission"},
                               {"mission", mission.name},
                               {"file", tested.file.string()},
                               {"passed", passed},
                               {"runs", came.runs.size()},
                               {"runs_passed", came.passed},
                               {"needed", came.needed},
                               {"wall_s", came.wall_s}})
                << '\n';
      return {};
    }
    if (shows) std::cout << '\r';
    std::cout << head;
    for (std::size_t i = 0; i < came.runs.size() && i < 60; ++i) std::cout << Mark(came.runs[i]);
    std::cout << "  " << came.passed << " of " << came.runs.size();
    if (came.needed != came.runs.size()) std::cout << ", " << came.needed << " needed";
    std::cout << (passed ? "" : "   FAILED") << "   " << mission::SecondsText(came.wall_s) << '\n';
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

/// When files of the missions were last written, to see that one was saved.
std::map<fs::path, fs::file_time_type> FileTimes(const std::vector<fs::path>& missions) {
  std::map<fs::path, fs::file_time_type> times;
  std::error_code error;
  for (const fs::path& mission : missions) {
    const fs::path folder = mission.has_parent_path() ? mission.parent_path() : fs::path(".");
    for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
      const fs::path extension = it->path().extension();
      if (extension == ".soar" || extension == ".lua" || extension == ".toml")
        times[it->path()] = fs::last_write_time(it->path(), error);
    }
  }
  return times;
}

}  // namespace

int Test(const TestOptions& options) {
  const Result<sim::DataFolders> data = FindDataFolders();
  if (!data) {
    std::cerr << Format(data.error());
    return kCannotStart;
  }
  if (!options.seeds.empty() && !mission::ParseSeeds(options.seeds)) {
    std::cerr << "soarbox: error: --seeds takes 1..20 or 1,4,7\n";
    return kUsage;
  }
  std::vector<fs::path> files;
  for (const fs::path& path : options.paths.empty() ? std::vector<fs::path>{"."} : options.paths) {
    std::vector<fs::path> found = mission::FindMissionFiles(path, *data);
    std::error_code error;
    if (found.empty()) {
      Diagnostic problem;
      problem.message = fs::exists(path, error) || !path.is_relative() || fs::exists(data->scenarios / path, error)
                            ? "there is no mission in " + (path == "." ? std::string("this folder") : path.string())
                            : "there is no file, folder or scenario '" + path.string() + "'";
      problem.hint = "a mission is a scenario.toml with [[check]] tables, or a mission.toml: docs/missions.md";
      std::cerr << Format(problem);
      return kTestNone;
    }
    files.insert(files.end(), found.begin(), found.end());
  }
  CatchInterrupts();
  Tester tester(options, *data);
  int code = tester.Round(files);
  while (options.watch && !WasInterrupted()) {
    std::cout << "waiting for a file to be saved; Ctrl-C ends it\n" << std::flush;
    const auto before = FileTimes(files);
    while (!WasInterrupted() && FileTimes(files) == before) std::this_thread::sleep_for(std::chrono::milliseconds(300));
    if (!WasInterrupted()) code = tester.Round(files);
  }
  return code;
}

}  // namespace soarbox::app
