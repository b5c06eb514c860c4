// SPDX-License-Identifier: BSD-2-Clause
// Minds in a world. The world is deterministic, so going back means running it again.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <utility>

#include "debugger/breakpoints.h"
#include "debugger/stack_rows.h"
#include "debugger/why.h"
#include "diagnostics/problem.h"
#include "editors/debuggee.h"
#include "editors/pausable_task.h"
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

class WorldDebuggee final : public Debuggee, public ScriptDebuggee {
 public:
  /// Creates the simulation in its state before the first tick.
  using Maker = std::function<Made()>;

  /// Begin must be called next.
  explicit WorldDebuggee(Maker maker) : maker_(std::move(maker)) {}
  ~WorldDebuggee() override { EndPause(); }

  Result<void> Begin() {
    Made made = Make();
    if (!made) return made.error();
    simulation_ = std::move(*made);
    Watch();
    return {};
  }
  void SetEnd(std::uint64_t last_tick) { last_tick_ = last_tick; }
  const sim::Simulation& simulation() const { return *simulation_; }

  std::vector<std::string> Agents() const override {
    std::vector<std::string> agents;
    for (std::size_t i = 0; i < simulation_->soar_agents(); ++i) agents.push_back(simulation_->AgentOfMind(i));
    return agents;
  }

  std::unique_ptr<explain::Inspector> Inspect(const std::string& agent) override { return simulation_->Inspect(agent); }

  StopReasons Advance(Step step, const std::string& agent) override {
    constexpr int kMostTicks = 300;  // Maximum number of ticks without a decision before a step ends.
    if (task_.is_paused()) return EndTick(task_.Resume());
    const std::uint64_t decisions = DecisionsOf(agent);
    StopReasons why;
    for (int i = 0; i < kMostTicks && !HasEnded() && why.empty(); ++i) {
      why = Tick();
      if (task_.is_paused() || step != Step::kDecision || DecisionsOf(agent) > decisions) break;
    }
    return why;
  }

  Result<void> GoBack() override {
    // A script is paused in a tick: go back to the beginning of that tick.
    if (task_.is_paused()) return GoTo(ended_tick_);
    if (simulation_->tick() == 0) return NoWorld("this is the beginning of the run: there is nothing before it");
    return GoTo(simulation_->tick() - 1);
  }
  Result<void> Restart() override { return GoTo(0); }

  Result<std::string> Command(const std::string& agent, const std::string& line) override {
    has_begun_ = true;
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

  ScriptDebuggee* Scripts() override { return this; }

  void With(const std::function<void(script::ScriptDebugger&)>& look) override {
    if (task_.is_paused()) return task_.Do([&] { look(scripts_); });
    // A script error during the inspection must not pause the run.
    scripts_.SetEnabled(false);
    look(scripts_);
    scripts_.SetEnabled(true);
  }

  bool IsPaused() const override { return task_.is_paused(); }

  StopReasons Advance(script::ScriptStep step, std::uint32_t owner) override {
    constexpr int kMostTicks = 300;  // A step ends if a script is not called for this number of ticks.
    StopReasons why;
    if (task_.is_paused()) {
      task_.Do([&] { scripts_.SetStep(step); });
      why = EndTick(task_.Resume());
    } else {
      scripts_.StopIn(owner);
    }
    for (int i = 0; i < kMostTicks && why.empty() && !task_.is_paused() && !HasEnded(); ++i) {
      if (!scripts_.IsWanted()) break;
      why = Tick();
    }
    if (!task_.is_paused()) scripts_.ForgetStep();
    return why;
  }

  void Run(std::uint32_t owner, const std::string& text) override {
    std::string agent;
    for (const script::ScriptView::Machine& machine : scripts_.view().Machines())
      if (machine.owner == owner && owner != 0) agent = machine.name;
    has_begun_ = true;
    asked_of_scripts_.push_back(text);
    simulation_->Submit(sim::ScriptInput{agent, text});
  }

 private:
  /// Runs a paused tick to its end, without another pause.
  void EndPause() {
    if (!task_.is_paused()) return;
    scripts_.SetEnabled(false);
    task_.Resume();
    scripts_.SetEnabled(true);
  }

  /// Returns what happened in a tick, or why a script has paused during it.
  StopReasons EndTick(bool has_ended) {
    if (has_ended) return std::exchange(is_set_up_again_, false) ? StopReasons() : AfterTick();
    std::vector<script::ScriptFrame> calls;
    StopReason reason;
    task_.Do([&] {
      const script::ScriptView& view = scripts_.view();
      calls = view.Frames();
      using Kind = StopReason::Kind;
      reason.kind = view.reason() == "error"  ? Kind::kScriptError
                    : view.reason() == "step" ? Kind::kScriptStep
                                              : Kind::kScriptLine;
      reason.text = reason.kind == Kind::kScriptError ? "error: " + view.error() : view.reason();
      // A condition without a value stops, too.
      if (reason.kind == Kind::kScriptLine && !view.error().empty()) reason.text += ": " + view.error();
    });
    if (!calls.empty())
      reason.text = calls.front().file + ":" + std::to_string(calls.front().line) + ": " + reason.text;
    return {reason};
  }

  void Watch() {
    for (const std::string& agent : Agents()) simulation_->NoteMind(agent, sim::MindDetail::kAll);
    TakeEvents();
  }

  sim::EventList TakeEvents() {
    sim::EventList events = simulation_->TakeEvents();
    for (const sim::RunEvent& event : events)
      if (!event.diagnostic.message.empty()) {
        news_.push_back(Format(event.diagnostic));
      } else if (event.kind == sim::EventKind::kLog ||
                 // Only results of scripts arrive here: Command() has already returned those of minds.
                 (event.kind == sim::EventKind::kAnswer && std::erase(asked_of_scripts_, event.news) > 0)) {
        news_.push_back((event.agent.empty() ? "" : event.agent + ": ") + event.text);
      }
    return events;
  }

  std::uint64_t DecisionsOf(const std::string& agent) {
    const std::unique_ptr<explain::Inspector> mind = simulation_->Inspect(agent);
    return mind == nullptr ? 0 : mind->Mind().decisions;
  }

  StopReasons Tick() {
    if (simulation_->tick() == 0 && scripts_.HasBreakpoints() && scripts_.IsWanted() &&
        !std::exchange(has_begun_, true)) {
      // Repeats the set-up of the world, because scripts may have breakpoints in it, which are known only now.
      is_set_up_again_ = true;
      if (!task_.Start([this] { SetUpAgain(); })) return EndTick(false);
      is_set_up_again_ = false;
    }
    breakpoints_.Prepare(*simulation_);
    scripts_.view().DropReferences();
    if (!scripts_.IsWanted()) {
      simulation_->Tick();
      return AfterTick();
    }
    return EndTick(task_.Start([this] { simulation_->Tick(); }));
  }

  /// Creates a simulation with the script debugger as its observer.
  Made Make() {
    const script::ObserveNewHosts observed(&scripts_);
    return maker_();
  }

  void SetUpAgain() {
    Made again = Make();
    if (!again) return news_.push_back(Format(again.error()));
    simulation_ = std::move(*again);
    Watch();
    news_.clear();  // The first set-up has printed the same.
  }

  StopReasons AfterTick() {
    ended_tick_ = simulation_->tick();
    for (const sim::Input& input : simulation_->LastInputs()) inputs_.push_back({simulation_->tick(), input});
    StopReasons why;
    for (const debugger::BreakHit& hit : breakpoints_.Check(*simulation_, TakeEvents()))
      why.push_back({hit.why, StopReason::Kind::kMind, hit.agent, hit.rule});
    return why;
  }

  Result<void> GoTo(std::uint64_t tick) {
    EndPause();
    scripts_.SetEnabled(false);
    Made again = Make();
    if (!again) {
      scripts_.SetEnabled(true);
      return again.error();
    }
    const std::vector<TickInput> inputs = std::exchange(inputs_, {});
    simulation_ = std::move(*again);
    has_begun_ = is_set_up_again_ = false;
    ended_tick_ = 0;
    // Inputs of the user are submitted again at their ticks; inputs of the recording are already queued there.
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
    scripts_.SetEnabled(true);
    news_.clear();
    return {};
  }

  struct TickInput {
    std::uint64_t tick = 0;
    sim::Input input;
  };
  Maker maker_;
  PausableTask task_;  ///< Runs ticks in which scripts may pause.
  script::ScriptDebugger scripts_{[this] { task_.Pause(); }};
  bool has_begun_ = false;        ///< A tick or a command was requested since the beginning.
  bool is_set_up_again_ = false;  ///< The task repeats the set-up of the world.
  std::uint64_t ended_tick_ = 0;
  std::unique_ptr<sim::Simulation> simulation_;
  std::uint64_t last_tick_ = 0;
  std::vector<TickInput> inputs_;
  debugger::Breakpoints breakpoints_;
  std::vector<std::string> news_;
  std::vector<std::string> asked_of_scripts_;  ///< Expressions whose results have not arrived yet.
};

std::uint64_t TickAt(double seconds, double step_s) {
  return static_cast<std::uint64_t>(std::llround(seconds / step_s));
}

Result<std::unique_ptr<Debuggee>> LaunchRecording(const LaunchRequest& request, const sim::DataFolders& data) {
  Result<std::unique_ptr<record::Reader>> opened = record::Reader::Open(request.program);
  if (!opened) return opened.error();
  const std::shared_ptr<record::Reader> reader = std::move(*opened);
  auto debuggee = std::make_unique<WorldDebuggee>([reader, &data]() -> Made {
    Result<record::Rerun> again = record::Restart(*reader, data);
    if (!again) return again.error();
    return std::move(again->simulation);
  });
  if (const Result<void> begun = debuggee->Begin(); !begun) return begun.error();
  std::uint64_t last = reader->last_tick();
  if (request.seconds) last = std::min(last, TickAt(*request.seconds, reader->header().step_s));
  debuggee->SetEnd(last);
  return std::unique_ptr<Debuggee>(std::move(debuggee));
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
  auto debuggee = std::make_unique<WorldDebuggee>(
      [scenario = *scenario, settings]() { return sim::Simulation::Create(scenario, settings); });
  if (const Result<void> begun = debuggee->Begin(); !begun) return begun.error();
  debuggee->SetEnd(TickAt(seconds, debuggee->simulation().world().settings().step_s));
  return std::unique_ptr<Debuggee>(std::move(debuggee));
}

}  // namespace soarbox::editors
