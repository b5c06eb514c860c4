// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <chrono>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "debugger/breakpoints.h"
#include "debugger/recorded_mind.h"
#include "debugger/rules.h"
#include "debugger/run_models.h"
#include "record/export.h"
#include "record/reader.h"
#include "workbench/checks.h"
#include "workbench/console_desk.h"
#include "workbench/desk_common.h"
#include "workbench/file_desk.h"
#include "workbench/live_run.h"
#include "workbench/mind_change.h"
#include "workbench/panel_exchange.h"
#include "workbench/script_desk.h"
#include "workbench/surroundings.h"
#include "workbench/time_machine.h"
#include "workbench/trail.h"

namespace soarbox::workbench {

/// The model behind the panels. A desk follows a run tick by tick, carries out the user's requests, and fills in the
/// contents of the visible panels when the tick or the user's selection has changed. It also shows recordings, in which
/// every tick is past.
///
/// A desk changes the run only if a request of the user does.
///
///   Desk desk(run, header, scenario, settings, surroundings);
///   PanelExchange panels;
///   while (...) {
///     desk.Prepare();
///     ... the run's next tick ...
///     ... panels.requests.push_back(...) ...
///     if (desk.Serve(panels)) ... draw panels.contents again; their moment changes in each call ...
///   }
class Desk {
 public:
  /// Subscribes to the ticks of the run. The run and the surroundings must outlive the desk.
  Desk(LiveRun& run, const record::Header& header, const sim::Scenario& scenario,
       const sim::SimulationSettings& settings, Surroundings& surroundings);
  /// Shows these ticks of a recording, which must outlive the desk.
  Desk(record::Reader& recording, const sim::DataFolders& data, record::TickRange range, Surroundings& surroundings);
  ~Desk();

  /// The state that is passed on to the next run: edited files, breakpoints, texts of consoles, watches.
  struct Belongings;
  Belongings TakeBelongings();
  /// Takes over the state of the desk of the previous run.
  void Bring(Belongings belongings);

  /// Shows another tick of a recording. The user can do the same with the scrubber.
  void Show(std::uint64_t tick);
  /// The available ticks and the one that is shown.
  const TimeMachine& past() const { return past_; }
  /// Sets the detail that minds record to what breakpoints and the selected agent's panels need. Call it before the
  /// ticks of a frame.
  void Prepare();
  /// Whether the last tick hit a breakpoint. The caller must then pause the world.
  bool WasHit() const { return !hits_.empty() && hit_is_new_; }
  /// Carries out and removes the requests, and updates the contents of the visible panels. Call it in each frame, or a
  /// few times per second, always with the same `panels`. Returns false if only `moment` may have changed. While a
  /// script is stopped, only the contents of the panels Script, Edit, Problems and Breakpoints are updated. Requests
  /// that would read a mind, or go to another tick, are refused then.
  bool Serve(PanelExchange& panels);
  /// The name of the agent with this id in the scene that is shown; empty if there is none.
  std::string NameOf(std::uint32_t agent_id);
  /// Adds a problem to the list.
  void NoteProblem(Diagnostic diagnostic, std::string agent);
  /// The scene to draw instead of the live one; null while a live run shows its newest tick. Never null for a
  /// recording.
  const world::SceneSnapshot* PastScene();
  /// Whether the recording is read and the past is rebuilt, so that Serve would fill in the same contents again.
  bool IsSettled();
  /// Call it when the world runs again. Clears the hit breakpoints and shows the newest tick.
  void GoOn();
  /// Starts to compare the selected agent's mind after each tick with its present state. Returns an error message, or
  /// an empty string.
  std::string AwaitChange() { return change_.Await(common_.Live(), agent_, past_.last_tick()); }
  MindChange& change() { return change_; }
  /// The scripts of the run, one of which may be stopped in the middle of a tick.
  ScriptDesk& scripts() { return scripts_; }

 private:
  using Clock = std::chrono::steady_clock;
  void OnTick(const record::TickRecord& tick);
  /// Updates the models that grow with the run from a tick, live or recorded.
  void Learn(const record::TickRecord& tick);
  /// Continues to read a recording, for a limited time per call: for the models up to the end of the range, for
  /// recorded minds up to the tick that is shown.
  void ReadOn();
  /// Whether recorded_ is at the tick that is shown.
  bool HasReadOn() const { return !recorded_.empty() && recorded_.last_tick() == past_.shown_tick(); }
  /// Reads the earlier points of plots that were added late, for a limited time per call.
  void FillPlots();
  bool HasMind(const std::string& agent);
  /// Why the recording has no data of the selected agent's mind at the tick that is shown.
  std::string NotRecorded() const;

  // Requests of the user (desk_requests.cpp).
  void Obey(const Request& request);
  void Resume();
  /// Notes that the user has changed the rules of the live world, if that is so.
  void NoteChangedRules();
  /// Saves unsaved text and unsent lines to the disk: at certain intervals, or now if `at_once`.
  void KeepDrafts(bool at_once);
  struct Visitor;

  // Contents of the panels (desk_contents.cpp).
  /// Selects `wanted_agent_` if the shown scene has it, else no agent. If the agent changes, clears what was selected
  /// of the previous one.
  void LookAtAgent(Contents& contents);
  bool ServeStopped(const std::vector<Request>& requests, Contents& contents);
  void Refresh(Contents& contents);
  void FillMoment(Contents& contents);
  /// Fills in the number of agents, and which of them have a mind.
  void FillSoarAgents(Contents& contents, const record::TickRecord* shown);
  void FillMind(Contents& contents, explain::Inspector& mind);
  /// Fills in the minds that are shown side by side.
  void FillBeside(Contents& contents, bool watches, bool minds);
  /// Fills in what can be opened, and the matches of the search everywhere.
  void FillOffers(Contents& contents, explain::Inspector* mind);
  /// Fills in the selected rule as its author wrote it.
  void FillRuleText(Contents& contents);
  /// All problems, in the order that `soarbox run` and `learn check` use.
  std::vector<ProblemRow> RankedProblems() const;
  /// Fills in what bodies do now.
  void FillActivities(Contents& contents);
  void FillWhy(Contents& contents, explain::Inspector* mind);
  /// Fills in the comparison of futures, and the positions of agents in the old future as ghosts.
  void FillFutures(Contents& contents);
  void FillLongTerm(Contents& contents, explain::Inspector* mind);
  void FillLearning(Contents& contents, explain::Inspector* mind);
  /// Fills in imagined scenes, and the parts that are drawn over the world.
  void FillImagery(Contents& contents, explain::Inspector* mind);
  /// Adds the objects of the selected episode as ghosts.
  void AddRemembered(const world::SceneSnapshot& scene, Contents& contents) const;
  auto NoteProblems() {
    return [this](Diagnostic diagnostic, std::string agent) { NoteProblem(std::move(diagnostic), std::move(agent)); };
  }
  /// Drops the problems of a file up to the tick that is shown.
  auto ForgetProblems() {
    return [this](const std::string& file) {
      std::erase_if(problems_, [&](const ProblemRow& one) {
        return one.diagnostic.file == file && one.tick <= past_.shown_tick();
      });
    };
  }

  LiveRun* run_ = nullptr;               ///< Null for a recording.
  record::Reader* recording_ = nullptr;  ///< Null for a live run.
  Surroundings& surroundings_;
  const int turn_ticks_;
  std::uint64_t next_tick_ = 0;  ///< The next tick of the recording to add to the models.
  debugger::RecordedMinds recorded_;
  TimeMachine past_;
  DeskCommon common_;
  FileDesk files_;
  ScriptDesk scripts_;
  ConsoleDesk consoles_;
  MindChange change_;
  debugger::RunModels models_;
  std::deque<debugger::PlotHistory> histories_;  ///< Histories of plots that still have to be read; the first one is in
                                                 ///< progress.
  std::uint64_t history_tick_ = 0;               ///< Next tick to read for the first history; 0: not begun.
  debugger::Breakpoints breakpoints_;
  std::vector<debugger::BreakHit> hits_;
  bool hit_is_new_ = false;
  std::vector<ProblemRow> problems_;  ///< In order of time.
  sim::EventFindings findings_;       ///< Refused commands and idle agents.
  std::vector<CheckRow> checks_;
  std::optional<std::uint64_t> changed_tick_;  ///< The tick at which the user last changed the rules of the live world.
  std::string news_;                           ///< A message to show at once; empty: none.
  std::map<std::string, debugger::Coverage> coverage_;
  debugger::MemoryChanges changes_;  ///< Of the selected agent, in the tick that is shown.

  // What the user has selected.
  static constexpr std::size_t kMostCurves = 6;
  PanelSet visible_;
  std::string wanted_agent_;  ///< The agent to select as soon as the world has it.
  std::string agent_;
  std::string noted_agent_;  ///< The agent whose mind records all details.
  std::string state_, search_, rule_;
  std::vector<std::string> watches_, beside_;  ///< The watches, and the agents whose values and minds are shown. If
                                               ///< there are no such agents: the selected one.
  std::map<std::pair<std::string, std::string>, WatchRow::Cell> watched_;  ///< By watch and agent: the cell that was
                                                                           ///< shown last.
  std::set<std::string> open_objects_;
  bool unfolds_top_ = true;  ///< The top state is to be unfolded, because another agent was selected.
  std::string known_search_;
  std::string learned_rule_;  ///< The selected learned rule; empty: none.
  std::size_t episode_ = 0;   ///< The selected episode of the agent, drawn as ghosts; 0: none.
  std::uint64_t timetag_ = 0;
  Trail elements_;                   ///< Time tags of the elements that the user has viewed.
  std::vector<std::string> curves_;  ///< Rules whose learned values are drawn.
  bool has_chosen_curves_ = false;   ///< If not, the rules whose values were updated most often are drawn.
  bool wants_coverage_ = false;
  debugger::TraceFilter trace_filter_;
  std::string watch_fault_;       ///< Why the last watch was not accepted; empty if it was.
  bool traces_selected_ = false;  ///< Only lines about the selected agent.
  debugger::TraceSearch trace_search_;
  std::string searched_;  ///< The text searched for everywhere; empty: none.
  bool offers_ = false;   ///< The user is about to choose something to open.
  WhyRequest why_;
  ImagineRequest imagined_;
  Clock::time_point kept_drafts_, read_recent_;

  bool is_stale_ = true;  ///< The contents have to be filled in again, even if the shown tick is the same.
  std::uint64_t refreshed_tick_ = ~std::uint64_t{0};
  PanelSet refreshed_panels_;
  std::string refreshed_note_;
  Clock::time_point refreshed_at_;
  Clock::time_point sought_at_;
  std::optional<std::uint64_t> resume_at_;  ///< The run is to continue from this tick once it is rebuilt.
  world::SceneSnapshot past_scene_;
  std::uint64_t past_scene_tick_ = ~std::uint64_t{0};
  bool has_told_damage_ = false;
};

struct Desk::Belongings {
  FileDesk::Belongings files;
  ScriptDesk::Belongings scripts;
  ConsoleDesk::Belongings consoles;
  std::vector<debugger::Breakpoint> breakpoints;
  std::vector<std::string> watches, beside;
};

}  // namespace soarbox::workbench
