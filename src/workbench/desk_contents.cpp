// SPDX-License-Identifier: BSD-2-Clause
// Fills in the contents of the panels.
#include <algorithm>
#include <unordered_set>
#include <utility>

#include "debugger/imagery_rows.h"
#include "debugger/learning.h"
#include "debugger/recall.h"
#include "debugger/revision.h"
#include "debugger/why.h"
#include "workbench/desk.h"
#include "world/world.h"

namespace soarbox::workbench {
namespace {

/// Refresh interval of panels about minds while the world runs.
constexpr auto kRefreshEvery = std::chrono::milliseconds(120);
constexpr auto kExerciseEvery = std::chrono::milliseconds(500);
/// Time without movement of the scrubber after which minds of the past are rebuilt.
constexpr auto kRest = std::chrono::milliseconds(250);
constexpr double kRebuildSlice_s = 0.012;

const char* const kNoKernel =
    "This mind cannot be looked into: its Soar kernel has gone, or it was stopped for good. "
    "The world keeps running. The panel Problems says more.";

GhostBody GhostOf(const world::AgentSnapshot& agent, std::string name) {
  return {std::move(name), agent.id,      agent.kind,     agent.team,
          agent.position,  agent.forward, agent.radius_m, agent.height_m};
}

}  // namespace

std::string Desk::NameOf(std::uint32_t agent_id) {
  const record::TickRecord* const shown = past_.Shown();
  if (shown == nullptr) return {};
  const auto found = std::ranges::find(shown->scene.agents, agent_id, &world::AgentSnapshot::id);
  return found == shown->scene.agents.end() ? std::string() : found->name;
}

void Desk::LookAtAgent(Contents& contents) {
  const record::TickRecord* const shown = past_.Shown();
  const bool is_there = shown != nullptr && std::ranges::find(shown->scene.agents, wanted_agent_,
                                                              &world::AgentSnapshot::name) != shown->scene.agents.end();
  const std::string agent = is_there ? wanted_agent_ : std::string();
  if (agent == agent_) return;
  agent_ = agent;
  state_.clear();
  search_.clear();
  rule_.clear();
  open_objects_.clear();
  unfolds_top_ = true;
  known_search_.clear();
  learned_rule_.clear();
  episode_ = 0;
  timetag_ = 0;
  elements_ = {};
  curves_.clear();
  has_chosen_curves_ = false;
  why_ = {};
  imagined_ = {};
  contents.coverage.clear();
  // The agent's coverage is counted from now on; it begins with what the model has counted so far.
  if (!agent_.empty()) coverage_.try_emplace(agent_, models_.coverage[agent_]);
  is_stale_ = true;
}

bool Desk::ServeStopped(const std::vector<Request>& requests, Contents& contents) {
  files_.ShowDraft();
  for (const Request& request : requests) {
    if (std::holds_alternative<CompleteRequest>(request)) continue;  // It would read the mind.
    if (const std::string refusal = scripts_.Refusal(request); !refusal.empty()) {
      surroundings_.Tell(refusal);
    } else {
      Obey(request);
    }
  }
  KeepDrafts(!requests.empty());
  is_stale_ |= files_.TakeNews();
  is_stale_ |= scripts_.TakeNews();
  is_stale_ |= visible_ != refreshed_panels_;
  if (!is_stale_ || !scripts_.is_stopped()) return false;
  is_stale_ = false;
  refreshed_panels_ = visible_;
  contents.revision = debugger::NewRevision();
  contents.problems = RankedProblems();
  contents.breakpoints = breakpoints_.list();
  files_.Fill(contents);
  scripts_.Fill(contents, visible_.Has(PanelId::kScript));
  return true;
}

bool Desk::Serve(PanelExchange& panels) {
  const std::vector<Request> requests = std::exchange(panels.requests, {});
  Contents& contents = panels.contents;
  if (scripts_.is_in_tick()) return ServeStopped(requests, contents);
  scripts_.Rest();
  if (scripts_.TakeNews()) is_stale_ = true;
  files_.ShowDraft();
  for (const Request& request : requests) Obey(request);
  NoteChangedRules();
  if (!past_.is_live() && Clock::now() - sought_at_ > kRest) past_.rebuilt().Advance(kRebuildSlice_s);
  files_.GoOn();
  if (resume_at_ && (past_.is_live() || past_.shown_tick() != *resume_at_)) resume_at_.reset();
  if (resume_at_ && past_.rebuilt().world() != nullptr) Resume();
  for (Diagnostic& warning : past_.TakeWarnings()) NoteProblem(std::move(warning), {});
  if (!news_.empty()) surroundings_.Tell(std::exchange(news_, {}));
  if (Lessons* const lessons = surroundings_.lessons()) is_stale_ |= lessons->Poll();
  ReadOn();
  FillPlots();
  // Saves drafts now, so that a text is on the disk before the answer to its request.
  KeepDrafts(!requests.empty());
  is_stale_ |= files_.TakeNews();
  LookAtAgent(contents);

  const std::string note =
      past_.is_live() || past_.rebuilt().world() != nullptr ? std::string{} : past_.rebuilt().Note();
  is_stale_ |= visible_ != refreshed_panels_ || note != refreshed_note_;
  const bool moved = past_.shown_tick() != refreshed_tick_;
  const bool is_due = Clock::now() - refreshed_at_ > kRefreshEvery;
  // Other simulations continue while the world is paused.
  is_stale_ |= visible_.Has(PanelId::kExercise) && contents.exercise && Clock::now() - refreshed_at_ > kExerciseEvery;
  FillMoment(contents);
  if (!is_stale_ && !(moved && (is_due || surroundings_.IsPaused()))) return false;
  refreshed_panels_ = visible_;
  refreshed_note_ = note;
  Refresh(contents);
  refreshed_tick_ = past_.shown_tick();
  refreshed_at_ = Clock::now();
  is_stale_ = false;
  return true;
}

std::string Desk::NotRecorded() const {
  if (!HasReadOn()) {
    const std::uint64_t goal = std::max<std::uint64_t>(1, past_.shown_tick());
    return "Reading the recording: " + std::to_string(100 * recorded_.last_tick() / goal) + " %";
  }
  if (recording_->header().level == record::Level::kWorld)
    return "Minds are not recorded at this level: record with --record-level decisions or all. " +
           past_.rebuilt().Note();
  return past_.rebuilt().Note();
}

void Desk::FillMoment(Contents& contents) {
  Moment& at = contents.moment;
  at.first_tick = past_.first_tick();
  at.last_tick = past_.last_tick();
  at.shown_tick = past_.shown_tick();
  const sim::Simulation* live = common_.Live();
  at.step_s = live != nullptr ? static_cast<double>(live->world().settings().step_s) : recording_->header().step_s;
  at.turn_ticks = turn_ticks_;
  at.is_recording = past_.is_recording();
  at.is_live = past_.is_live();
  at.can_go_back = past_.last_tick() > past_.first_tick();
  at.can_resume = (past_.rebuilt().world() != nullptr || past_.rebuilt().IsPossible()) && !at.is_recording;
  at.resume_refusal = at.can_resume ? "" : past_.rebuilt().Note();
  const TimeMachine::Parting* const parting = past_.parting();
  at.branch_tick = parting != nullptr ? std::optional(parting->tick) : std::nullopt;
  at.branches = parting != nullptr ? parting->number : 0;
  at.changed_tick = changed_tick_;
}

void Desk::FillSoarAgents(Contents& contents, const record::TickRecord* shown) {
  contents.soar_agents.clear();
  contents.agent_count = shown == nullptr ? 0 : shown->scene.agents.size();
  if (shown == nullptr) return;
  for (const world::AgentSnapshot& agent : shown->scene.agents) {
    if (contents.soar_agents.size() >= Contents::kMostSoarAgents) return;
    if (HasMind(agent.name)) contents.soar_agents.push_back(agent.name);
  }
}

void Desk::Refresh(Contents& contents) {
  contents.revision = debugger::NewRevision();
  contents.agent = agent_;
  contents.timeline = &models_.timeline;
  contents.trace = &models_.trace;
  trace_filter_.agent = traces_selected_ ? agent_ : std::string();
  contents.trace_filter = trace_filter_;
  contents.trace_found = visible_.Has(PanelId::kTrace) ? &trace_search_.Find(models_.trace, trace_filter_) : nullptr;
  contents.messages = &models_.messages;
  contents.plots = &models_.plots.series();
  const auto recalls = models_.recalls.find(agent_);
  contents.recalls = recalls == models_.recalls.end() ? nullptr : &recalls->second;
  const auto learning = models_.learning.find(agent_);
  contents.learning_log = learning == models_.learning.end() ? nullptr : &learning->second;
  contents.problems = RankedProblems();
  contents.checks = checks_;
  if (const Lessons* const lessons = surroundings_.lessons()) lessons->Fill(contents);
  contents.watch_fault = watch_fault_;
  contents.breakpoints = breakpoints_.list();
  contents.hits = hits_;
  files_.Fill(contents);
  scripts_.Fill(contents, visible_.Has(PanelId::kScript));
  const record::TickRecord* shown = past_.Shown();
  sim::Simulation* world = common_.Looked();
  if (visible_.Has(PanelId::kAgents) && shown != nullptr) {
    contents.agents = past_.is_live() ? debugger::ListAgents(*common_.Live(), models_.troubles, &models_.timeline)
                                      : debugger::ListAgents(*shown, models_.timeline, models_.troubles);
  }
  contents.has_mind = HasMind(agent_);
  FillSoarAgents(contents, shown);
  consoles_.Fill(contents);
  if (visible_.Has(PanelId::kEdit) && common_.Live() != nullptr) {
    contents.files = debugger::FilesOf(*common_.Live(), agent_);
    // The agent's rules come first, then its scripts; files that come with the program come last.
    const auto rank = [&](const sim::WatchedFile& file) {
      return (file.agent == agent_ && !agent_.empty() ? 0 : 2) + (file.is_rules ? 0 : 1);
    };
    std::stable_sort(contents.files.begin(), contents.files.end(),
                     [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  }
  changes_ = {};
  if (shown != nullptr) {
    if (const record::MindRecord* mind = record::FindMind(*shown, agent_))
      changes_ = debugger::MemoryChanges(mind->events);
  }
  std::unique_ptr<explain::Inspector> mind = world != nullptr && contents.has_mind ? world->Inspect(agent_) : nullptr;
  contents.not_available.clear();
  contents.past_note.clear();
  if (world == nullptr && recording_ != nullptr) {
    // The recorded mind is shown until it is simulated again.
    if (HasReadOn()) mind = recorded_.Inspect(agent_);
    contents.past_note = past_.rebuilt().Note();
    if (mind == nullptr) contents.not_available = NotRecorded();
  } else if (world == nullptr) {
    contents.not_available = past_.rebuilt().Note();
  } else if (contents.has_mind && mind == nullptr) {
    contents.not_available = kNoKernel;
  }
  contents.not_recorded = mind == nullptr ? std::string{} : debugger::MemoryAbsence(*mind);
  contents.shown = {};
  if (shown != nullptr && visible_.Has(PanelId::kMind)) {
    contents.shown = debugger::LookAtShown(shown->scene, agent_);
    contents.shown.tick = shown->tick;
  }
  if (mind != nullptr) FillMind(contents, *mind);
  FillBeside(contents, visible_.Has(PanelId::kWatch), visible_.Has(PanelId::kMinds));
  if (visible_.Has(PanelId::kAgents) || visible_.Has(PanelId::kMind)) FillActivities(contents);
  FillOffers(contents, mind.get());
  contents.exercise.reset();
  if (visible_.Has(PanelId::kExercise) && run_ != nullptr) contents.exercise = run_->Exercise();
  if (visible_.Has(PanelId::kWhy)) FillWhy(contents, mind.get());
  contents.long_term = {};
  contents.known_search = known_search_;
  contents.episode = {};
  if (visible_.Has(PanelId::kLongTerm)) FillLongTerm(contents, mind.get());
  contents.learning = {};
  contents.learned_rule = {};
  if (visible_.Has(PanelId::kLearning)) FillLearning(contents, mind.get());
  contents.ghosts.clear();
  FillFutures(contents);
  if (shown != nullptr) AddRemembered(shown->scene, contents);
  FillImagery(contents, mind.get());
}

void Desk::FillMind(Contents& contents, explain::Inspector& mind) {
  if (visible_.Has(PanelId::kMind)) {
    contents.stack = debugger::LookAtStack(mind);
    contents.operators = debugger::LookAtOperators(mind, state_);
    if (contents.operators.rows.empty() && !state_.empty()) {
      // The selected state does not exist any more: selects the lowest.
      const auto& levels = contents.stack.levels;
      const bool is_there =
          std::any_of(levels.begin(), levels.end(), [&](const auto& level) { return level.state == state_; });
      if (!is_there) {
        state_.clear();
        contents.operators = debugger::LookAtOperators(mind);
      }
    }
  }
  if (visible_.Has(PanelId::kMemory)) {
    if (!visible_.Has(PanelId::kMind)) contents.stack = debugger::LookAtStack(mind);
    // The top state is initially unfolded.
    if (unfolds_top_ && !contents.stack.levels.empty()) {
      open_objects_.insert(contents.stack.levels.front().state);
      unfolds_top_ = false;
    }
    contents.objects.clear();
    for (const std::string& id : open_objects_) contents.objects[id] = debugger::LookAtObject(mind, id, changes_);
    contents.story = timetag_ != 0 ? debugger::LookAtElement(mind, timetag_) : std::nullopt;
    contents.element_before = elements_.before();
    contents.element_after = elements_.after();
    contents.memory_search = search_;
    contents.found = search_.empty() ? std::vector<explain::ElementFact>{} : debugger::SearchMemory(mind, search_, 200);
  }
  if (visible_.Has(PanelId::kRules)) {
    contents.rules = debugger::ListRules(mind);
    contents.rule = rule_.empty() ? std::nullopt : debugger::LookAtRule(mind, rule_);
    FillRuleText(contents);
    if (wants_coverage_) {
      debugger::Coverage& coverage = coverage_[agent_];
      coverage.Look(mind);
      contents.coverage = coverage.rows();
    }
    wants_coverage_ = false;
  }
  if (visible_.Has(PanelId::kLinks)) contents.io = debugger::LookAtIo(mind, changes_);
  if (visible_.Has(PanelId::kPlots)) contents.plottable = debugger::Plottable(mind);
}

void Desk::FillWhy(Contents& contents, explain::Inspector* mind) {
  contents.why = {};
  sim::Simulation* world = common_.Looked();
  if (agent_.empty() || (world == nullptr && mind == nullptr)) return;
  using About = WhyRequest::About;
  WhyContents& why = contents.why;
  if (why_.about == About::kAgent) {
    why.question = "Why does " + agent_ + " do what it does?";
    if (world != nullptr) {
      why.answer = debugger::WhyAgent(*world, agent_);
    } else if (const debugger::RecordedMind* recorded = recorded_.Find(agent_)) {
      why.answer = debugger::WhyRecorded(*recorded, agent_);
    }
    const auto recalls = models_.recalls.find(agent_);
    if (why.answer && recalls != models_.recalls.end())
      debugger::TellRecalls(recalls->second.Until(past_.shown_tick()), *why.answer);
    return;
  }
  if (mind == nullptr) return;
  if (world == nullptr) {
    why.question = "Why, or why not, " + why_.what + "?";
    why.answer = debugger::WhyNode{"Not recorded. Soarbox can say why once it has simulated this moment again."};
    return;
  }
  switch (why_.about) {
    case About::kOperator:
      why.question = "Why the operator " + why_.what + "?";
      break;
    case About::kCommand:
      why.question = "Why the command " + why_.what + "?";
      break;
    case About::kNot:
      why.question = "Why not " + why_.what + "?";
      break;
    case About::kElement:
      why.question = "Where does element " + why_.what + " come from?";
      why.answer = debugger::WhyElement(*mind, std::strtoull(why_.what.c_str(), nullptr, 10));
      return;
    case About::kAgent:
      return;
  }
  why.answer = debugger::WhyNameOrError(*world, agent_, why_.what);
}

void Desk::FillLongTerm(Contents& contents, explain::Inspector* mind) {
  if (mind == nullptr) return;
  contents.long_term = debugger::LookAtLongTerm(*mind, known_search_);
  contents.episode = debugger::LookAtEpisode(*mind, episode_);
}

void Desk::FillLearning(Contents& contents, explain::Inspector* mind) {
  if (mind == nullptr) return;
  contents.learning = debugger::LookAtLearning(*mind, {}, contents.learning_log, past_.shown_tick());
  if (!has_chosen_curves_) curves_ = debugger::MostMoved(contents.learning, kMostCurves);
  contents.learning_curves = curves_;
  contents.learned_rule = debugger::LookAtLearnedRule(*mind, learned_rule_, contents.learning_log, past_.shown_tick());
}

void Desk::FillImagery(Contents& contents, explain::Inspector* mind) {
  contents.imagery = mind == nullptr ? debugger::ImageryView() : debugger::LookAtImagery(*mind);
  const auto& scenes = contents.imagery.scenes;
  // The selected state does not exist any more: shows what the agent created in any scene.
  if (std::ranges::find(scenes, imagined_.state, &debugger::SceneView::state) == scenes.end()) imagined_.state.clear();
  contents.imagined_state = imagined_.state;
  contents.imagined_record = imagined_.record;
  contents.shapes = debugger::ShapesOf(contents.imagery, imagined_.state);
  contents.answer_lines = debugger::LinesOf(contents.imagery, imagined_.record);
}

void Desk::FillFutures(Contents& contents) {
  TimeMachine::Parting* const parting = past_.parting();
  if (parting == nullptr) return;
  const std::uint64_t now = past_.shown_tick();
  const record::TickRecord* old = now >= parting->tick ? parting->futures.Old(now) : nullptr;
  contents.futures = FuturesContents{parting->tick, now, old != nullptr, parting->futures.comparison()};
  // The positions of all agents at this time in the old future.
  if (old == nullptr) return;
  for (const world::AgentSnapshot& agent : old->scene.agents) {
    if (agent.alive) contents.ghosts.push_back(GhostOf(agent, agent.name + " before"));
  }
}

void Desk::AddRemembered(const world::SceneSnapshot& scene, Contents& contents) const {
  for (const debugger::RememberedThing& thing : contents.episode.things) {
    const std::string& name = thing.name == "self" ? agent_ : thing.name;
    const std::string title = name + " in episode " + std::to_string(contents.episode.number);
    const auto agent = std::ranges::find(scene.agents, name, &world::AgentSnapshot::name);
    GhostBody ghost;
    if (agent != scene.agents.end()) {
      ghost = GhostOf(*agent, title);
    } else {
      // A thing is drawn as a low column.
      ghost.name = title;
      ghost.position.y = ghost.height_m / 2;
    }
    ghost.position.x = static_cast<decltype(ghost.position.x)>(thing.x);
    ghost.position.z = static_cast<decltype(ghost.position.z)>(thing.z);
    contents.ghosts.push_back(std::move(ghost));
  }
}

}  // namespace soarbox::workbench
