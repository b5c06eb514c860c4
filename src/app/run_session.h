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

/// One run under way: the simulation and what is told about it. The headless loop and the window's loop drive it.
class RunSession final : public workbench::LiveRun {
 public:
  /// `followed`: the run does what the agents of another kernel did; it has a tick whenever they have gone on. Null: it
  /// follows nobody.
  RunSession(std::unique_ptr<sim::Simulation> simulation, std::unique_ptr<EventPrinter> printer,
             const RunOptions& options, std::unique_ptr<KernelWatch> followed = nullptr);

  /// Advances one tick and prints what happened.
  void Tick();
  /// Serves debuggers while paused, and prints what they caused.
  void Idle();
  /// True once the asked-for time has passed or the user has asked to stop (Ctrl-C).
  bool IsOver() const;
  /// Follows the checks of a mission from now on. Call it before anybody records or watches ticks. Null: no mission.
  void SetMission(std::unique_ptr<MissionWatch> mission);
  /// Joins the run to other simulations: what they say is submitted before each tick.
  void Join(std::unique_ptr<dis::Gateway> gateway);
  /// Null: this run is on its own.
  const dis::Gateway* gateway() const { return gateway_.get(); }
  /// What minds must note even if nobody looks at them.
  sim::MindDetail LeastDetail() const override {
    return mission_ != nullptr ? mission_->LeastDetail() : sim::MindDetail::kNone;
  }
  std::optional<workbench::ExerciseContents> Exercise() override;
  /// Records what follows, with `last_tick_too` beginning with what is there now. Null: records nothing.
  void Record(std::unique_ptr<record::Recorder> recorder, bool last_tick_too = true);
  void Watch(OnTick on_tick) override;
  /// Ends the recording; on_branch may begin another one.
  void GoOnWith(std::unique_ptr<sim::Simulation> simulation, const record::TickRecord& at,
                const std::vector<record::TickInputs>& inputs) override;
  using OnBranch = std::function<void(const record::TickRecord& at, const std::vector<record::TickInputs>& inputs)>;
  void SetOnBranch(OnBranch on_branch) { on_branch_ = std::move(on_branch); }
  void SetOnEdit(OnEdit on_edit) override { on_edit_ = std::move(on_edit); }
  /// Runs the clean-up, prints the footer and returns the exit code.
  int Finish();

  /// How to make the run anew from a seed; `on_made` is called once the new one is in place (to record it).
  using Make = std::function<Result<std::unique_ptr<sim::Simulation>>(std::uint64_t seed)>;
  void SetMake(std::uint64_t seed, std::string scenario, Make make, std::function<void()> on_made);
  /// Ends the simulation and makes another one, with this seed, the next or the given one. It reads rules and scripts
  /// again. Nobody watches the new one: ask again. After an error there is no simulation any more; end the process.
  Result<void> BeginAgain(bool with_next_seed, std::optional<std::uint64_t> seed = {});
  std::uint64_t seed() const { return seed_; }
  /// The folder of the lesson that the world belongs to, if that was said.
  const std::filesystem::path& lesson() const { return lesson_; }

  sim::Simulation& simulation() override { return *simulation_; }
  /// Whether inputs for ticks after the end of the run are a mistake: inputs of a file are, keys pressed in a paused
  /// window are not.
  void ExpectInputs(bool expects) { expects_inputs_ = expects; }

 private:
  void PrintEvents();
  void RecordTick();
  /// Submits what the followed agents did in the next tick. False: nothing has happened.
  bool TakeFollowed();
  /// Command lines of this simulation go to the kernel that is followed.
  void SendCommandsToFollowed();
  /// Reloads files that were edited, twice per second of real time.
  void TakeEdits();

  std::unique_ptr<sim::Simulation> simulation_;
  std::unique_ptr<EventPrinter> printer_;
  std::unique_ptr<MissionWatch> mission_;
  std::unique_ptr<dis::Gateway> gateway_;
  std::unique_ptr<KernelWatch> followed_;
  std::filesystem::path lesson_;
  std::unique_ptr<record::Recorder> recorder_;
  OnTick on_tick_;
  record::TickRecord seen_;    ///< For on_tick_.
  sim::EventList unrecorded_;  ///< Since the last tick that was recorded.
  sim::EventList set_up_;      ///< Of the set-up, for those who come later.
  double end_s_;               ///< Simulated time to stop at; infinite if none.
  bool ends_with_scenario_;    ///< Headless runs end where the scenario does.
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

/// Makes SIGINT (Ctrl-C) and SIGTERM end the run: scripts are stopped where they are, the footer is printed, and after
/// two seconds the process ends in any case; a second signal ends it at once. So does a reader of the output that goes
/// away (SIGPIPE). Idempotent.
void CatchInterrupts();
bool WasInterrupted();

}  // namespace soarbox::app
