// SPDX-License-Identifier: BSD-2-Clause
//
// Cost of recording a run, at each level: per tick, and on disk.
//
//   recording_cost [SCENARIO [SECONDS]]     all levels; runs a recorded and an unrecorded world in alternating ticks:
//                                           processor time of the world's thread per tick, and
//                                           bytes per agent and simulated second
//   recording_cost count LEVEL SCENARIO SECONDS [WARM]
//                                           one run alone, for counting instructions with valgrind in the function
//                                           MeasuredTicks; LEVEL is off, world, decisions, all or watched (a window is
//                                           open, nothing is recorded); WARM seconds before are not counted
//   recording_cost seek [SCENARIO [SECONDS]]
//                                           records, and measures how long going to ticks of the file takes
//
// Prints lines of JSON. Minds decide on one thread.

#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "record/reader.h"
#include "record/recorder.h"
#include "sim/scenario.h"
#include "sim/simulation.h"
#include "world/world.h"

namespace {

using namespace soarbox;
namespace fs = std::filesystem;

int Fail(const Diagnostic& problem) {
  std::fputs(Format(problem).c_str(), stderr);
  return 1;
}

/// A run; recorded if a level is given.
struct Run {
  std::unique_ptr<sim::Simulation> simulation;
  std::unique_ptr<record::Recorder> recorder;

  void Tick() {
    simulation->Tick();
    sim::EventList events = simulation->TakeEvents();
    if (recorder != nullptr) (void)recorder->Take(*simulation, std::move(events));
  }
};

Result<Run> Start(const std::string& name, std::optional<record::Level> level, const fs::path& file,
                  bool is_watched = false) {
  const std::string root = SOARBOX_SOURCE_DIR;
  const Result<sim::Scenario> scenario = sim::FindScenario(name, {root + "/scenarios", root + "/media"});
  if (!scenario) return scenario.error();
  sim::SimulationSettings settings;
  settings.soar.threads = 1;
  if (level) settings.mind_detail = record::DetailOf(*level);
  // As in a headless run: nothing asks why. In a window, the minds note what they do, recorded or not.
  settings.records_origins = is_watched;
  if (is_watched) settings.mind_detail = sim::MindDetail::kDecisions;
  Result<std::unique_ptr<sim::Simulation>> simulation = sim::Simulation::Create(*scenario, settings);
  if (!simulation) return simulation.error();
  Run run;
  run.simulation = std::move(*simulation);
  if (level) {
    const double step_s = static_cast<double>(run.simulation->world().settings().step_s);
    Result<std::unique_ptr<record::Writer>> writer =
        record::Writer::Create(file, record::HeaderOf(*scenario, settings, step_s, *level));
    if (!writer) return writer.error();
    run.recorder = std::make_unique<record::Recorder>(std::move(*writer), *level);
  }
  return run;
}

double ProcessorTime(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

/// Executes a tick and returns the processor time of the thread that runs the world.
double Measure(Run& run) {
  const double begin = ProcessorTime(CLOCK_THREAD_CPUTIME_ID);
  run.Tick();
  return ProcessorTime(CLOCK_THREAD_CPUTIME_ID) - begin;
}

int Compare(const std::string& scenario, double seconds, record::Level level, const fs::path& file) {
  Result<Run> bare = Start(scenario, std::nullopt, {});
  if (!bare) return Fail(bare.error());
  Result<Run> recorded = Start(scenario, level, file);
  if (!recorded) return Fail(recorded.error());
  double without_s = 0, with_s = 0;
  while (bare->simulation->time_s() < seconds) {
    without_s += Measure(*bare);
    with_s += Measure(*recorded);
  }
  const std::size_t agents = bare->simulation->world().AgentIds().size();
  const auto ticks = static_cast<double>(bare->simulation->tick());
  recorded->recorder.reset();
  const auto bytes = static_cast<double>(fs::file_size(file));
  std::printf(
      "{\"benchmark\": \"recording_cost\", \"scenario\": \"%s\", \"level\": \"%s\", \"agents\": %zu, \"ticks\": %.0f, "
      "\"tick_us\": %.1f, \"recorded_tick_us\": %.1f, \"cost_percent\": %.1f, \"bytes_per_agent_second\": %.0f, "
      "\"megabytes\": %.2f}\n",
      scenario.c_str(), std::string(NameOf(level)).c_str(), agents, ticks, without_s / ticks * 1e6,
      with_s / ticks * 1e6, 100 * (with_s - without_s) / without_s,
      bytes / (static_cast<double>(agents) * bare->simulation->time_s()), bytes / 1e6);
  std::fflush(stdout);
  return bare->simulation->StateHash() == recorded->simulation->StateHash() ? 0 : 1;
}

extern "C" [[gnu::noinline]] void MeasuredTicks(Run& run, double seconds) {
  for (const double end_s = run.simulation->time_s() + seconds; run.simulation->time_s() < end_s;) run.Tick();
}

int Count(const std::string& level, const std::string& scenario, double seconds, double warm_s, const fs::path& file) {
  std::optional<record::Level> wanted;
  const bool is_watched = level == "watched";
  if (level != "off" && !is_watched) {
    const Result<record::Level> named = record::LevelNamed(level);
    if (!named) return Fail(named.error());
    wanted = *named;
  }
  Result<Run> run = Start(scenario, wanted, file, is_watched);
  if (!run) return Fail(run.error());
  while (run->simulation->time_s() < warm_s) run->Tick();
  MeasuredTicks(*run, seconds);
  return 0;
}

int Seek(const std::string& scenario, double seconds, const fs::path& file) {
  Result<Run> run = Start(scenario, record::Level::kDecisions, file);
  if (!run) return Fail(run.error());
  while (run->simulation->time_s() < seconds) run->Tick();
  const std::size_t agents = run->simulation->world().AgentIds().size();
  run->recorder.reset();
  using Clock = std::chrono::steady_clock;
  const auto since = [](Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
  };
  Clock::time_point begin = Clock::now();
  const Result<std::unique_ptr<record::Reader>> opened = record::Reader::Open(file);
  if (!opened) return Fail(opened.error());
  record::Reader& reader = **opened;
  const double open_ms = since(begin);
  begin = Clock::now();
  if (const auto inputs = reader.Inputs(); !inputs) return Fail(inputs.error());
  const double inputs_ms = since(begin);
  // The ticks are far apart, so that each one is in another block.
  double slowest_ms = 0, all_ms = 0;
  constexpr int kPlaces = 200;
  for (std::uint64_t i = 0; i < kPlaces; ++i) {
    begin = Clock::now();
    const auto record = reader.At((i * 7919 * 31 + 29) % (reader.last_tick() + 1));
    if (!record) return Fail(record.error());
    slowest_ms = std::max(slowest_ms, since(begin));
    all_ms += since(begin);
  }
  std::printf(
      "{\"benchmark\": \"recording_seek\", \"scenario\": \"%s\", \"agents\": %zu, \"seconds\": %.0f, \"megabytes\": "
      "%.1f, \"open_ms\": %.2f, \"inputs_ms\": %.2f, \"mean_seek_ms\": %.2f, \"slowest_seek_ms\": %.2f}\n",
      scenario.c_str(), agents, seconds, static_cast<double>(fs::file_size(file)) / 1e6, open_ms, inputs_ms,
      all_ms / kPlaces, slowest_ms);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const fs::path file = fs::temp_directory_path() / ("soarbox-recording-cost-" + std::to_string(getpid()));
  const std::string what = argc > 1 ? argv[1] : "";
  int code = 0;
  if (what == "count" && (argc == 5 || argc == 6)) {
    code = Count(argv[2], argv[3], std::atof(argv[4]), argc > 5 ? std::atof(argv[5]) : 0, file);
  } else if (what == "seek") {
    code = Seek(argc > 2 ? argv[2] : "crowd/crowd_10.lua", argc > 3 ? std::atof(argv[3]) : 3600, file);
  } else {
    for (const record::Level level : {record::Level::kWorld, record::Level::kDecisions, record::Level::kAll}) {
      if (code == 0)
        code = Compare(argc > 1 ? what : "crowd/crowd_100.lua", argc > 2 ? std::atof(argv[2]) : 10, level, file);
    }
  }
  std::error_code ignored;
  fs::remove(file, ignored);
  return code;
}
