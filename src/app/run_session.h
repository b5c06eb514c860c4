// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/event_printer.h"
#include "app/kernel_watch.h"
#include "app/mission_watch.h"
#include "app/run_options.h"
#include "dis/gateway.h"
#include "record/recorder.h"
#include "sim/findings.h"
#include "sim/simulation.h"
#include "workbench/live_run.h"

namespace soarbox::app {

/// A run in progress: the simulation and its output. The headless loop and the window's loop drive it.
class RunSession final : public workbench::LiveRun {
 public:
  /// `followed`: the kernel whose agents the run repeats. The run advances by a tick when that kernel has reached it.
  /// Null: it is an ordinary run.
  RunSession(std::unique_ptr<sim::Simulation> simulation, std::unique_ptr<EventPrinter> printer,
             const RunOptions& options, std::unique_ptr<KernelWatch> followed = nullptr);

  /// Advances one tick and prints what happened. Only waits some ms if the exercise of other simulations is frozen, or
  /// if the followed kernel has not reached the next tick.
  void Tick();
  /// Serves debuggers while paused, and prints the resulting events. After a command to followed agents, first advances
  /// to what they have done by now.
  void Idle();
  /// True once the requested time has passed, or the user has requested the end (Ctrl-C). For a headless run also once
  /// the scenario, or the followed kernel, has ended.
  bool IsOver() const;
  /// From now on evaluates the checks of a mission. Call it before ticks are recorded or watched. Null: no mission.
  void SetMission(std::unique_ptr<MissionWatch> mission);
  /// Connects the run to other simulations: their inputs are submitted before each tick.
  void Join(std::unique_ptr<dis::Gateway> gateway);
  /// Null: this run is not connected.
  const dis::Gateway* gateway() const { return gateway_.get(); }
  /// The detail that minds must record even if nobody watches them.
  sim::MindDetail LeastDetail() const override {
    return mission_ != nullptr ? mission_->LeastDetail() : sim::MindDetail::kNone;
  }
  std::optional<workbench::ExerciseContents> Exercise() override;
  /// Records from now on; with `last_tick_too`, starting with the current state. Null: records nothing.
  void Record(std::unique_ptr<record::Recorder> recorder, bool last_tick_too = true);
  void Watch(OnTick on_tick) override;
  /// Ends the recording; on_branch may start another one.
  void GoOnWith(std::unique_ptr<sim::Simulation> simulation, const record::TickRecord& at,
                const std::vector<record::TickInputs>& inputs) override;
  using OnBranch = std::function<void(const record::TickRecord& at, const std::vector<record::TickInputs>& inputs)>;
  void SetOnBranch(OnBranch on_branch) { on_branch_ = std::move(on_branch); }
  void SetOnEdit(OnEdit on_edit) override { on_edit_ = std::move(on_edit); }
  /// Runs the clean-up, prints the footer and returns the exit code.
  int Finish();

  /// Creates the run again with a seed; `on_made` is called when the new run is in place (to record it).
  using Make = std::function<Result<std::unique_ptr<sim::Simulation>>(std::uint64_t seed)>;
  void SetMake(std::uint64_t seed, std::string scenario, Make make, std::function<void()> on_made);
  /// Ends the simulation and creates another one, with the same seed, the next or the given one. Reads rules and
  /// scripts again. Nobody watches the new simulation: call Watch() again. After an error there is no simulation; end
  /// the process.
  Result<void> BeginAgain(bool with_next_seed, std::optional<std::uint64_t> seed = {});
  std::uint64_t seed() const { return seed_; }
  /// The folder of the lesson of this world, if it was given.
  const std::filesystem::path& lesson() const { return lesson_; }

  sim::Simulation& simulation() override { return *simulation_; }
  /// Whether Finish warns about inputs for ticks after the end of the run. It should if they come from a file of
  /// inputs, but not if they are keys pressed in a paused window.
  void ExpectInputs(bool expects) { expects_inputs_ = expects; }

 private:
  void PrintEvents();
  void RecordTick();
  void AdvanceTick();
  void CatchUp();
  /// Submits what the followed agents did in the next tick. Returns false if they have not reached it.
  bool TakeFollowed();
  /// Reports that the followed kernel has ended: on standard error, and to the user of a window or page as a problem.
  void ReportNews();
  /// Lets the simulation send command lines to the followed kernel, if there is one.
  void SendCommandsToFollowed();
  /// Reloads files that were edited, twice per second of real time.
  void TakeEdits();

  std::unique_ptr<sim::Simulation> simulation_;
  std::unique_ptr<EventPrinter> printer_;
  std::unique_ptr<MissionWatch> mission_;
  std::unique_ptr<dis::Gateway> gateway_;
  std::unique_ptr<KernelWatch> followed_;
  bool is_behind_ = false;  ///< A command may have changed the followed agents.
  std::filesystem::path lesson_;
  std::unique_ptr<record::Recorder> recorder_;
  OnTick on_tick_;
  record::TickRecord seen_;    ///< For on_tick_.
  sim::EventList unrecorded_;  ///< Since the last recorded tick.
  sim::EventList set_up_;      ///< Of the set-up, for observers that are added later.
  double end_s_;               ///< Simulated time at which to stop; infinite if none.
  bool ends_with_scenario_;    ///< Headless runs end when the scenario does.
  double report_every_s_;      ///< 0: never.
  double next_report_s_ = 0;
  std::unique_ptr<sim::LiveEdits> edits_;  ///< Null if files are not watched.
  std::chrono::steady_clock::time_point next_look_;
  std::size_t problems_ = 0;
  sim::EventFindings findings_;
  bool expects_inputs_ = true;
  std::uint64_t seed_ = 1;
  std::string scenario_name_;
  Make make_;
  std::function<void()> on_made_;
  OnBranch on_branch_;
  OnEdit on_edit_;
};

/// Makes SIGINT (Ctrl-C) and SIGTERM end the run: scripts are interrupted, the footer is printed, and after two seconds
/// the process ends in any case. A second signal ends it at once. A closed pipe of the output (SIGPIPE) also ends the
/// run. Idempotent.
void CatchInterrupts();
bool WasInterrupted();

}  // namespace soarbox::app
