// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/pace.h"
#include "app/run_session.h"
#include "app/time_machine.h"
#include "debugger/breakpoints.h"
#include "debugger/console.h"
#include "debugger/edit.h"
#include "debugger/rules.h"
#include "debugger/run_models.h"
#include "viewer/viewer.h"

namespace soarbox::app {

/// What the window's panels work with: follows the run tick by tick, carries out what the user asks for in panels, and
/// fills in what the visible ones show when the tick or the question has changed.
///
/// The run itself is the same with it and without, but for what the user does.
class Desk {
 public:
  /// The session tells it of each tick from now on and must outlive it.
  Desk(RunSession& session, const record::Header& header, const sim::Scenario& scenario,
       const sim::SimulationSettings& settings);
  ~Desk();

  /// Before the ticks of a frame: minds note what breakpoints and the selected agent's panels need.
  void Prepare();
  /// Whether a breakpoint was hit in the last tick: the world is to stand still.
  bool WasHit() const { return !hits_.empty() && hit_is_new_; }
  /// Carries out what was asked for, and refreshes the contents of the visible panels. Each frame.
  void Serve(viewer::Viewer& viewer, Pace& pace);
  /// The scene to draw instead of the live one; null while live.
  const world::SceneSnapshot* PastScene();
  bool is_live() const { return past_.is_live(); }
  /// The user lets the world go on: what stopped it is over, and the newest moment is shown.
  void GoOn();
  /// Takes notes of this agent from now on, as if it were selected.
  void Follow(const std::string& agent) { agent_ = agent; }

 private:
  using Clock = std::chrono::steady_clock;

  void OnTick(const record::TickRecord& tick);
  void NoteProblem(Diagnostic diagnostic, std::string agent);

  // What the user asks for (desk_requests.cpp).
  void Obey(const viewer::PanelRequest& request, viewer::Viewer& viewer, Pace& pace);
  void Resume(Pace& pace);
  void OpenEdit(const viewer::EditRequest& request);
  void ChangeText(const viewer::EditTextRequest& request);
  void Type(const viewer::ConsoleRequest& request);
  struct Visitor;

  // What the panels show (desk_contents.cpp).
  void Refresh(viewer::Viewer& viewer);
  void FillMoment(viewer::PanelContents& contents);
  void FillMind(viewer::Viewer& viewer, sim::Inspector& mind);
  void FillWhy(viewer::PanelContents& contents, sim::Inspector* mind);
  void FillFutures(viewer::Viewer& viewer);
  /// The world that the panels look into: the live one, or the rebuilt past; null while that is not there.
  sim::Simulation* Looked();
  debugger::Console& ConsoleOf(const std::string& agent);

  RunSession& session_;
  TimeMachine past_;
  debugger::RunModels models_;
  debugger::Breakpoints breakpoints_;
  std::vector<debugger::BreakHit> hits_;
  bool hit_is_new_ = false;
  std::vector<viewer::ProblemRow> problems_;
  std::map<std::string, debugger::Console> consoles_;
  std::uint64_t console_lines_ = 0;
  std::map<std::string, debugger::Coverage> coverage_;
  debugger::MemoryChanges changes_;  ///< Of the selected agent in the tick that is shown.

  // What the user looks at.
  std::string agent_;
  std::string noted_agent_;  ///< The one whose mind was asked to note all.
  std::string state_, search_, rule_;
  std::set<std::string> open_objects_;
  std::uint64_t timetag_ = 0;
  bool wants_coverage_ = false;
  viewer::WhyRequest why_;
  std::optional<debugger::Edit> edit_;
  viewer::EditContents edit_contents_;
  std::string completed_line_;
  debugger::Completion completion_;

  bool is_stale_ = true;  ///< The user asked for something else than what is shown.
  std::uint64_t refreshed_tick_ = ~std::uint64_t{0};
  std::uint64_t refreshed_panels_ = 0;
  std::string refreshed_note_;
  Clock::time_point refreshed_at_;
  Clock::time_point sought_at_;
  world::SceneSnapshot past_scene_;
  std::uint64_t past_scene_tick_ = ~std::uint64_t{0};
};

}  // namespace soarbox::app
