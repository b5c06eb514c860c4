// SPDX-License-Identifier: BSD-2-Clause
#include "record/rerun.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "record/recorder.h"
#include "sim/input_text.h"

namespace soarbox::record {
namespace fs = std::filesystem;
namespace {

Diagnostic Warning(const Reader& recording, std::string message, std::string hint) {
  Diagnostic warning;
  warning.severity = Severity::kWarning;
  warning.file = recording.file().string();
  warning.message = std::move(message);
  warning.hint = std::move(hint);
  return warning;
}

/// The scenario's name as it must be looked for from here: relative names were relative to the run's folder.
std::string NameFromHere(const Header& header, const std::string& name) {
  std::error_code error;
  const fs::path there = fs::path(header.folder) / name;
  return fs::exists(there, error) ? there.string() : name;
}

std::string Text(world::Vec3 v) {
  return fmt::format("({}, {}, {})", v.x, v.y, v.z);
}

std::string Text(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "; ") + line;
  return text.empty() ? "nothing" : text;
}

std::optional<Difference> DifferenceOfBodies(const TickRecord& recorded, const TickRecord& now) {
  Difference found;
  found.tick = recorded.tick;
  const std::size_t count = std::max(recorded.scene.agents.size(), now.scene.agents.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (i >= recorded.scene.agents.size() || i >= now.scene.agents.size()) {
      const bool more = i >= recorded.scene.agents.size();
      found.agent = more ? now.scene.agents[i].name : recorded.scene.agents[i].name;
      found.element = "presence";
      found.recorded = more ? "absent" : "present";
      found.now = more ? "present" : "absent";
      return found;
    }
    const world::AgentSnapshot& a = recorded.scene.agents[i];
    const world::AgentSnapshot& b = now.scene.agents[i];
    found.agent = a.name;
    const auto differs = [&](const char* element, const std::string& was, const std::string& is) {
      found.element = element;
      found.recorded = was;
      found.now = is;
      return found;
    };
    if (a.name != b.name) return differs("name", a.name, b.name);
    if (a.last_command != b.last_command) return differs("command", a.last_command, b.last_command);
    if (a.position != b.position) return differs("position", Text(a.position), Text(b.position));
    if (a.velocity != b.velocity) return differs("velocity", Text(a.velocity), Text(b.velocity));
    if (a.forward != b.forward) return differs("heading", Text(a.forward), Text(b.forward));
    if (a.health != b.health) return differs("health", std::to_string(a.health), std::to_string(b.health));
  }
  return std::nullopt;
}

std::optional<Difference> DifferenceOfMinds(const TickRecord& recorded, const TickRecord& now) {
  if (recorded.minds.empty() || now.minds.empty()) return std::nullopt;  // A level that tells nothing of minds.
  const std::size_t count = std::max(recorded.minds.size(), now.minds.size());
  for (std::size_t i = 0; i < count; ++i) {
    static const MindRecord kNothing;
    const MindRecord& a = i < recorded.minds.size() ? recorded.minds[i] : kNothing;
    const MindRecord& b = i < now.minds.size() ? now.minds[i] : kNothing;
    const std::pair<const char*, std::vector<std::string> MindRecord::*> parts[] = {
        {"percepts", &MindRecord::percepts},
        {"decisions", &MindRecord::decisions},
        {"commands", &MindRecord::commands}};
    for (const auto& [element, part] : parts) {
      if (a.agent == b.agent && a.*part == b.*part) continue;
      return Difference{recorded.tick, a.agent.empty() ? b.agent : a.agent, element, Text(a.*part), Text(b.*part)};
    }
  }
  return std::nullopt;
}

/// Runs on until the end of a tick; `see` is shown each record and says whether to go on.
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

std::optional<Difference> FirstDifference(const TickRecord& recorded, const TickRecord& now) {
  if (recorded.inputs != now.inputs)
    return Difference{recorded.tick, "", "inputs", Text(recorded.inputs), Text(now.inputs)};
  if (std::optional<Difference> minds = DifferenceOfMinds(recorded, now)) return minds;
  if (std::optional<Difference> bodies = DifferenceOfBodies(recorded, now)) return bodies;
  if (recorded.state_hash != now.state_hash) {
    return Difference{recorded.tick, "", "the state's hash", fmt::format("{:016x}", recorded.state_hash),
                      fmt::format("{:016x}", now.state_hash)};
  }
  return std::nullopt;
}

Result<Rerun> Restart(Reader& recording, const sim::DataFolders& data, std::uint64_t last_tick) {
  const Header& header = recording.header();
  Rerun rerun;
  std::vector<fs::path> extra;
  for (const std::string& folder : header.extra_folders) extra.emplace_back(NameFromHere(header, folder));
  const Result<sim::Scenario> scenario = sim::FindScenario(NameFromHere(header, header.scenario), data, extra);
  if (!scenario) {
    Diagnostic problem = scenario.error();
    problem.file = recording.file().string();
    problem.message = "the scenario of this recording cannot be run again: " + problem.message;
    return problem;
  }
  if (header.build != BuildId()) {
    rerun.warnings.push_back(Warning(recording, "another build of Soarbox made this recording (" + header.build + ")",
                                     "it may take another course than the recording does"));
  }
  if (header.scenario_digest != DigestOf(*scenario)) {
    rerun.warnings.push_back(Warning(recording, "files of the scenario have changed since this was recorded",
                                     "the run may take another course than the recording does"));
  }
  if (!header.own_kernel) {
    rerun.warnings.push_back(Warning(recording,
                                     "the minds of this recording lived in a kernel that was not Soarbox's own",
                                     "Soarbox's own kernel takes its place now"));
  }
  sim::SimulationSettings settings;
  settings.seed = settings.soar.seed = header.seed;
  settings.screen_width_px = static_cast<int>(header.screen_width_px);
  settings.screen_height_px = static_cast<int>(header.screen_height_px);
  settings.mind_detail = DetailOf(header.level);
  Result<std::unique_ptr<sim::Simulation>> made = sim::Simulation::Create(*scenario, settings);
  if (!made) return made.error();
  rerun.simulation = std::move(*made);

  const Result<std::vector<TickInputs>> inputs = recording.Inputs();
  if (!inputs) return inputs.error();
  for (const TickInputs& entry : *inputs) {
    if (entry.tick > last_tick) break;
    std::string text;
    for (const std::string& line : entry.inputs) text += line + "\n";
    sim::InputText read = sim::ReadInputs(text, recording.file().string());
    if (!read.problems.empty()) return read.problems.front();
    for (sim::Input& input : read.inputs) rerun.simulation->Submit(std::move(input));
  }
  return rerun;
}

Result<Verdict> Verify(Reader& recording, const sim::DataFolders& data, const Progress& progress) {
  Result<Rerun> rerun = Restart(recording, data);
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
        verdict.difference = FirstDifference(**recorded, now);
        return !verdict.difference.has_value();
      });
  if (damage) return *damage;
  verdict.interrupted = !done;
  return verdict;
}

Result<Rerun> GoTo(Reader& recording, std::uint64_t tick, const sim::DataFolders& data, const Progress& progress) {
  const Result<const TickRecord*> there = recording.At(tick);
  if (!there) return there.error();
  const TickRecord goal = **there;
  Result<Rerun> rerun = Restart(recording, data, tick);
  if (!rerun) return rerun;
  std::optional<Difference> difference;
  const bool done = RunTo(*rerun->simulation, tick, recording.header().level, progress, [&](const TickRecord& now) {
    if (now.tick == tick) difference = FirstDifference(goal, now);
    return true;
  });
  Diagnostic problem;
  problem.file = recording.file().string();
  if (!done) {
    problem.message = "interrupted before tick " + std::to_string(tick) + " was reached";
    return problem;
  }
  if (!difference) return rerun;
  problem.message = fmt::format("simulated again, the run has another state at tick {}: {}{} was {} and is {}", tick,
                                difference->agent.empty() ? "" : difference->agent + "'s ", difference->element,
                                difference->recorded, difference->now);
  problem.hint = "`soarbox verify` tells the first tick that differs";
  return problem;
}

}  // namespace soarbox::record
