// SPDX-License-Identifier: BSD-2-Clause
#include "app/run_session.h"

#include <unistd.h>

#include <csignal>
#include <iostream>
#include <limits>
#include <thread>
#include <utility>

#include "app/exit_codes.h"
#include "app/refuse.h"
#include "diagnostics/problem.h"
#include "sim/foreign_bodies.h"
#include "world/world.h"

namespace soarbox::app {
namespace {

volatile std::sig_atomic_t g_interrupted = 0;

/// Seconds after the first signal after which the process ends in any case. Its output so far has been written.
constexpr unsigned kGrace_s = 2;

/// The first signal ends the run properly, the second at once. Uses only async-signal-safe calls.
void OnInterrupt(int signal) {
  if (g_interrupted != 0) _exit(128 + signal);
  g_interrupted = signal;
  sim::Simulation::EndScripts();
  alarm(kGrace_s);
}

/// Nobody reads the output, as after `| head`: the run ends properly with a complete recording. Each further printed
/// line raises the signal again.
void OnBrokenPipe(int signal) {
  if (g_interrupted == 0) OnInterrupt(signal);
}

void OnAlarm(int) {
  _exit(128 + static_cast<int>(g_interrupted));
}

}  // namespace

void CatchInterrupts() {
  std::signal(SIGINT, &OnInterrupt);
  std::signal(SIGTERM, &OnInterrupt);
  std::signal(SIGPIPE, &OnBrokenPipe);
  std::signal(SIGALRM, &OnAlarm);
}

bool WasInterrupted() {
  return g_interrupted != 0;
}

RunSession::RunSession(std::unique_ptr<sim::Simulation> simulation, std::unique_ptr<EventPrinter> printer,
                       const RunOptions& options, std::unique_ptr<KernelWatch> followed)
    : simulation_(std::move(simulation)),
      printer_(std::move(printer)),
      followed_(std::move(followed)),
      lesson_(options.lesson),
      end_s_(options.seconds.value_or(std::numeric_limits<double>::infinity())),
      ends_with_scenario_(options.headless),
      report_every_s_(options.report_s.value_or(0)) {
  SendCommandsToFollowed();
  if (options.watch) edits_ = std::make_unique<sim::LiveEdits>(*simulation_);
  PrintEvents();
}

void RunSession::TakeEdits() {
  const auto now = std::chrono::steady_clock::now();
  if (edits_ == nullptr || now < next_look_) return;
  next_look_ = now + std::chrono::milliseconds(500);
  for (const Diagnostic& told : edits_->Poll()) {
    std::cerr << Format(told);
    if (on_edit_) on_edit_(told);
  }
}

void RunSession::SetMission(std::unique_ptr<MissionWatch> mission) {
  mission_ = std::move(mission);
  if (mission_ != nullptr) mission_->Begin(*simulation_, unrecorded_);
}

void RunSession::Join(std::unique_ptr<dis::Gateway> gateway) {
  gateway_ = std::move(gateway);
}

void RunSession::SendCommandsToFollowed() {
  if (followed_ == nullptr) return;
  simulation_->SendCommandsElsewhere([this](const std::string& agent, const std::string& line) {
    is_behind_ = true;
    return followed_->Command(agent, line);
  });
}

bool RunSession::TakeFollowed() {
  const std::string* const acts = followed_->After(simulation_->tick());
  if (acts != nullptr) {
    simulation_->Submit(sim::CommandInput{"", *acts});
    return true;
  }
  ReportNews();
  return false;
}

void RunSession::ReportNews() {
  Diagnostic warning;
  warning.severity = Severity::kWarning;
  warning.message = followed_->TakeNews();
  if (warning.message.empty()) return;
  std::cerr << "soarbox: " << warning.message << '\n';
  if (on_edit_) on_edit_(warning);
}

std::optional<workbench::ExerciseContents> RunSession::Exercise() {
  if (gateway_ == nullptr) return std::nullopt;
  const dis::Settings& settings = gateway_->settings();
  const dis::Traffic& traffic = gateway_->traffic();
  workbench::ExerciseContents contents;
  contents.exercise = settings.exercise;
  contents.address = settings.address + ":" + std::to_string(settings.port);
  contents.is_of_this_machine = gateway_->IsOfThisMachine();
  contents.as = std::to_string(settings.site) + ":" + std::to_string(settings.application);
  contents.listens_only = settings.listens_only;
  contents.takes_orders = settings.takes_orders;
  contents.is_frozen = gateway_->IsFrozen();
  contents.sent = traffic.sent;
  contents.not_sent = traffic.unsent;
  contents.received = traffic.received;
  contents.sent_per_s = traffic.sent_per_s;
  contents.received_per_s = traffic.received_per_s;
  contents.dropped = traffic.Dropped();
  contents.entity_count = traffic.entities;
  const sim::Simulation& simulation = *simulation_;
  for (dis::ForeignEntity& one : gateway_->Entities(workbench::ExerciseContents::kMostListed)) {
    const world::EntityId body = simulation.foreign().Find(one.id);
    const world::Agent* agent = body == world::kNoEntity ? nullptr : simulation.world().FindAgent(body);
    contents.entities.push_back({one.id, agent == nullptr ? std::string() : agent->name(), one.marking, one.team,
                                 one.body, one.type, static_cast<int>(one.silent_s)});
  }
  return contents;
}

void RunSession::Tick() {
  if (gateway_ != nullptr && gateway_->IsFrozen()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return Idle();
  }
  if (followed_ != nullptr && !TakeFollowed()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return Idle();
  }
  AdvanceTick();
}

void RunSession::CatchUp() {
  followed_->Sync();
  constexpr int kMostTicks = 3000;  // Limits the time that the user waits.
  for (int i = 0; i < kMostTicks && TakeFollowed(); ++i) AdvanceTick();
}

void RunSession::AdvanceTick() {
  TakeEdits();
  if (gateway_ != nullptr) gateway_->Receive(*simulation_);
  simulation_->Tick();
  if (gateway_ != nullptr) gateway_->Send(*simulation_);
  PrintEvents();
  RecordTick();
  if (report_every_s_ > 0 && simulation_->time_s() >= next_report_s_) {
    printer_->Report(simulation_->Snapshot());
    next_report_s_ += report_every_s_;
  }
}

void RunSession::Idle() {
  TakeEdits();
  if (std::exchange(is_behind_, false)) CatchUp();
  if (followed_ != nullptr) ReportNews();
  if (gateway_ != nullptr) gateway_->Idle(*simulation_);
  simulation_->Idle();
  PrintEvents();
}

void RunSession::Record(std::unique_ptr<record::Recorder> recorder, bool last_tick_too) {
  recorder_ = std::move(recorder);
  if (last_tick_too) RecordTick();
}

void RunSession::RecordTick() {
  if (simulation_->tick() == 0 && set_up_.empty()) set_up_ = unrecorded_;
  if (on_tick_) record::Observe(*simulation_, unrecorded_, record::Level::kAll, seen_);
  sim::EventList events = std::exchange(unrecorded_, {});
  if (recorder_ != nullptr) {
    const Result<void> taken = recorder_->Take(*simulation_, std::move(events), on_tick_ ? &seen_ : nullptr);
    if (!taken) std::cerr << Format(taken.error());
  }
  if (on_tick_) on_tick_(seen_);
}

void RunSession::SetMake(std::uint64_t seed, std::string scenario, Make make, std::function<void()> on_made) {
  seed_ = seed;
  scenario_name_ = std::move(scenario);
  make_ = std::move(make);
  on_made_ = std::move(on_made);
}

Result<void> RunSession::BeginAgain(bool with_next_seed, std::optional<std::uint64_t> seed) {
  if (seed) seed_ = *seed;
  if (with_next_seed) ++seed_;
  on_tick_ = {};
  // Scripts do not stop in the clean-up and the set-up.
  sim::ObserveScripts(*simulation_, nullptr);
  simulation_->Finish();
  PrintEvents();
  const bool watches = edits_ != nullptr;
  edits_.reset();
  recorder_.reset();
  unrecorded_.clear();
  set_up_.clear();
  if (mission_ != nullptr) mission_->Leave();  // It refers to the old simulation.
  // Destroys the old simulation first, because it uses the port for debuggers.
  simulation_.reset();
  Result<std::unique_ptr<sim::Simulation>> made = make_(seed_);
  if (!made) return made.error();
  simulation_ = std::move(*made);
  SendCommandsToFollowed();
  if (watches) edits_ = std::make_unique<sim::LiveEdits>(*simulation_);
  next_report_s_ = 0;
  findings_.Clear();
  printer_->Begin({scenario_name_, seed_, false});
  PrintEvents();
  if (mission_ != nullptr) mission_->Begin(*simulation_, unrecorded_);
  if (on_made_) on_made_();
  return {};
}

void RunSession::Watch(OnTick on_tick) {
  on_tick_ = std::move(on_tick);
  if (!on_tick_) {
    // After a failed restart there is no simulation.
    if (simulation_ != nullptr) sim::ObserveScripts(*simulation_, nullptr);
    return;
  }
  const bool is_begun = simulation_->tick() == 0 && unrecorded_.empty();
  record::Observe(*simulation_, is_begun ? set_up_ : unrecorded_, record::Level::kAll, seen_);
  on_tick_(seen_);
  if (recorder_ != nullptr) return;
  // These events have been passed on, so the next tick must not contain them. Those of the set-up are kept for later
  // observers.
  if (simulation_->tick() == 0 && set_up_.empty()) set_up_ = unrecorded_;
  unrecorded_.clear();
}

void RunSession::GoOnWith(std::unique_ptr<sim::Simulation> simulation, const record::TickRecord& at,
                          const std::vector<record::TickInputs>& inputs) {
  const bool was_recorded = recorder_ != nullptr;
  if (was_recorded) {
    Remark(Severity::kNote, NewProblem("the recording ends at tick " + std::to_string(simulation_->tick()) +
                                       ": the run continues from tick " + std::to_string(simulation->tick())));
    if (const Result<void> written = recorder_->Finish(); !written) std::cerr << Format(written.error());
    recorder_.reset();
  }
  sim::ObserveScripts(*simulation_, nullptr);
  simulation_->Finish();
  simulation_->TakeEvents();
  simulation->TakeEvents();  // These were reported when they happened.
  simulation_ = std::move(simulation);
  if (mission_ != nullptr) mission_->Leave();
  unrecorded_.clear();
  // Changes on disk since then are applied as edits of the new run.
  if (edits_ != nullptr) edits_ = std::make_unique<sim::LiveEdits>(*simulation_, *edits_);
  if (was_recorded && on_branch_) on_branch_(at, inputs);
}

bool RunSession::IsOver() const {
  return WasInterrupted() || simulation_->time_s() >= end_s_ ||
         (ends_with_scenario_ && (simulation_->HasEnded() || (followed_ != nullptr && followed_->HasEnded())));
}

int RunSession::Finish() {
  if (expects_inputs_ && simulation_->waiting_inputs() > 0 && !WasInterrupted())
    Remark(Severity::kWarning,
           NewProblem("the run ended before " + std::to_string(simulation_->waiting_inputs()) + " of its inputs",
                      "let it run longer with --seconds"));
  sim::ObserveScripts(*simulation_, nullptr);
  simulation_->Finish();
  PrintEvents();
  if (recorder_ != nullptr) {
    if (const Result<void> written = recorder_->Finish(); !written) std::cerr << Format(written.error());
  }
  RunFooter footer;
  footer.ticks = simulation_->tick();
  footer.time_s = simulation_->time_s();
  footer.state_hash = simulation_->StateHash();
  footer.agents = simulation_->Snapshot().agents.size();
  footer.soar_agents = simulation_->present_soar_agents();
  footer.problems = problems_;
  footer.findings = findings_.Ranked();
  printer_->End(footer);
  // The exit code of a process is one byte. Other codes of scripts become 255.
  constexpr int kMostCode = 255;
  const int asked = simulation_->ExitCode();
  if (asked != 0) return asked > 0 && asked < kMostCode ? asked : kMostCode;
  return problems_ == 0 ? kOk : kProblems;
}

void RunSession::PrintEvents() {
  sim::EventList events = simulation_->TakeEvents();
  findings_.See(events);
  for (sim::RunEvent& event : events) {
    const bool is_problem =
        event.kind == sim::EventKind::kAgentFailed || event.kind == sim::EventKind::kMindFailed ||
        (event.kind == sim::EventKind::kDiagnostic && event.diagnostic.severity == Severity::kError);
    if (is_problem) ++problems_;
    printer_->Print(event);
    if (recorder_ != nullptr || on_tick_ || mission_ != nullptr || simulation_->tick() == 0)
      unrecorded_.push_back(std::move(event));
  }
  if (mission_ != nullptr) mission_->See(unrecorded_);
  // A run may be ended at any moment, so its output is flushed.
  if (!events.empty()) std::cout.flush();
}

}  // namespace soarbox::app
