// SPDX-License-Identifier: BSD-2-Clause
#include "app/engine/engine_window.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/data_folders.h"
#include "app/engine/engine_desk.h"
#include "app/engine/engine_page.h"
#include "app/engine/engine_watch.h"
#include "app/exit_codes.h"
#include "app/lesson.h"
#include "app/mind_steps.h"
#include "app/refuse.h"
#include "app/run_options.h"
#include "app/run_setup.h"
#include "diagnostics/problem.h"
#include "record/reader.h"
#include "record/rerun.h"
#include "serve/wall.h"
#include "sim/scenario_file.h"
#include "vocabulary/vocabulary.h"
#include "workbench/desk.h"
#include "world/world.h"

namespace soarbox::app {
namespace {

namespace fs = std::filesystem;
using workbench::Flow;
using Clock = std::chrono::steady_clock;

/// Minimum interval of contents, unless there was a request.
constexpr auto kContentsEvery = std::chrono::milliseconds(250);
/// Maximum time that an engine waits for requests, before it checks files and debuggers again: while a page is open and
/// the world is paused, and while no page is open.
constexpr int kIdle_ms = 50, kAlone_ms = 500;

/// Common parts of live runs and recordings: the open panels, and the time of the next contents.
class PanelsOfPage {
 public:
  explicit PanelsOfPage(EnginePage& page) : page_(page) {}

  /// Lets the desk execute the requests, and sends the changed contents.
  /// `at_once`: also if contents were sent a moment ago.
  void Serve(workbench::Desk& desk, std::vector<workbench::Request> requests, bool at_once = false) {
    bool is_told = shown_ == (panels_ | page_.presence().watched);
    for (workbench::Request& request : requests) {
      auto* const look = std::get_if<workbench::LookRequest>(&request);
      if (look == nullptr) continue;
      panels_ = look->panels;
      look->panels = shown_ = panels_ | page_.presence().watched;
      is_told = true;
    }
    if (!is_told) {
      shown_ = panels_ | page_.presence().watched;
      requests.emplace_back(workbench::LookRequest{shown_});
    }
    if (!at_once && requests.empty() && (page_.is_alone() || Clock::now() - served_ < kContentsEvery)) return;
    served_ = Clock::now();
    // If no contents were filled in, only the moment may have changed.
    exchange_.requests = std::move(requests);
    const bool is_new = desk.Serve(exchange_);
    page_.ShowContents(exchange_.contents, !is_new                       ? workbench::PanelSet()
                                           : desk.scripts().is_stopped() ? ShownInTick()
                                                                         : shown_);
  }
  /// After the desk was replaced, all contents are filled in again.
  std::vector<workbench::Request> BeginAgain() {
    std::string agent = exchange_.contents.agent;
    exchange_.contents = {};
    return {workbench::LookRequest{panels_}, workbench::SelectRequest{std::move(agent)}};
  }
  const std::string& agent() const { return exchange_.contents.agent; }

 private:
  /// The visible panels that a desk fills in while a script is stopped.
  workbench::PanelSet ShownInTick() const {
    workbench::PanelSet panels;
    for (const workbench::PanelId id :
         {workbench::PanelId::kScript, workbench::PanelId::kEdit, workbench::PanelId::kProblems})
      if (shown_.Has(id)) panels.Add(id);
    return panels;
  }

  EnginePage& page_;
  workbench::PanelSet panels_;  ///< Of the user whose run it is.
  workbench::PanelSet shown_;   ///< Including those of users who watch.
  workbench::PanelExchange exchange_;
  Clock::time_point served_;
};

nlohmann::ordered_json NamesOf(const world::SceneSnapshot& scene) {
  nlohmann::ordered_json names = nlohmann::ordered_json::array();
  for (const world::AgentSnapshot& agent : scene.agents) names.push_back(agent.name);
  return names;
}

class LiveEngine {
 public:
  /// `may_wait`: a round may take as long as a script is stopped.
  LiveEngine(RunSession& session, EnginePage& page, const WindowRun& run, const EngineOptions& options, bool may_wait)
      : session_(session),
        page_(page),
        run_(run),
        options_(options),
        may_wait_(may_wait),
        lessons_(run.scenario, session.lesson()),
        surroundings_(page, pace_, &lessons_, options.home),
        panels_(page) {
    // A followed kernel's ticks are shown as soon as they are known. The first tick creates its first agents.
    if (session.simulation().sends_commands_elsewhere()) {
      pace_.Obey(Flow::kUnlimited);
      session.Tick();
    }
    MakeDesk();
    Hello();
    // Selects an agent with a mind, so that a new user sees what the panels are for.
    for (const world::AgentSnapshot& agent : session.simulation().Snapshot().agents) {
      if (!session.simulation().HasMind(agent.name)) continue;
      panels_.Serve(*desk_, {workbench::SelectRequest{agent.name}});
      break;
    }
  }

  int Run() {
    while (!IsOver())
      if (const Result<void> done = Round(Wait_ms()); !done) return Refuse(done.error());
    return session_.Finish();
  }
  bool IsOver() const { return session_.IsOver() || !page_.is_open(); }
  /// Maximum time in ms that a round may wait for requests.
  int Wait_ms() {
    if (page_.is_alone()) return kAlone_ms;
    if (pace_.paused() || !desk_->past().is_live()) return kIdle_ms;
    if (std::isinf(pace_.speed())) return 0;
    const double rest_s = (1 - pace_.Blend(Step_s())) * Step_s() / pace_.speed();
    return std::clamp(static_cast<int>(std::ceil(rest_s * 1000)), 1, kIdle_ms);
  }
  /// Executes requests, executes the ticks that are due, and sends the result. An error ends the run.
  Result<void> Round(int most_ms) {
    page_.ShowLife();
    EnginePage::Asked asked = std::exchange(postponed_, {});
    page_.Receive(asked.empty() ? most_ms : 0, asked);
    const bool was_asked = !asked.empty();
    if (Result<void> obeyed = Obey(asked); !obeyed) return obeyed;
    panels_.Serve(*desk_, std::move(asked.requests));
    if (desk_->past().is_live() && !page_.is_alone()) {
      for (sim::InputValue& input : asked.inputs) session_.simulation().Submit(std::move(input));
      Tick();
    } else {
      pace_.Skip();
    }
    Show();
    if (was_asked) page_.Done();
    return {};
  }

 private:
  double Step_s() const { return static_cast<double>(std::as_const(session_.simulation()).world().settings().step_s); }

  void MakeDesk() {
    desk_.emplace(session_, run_.header, run_.scenario, run_.settings, surroundings_);
    if (may_wait_) desk_->scripts().SetWait([this] { WaitInTick(); });
  }

  void Hello() {
    sim::Simulation& simulation = session_.simulation();
    const world::SceneSnapshot scene = simulation.Snapshot();
    nlohmann::ordered_json minds = nlohmann::ordered_json::array();
    for (const world::AgentSnapshot& agent : scene.agents)
      if (simulation.HasMind(agent.name)) minds.push_back(agent.name);
    nlohmann::ordered_json percepts = nlohmann::ordered_json::array();
    for (const vocabulary::PerceptRow& row : vocabulary::Percepts()) percepts.push_back(row.path);
    page_.Hello({{"lesson", session_.lesson().filename().string()},
                 {"scenario", run_.scenario.name},
                 {"seed", session_.seed()},
                 {"agents", NamesOf(scene)},
                 {"minds", std::move(minds)},
                 {"percepts", std::move(percepts)},
                 {"step_s", Step_s()},
                 {"turn_ticks", turn_ticks_},
                 {"may_edit", true},
                 {"is_recording", false},
                 {"has_exercise", session_.gateway() != nullptr}});
  }

  Result<void> Obey(const EnginePage::Asked& asked) {
    if (asked.pause) {
      if (!*asked.pause) desk_->GoOn();
      *asked.pause ? pace_.Pause() : pace_.Resume();
      desk_->change().AwaitNothing();
    }
    for (const Flow flow : asked.flows) {
      // A user who looks at the past and lets the world or a mind advance returns to the present.
      if (IsStep(flow)) desk_->GoOn();
      pace_.Obey(flow);
      if (flow == Flow::kStepChange) {
        if (const std::string refusal = desk_->AwaitChange(); !refusal.empty()) {
          pace_.Pause();
          page_.Tell(refusal);
        }
      } else if (IsStep(flow)) {
        desk_->change().AwaitNothing();
      }
      if (flow == Flow::kStepDecision) Prepare();  // Its tick stops at lines, too.
      if (flow == Flow::kStepDecision || flow == Flow::kStepPhase)
        page_.Tell(
            StepMind(session_, panels_.agent(), flow == Flow::kStepDecision ? MindStep::kDecision : MindStep::kPhase)
                .told);
      was_stopped_ = false;
      if (flow == Flow::kReset || flow == Flow::kNextSeed) {
        if (const Result<void> begun = BeginAgain(flow == Flow::kNextSeed, asked.seed); !begun) return begun;
      }
    }
    return {};
  }

  Result<void> BeginAgain(bool with_next_seed, std::optional<std::uint64_t> seed) {
    workbench::Desk::Belongings belongings = desk_->TakeBelongings();
    desk_.reset();
    if (const Result<void> begun = session_.BeginAgain(with_next_seed, seed); !begun) return begun;
    MakeDesk();
    desk_->Bring(std::move(belongings));
    Hello();
    panels_.Serve(*desk_, panels_.BeginAgain());
    page_.Tell("From the beginning, seed " + std::to_string(session_.seed()));
    pace_.Skip();
    return {};
  }

  /// Prepares the desk for a tick. Scripts stop only if somebody can let them continue.
  void Prepare() {
    desk_->Prepare();
    if (page_.presence().controlling == 0) desk_->scripts().Rest();
  }

  void Tick() {
    const int due = pace_.TicksDue(Step_s(), session_.simulation().tick(), turn_ticks_);
    bool is_cut = false;
    for (int i = 0; i < due && !is_cut && !session_.IsOver(); ++i) {
      Prepare();
      session_.Tick();
      if (const std::string change = desk_->change().Take(); !change.empty()) {
        pace_.Pause();
        page_.Tell(change);
        is_cut = true;
      }
      if (desk_->WasHit()) {
        pace_.Pause();
        is_cut = true;
      }
      if (std::exchange(was_stopped_, false) && !is_cut) {
        is_cut = true;
        pace_.Owe(due - i - 1);
      }
      if (!is_cut && pace_.OutOfTime()) {
        is_cut = true;
        pace_.Owe(due - i - 1);
      }
    }
    if (due == 0) session_.Idle();
  }

  /// Serves pages while a script is stopped in the middle of a tick.
  void WaitInTick() {
    workbench::ScriptDesk& scripts = desk_->scripts();
    // A user who loads the page again has this time to connect. After it, the script continues.
    constexpr auto kPatience = std::chrono::seconds(10);
    Clock::time_point seen = Clock::now();
    bool is_new = true, is_shown = false;
    page_.Done();  // The requests that led to this tick have been executed.
    while (scripts.is_stopped() && page_.is_open() && !WasInterrupted()) {
      page_.ShowLife();
      EnginePage::Asked asked;
      page_.Receive(is_new ? 0 : kIdle_ms, asked);
      if (page_.presence().controlling > 0) seen = Clock::now();
      if (Clock::now() - seen > kPatience) break;
      const bool was_asked = !asked.empty();
      ObeyInTick(asked);
      panels_.Serve(*desk_, std::move(asked.requests), is_new);
      if (scripts.is_stopped()) is_shown = ShowInTick(is_shown);
      is_new = false;
      if (was_asked) page_.Done();
    }
    shown_tick_ = ~std::uint64_t{0};
    was_stopped_ = true;
    pace_.Skip();
  }

  /// Executes commands for the run while a script is stopped. Postpones restarts to the end of the tick.
  void ObeyInTick(EnginePage::Asked& asked) {
    workbench::ScriptDesk& scripts = desk_->scripts();
    if (asked.pause && *asked.pause) pace_.Pause();
    if (asked.pause && !*asked.pause) scripts.ObeyInTick(Flow::kTogglePause, pace_);
    for (const Flow flow : asked.flows) {
      if (scripts.ObeyInTick(flow, pace_)) continue;
      postponed_.flows.push_back(flow);
      postponed_.seed = asked.seed;
    }
    // The simulation executes these inputs in the next tick.
    for (sim::InputValue& input : asked.inputs) session_.simulation().Submit(std::move(input));
  }

  /// Sends the scene once after the script has stopped, because the script may have moved something. `is_shown`: it was
  /// sent. Returns whether it is sent now.
  bool ShowInTick(bool is_shown) {
    if (page_.is_alone()) return false;
    const std::uint64_t tick = desk_->past().shown_tick();
    page_.ShowFlow(pace_, tick, static_cast<double>(tick) * Step_s(), true);
    if (is_shown && !page_.WantsFull()) return true;
    if (!page_.WantsScene(agents_)) return false;
    page_.ShowScene(session_.simulation().Snapshot(), nullptr);
    return true;
  }

  void Show() {
    if (page_.is_alone()) return;
    const sim::Simulation& simulation = session_.simulation();
    page_.ShowFlow(pace_, desk_->past().shown_tick(), static_cast<double>(desk_->past().shown_tick()) * Step_s());
    if (const world::SceneSnapshot* past = desk_->PastScene()) {
      if (page_.WantsScene(past->agents.size()) && (past->tick != shown_tick_ || page_.WantsFull())) {
        page_.ShowScene(*past, nullptr);
        shown_tick_ = past->tick;
        agents_ = past->agents.size();
      }
      return;
    }
    if (!page_.WantsScene(agents_) || (simulation.tick() == shown_tick_ && !page_.WantsFull())) return;
    const world::SceneSnapshot scene = simulation.Snapshot();
    const world::OverlaySnapshot overlays = simulation.Overlays(page_.overlay_wants());
    page_.ShowScene(scene, &overlays);
    shown_tick_ = simulation.tick();
    agents_ = scene.agents.size();
  }

  RunSession& session_;
  EnginePage& page_;
  const WindowRun& run_;
  const EngineOptions& options_;
  const bool may_wait_;
  workbench::Pace pace_{1};
  LessonDesk lessons_;
  EngineDesk surroundings_;
  std::optional<workbench::Desk> desk_;
  PanelsOfPage panels_;
  EnginePage::Asked postponed_;  ///< Requests for after the tick in which a script is stopped.
  bool was_stopped_ = false;     ///< A script was stopped in the last tick.
  std::uint64_t shown_tick_ = ~std::uint64_t{0};
  std::size_t agents_ = 0;  ///< Number of agents in the last scene sent.
  const int turn_ticks_ = sim::TurnTicks(run_.scenario);
};

class ReplayEngine {
 public:
  ReplayEngine(record::Reader& recording, record::TickRange range, const sim::DataFolders& data, EnginePage& page,
               const EngineOptions& options)
      : page_(page),
        surroundings_(page, pace_, nullptr, options.home),
        desk_(recording, data, range, surroundings_),
        panels_(page),
        step_s_(recording.header().step_s),
        turn_ticks_(record::TurnTicks(recording.header())) {
    // If there are no agents yet, shows the next tick: a recorded client makes its agents in the first tick.
    if (desk_.PastScene()->agents.empty() && desk_.past().first_tick() < desk_.past().last_tick())
      desk_.Show(desk_.past().first_tick() + 1);
    const world::SceneSnapshot& scene = *desk_.PastScene();
    nlohmann::ordered_json minds = nlohmann::ordered_json::array();
    for (const world::AgentSnapshot& agent : scene.agents)
      if (agent.kind.starts_with("soar")) minds.push_back(agent.name);
    page.Hello({{"lesson", ""},
                {"scenario", recording.header().scenario},
                {"seed", recording.header().seed},
                {"agents", NamesOf(scene)},
                {"minds", minds},
                {"step_s", step_s_},
                {"turn_ticks", turn_ticks_},
                {"may_edit", true},
                {"is_recording", true},
                {"has_exercise", false}});
    if (!minds.empty()) panels_.Serve(desk_, {workbench::SelectRequest{minds.front().get<std::string>()}});
  }

  int Run() {
    while (!IsOver()) Round(Wait_ms());
    return kOk;
  }
  bool IsOver() const { return WasInterrupted() || !page_.is_open(); }
  int Wait_ms() const {
    const bool stands = pace_.paused() || page_.is_alone();
    return stands ? kIdle_ms : static_cast<int>(std::ceil(step_s_ * 500));
  }
  void Round(int most_ms) {
    page_.ShowLife();
    EnginePage::Asked asked;
    page_.Receive(most_ms, asked);
    const bool was_asked = !asked.empty();
    Obey(asked);
    if (page_.is_alone()) {
      pace_.Skip();
    } else if (const int due = pace_.TicksDue(step_s_, desk_.past().shown_tick(), turn_ticks_); due > 0) {
      desk_.Show(std::min(desk_.past().shown_tick() + static_cast<std::uint64_t>(due), desk_.past().last_tick()));
    }
    panels_.Serve(desk_, std::move(asked.requests));
    if (was_asked) page_.Done();
    if (page_.is_alone()) return;
    const world::SceneSnapshot& scene = *desk_.PastScene();
    page_.ShowFlow(pace_, desk_.past().shown_tick(), scene.time_s);
    if (page_.WantsScene(scene.agents.size()) && (scene.tick != shown_tick_ || page_.WantsFull()))
      page_.ShowScene(scene, nullptr);
    shown_tick_ = scene.tick;
  }

 private:
  void Obey(const EnginePage::Asked& asked) {
    if (asked.pause) {
      // At the end, continuing restarts the recording.
      if (!*asked.pause && desk_.past().shown_tick() >= desk_.past().last_tick()) desk_.Show(desk_.past().first_tick());
      *asked.pause ? pace_.Pause() : pace_.Resume();
    }
    for (const Flow flow : asked.flows) {
      if (flow == Flow::kReset) {
        desk_.Show(desk_.past().first_tick());
      } else if (flow == Flow::kNextSeed || (IsStep(flow) && flow != Flow::kStepTick && flow != Flow::kStepTurn)) {
        page_.Tell("Only a run can do this; this is a recording of one");
      } else {
        pace_.Obey(flow);
      }
    }
  }

  EnginePage& page_;
  workbench::Pace pace_{1};
  EngineDesk surroundings_;
  workbench::Desk desk_;
  PanelsOfPage panels_;
  double step_s_;
  int turn_ticks_;
  std::uint64_t shown_tick_ = ~std::uint64_t{0};
};

/// Implements Window for an engine: it shows runs and recordings to pages.
class EngineWindow final : public Window {
 public:
  explicit EngineWindow(const EngineOptions& options)
      : options_(options), channel_(options.socket), page_(channel_, options.home) {
    OnRefusal([this](const Diagnostic& problem) { channel_.Send(serve::FrameKind::kReason, problem.message); });
  }
  ~EngineWindow() { OnRefusal({}); }
  EngineWindow(const EngineWindow&) = delete;
  EngineWindow& operator=(const EngineWindow&) = delete;

  [[nodiscard]] bool CanOpen() const override { return true; }
  [[nodiscard]] std::optional<std::pair<int, int>> RoomOnDisplay() const override { return std::nullopt; }
  int Run(RunSession& session, const RunOptions& asked, const sim::DataFolders&, const WindowRun& run) const override {
    if (!asked.warning.empty()) page_.Tell(asked.warning);
    return LiveEngine(session, page_, run, options_, true).Run();
  }
  int Replay(record::Reader& recording, record::TickRange range, const sim::DataFolders& data,
             const RecordingOptions&) const override {
    return ReplayEngine(recording, range, data, page_, options_).Run();
  }
  EnginePage& page() const { return page_; }

 private:
  const EngineOptions& options_;
  mutable EngineChannel channel_;
  mutable EnginePage page_;
};

/// Restricts this process: it may write only below its place, and read only there and in the program's own folders.
/// Called before any file of the place is read.
void RaiseWall(const EngineOptions& options) {
  serve::WallSettings wall;
  wall.may_connect = options.may_join;
  const char* const place = std::getenv("SOARBOX_PLACE");
  wall.writable = {place != nullptr ? fs::path(place) : options.home.parent_path()};
  if (const Result<sim::DataFolders> data = FindDataFolders(); data) {
    wall.readable = {data->scenarios, data->media, ShippedLessons(*data)};
  }
  if (!options.from.empty()) wall.readable.push_back(options.from);
  // The recording of a match is outside of the place, and so are the files that the match was run with. Its minds are
  // simulated again from these files.
  if (!options.recording.empty()) {
    wall.readable.push_back(options.recording);
    std::error_code error;
    if (const fs::path home = options.recording.parent_path().parent_path() / "home"; fs::is_directory(home, error))
      wall.readable.push_back(home);
  }
  serve::RaiseWall(wall);
}

/// Runs a match without pages, records it, and sends the server the scores of the agents in their order.
int PlayMatch(const EngineOptions& options, EngineChannel& channel) {
  const char* const state = std::getenv("XDG_STATE_HOME");
  RunOptions run;
  run.scenario = options.match.string();
  run.headless = run.by_strangers = true;
  run.may_join = false;
  run.port = 0;
  run.threads = 1;
  run.memory_mb = options.memory_mb;
  run.seed = options.seed;
  run.seconds = options.match_s;
  run.record = fs::path(state != nullptr ? state : ".") / "match.soarrec";
  run.record_level = "all";  // A replay shows working memory, too.
  constexpr double kRecording_mb = 16;
  run.record_limit_mb = kRecording_mb;
  const int code = Run(run);
  const Result<std::unique_ptr<record::Reader>> recording = record::Reader::Open(run.record);
  if (!recording) return code == kOk || code == kProblems ? Refuse(recording.error()) : code;
  const Result<const record::TickRecord*> last = (*recording)->At((*recording)->last_tick());
  if (!last) return Refuse(last.error());
  nlohmann::ordered_json scores = nlohmann::ordered_json::array();
  for (const world::AgentSnapshot& agent : (*last)->scene.agents)
    scores.push_back(agent.has_score ? nlohmann::ordered_json(agent.score) : nlohmann::ordered_json());
  channel.Send(serve::FrameKind::kText, nlohmann::ordered_json{{"message", "match"}, {"scores", scores}}.dump());
  // Sends the queued data before this process ends.
  constexpr int kToSend_ms = 100;
  channel.Receive(kToSend_ms);
  return kOk;
}

/// Returns the options of the corresponding `soarbox run`. Creates the learner's copy of the world or lesson if there
/// is none.
Result<RunOptions> RunOf(const EngineOptions& options) {
  std::error_code error;
  RunOptions run;
  run.port = 0;
  run.threads = 1;
  run.memory_mb = options.memory_mb;
  run.by_strangers = true;
  // A run of the user of this machine is not restricted.
  run.may_join = options.may_join || !options.run.empty();
  run.dis = options.dis;
  constexpr double kRecording_mb = 16;
  run.record_limit_mb = kRecording_mb;
  const Result<sim::DataFolders> data = FindDataFolders();
  if (!data) return data.error();
  run.seed = options.seed;
  run.follow = options.follow;
  if (!options.follow.empty()) return run;
  if (!options.run.empty()) {
    run.scenario = options.run;
  } else if (options.lesson.empty()) {
    const fs::path folder = options.home / "worlds" / options.world;
    if (!fs::exists(folder, error)) {
      fs::create_directories(folder.parent_path(), error);
      fs::copy(options.from.empty() ? data->scenarios / options.world : options.from, folder,
               fs::copy_options::recursive, error);
      if (error) return NewProblem("there is no world '" + options.world + "' to copy: " + error.message());
    }
    run.scenario = folder.string();
  } else {
    std::vector<Diagnostic> problems;
    const std::optional<Lesson> lesson = ReadLesson(LessonOf(LessonsFolder() / options.lesson, *data), *data, problems);
    if (!lesson) return NewProblem("there is no lesson '" + options.lesson + "'");
    const fs::path folder = LessonsFolder() / lesson->name;
    if (const Result<void> prepared = PrepareLesson(*lesson, folder); !prepared) return prepared.error();
    run.scenario = folder.string();
    run.lesson = lesson->folder;
  }
  return run;
}

EngineOptions WithRealPaths(EngineOptions options) {
  std::error_code error;
  options.home = fs::weakly_canonical(options.home, error);
  if (!options.recording.empty()) options.recording = fs::absolute(options.recording, error);
  return options;
}

class SteppedLive final : public SteppedEngine {
 public:
  explicit SteppedLive(const EngineOptions& options) : options_(WithRealPaths(options)), window_(options_) {
    SetProgramWindow(&window_);
  }
  ~SteppedLive() override { SetProgramWindow(nullptr); }

  bool Begin() {
    const Result<RunOptions> run = RunOf(options_);
    if (!run) {
      Refuse(run.error());
      return false;
    }
    if (SetUpRun(*run, run_) != kOk) return false;
    what_.emplace(WindowRun{run_->scenario, run_->settings, run_->header});
    if (!run_->options.warning.empty()) window_.page().Tell(run_->options.warning);
    engine_.emplace(*run_->session, window_.page(), *what_, options_, false);
    return true;
  }
  std::optional<int> Step() override {
    if (engine_->IsOver()) return End();
    if (const Result<void> done = engine_->Round(0); !done) {
      Refuse(done.error());
      return std::nullopt;
    }
    return engine_->IsOver() ? End() : engine_->Wait_ms();
  }

 private:
  std::optional<int> End() {
    run_->session->Finish();
    return std::nullopt;
  }

  const EngineOptions options_;
  const EngineWindow window_;
  std::unique_ptr<RunSetup> run_;
  std::optional<WindowRun> what_;
  std::optional<LiveEngine> engine_;
};

class SteppedReplay final : public SteppedEngine {
 public:
  explicit SteppedReplay(const EngineOptions& options) : options_(WithRealPaths(options)), window_(options_) {}

  bool Begin() {
    const Result<sim::DataFolders> data = FindDataFolders();
    Result<std::unique_ptr<record::Reader>> reader = record::Reader::Open(options_.recording);
    if (!data || !reader) {
      Refuse(data ? reader.error() : data.error());
      return false;
    }
    reader_ = std::move(*reader);
    engine_.emplace(*reader_, record::TickRange(), *data, window_.page(), options_);
    return true;
  }
  std::optional<int> Step() override {
    if (engine_->IsOver()) return std::nullopt;
    engine_->Round(0);
    return engine_->Wait_ms();
  }

 private:
  const EngineOptions options_;
  const EngineWindow window_;
  std::unique_ptr<record::Reader> reader_;
  std::optional<ReplayEngine> engine_;
};

/// Null if the engine cannot begin; the page was sent the error.
template <typename Engine>
std::unique_ptr<SteppedEngine> Begun(const EngineOptions& options) {
  auto engine = std::make_unique<Engine>(options);
  return engine->Begin() ? std::move(engine) : nullptr;
}

}  // namespace

std::unique_ptr<SteppedEngine> SteppedEngine::Make(const EngineOptions& options) {
  return options.recording.empty() ? Begun<SteppedLive>(options) : Begun<SteppedReplay>(options);
}

int Engine(const EngineOptions& given) {
  const EngineOptions options = WithRealPaths(given);
  if (options.is_walled) RaiseWall(options);
  EndWithServer(options.socket);
  // The server gets the reason of an end only while the channel exists, so exceptions are caught here.
  if (!options.match.empty()) {
    EngineChannel channel(options.socket);
    OnRefusal([&](const Diagnostic& problem) { channel.Send(serve::FrameKind::kReason, problem.message); });
    const int code = RefuseExceptions([&] { return PlayMatch(options, channel); });
    OnRefusal({});
    return code;
  }
  const EngineWindow window(options);
  SetProgramWindow(&window);
  return RefuseExceptions([&] {
    if (!options.recording.empty()) {
      RecordingOptions replay;
      replay.file = options.recording;
      return Replay(replay);
    }
    const Result<RunOptions> run = RunOf(options);
    return run ? Run(*run) : Refuse(run.error());
  });
}

}  // namespace soarbox::app
