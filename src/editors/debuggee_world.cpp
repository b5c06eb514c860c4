// SPDX-License-Identifier: BSD-2-Clause
// Minds in a world. It is deterministic, so that going back is going there again.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <utility>

#include "debugger/breakpoints.h"
#include "debugger/goal_stack.h"
#include "debugger/why.h"
#include "diagnostics/problem.h"
#include "editors/debuggee.h"
#include "language/visual_soar.h"
#include "record/reader.h"
#include "record/rerun.h"
#include "sim/scenario_file.h"
#include "sim/simulation.h"
#include "world/world.h"

namespace soarbox::editors {
namespace {

using Made = Result<std::unique_ptr<sim::Simulation>>;

Diagnostic NoWorld(std::string message, std::string hint = {}) {
  return NewProblem(std::move(message), std::move(hint));
}

class WorldDebuggee final : public Debuggee {
 public:
  /// Makes the simulation as it is before its first tick.
  using Maker = std::function<Made()>;

  WorldDebuggee(Maker maker, std::unique_ptr<sim::Simulation> simulation, std::uint64_t last_tick)
      : maker_(std::move(maker)), simulation_(std::move(simulation)), last_tick_(last_tick) {
    Watch();
  }

  std::vector<std::string> Agents() const override {
    std::vector<std::string> agents;
    for (std::size_t i = 0; i < simulation_->soar_agents(); ++i) agents.push_back(simulation_->AgentOfMind(i));
    return agents;
  }

  std::unique_ptr<explain::Inspector> Inspect(const std::string& agent) override { return simulation_->Inspect(agent); }

  std::vector<std::string> Advance(Step step, const std::string& agent) override {
    constexpr int kMostTicks = 300;  // So long nothing may be decided before a step ends anyway.
    const std::uint64_t decisions = DecisionsOf(agent);
    std::vector<std::string> why;
    for (int i = 0; i < kMostTicks && !HasEnded() && why.empty(); ++i) {
      why = Tick();
      if (step != Step::kDecision || DecisionsOf(agent) > decisions) break;
    }
    return why;
  }

  Result<void> GoBack() override {
    if (simulation_->tick() == 0) return NoWorld("this is the beginning: nothing lies before it");
    return GoTo(simulation_->tick() - 1);
  }
  Result<void> Restart() override { return GoTo(0); }

  Result<std::string> Command(const std::string& agent, const std::string& line) override {
    return simulation_->Command(agent, line);
  }

  Result<explain::WhyNode> Why(const std::string& agent, const std::string& topic) override {
    if (topic.empty()) return debugger::WhyAgent(*simulation_, agent);
    return debugger::WhyName(*simulation_, agent, topic);
  }

  void SetStops(const std::vector<std::string>& rules, const std::vector<StopWish>& wishes) override {
    breakpoints_.ClearAll();
    for (const std::string& rule : rules) (void)breakpoints_.Set(debugger::BreakKind::kFire, "", rule);
    for (const StopWish& wish : wishes) {
      const auto kind = debugger::BreakKindNamed(wish.kind);
      if (!kind) continue;
      if (const Result<int> set = breakpoints_.Set(*kind, "", wish.what); !set) news_.push_back(Format(set.error()));
    }
  }

  bool HasEnded() const override { return simulation_->HasEnded() || simulation_->tick() >= last_tick_; }
  bool CanGoBack() const override { return true; }
  std::string When() const override {
    char text[64];
    std::snprintf(text, sizeof text, "tick %llu, %.2f s", static_cast<unsigned long long>(simulation_->tick()),
                  simulation_->time_s());
    return text;
  }

  std::vector<std::string> TakeNews() override { return std::exchange(news_, {}); }

 private:
  void Watch() {
    for (const std::string& agent : Agents()) simulation_->NoteMind(agent, sim::MindDetail::kAll);
    TakeEvents();
  }

  sim::EventList TakeEvents() {
    sim::EventList events = simulation_->TakeEvents();
    for (const sim::RunEvent& event : events)
      if (!event.diagnostic.message.empty()) {
        news_.push_back(Format(event.diagnostic));
      } else if (event.kind == sim::EventKind::kLog) {
        news_.push_back((event.agent.empty() ? "" : event.agent + ": ") + event.text);
      }
    return events;
  }

  std::uint64_t DecisionsOf(const std::string& agent) {
    const std::unique_ptr<explain::Inspector> mind = simulation_->Inspect(agent);
    return mind == nullptr ? 0 : mind->Mind().decisions;
  }

  std::vector<std::string> Tick() {
    breakpoints_.Prepare(*simulation_);
    simulation_->Tick();
    for (const sim::Input& input : simulation_->LastInputs()) inputs_.push_back({simulation_->tick(), input});
    std::vector<std::string> why;
    for (const debugger::BreakHit& hit : breakpoints_.Check(*simulation_, TakeEvents())) why.push_back(hit.why);
    return why;
  }

  Result<void> GoTo(std::uint64_t tick) {
    Made again = maker_();
    if (!again) return again.error();
    const std::vector<TickInput> inputs = std::exchange(inputs_, {});
    simulation_ = std::move(*again);
    // What the user said comes in at its tick again; what the recording holds waits there already.
    for (const TickInput& one : inputs) {
      if (one.tick > tick || one.input.recorded) continue;
      sim::Input input = one.input;
      input.tick = one.tick;
      simulation_->Submit(std::move(input));
    }
    Watch();
    const debugger::Breakpoints kept = std::exchange(breakpoints_, {});
    while (simulation_->tick() < tick) Tick();
    breakpoints_ = kept;
    news_.clear();
    return {};
  }

  struct TickInput {
    std::uint64_t tick = 0;
    sim::Input input;
  };
  Maker maker_;
  std::unique_ptr<sim::Simulation> simulation_;
  std::uint64_t last_tick_;
  std::vector<TickInput> inputs_;
  debugger::Breakpoints breakpoints_;
  std::vector<std::string> news_;
};

std::uint64_t TickAt(double seconds, double step_s) {
  return static_cast<std::uint64_t>(std::llround(seconds / step_s));
}

Result<std::unique_ptr<Debuggee>> LaunchRecording(const LaunchRequest& request, const sim::DataFolders& data) {
  Result<std::unique_ptr<record::Reader>> opened = record::Reader::Open(request.program);
  if (!opened) return opened.error();
  const std::shared_ptr<record::Reader> reader = std::move(*opened);
  const WorldDebuggee::Maker maker = [reader, &data]() -> Made {
    Result<record::Rerun> again = record::Restart(*reader, data);
    if (!again) return again.error();
    return std::move(again->simulation);
  };
  Made made = maker();
  if (!made) return made.error();
  std::uint64_t last = reader->last_tick();
  if (request.seconds) last = std::min(last, TickAt(*request.seconds, reader->header().step_s));
  return std::unique_ptr<Debuggee>(std::make_unique<WorldDebuggee>(maker, std::move(*made), last));
}

}  // namespace

Result<std::unique_ptr<Debuggee>> LaunchWorld(const LaunchRequest& request, const sim::DataFolders& data) {
  constexpr double kSeconds = 60;
  if (record::IsRecording(request.program)) return LaunchRecording(request, data);
  std::string program = request.program;
  if (language::IsVisualSoarProject(program)) {
    program = language::RootOfProject(program).string();
    if (program.empty()) return NoWorld("there is no file beside this project that loads its rules");
  }
  const Result<sim::Scenario> scenario = sim::FindScenario(program, data);
  if (!scenario) return scenario.error();
  sim::SimulationSettings settings;
  settings.mind_detail = sim::MindDetail::kAll;
  double seconds = request.seconds.value_or(kSeconds);
  if (!scenario->definition.empty()) {
    const Result<sim::ScenarioFile> file = sim::ReadScenarioFile(scenario->definition);
    if (!file) return file.error();
    settings.seed = file->seed.value_or(1);
    if (!request.seconds) seconds = file->seconds.value_or(seconds);
  }
  if (request.seed) settings.seed = *request.seed;
  const WorldDebuggee::Maker maker = [scenario = *scenario, settings]() {
    return sim::Simulation::Create(scenario, settings);
  };
  Made made = maker();
  if (!made) return made.error();
  const std::uint64_t last = TickAt(seconds, (*made)->world().settings().step_s);
  return std::unique_ptr<Debuggee>(std::make_unique<WorldDebuggee>(maker, std::move(*made), last));
}

}  // namespace soarbox::editors
