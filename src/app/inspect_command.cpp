// SPDX-License-Identifier: BSD-2-Clause
#include "app/inspect_command.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <tuple>

#include "app/data_folders.h"
#include "app/exit_codes.h"
#include "app/kernel_address.h"
#include "app/panel_view.h"
#include "app/refuse.h"
#include "debugger/breakpoints.h"
#include "debugger/views.h"
#include "diagnostics/problem.h"
#include "record/reader.h"
#include "record/recorder.h"
#include "record/rerun.h"
#include "sim/scenario_file.h"
#include "world/world.h"

namespace soarbox::app {
namespace {

/// A run at the requested tick, with the models of its earlier ticks.
struct Inspected {
  std::unique_ptr<sim::Simulation> simulation;  ///< Null if a recording cannot be simulated again.
  debugger::RunModels models;
  debugger::RecordedMinds recorded;  ///< For a recording.
  record::TickRecord last;
  double step_s = 1.0 / 30;
  std::vector<Diagnostic> warnings;
};

/// Splits "rule propose*move" into view and argument.
std::pair<std::string, std::string> SplitView(const std::string& view) {
  const std::size_t blank = view.find(' ');
  if (blank == std::string::npos) return {view, ""};
  const std::size_t begin = view.find_first_not_of(' ', blank);
  return {view.substr(0, blank), begin == std::string::npos ? "" : view.substr(begin)};
}

Result<void> SetUntil(const std::string& until, const std::string& agent, debugger::Breakpoints& breakpoints) {
  if (until.empty()) return {};
  const auto [kind, what] = SplitView(until);
  const std::optional<debugger::BreakKind> known = debugger::BreakKindNamed(kind);
  if (!known) {
    return NewProblem(
        "a run cannot be stopped at '" + until + "'",
        "say fire RULE, match RULE, element \"^ATTRIBUTE VALUE\", removed \"^ATTRIBUTE VALUE\", number \"^ATTRIBUTE < "
        "NUMBER\", operator NAME, impasse KIND, command NAME, failed NAME, death or time SECONDS");
  }
  const Result<int> set = breakpoints.Set(*known, agent, what);
  return set ? Result<void>() : set.error();
}

void Plot(const InspectOptions& options, Inspected& run, const std::string& agent) {
  const auto [view, of] = SplitView(options.view);
  if (view == "plots" && !agent.empty()) run.models.plots.Plot(agent, of.empty() ? "decisions" : of);
}

/// The requested agent; the first one with a mind if none was named.
std::string AgentOf(const InspectOptions& options, const sim::Simulation& simulation) {
  if (!options.agent.empty()) return options.agent;
  for (std::size_t i = 0; i < simulation.soar_agents(); ++i)
    if (simulation.HasMind(simulation.AgentOfMind(i))) return simulation.AgentOfMind(i);
  return {};
}

Result<void> RunScenario(const InspectOptions& options, const sim::DataFolders& data, Inspected& run) {
  const Result<sim::Scenario> scenario = sim::FindScenario(options.source, data, options.extra_folders);
  if (!scenario) return scenario.error();
  sim::SimulationSettings settings;
  settings.mind_detail = sim::MindDetail::kAll;
  if (!options.kernel.empty()) {
    if (const Result<void> read = ReadKernelAddress(options.kernel, settings.soar); !read) return read;
  }
  settings.seed = sim::SeedOf(*scenario, options.seed);
  Result<std::unique_ptr<sim::Simulation>> made = sim::Simulation::Create(*scenario, settings);
  if (!made) return made.error();
  run.simulation = std::move(*made);
  run.step_s = run.simulation->world().settings().step_s;
  debugger::Breakpoints breakpoints;
  const std::string agent = AgentOf(options, *run.simulation);
  if (const Result<void> set = SetUntil(options.until, options.agent, breakpoints); !set) return set;
  Plot(options, run, agent);
  const auto take = [&] {
    record::Observe(*run.simulation, run.simulation->TakeEvents(), record::Level::kAll, run.last);
    run.models.Add(run.last);
    run.models.plots.Sample(*run.simulation);
  };
  take();
  const auto last = static_cast<std::uint64_t>(std::llround(options.at_s / run.step_s));
  while (run.simulation->tick() < last) {
    run.simulation->Tick();
    take();
    const std::vector<debugger::BreakHit> hits = breakpoints.Check(*run.simulation, run.last.events);
    for (const debugger::BreakHit& hit : hits) std::cerr << "tick " << hit.tick << ": " << hit.why << '\n';
    if (!hits.empty()) return {};
  }
  if (options.until.empty()) return {};
  return NewProblem("the run did not come to '" + options.until + "' by tick " + std::to_string(last),
                    "--at SECONDS says how long to wait for it");
}

Result<void> ReadRecording(const InspectOptions& options, const sim::DataFolders& data, Inspected& run) {
  Result<std::unique_ptr<record::Reader>> opened = record::Reader::Open(options.source);
  if (!opened) return opened.error();
  record::Reader& reader = **opened;
  run.step_s = reader.header().step_s;
  const auto wanted = static_cast<std::uint64_t>(std::llround(options.at_s / run.step_s));
  const std::uint64_t last = std::clamp(wanted, reader.first_tick(), reader.last_tick());
  run.recorded = debugger::RecordedMinds(reader.header().level);
  for (std::uint64_t tick = reader.first_tick(); tick <= last; ++tick) {
    const Result<const record::TickRecord*> read = reader.At(tick);
    if (!read) return read.error();
    // The first tick is plotted too, because the agent is known only after it.
    if (tick == reader.first_tick()) {
      std::string agent = options.agent;
      if (agent.empty() && !(*read)->scene.agents.empty()) agent = (*read)->scene.agents.front().name;
      Plot(options, run, agent);
    }
    run.models.Add(**read);
    run.recorded.Add(**read);
    run.last = **read;
  }
  if (options.recorded) return {};
  Result<record::Rerun> again = record::GoTo(reader, last, data);
  if (again) {
    run.simulation = std::move(again->simulation);
    run.warnings = std::move(again->warnings);
  } else {
    run.warnings.push_back(again.error());
    run.warnings.back().severity = Severity::kWarning;
  }
  return {};
}

}  // namespace

int Inspect(const InspectOptions& options) {
  const Result<sim::DataFolders> data = FindDataFolders();
  if (!data) return Refuse(data.error());
  if (const auto [view, of] = SplitView(options.view); view == "panel") {
    const Result<std::string> shown = ShowPanel(options, of, *data);
    if (!shown) return Refuse(shown.error());
    std::cout << *shown;
    return kOk;
  }
  Inspected run;
  if (options.recorded && !record::IsRecording(options.source))
    return Refuse("--recorded is about recordings, and this is none",
                  "`soarbox run " + options.source + " --record FILE` makes one", options.source);
  const Result<void> brought =
      record::IsRecording(options.source) ? ReadRecording(options, *data, run) : RunScenario(options, *data, run);
  if (!brought) return Refuse(brought.error());
  for (const Diagnostic& warning : run.warnings) std::cerr << Format(warning);
  debugger::ViewRequest request;
  std::tie(request.view, request.of) = SplitView(options.view);
  request.agent = options.agent;
  request.first_tick = static_cast<std::uint64_t>(std::llround(options.from_s / run.step_s));
  request.last_tick = run.last.tick;
  const Result<debugger::ViewText> shown =
      debugger::ShowView({run.simulation.get(), &run.models, &run.last, &run.recorded}, request);
  if (!shown) return Refuse(shown.error());
  std::cout << (options.json ? shown->json : shown->text);
  return kOk;
}

}  // namespace soarbox::app
