// SPDX-License-Identifier: BSD-2-Clause
#include "app/desk.h"

#include <utility>

namespace soarbox::app {
namespace {

constexpr std::size_t kMostProblems = 500;

bool IsProblem(const sim::Event& event) {
  return event.kind == sim::EventKind::kAgentFailed || event.kind == sim::EventKind::kMindFailed ||
         (event.kind == sim::EventKind::kDiagnostic && event.diagnostic.severity != Severity::kNote);
}

}  // namespace

Desk::Desk(RunSession& session, const record::Header& header, const sim::Scenario& scenario,
           const sim::SimulationSettings& settings)
    : session_(session), past_(header, scenario, settings) {
  session_.Watch([this](const record::TickRecord& tick) { OnTick(tick); });
}

Desk::~Desk() {
  session_.Watch({});
}

void Desk::Prepare() {
  hit_is_new_ = false;
  sim::Simulation& simulation = session_.simulation();
  breakpoints_.Prepare(simulation);
  if (noted_agent_ == agent_ || past_.branches() > 0) return;  // Minds of another future note all.
  // Breakpoints may need the one before; they ask again in each frame.
  if (!noted_agent_.empty()) simulation.NoteMind(noted_agent_, sim::MindDetail::kDecisions);
  if (!agent_.empty()) simulation.NoteMind(agent_, sim::MindDetail::kAll);
  noted_agent_ = agent_;
}

void Desk::OnTick(const record::TickRecord& tick) {
  past_.Add(tick);
  models_.Add(tick);
  for (const sim::Event& event : tick.events) {
    if (!IsProblem(event)) continue;
    problems_.push_back({event.diagnostic, event.agent, tick.tick, tick.scene.time_s});
    if (problems_.size() > kMostProblems) problems_.erase(problems_.begin());
  }
  for (auto& [agent, coverage] : coverage_) {
    if (const record::MindRecord* mind = record::FindMind(tick, agent)) coverage.Add(tick.tick, *mind);
  }
  for (auto& [agent, console] : consoles_) {
    const std::size_t before = console.lines().size();
    console.Add(tick.events);
    if (console.lines().size() != before) ++console_lines_;
  }
  const sim::Simulation& simulation = session_.simulation();
  models_.plots.Sample(simulation);
  if (breakpoints_.list().empty()) return;
  if (std::vector<debugger::BreakHit> hits = breakpoints_.Check(simulation); !hits.empty()) {
    hits_ = std::move(hits);
    hit_is_new_ = true;
    is_stale_ = true;
  }
}

void Desk::NoteProblem(Diagnostic diagnostic, std::string agent) {
  const sim::Simulation& simulation = session_.simulation();
  problems_.push_back({std::move(diagnostic), std::move(agent), simulation.tick(), simulation.time_s()});
  is_stale_ = true;
}

const world::SceneSnapshot* Desk::PastScene() {
  if (past_.is_live()) return nullptr;
  if (past_scene_tick_ != past_.shown_tick()) {
    if (const record::TickRecord* record = past_.Shown()) past_scene_ = record->scene;
    past_scene_tick_ = past_.shown_tick();
  }
  return &past_scene_;
}

void Desk::GoOn() {
  hits_.clear();
  past_.GoLive();
  is_stale_ = true;
}

sim::Simulation* Desk::Looked() {
  return past_.is_live() ? &session_.simulation() : past_.past();
}

debugger::Console& Desk::ConsoleOf(const std::string& agent) {
  return consoles_.try_emplace(agent, agent).first->second;
}

}  // namespace soarbox::app
