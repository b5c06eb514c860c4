// SPDX-License-Identifier: BSD-2-Clause
#include "record/rerun.h"

#include <algorithm>
#include <filesystem>

#include "diagnostics/problem.h"
#include "record/branch.h"
#include "record/recorder.h"
#include "sim/input_text.h"
#include "sim/scenario_file.h"

namespace soarbox::record {
namespace fs = std::filesystem;
namespace {

Diagnostic Warning(const TickSource& recording, std::string message, std::string hint) {
  Diagnostic warning;
  warning.severity = Severity::kWarning;
  warning.file = recording.name();
  warning.message = std::move(message);
  warning.hint = std::move(hint);
  return warning;
}

/// The scenario's name relative to the current folder. Relative names were relative to the run's folder.
std::string NameFromHere(const Header& header, const std::string& name) {
  std::error_code error;
  const fs::path there = fs::path(header.folder) / name;
  return fs::exists(there, error) ? there.string() : name;
}

/// The scenario as it is on the disk now. Folders given with --path come only from the recording, possibly by a
/// stranger. Therefore, only the files that the recording keeps are used for them.
Result<sim::Scenario> FoundOnDisk(const TickSource& recording, const sim::DataFolders& data,
                                  std::vector<Diagnostic>& warnings) {
  const Header& header = recording.header();
  const std::string name = NameFromHere(header, header.scenario);
  if (header.extra_folders.empty()) return sim::FindScenario(name, data);
  const Result<RestoredFolders> restored = RestoreExtraFolders(header);
  if (!restored) {
    warnings.push_back(Warning(recording, "the folders given with --path are left out: " + restored.error().message,
                               "the run may differ from the recording"));
    return sim::FindScenario(name, data);
  }
  std::vector<fs::path> extra;
  for (const auto& [copy, original] : restored->folders) extra.push_back(copy);
  Result<sim::Scenario> scenario = sim::FindScenario(name, data, extra);
  if (!scenario) return scenario;
  scenario->stand_ins = restored->folders;
  scenario->keeps = restored->keeps;
  return scenario;
}

/// The same, with replacement rules.
Result<sim::Scenario> FromDisk(const TickSource& recording, const sim::DataFolders& data,
                               std::vector<Diagnostic>& warnings) {
  Result<sim::Scenario> scenario = FoundOnDisk(recording, data, warnings);
  if (!scenario) return scenario;
  for (const std::string& agent : ReplaceRulesAsRecorded(*scenario, recording.header()))
    warnings.push_back(Warning(recording, "the rules that --rules named for " + agent + " are not there any more",
                               "it runs with those of the scenario, and will differ from the recording"));
  return scenario;
}

/// Runs to the end of a tick. Passes each record to `see`, which returns whether to continue.
template <typename See>
bool RunTo(sim::Simulation& simulation, std::uint64_t last_tick, Level level, const Progress& progress, See see) {
  TickRecord record;
  while (true) {
    Observe(simulation, simulation.TakeEvents(), level, record);
    if (!see(record)) return true;
    if (simulation.tick() >= last_tick) return true;
    if (progress && !progress(simulation.tick())) return false;
    simulation.Tick();
  }
}

}  // namespace

int TurnTicks(const Header& header) {
  const std::string last = fs::path(header.scenario).filename().string();
  for (const std::string& name : {last, last + ".toml", std::string("scenario.toml")}) {
    for (const KeptFile& file : header.files) {
      if (file.folder != 0 || file.name != name || !name.ends_with(".toml")) continue;
      std::vector<Diagnostic> problems;
      return sim::ParseScenarioFile(file.content, name, problems).turn_ticks;
    }
  }
  return 1;
}

Result<Rerun> Restart(TickSource& recording, const sim::DataFolders& data, const RerunSettings& rerun) {
  const Header& header = recording.header();
  std::vector<Diagnostic> warnings;
  Result<sim::Scenario> scenario = FromDisk(recording, data, warnings);
  if (!scenario) {
    Diagnostic problem = scenario.error();
    problem.file = recording.name();
    problem.message = "the scenario of this recording cannot be run again: " + problem.message;
    if (header.files.empty()) return problem;
    if (rerun.files == FilesFrom::kDisk) {
      problem.hint = "--as-recorded uses the files in the recording";
      return problem;
    }
    scenario = ScenarioFromKeptFiles(header, data);
    if (!scenario) return scenario.error();
    warnings.push_back(Warning(recording, "the scenario of this recording is no longer there",
                               "the run is made from the files that the recording keeps"));
  }
  sim::SimulationSettings settings;
  settings.seed = header.seed;
  settings.screen_width_px = static_cast<int>(header.screen_width_px);
  settings.screen_height_px = static_cast<int>(header.screen_height_px);
  settings.soar.threads = rerun.threads;
  // The recording may come from a stranger. It may use more memory than usual, but not all memory.
  constexpr std::uint64_t kMostMemory_mb = 16'384;
  settings.limits.memory_bytes = static_cast<std::size_t>(std::min(header.memory_mb, kMostMemory_mb)) << 20;
  Result<Rerun> made = Restart(recording, *scenario, settings, rerun);
  if (made) made->warnings.insert(made->warnings.begin(), warnings.begin(), warnings.end());
  return made;
}

Result<Rerun> Restart(TickSource& recording, const sim::Scenario& given_scenario, const sim::SimulationSettings& given,
                      const RerunSettings& how) {
  const Header& header = recording.header();
  sim::Scenario scenario = given_scenario;
  Rerun rerun;
  if (header.build != BuildId()) {
    rerun.warnings.push_back(Warning(recording, "another build of Soarbox made this recording (" + header.build + ")",
                                     "it may differ from the recording"));
  }
  if (HaveChanged(scenario, header.scenario_digest, header.files)) {
    std::string hint = "the run may differ from the recording";
    if (how.files == FilesFrom::kRecording && !header.files.empty()) {
      Result<sim::Scenario> kept = WithKeptFiles(scenario, header.files);
      if (!kept) return kept.error();
      scenario = std::move(*kept);
      hint = "the run is made from them as they were then";
    }
    rerun.warnings.push_back(
        Warning(recording, "files of the scenario have changed since this was recorded", std::move(hint)));
  }
  if (!header.own_kernel) {
    rerun.warnings.push_back(Warning(recording, "the minds of this recording ran in a kernel in another process",
                                     "they run in this one now; their decisions are not compared, because the other "
                                     "kernel reported less"));
  }
  sim::SimulationSettings settings = given;
  settings.soar.seed = settings.seed;
  settings.soar.port = 0;  // The port is used by the running world.
  settings.soar.remote_host.clear();
  settings.mind_detail = DetailOf(header.level);
  settings.records_origins = how.origins;
  Result<std::unique_ptr<sim::Simulation>> made = sim::Simulation::Create(scenario, settings);
  if (!made) return made.error();
  rerun.simulation = std::move(*made);

  const Result<std::vector<TickInputs>> inputs = recording.Inputs();
  if (!inputs) return inputs.error();
  for (const TickInputs& entry : *inputs) {
    // A recorded client repeats all its actions, whatever the run does.
    std::string text;
    for (const std::string& line : entry.inputs)
      if (entry.tick <= how.last_tick || line.starts_with(std::to_string(entry.tick) + " command \"\" "))
        text += line + "\n";
    sim::InputText read = sim::ReadInputs(text, recording.name());
    if (!read.problems.empty()) return read.problems.front();
    for (sim::Input& input : read.inputs) {
      input.recorded = true;
      rerun.simulation->Submit(std::move(input));
    }
  }
  return rerun;
}

Result<Verdict> Verify(TickSource& recording, const sim::DataFolders& data, const Progress& progress, int threads,
                       FilesFrom files) {
  Result<Rerun> rerun =
      Restart(recording, data, {.threads = threads, .files = files, .origins = recording.header().has_origins});
  if (!rerun) return rerun.error();
  Verdict verdict;
  verdict.first_tick = recording.first_tick();
  verdict.last_tick = recording.first_tick();
  verdict.warnings = std::move(rerun->warnings);
  std::optional<Diagnostic> damage;
  const bool done =
      RunTo(*rerun->simulation, recording.last_tick(), recording.header().level, progress, [&](const TickRecord& now) {
        if (now.tick < recording.first_tick()) return true;
        const Result<const TickRecord*> recorded = recording.At(now.tick);
        if (!recorded) {
          damage = recorded.error();
          return false;
        }
        verdict.last_tick = now.tick;
        verdict.difference = FirstDifference(**recorded, now, recording.header().own_kernel);
        return !verdict.difference.has_value();
      });
  if (damage) return *damage;
  verdict.interrupted = !done;
  return verdict;
}

Result<Rerun> GoTo(TickSource& recording, std::uint64_t tick, const sim::DataFolders& data, const Progress& progress,
                   int threads) {
  if (!recording.Holds(tick)) return NotThere(recording, tick);
  Result<std::unique_ptr<Branch>> branch = Branch::Begin(recording, data, tick, threads);
  if (!branch) return branch.error();
  while (!(*branch)->IsThere()) {
    if (progress && !progress((*branch)->tick())) {
      return ProblemIn(recording.name(), "interrupted before tick " + std::to_string(tick) + " was reached");
    }
    if (const Result<void> gone = (*branch)->Advance(1); !gone) return gone.error();
  }
  return Rerun{(*branch)->TakeSimulation(), (*branch)->warnings()};
}

}  // namespace soarbox::record
