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
#include "workbench/contents.h"
#include "workbench/desk_common.h"
#include "workbench/file_desk.h"
#include "workbench/live_run.h"
#include "workbench/mind_change.h"
#include "workbench/requests.h"
#include "workbench/surroundings.h"
#include "workbench/time_machine.h"
#include "workbench/trail.h"

namespace soarbox::workbench {

/// What everybody who watches a run works with. It follows the run tick by tick, carries out requests, and fills in
/// what the panels in view show whenever the tick or the question has changed. The same code shows a recording: a run
/// whose every tick is past.
///
/// Watching changes nothing: only what the user does changes the run.
///
///   Desk desk(run, header, scenario, settings, surroundings);
///   Contents contents;
///   while (...) {
///     desk.Prepare();
///     ... the run's next tick ...
///     if (desk.Serve(requests, contents)) ... show the contents anew; contents.moment is new each time ...
///   }
class Desk {
 public:
  /// The run tells it of each tick from now on and must outlive it, and so must the surroundings.
  Desk(LiveRun& run, const record::Header& header, const sim::Scenario& scenario,
       const sim::SimulationSettings& settings, Surroundings& surroundings);
  /// Of these ticks of a recording, which must live longer.
  Desk(record::Reader& recording, const sim::DataFolders& data, record::TickRange range, Surroundings& surroundings);
  ~Desk();

  /// What outlives the run: files that are being edited, breakpoints, the text of consoles, watches.
  struct Belongings;
  Belongings TakeBelongings();
  /// Of a desk whose run has begun again.
  void Bring(Belongings belongings);

  /// Shows another tick of a recording. The user moves it, too, with the scrubber.
  void Show(std::uint64_t tick);
  /// Which ticks there are, and which of them is shown.
  const TimeMachine& past() const { return past_; }
  /// Call it before the ticks of a frame: minds then note what breakpoints and the selected agent's panels need.
  void Prepare();
  /// True if the last tick hit a breakpoint: stop the world.
  bool WasHit() const { return !hits_.empty() && hit_is_new_; }
  /// Carries out requests and refreshes the contents of the panels in view. Call it in each frame, or a few times per
  /// second, always with the same contents. Returns false if nothing but the moment may have changed.
  bool Serve(const std::vector<Request>& requests, Contents& contents);
  /// The agent of this number in the scene that is shown; empty: there is none.
  std::string NameOf(std::uint32_t agent_id);
  /// Adds a problem to the list.
  void NoteProblem(Diagnostic diagnostic, std::string agent);
  /// The scene to draw instead of the live one; null while live.
  const world::SceneSnapshot* PastScene();
  /// Nothing is still being read or simulated again: Serve would fill in the same contents again.
  bool IsSettled();
  /// Lets the world run again: forgets why it stopped, and shows the newest moment.
  void GoOn();
  /// From now on compares the selected agent's mind after each tick with what it is now. Returns why it cannot; empty
  /// if it can.
  std::string AwaitChange() { return change_.Await(common_.Live(), agent_, past_.last_tick()); }
  MindChange& change() { return change_; }
  /// Takes notes of this agent from now on, as if it were selected.
  void Follow(const std::string& agent) { agent_ = wanted_agent_ = agent; }

 private:
  using Clock = std::chrono::steady_clock;
  void OnTick(const record::TickRecord& tick);
  /// What the models that grow with a run take from a tick, live or recorded.
  void Learn(const record::TickRecord& tick);
  /// Reads on in a recording, a slice of time per call: for the models up to its end, for recorded minds up to the tick
  /// that is shown.
  void ReadOn();
  /// Recorded minds are those of the tick that is shown.
  bool HasReadOn() const { return !recorded_.empty() && recorded_.last_tick() == past_.shown_tick(); }
  /// Reads what was before plots that were asked for late, a slice of time per call.
  void FillPlots();
  bool HasMind(const std::string& agent);
  /// Why a recording tells nothing of the selected agent's mind at the tick that is shown.
  std::string NotRecorded() const;

  // What the user asks for (desk_requests.cpp).
  void Obey(const Request& request);
  void Resume();
  /// Keeps what was typed and not saved or sent on the disk, now and then, or `at_once`.
  void KeepDrafts(bool at_once);
  struct Visitor;

  // What the panels show (desk_contents.cpp).
  /// Selects another agent if the user wants one, and forgets what was asked about the one before.
  void LookAtAgent(Contents& contents);
  void Refresh(Contents& contents);
  void FillMoment(Contents& contents);
  /// How many agents there are, and which of them have a mind.
  void FillSoarAgents(Contents& contents, const record::TickRecord* shown);
  void FillMind(Contents& contents, explain::Inspector& mind);
  /// The minds that are looked at side by side.
  void FillBeside(Contents& contents, bool watches, bool minds);
  /// What can be opened, and where a text stands that is searched everywhere.
  void FillOffers(Contents& contents, explain::Inspector* mind);
  /// The rule that is looked at as its author wrote it.
  void FillRuleText(Contents& contents);
  /// Everything that went wrong, ranked as `soarbox run` and `learn check` rank it.
  std::vector<ProblemRow> RankedProblems() const;
  /// What bodies do now.
  void FillActivities(Contents& contents);
  void FillWhy(Contents& contents, explain::Inspector* mind);
  /// With where everybody was in the old future.
  void FillFutures(Contents& contents);
  void FillLongTerm(Contents& contents, explain::Inspector* mind);
  void FillLearning(Contents& contents, explain::Inspector* mind);
  /// With what is drawn of it over the world.
  void FillImagery(Contents& contents, explain::Inspector* mind);
  /// Adds what the selected agent remembers of the episode that is looked at.
  void AddRemembered(const world::SceneSnapshot& scene, Contents& contents) const;
  auto NoteProblems() {
    return [this](Diagnostic diagnostic, std::string agent) { NoteProblem(std::move(diagnostic), std::move(agent)); };
  }

  LiveRun* run_ = nullptr;               ///< Null: a recording.
  record::Reader* recording_ = nullptr;  ///< Null: a live run.
  Surroundings& surroundings_;
  const int turn_ticks_;
  std::uint64_t next_tick_ = 0;  ///< Of the recording, for the models.
  debugger::RecordedMinds recorded_;
  TimeMachine past_;
  DeskCommon common_;
  FileDesk files_;
  ConsoleDesk consoles_;
  MindChange change_;
  debugger::RunModels models_;
  std::deque<debugger::PlotHistory> histories_;  ///< Still to be read; the first one is under way.
  std::uint64_t history_tick_ = 0;               ///< Next for it; 0: not begun.
  debugger::Breakpoints breakpoints_;
  std::vector<debugger::BreakHit> hits_;
  bool hit_is_new_ = false;
  std::vector<ProblemRow> problems_;  ///< In order of time.
  sim::EventFindings findings_;       ///< Refused commands and idle agents.
  std::vector<CheckRow> checks_;
  std::string news_;  ///< To be told at once; empty: nothing.
  std::map<std::string, debugger::Coverage> coverage_;
  debugger::MemoryChanges changes_;  ///< Of the selected agent in the tick that is shown.

  // What the user looks at.
  static constexpr std::size_t kMostCurves = 6;
  PanelSet visible_;
  std::string wanted_agent_;  ///< The agent to select as soon as the world has it.
  std::string agent_;
  std::string noted_agent_;  ///< The one whose mind was asked to note all.
  std::string state_, search_, rule_;
  std::vector<std::string> watches_, beside_;  ///< What is watched, and of which agents; none: of the selected one.
  std::map<std::pair<std::string, std::string>, WatchRow::Cell> watched_;  ///< By what and agent: shown last.
  std::set<std::string> open_objects_;
  bool unfolds_top_ = true;  ///< The top state is to be unfolded: another agent was selected.
  std::string known_search_;
  std::string learned_rule_;  ///< Whose explanation is looked at; empty: none.
  std::size_t episode_ = 0;   ///< Of the selected agent, as ghosts; 0: none.
  std::uint64_t timetag_ = 0;
  Trail elements_;                   ///< Time tags of elements that the user has looked at.
  std::vector<std::string> curves_;  ///< Rules whose learned values are drawn.
  bool has_chosen_curves_ = false;   ///< Else those that moved most often are drawn.
  bool wants_coverage_ = false;
  debugger::TraceFilter trace_filter_;
  std::string watch_fault_;       ///< Why what was to be watched last cannot be; empty: it can.
  bool traces_selected_ = false;  ///< Only lines about the selected agent.
  debugger::TraceSearch trace_search_;
  std::string searched_;  ///< Everywhere; empty: nothing.
  bool offers_ = false;   ///< Somebody is about to choose what to open.
  WhyRequest why_;
  ImagineRequest imagined_;
  Clock::time_point kept_drafts_, read_recent_;

  bool is_stale_ = true;  ///< The user asked for something that is not shown yet.
  std::uint64_t refreshed_tick_ = ~std::uint64_t{0};
  PanelSet refreshed_panels_;
  std::string refreshed_note_;
  Clock::time_point refreshed_at_;
  Clock::time_point sought_at_;
  std::optional<std::uint64_t> resume_at_;  ///< The run is to go on from this tick, which is being rebuilt.
  world::SceneSnapshot past_scene_;
  std::uint64_t past_scene_tick_ = ~std::uint64_t{0};
  bool has_told_damage_ = false;
};

struct Desk::Belongings {
  FileDesk::Belongings files;
  ConsoleDesk::Belongings consoles;
  std::vector<debugger::Breakpoint> breakpoints;
  std::vector<std::string> watches, beside;
};

}  // namespace soarbox::workbench
