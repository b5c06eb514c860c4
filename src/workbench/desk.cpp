// SPDX-License-Identifier: BSD-2-Clause
#include "workbench/desk.h"

#include <algorithm>
#include <utility>

#include "record/rerun.h"
#include "sim/scenario_file.h"

namespace soarbox::workbench {
namespace {

constexpr std::size_t kMostProblems = 500;

bool IsProblem(const sim::RunEvent& event) {
  return event.kind == sim::EventKind::kMindLost || event.kind == sim::EventKind::kMindBack ||
         event.kind == sim::EventKind::kAgentFailed || event.kind == sim::EventKind::kMindFailed ||
         (event.kind == sim::EventKind::kDiagnostic && event.diagnostic.severity != Severity::kNote);
}

std::uint64_t FirstOf(const record::Reader& recording, record::TickRange range) {
  return std::clamp(range.first, recording.first_tick(), recording.last_tick());
}
std::uint64_t LastOf(const record::Reader& recording, record::TickRange range) {
  return std::clamp(range.last, FirstOf(recording, range), recording.last_tick());
}

std::filesystem::path FileOf(const sim::Scenario& scenario) {
  if (!scenario.rules.empty()) return scenario.Original(scenario.rules);
  return scenario.Original(scenario.definition.empty() ? scenario.script : scenario.definition);
}

/// Events of a kernel in another process have only text; other events have a diagnostic.
Diagnostic DiagnosticOf(const sim::RunEvent& event) {
  Diagnostic diagnostic = event.diagnostic;
  const bool is_lost = event.kind == sim::EventKind::kMindLost;
  if (!is_lost && event.kind != sim::EventKind::kMindBack) return diagnostic;
  diagnostic.severity = is_lost ? Severity::kError : Severity::kNote;
  diagnostic.message = event.text;
  if (is_lost) diagnostic.hint = "the world keeps running; start a kernel there again (soarbox kernel --port N)";
  return diagnostic;
}

}  // namespace

Desk::Desk(LiveRun& run, const record::Header& header, const sim::Scenario& scenario,
           const sim::SimulationSettings& settings, Surroundings& surroundings)
    : run_(&run),
      surroundings_(surroundings),
      turn_ticks_(sim::TurnTicks(scenario)),
      past_(header, scenario, settings),
      common_{&run, past_, surroundings, NoteProblems(), ForgetProblems()},
      files_(common_),
      scripts_(common_, files_),
      consoles_(common_, FileOf(scenario)) {
  run.Watch([this](const record::TickRecord& tick) { OnTick(tick); });
  run.SetOnEdit([this](const Diagnostic& told) {
    if (told.severity != Severity::kNote) NoteProblem(told, {});
  });
}

Desk::Desk(record::Reader& recording, const sim::DataFolders& data, record::TickRange range, Surroundings& surroundings)
    : recording_(&recording),
      surroundings_(surroundings),
      turn_ticks_(record::TurnTicks(recording.header())),
      next_tick_(recording.first_tick()),
      recorded_(recording.header().level),
      past_(recording, data, FirstOf(recording, range), LastOf(recording, range)),
      common_{nullptr, past_, surroundings, NoteProblems(), ForgetProblems()},
      files_(common_),
      scripts_(common_, files_),
      consoles_(common_, std::filesystem::path(recording.header().folder) / recording.header().scenario) {}

Desk::~Desk() {
  KeepDrafts(true);
  if (run_ != nullptr) {
    run_->Watch({});
    run_->SetOnEdit({});
  }
}

Desk::Belongings Desk::TakeBelongings() {
  KeepDrafts(true);
  return {files_.Take(), scripts_.Take(), consoles_.Take(), breakpoints_.list(), watches_, beside_};
}

void Desk::Bring(Belongings belongings) {
  files_.Bring(std::move(belongings.files));
  scripts_.Bring(belongings.scripts);
  consoles_.Bring(std::move(belongings.consoles));
  for (const debugger::Breakpoint& kept : belongings.breakpoints) {
    const Result<int> set = breakpoints_.Set(kept.kind, kept.agent, kept.what);
    if (set && !kept.enabled) breakpoints_.Enable(*set, false);
  }
  watches_ = std::move(belongings.watches);
  beside_ = std::move(belongings.beside);
}

void Desk::KeepDrafts(bool at_once) {
  constexpr auto kEvery = std::chrono::seconds(1);
  if (!at_once && Clock::now() - kept_drafts_ < kEvery) return;
  kept_drafts_ = Clock::now();
  files_.KeepDrafts();
  consoles_.KeepDrafts();
}

void Desk::Prepare() {
  hit_is_new_ = false;
  if (run_ == nullptr) return;
  scripts_.Prepare();
  sim::Simulation& simulation = run_->simulation();
  breakpoints_.Prepare(simulation);
  // After the run went back, its simulation is a rebuilt one, in which all minds record all details.
  if (noted_agent_ == agent_ || past_.parting() != nullptr) return;
  // Breakpoints may still need the previous agent; they request details again in each frame.
  const sim::MindDetail least = std::max(sim::MindDetail::kDecisions, run_->LeastDetail());
  if (!noted_agent_.empty()) simulation.NoteMind(noted_agent_, least);
  if (!agent_.empty()) simulation.NoteMind(agent_, sim::MindDetail::kAll);
  noted_agent_ = agent_;
}

void Desk::OnTick(const record::TickRecord& tick) {
  past_.Add(tick);
  Learn(tick);
  for (const sim::RunEvent& event : tick.events) {
    if (event.kind == sim::EventKind::kMindLost || event.kind == sim::EventKind::kMindBack) news_ = event.text;
  }
  consoles_.Add(tick.events);
  sim::Simulation& simulation = run_->simulation();
  models_.plots.Sample(simulation);
  change_.Look(simulation, tick);
  if (breakpoints_.list().empty()) return;
  if (std::vector<debugger::BreakHit> hits = breakpoints_.Check(simulation, tick.events); !hits.empty()) {
    hits_ = std::move(hits);
    hit_is_new_ = true;
    is_stale_ = true;
  }
}

void Desk::Learn(const record::TickRecord& tick) {
  models_.Add(tick);
  findings_.See(tick.events);
  for (const sim::RunEvent& event : tick.events) {
    is_stale_ |= NoteCheck(event, checks_);
    if (!IsProblem(event)) continue;
    const Diagnostic problem = DiagnosticOf(event);
    problems_.push_back({problem, event.agent, tick.tick, tick.scene.time_s, sim::CauseOf(problem)});
    if (problems_.size() > kMostProblems) problems_.erase(problems_.begin());
  }
  for (auto& [agent, coverage] : coverage_) {
    if (const record::MindRecord* mind = record::FindMind(tick, agent)) coverage.Add(tick.tick, *mind);
  }
}

void Desk::Show(std::uint64_t tick) {
  past_.Seek(tick);
}

void Desk::ReadOn() {
  if (recording_ == nullptr) return;
  constexpr auto kSlice = std::chrono::milliseconds(12);
  const Clock::time_point begin = Clock::now();
  const auto is_out_of_time = [&] { return Clock::now() - begin > kSlice; };
  // Damaged ticks are skipped. PastScene reports the first one that is shown.
  const std::uint64_t shown = past_.shown_tick();
  if (!recorded_.empty() && recorded_.last_tick() > shown) recorded_.Clear();
  while (!is_out_of_time()) {
    const std::uint64_t tick = recorded_.empty() ? recording_->first_tick() : recorded_.last_tick() + 1;
    if (!recorded_.empty() && recorded_.last_tick() >= shown) break;
    const Result<const record::TickRecord*> record = recording_->At(tick);
    if (record) {
      recorded_.Add(**record);
    } else {
      record::TickRecord missing;
      missing.tick = tick;
      recorded_.Add(missing);
    }
    is_stale_ |= recorded_.last_tick() == shown;
  }
  while (next_tick_ <= past_.last_tick() && !is_out_of_time()) {
    if (const Result<const record::TickRecord*> record = recording_->At(next_tick_)) Learn(**record);
    is_stale_ |= ++next_tick_ > past_.last_tick();
  }
}

bool Desk::IsSettled() {
  if (recording_ != nullptr && (!HasReadOn() || next_tick_ <= past_.last_tick())) return false;
  return past_.is_live() || past_.rebuilt().world() != nullptr || !past_.rebuilt().IsPossible();
}

void Desk::FillPlots() {
  if (histories_.empty() || past_.empty()) return;
  constexpr auto kSlice = std::chrono::milliseconds(8);
  const Clock::time_point begin = Clock::now();
  debugger::PlotHistory& history = histories_.front();
  std::uint64_t tick = std::max(history_tick_, past_.first_tick());
  while (tick <= past_.last_tick() && Clock::now() - begin < kSlice) {
    if (const record::TickRecord* record = past_.At(tick)) history.Add(*record);
    ++tick;
  }
  history_tick_ = tick;
  if (tick <= past_.last_tick()) return;
  models_.plots.Prepend(history.agent(), history.what(), history.points());
  histories_.pop_front();
  history_tick_ = 0;
  is_stale_ = true;
}

bool Desk::HasMind(const std::string& agent) {
  if (agent.empty()) return false;
  if (const sim::Simulation* live = common_.Live()) return live->HasMind(agent);
  if (const sim::Simulation* past = past_.rebuilt().world()) return past->HasMind(agent);
  // Until the recording is read up to the shown tick, the agent is assumed to have a mind.
  const bool is_known = HasReadOn() && recording_->header().level != record::Level::kWorld;
  return !is_known || recorded_.Find(agent) != nullptr;
}

void Desk::NoteProblem(Diagnostic diagnostic, std::string agent) {
  const sim::Simulation* simulation = common_.Live();
  const std::uint64_t tick = simulation != nullptr ? simulation->tick() : past_.shown_tick();
  const double time_s =
      simulation != nullptr ? simulation->time_s() : static_cast<double>(tick) * recording_->header().step_s;
  const sim::Cause cause = sim::CauseOf(diagnostic);
  problems_.push_back({std::move(diagnostic), std::move(agent), tick, time_s, cause});
  is_stale_ = true;
}

std::vector<ProblemRow> Desk::RankedProblems() const {
  std::vector<ProblemRow> rows;
  for (const sim::Finding& finding : findings_.OfAgents()) {
    ProblemRow& row = rows.emplace_back(ProblemRow{{}, finding.agent, finding.tick, finding.time_s, finding.cause});
    row.diagnostic.severity = finding.cause == sim::Cause::kRefused ? Severity::kWarning : Severity::kNote;
    row.diagnostic.message = finding.text;
  }
  rows.insert(rows.end(), problems_.begin(), problems_.end());
  std::ranges::reverse(rows);
  sim::RankByCause(rows);
  return rows;
}

const world::SceneSnapshot* Desk::PastScene() {
  if (past_.is_live()) return nullptr;
  if (past_scene_tick_ != past_.shown_tick()) {
    past_scene_tick_ = past_.shown_tick();
    if (const record::TickRecord* record = past_.Shown()) {
      past_scene_ = record->scene;
    } else if (recording_ != nullptr && !std::exchange(has_told_damage_, true)) {
      // If the tick cannot be read, the last scene is kept.
      if (const auto damaged = recording_->At(past_scene_tick_); !damaged) NoteProblem(damaged.error(), {});
    }
  }
  return &past_scene_;
}

void Desk::GoOn() {
  hits_.clear();
  past_.GoLive();
  is_stale_ = true;
}

}  // namespace soarbox::workbench
