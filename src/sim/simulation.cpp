// SPDX-License-Identifier: BSD-2-Clause
#include "sim/simulation.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <optional>
#include <utility>

#include "diagnostics/problem.h"
#include "script/lua_machine.h"
#include "script/script_host.h"
#include "script/script_observer.h"
#include "sim/apply_input.h"
#include "sim/arena.h"
#include "sim/foreign_bodies.h"
#include "sim/input_door.h"
#include "sim/minds.h"
#include "sim/overlays.h"
#include "sim/replaced_rules.h"
#include "sim/scenario_build.h"
#include "sim/scenario_file.h"
#include "sim/sourced_files.h"
#include "world/state_hash.h"
#include "world/world.h"

namespace soarbox::sim {
namespace {

/// Adds up the time between laps.
class Stopwatch {
 public:
  void Lap(double& seconds) {
    const Clock::time_point now = Clock::now();
    seconds += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_ = Clock::now();
};

/// Adds the calls that led to a script error to its message.
Diagnostic WithCallers(const script::ScriptError& error) {
  Diagnostic diagnostic = error.diagnostic;
  if (const std::string callers = script::CallersIn(error.traceback); !callers.empty())
    diagnostic.hint += (diagnostic.hint.empty() ? "" : "; ") + callers;
  return diagnostic;
}

/// Whether a script refused a command. An error in the script has been reported as such.
bool IsRefusal(const script::CommandAnswer& answer) {
  return answer.state == script::CommandAnswer::State::kError && answer.reason != "script-failed";
}

}  // namespace

struct Simulation::Impl final : script::ScriptListener {
  Impl(const Scenario& given, const SimulationSettings& given_settings)
      : scenario(given), settings(given_settings), world(WorldSettingsOf(given_settings)) {}

  // script::ScriptListener
  void OnPrint(std::string_view script, std::string_view text) override;
  void OnScriptFailed(world::EntityId agent, const script::ScriptError& error) override;
  void OnScriptTrouble(const script::ScriptTrouble& trouble) override;
  void OnErrorCount(const script::ErrorCount& count) override;
  void OnScriptWarning(const Diagnostic& warning) override;
  void OnEndReached(std::string_view end) override;

  static world::WorldSettings WorldSettingsOf(const SimulationSettings& settings) {
    world::WorldSettings result;
    result.seed = settings.seed;
    result.screen_width_px = settings.screen_width_px;
    result.screen_height_px = settings.screen_height_px;
    return result;
  }

  /// "a, b and 3 more".
  std::string NamesOf(const std::vector<world::EntityId>& agents) const;
  void Report(RunEvent event);
  void ReportDiagnostic(const Diagnostic& diagnostic);
  /// Reports the result of a command line from outside.
  void ReportAnswer(const CommandInput& asked, const Result<std::string>& answer);
  /// Reports the loss of the minds' kernel, and creates the minds again when a kernel is available.
  void KeepConnected();
  /// Records what attached debuggers did since the last tick.
  void ServeClients();
  void ApplyInputs();
  void ReportNewAgents();
  /// Ends the minds and bodies of the agents in `removed`, which also contains ids of objects.
  void EndRemoved(std::span<const world::EntityId> removed);
  void ReportWarningsOfWorld();
  void ReportEnd(const std::string& reached);
  void ReportEndOfScripts();
  void ReportCommand(Minds::Mind& mind, const world::Agent& body, const vocabulary::SaidCommand& command);
  void ActByScript(world::EntityId id);
  /// Continues the commands that the agent's script executes over several ticks.
  void ContinueByScript(world::EntityId id);
  /// Converts a script's answer to a command to an outcome; nothing if there is nothing to report yet.
  std::optional<Outcome> OutcomeOf(const script::CommandAnswer& answer, std::uint64_t tag, const std::string& command);
  /// Executes the commands of the agent's mind, or only updates an agent without a mind.
  void Act(world::EntityId id);

  const Scenario scenario;
  const SimulationSettings settings;
  world::World world;
  // The order of members matters: the kernel must outlive the minds, which must outlive the scripts.
  std::unique_ptr<SoarHost> soar;
  std::unique_ptr<Arena> arena;
  std::unique_ptr<ForeignBodies> foreign;
  std::unique_ptr<Minds> minds;
  std::unique_ptr<script::ScriptHost> scripts;
  std::unique_ptr<ScenarioEnd> end;  ///< Null without a scenario file.
  bool end_of_scripts_told = false;
  bool ended_by_script = false;
  InputDoor door;
  std::vector<std::pair<CommandInput, Result<std::string>>> answered;  ///< Between the last tick and the next.
  std::optional<std::uint64_t> flood_told_at;                          ///< Tick.
  CommandsElsewhere elsewhere;                                         ///< Empty: commands go to its own minds.
  std::vector<world::EntityId> order;                                  ///< Temporary: agents to update in this tick.
  EventList events;
  TickCosts costs;
  world::EntityId last_reported = world::EntityId::kSandbox;
  bool connected = true;
  bool finished = false;
};

void Simulation::Impl::OnPrint(std::string_view script, std::string_view text) {
  RunEvent event;
  event.kind = EventKind::kLog;
  event.text = std::string(script) + ": " + std::string(text);
  Report(std::move(event));
}

void Simulation::Impl::OnScriptFailed(world::EntityId agent, const script::ScriptError& error) {
  RunEvent event;
  event.diagnostic = WithCallers(error);
  const world::Agent* body = world.FindAgent(agent);
  event.kind = body != nullptr ? EventKind::kAgentFailed : EventKind::kDiagnostic;
  if (body != nullptr) event.agent = body->name();
  event.text = error.traceback;
  Report(std::move(event));
}

void Simulation::Impl::OnScriptTrouble(const script::ScriptTrouble& trouble) {
  using Kind = script::ScriptTrouble::Kind;
  RunEvent event;
  event.kind = EventKind::kDiagnostic;
  const std::string who = NamesOf(trouble.agents);
  if (trouble.agents.size() == 1)
    if (const world::Agent* body = world.FindAgent(trouble.agents.front())) event.agent = body->name();
  event.diagnostic = WithCallers(trouble.error);
  event.text = trouble.error.traceback;
  if (trouble.kind == Kind::kError) {
    event.diagnostic.message += " (" + trouble.callback + " of " + who + ")";
  } else if (trouble.kind == Kind::kKeepsFailing) {
    event.diagnostic.severity = Severity::kWarning;
    event.diagnostic.message =
        trouble.callback + " of " + who + " fails again and again; it is still called in each tick";
    event.diagnostic.excerpt.clear();
    event.diagnostic.hint.clear();
  } else {
    event.diagnostic.severity = Severity::kNote;
    event.diagnostic.message = trouble.callback + " of " + who + " works again";
  }
  Report(std::move(event));
}

void Simulation::Impl::OnErrorCount(const script::ErrorCount& count) {
  Diagnostic note = count.error;
  note.severity = Severity::kNote;
  note.excerpt.clear();
  note.hint.clear();
  note.message = "this error came " + std::to_string(count.count) + " times in all, in " + NamesOf(count.agents) +
                 ": " + count.error.message;
  ReportDiagnostic(note);
}

std::string Simulation::Impl::NamesOf(const std::vector<world::EntityId>& agents) const {
  constexpr std::size_t kMostNamed = 5;
  std::string names;
  for (std::size_t i = 0; i < agents.size() && i < kMostNamed; ++i) {
    const world::Agent* body = world.FindAgent(agents[i]);
    names += (i == 0 ? "" : ", ") + (body != nullptr ? body->name() : std::string("the sandbox"));
  }
  if (agents.size() > kMostNamed) names += " and " + std::to_string(agents.size() - kMostNamed) + " more";
  return names;
}

void Simulation::Impl::OnScriptWarning(const Diagnostic& warning) {
  ReportDiagnostic(warning);
}

void Simulation::Impl::OnEndReached(std::string_view end) {
  if (ended_by_script || finished) return;
  ended_by_script = true;
  ReportEnd(std::string(end));
}

void Simulation::Impl::Report(RunEvent event) {
  // The creation of an agent must be reported before its other events.
  if (event.kind != EventKind::kAgentCreated && !event.agent.empty()) ReportNewAgents();
  event.tick = world.tick();
  event.time_s = world.time_s();
  events.push_back(std::move(event));
}

void Simulation::Impl::ReportDiagnostic(const Diagnostic& diagnostic) {
  RunEvent event;
  event.kind = EventKind::kDiagnostic;
  event.diagnostic = diagnostic;
  Report(std::move(event));
}

void Simulation::Impl::KeepConnected() {
  if (soar->IsConnected()) return;
  const std::string address = soar->settings().remote_host + ":" + std::to_string(soar->settings().remote_port);
  RunEvent event;
  if (std::exchange(connected, false)) {
    event.kind = EventKind::kMindLost;
    event.text =
        "the Soar kernel at " + address + " no longer answers; its agents do nothing until a kernel answers there";
    Report(std::move(event));
  }
  if (!soar->Reconnect()) return;
  minds->Restore();
  if (!soar->IsConnected()) return;
  connected = true;
  event.kind = EventKind::kMindBack;
  event.text = "a Soar kernel answers at " + address + " again; the agents' rules are loaded, their memories are new";
  Report(std::move(event));
}

void Simulation::Impl::ServeClients() {
  soar->ServeClients();
  for (CommandInput& command : soar->TakeHeard()) door.Note(std::move(command));
}

void Simulation::Impl::ApplyInputs() {
  const InputTargets targets{
      world,
      *scripts,
      *soar,
      [this](const CommandInput& asked, const Result<std::string>& answer) { ReportAnswer(asked, answer); },
      [this](const Diagnostic& warning) { ReportDiagnostic(warning); },
      [this](world::EntityId agent, const std::string& order) { arena->Order(agent, order); },
      *foreign,
      minds->body_kinds(),
      [this](std::string_view acts) { minds->client_acts += acts; }};
  for (const auto& [asked, answer] : std::exchange(answered, {})) ReportAnswer(asked, answer);
  for (const Input& input : door.taken().subspan(door.noted())) ApplyInput(input, targets);
}

void Simulation::Impl::ReportAnswer(const CommandInput& asked, const Result<std::string>& answer) {
  RunEvent event;
  event.kind = answer ? EventKind::kAnswer : EventKind::kDiagnostic;
  event.agent = asked.agent;
  event.news = asked.line;
  if (answer) {
    event.text = *answer;
  } else {
    event.diagnostic = answer.error();
  }
  Report(std::move(event));
}

void Simulation::Impl::ReportEnd(const std::string& reached) {
  RunEvent event;
  event.kind = EventKind::kEnded;
  event.text = reached;
  Report(std::move(event));
}

void Simulation::Impl::ReportEndOfScripts() {
  if (end_of_scripts_told || !scripts->End()) return;
  end_of_scripts_told = true;
  const script::ScriptsEnd& asked = *scripts->End();
  ReportEnd("the end that " + asked.script + " asked for by os.exit(" + std::to_string(asked.exit_code) +
            "); no script runs any more");
}

void Simulation::Impl::ReportNewAgents() {
  // Ids ascend; those of removed agents are no longer listed.
  const std::span<const world::EntityId> ids = world.AgentIds();
  for (auto next = std::ranges::upper_bound(ids, last_reported); next != ids.end(); ++next) {
    last_reported = *next;
    const world::Agent& body = *world.FindAgent(*next);
    RunEvent event;
    event.kind = EventKind::kAgentCreated;
    event.agent = body.name();
    event.text = body.kind();
    if (!body.script().empty()) event.text += ", " + body.script();
    Report(std::move(event));
  }
}

void Simulation::Impl::EndRemoved(std::span<const world::EntityId> removed) {
  for (const world::EntityId id : removed) {
    if (world.FindAgent(id) == nullptr) continue;
    arena->Remove(id);
    minds->EndRemoved(id);
  }
}

void Simulation::Impl::ReportWarningsOfWorld() {
  for (const Diagnostic& warning : world.TakeWarnings()) ReportDiagnostic(warning);
}

void Simulation::Impl::ReportCommand(Minds::Mind& mind, const world::Agent& body,
                                     const vocabulary::SaidCommand& command) {
  if (mind.is_scripted && !mind.by_sandbox && command.name == mind.last_command && !settings.every_command) return;
  mind.last_command = command.name;
  RunEvent event;
  event.kind = EventKind::kCommand;
  event.agent = body.name();
  event.text = command.name;
  event.parameters = vocabulary::Describe(command.parameters);
  event.has_perceived = mind.settings.has_distance;
  event.perceived = mind.distance_squared_m2;
  event.position = body.Position();
  Report(std::move(event));
}

void Simulation::Impl::ActByScript(world::EntityId id) {
  world::Agent& body = *world.FindAgent(id);
  Minds::Mind* mind = minds->Find(id);
  std::vector<Outcome> outcomes;
  // One update per command, as in the thesis; none without a command.
  for (std::size_t i = 0; i < mind->soar.commands().size(); ++i) {
    const vocabulary::SaidCommand command = mind->soar.commands()[i];  // A copy, because the script may create agents
                                                                       // with minds.
    body.SetLastCommand(command.name);
    ReportCommand(*mind, body, command);
    Outcome outcome;
    outcome.tag = command.tag;
    outcome.command = command.name;
    if (command.is_too_large) {
      outcome.reason = "too-large";
    } else if (mind->by_sandbox) {
      script::GameAnswer answer = scripts->CommandBySandbox(id, command.name, ToTable(command.parameters));
      outcome.reason = std::move(answer.reason);
      outcome.text = std::move(answer.text);
      for (Outcome& other : outcomes) {
        if (answer.drops.empty() || other.command != answer.drops || !other.reason.empty()) continue;
        other.reason = answer.drop_reason;
        other.text = std::move(outcome.text);
      }
    } else {
      const script::CommandAnswer answer =
          scripts->CommandAgent(id, command.tag, command.name, ToTable(command.parameters));
      mind = minds->Find(id);
      if (answer.state == script::CommandAnswer::State::kRunning)
        mind->under_way.push_back({command.tag, command.name});
      if (std::optional<Outcome> result = OutcomeOf(answer, command.tag, command.name))
        minds->NoteAnswer(*mind, std::move(*result), IsRefusal(answer));
      continue;
    }
    mind = minds->Find(id);
    outcomes.push_back(std::move(outcome));
  }
  for (Outcome& outcome : outcomes) {
    if (!outcome.reason.empty()) outcome.status = Outcome::Status::kError;
    minds->NoteAnswer(*mind, std::move(outcome));
  }
}

std::optional<Outcome> Simulation::Impl::OutcomeOf(const script::CommandAnswer& answer, std::uint64_t tag,
                                                   const std::string& command) {
  using State = script::CommandAnswer::State;
  Outcome outcome;
  outcome.tag = tag;
  outcome.command = command;
  if (answer.state == State::kRunning) {
    if (!answer.progress) return std::nullopt;
    outcome.status = Outcome::Status::kProgress;
    outcome.progress = *answer.progress;
  } else if (answer.state == State::kError) {
    outcome.status = Outcome::Status::kError;
    outcome.reason = answer.reason;
    outcome.text = answer.text;
  }
  return outcome;
}

void Simulation::Impl::ContinueByScript(world::EntityId id) {
  // A copy, because the script may create agents with minds.
  const std::vector<Minds::Mind::UnderWay> under_way = minds->Find(id)->under_way;
  for (const Minds::Mind::UnderWay& command : under_way) {
    Minds::Mind* mind = minds->Find(id);
    const auto forget = [&] {
      std::erase_if(mind->under_way, [&](const auto& other) { return other.tag == command.tag; });
    };
    if (!mind->soar.HasCommand(command.tag)) {
      forget();
      scripts->WithdrawCommand(id, command.tag, command.name);
      continue;
    }
    const script::CommandAnswer answer = scripts->ContinueCommand(id, command.tag, command.name);
    mind = minds->Find(id);
    const bool is_over = answer.state != script::CommandAnswer::State::kRunning;
    const bool is_news = answer.state == script::CommandAnswer::State::kComplete || IsRefusal(answer);
    if (is_over) forget();
    if (std::optional<Outcome> outcome = OutcomeOf(answer, command.tag, command.name))
      minds->NoteAnswer(*mind, std::move(*outcome), is_news);
  }
}

void Simulation::Impl::Act(world::EntityId id) {
  world::Agent& body = *world.FindAgent(id);
  if (Minds::Mind* mind = minds->Find(id)) {
    if (mind->by_client) return world.SyncAgent(id);  // Its client acted.
    minds->Await(*mind);
    // A body whose mind is lost has no controller: it stops, and falls if it is in the air.
    if (!connected || mind->lost) body.SetVelocity({0, std::min(body.Velocity().y, 0.0f), 0});
    if (mind->is_scripted && !mind->by_sandbox) {
      ContinueByScript(id);
      if (minds->Find(id)->decided) ActByScript(id);
      scripts->TickAgent(id);
    } else if (mind->decided && mind->is_scripted) {
      ActByScript(id);
    } else if (Actor* actor = arena->Find(id); mind->decided && actor != nullptr) {
      for (const std::uint64_t tag : mind->soar.withdrawn()) actor->Cancel(tag);
      for (const vocabulary::SaidCommand& command : mind->soar.commands()) {
        body.SetLastCommand(command.name);
        ReportCommand(*mind, body, command);
        actor->Begin(command);
      }
    }
  } else {
    scripts->UpdateAgent(id);
  }
  world.SyncAgent(id);
}

Simulation::Simulation(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Simulation::~Simulation() = default;

bool Simulation::sends_commands_elsewhere() const {
  return static_cast<bool>(impl_->elsewhere);
}

void Simulation::SendCommandsElsewhere(CommandsElsewhere elsewhere) {
  impl_->elsewhere = std::move(elsewhere);
}

Result<std::unique_ptr<Simulation>> Simulation::Create(const Scenario& scenario, const SimulationSettings& settings) {
  auto impl = std::make_unique<Impl>(scenario, settings);
  SoarSettings soar = settings.soar;
  soar.seed = settings.seed;
  soar.folders = ReadableRuleFolders(scenario);
  Result<std::unique_ptr<SoarHost>> host = SoarHost::Create(soar);
  if (!host) return host.error();
  impl->soar = std::move(*host);
  const auto report = [self = impl.get()](RunEvent event) { self->Report(std::move(event)); };
  impl->arena = std::make_unique<Arena>(impl->world, report);
  impl->foreign = std::make_unique<ForeignBodies>(impl->world, *impl->arena, report);
  impl->minds = std::make_unique<Minds>(impl->world, impl->scenario, *impl->soar, *impl->arena, report);
  impl->minds->SetDetail(settings.mind_detail, settings.records_origins);
  impl->minds->SetMemoryLimit(settings.limits.memory_bytes);
  std::optional<ScenarioFile> definition;
  if (!scenario.definition.empty()) {
    Result<ScenarioFile> read = ReadScenarioFile(scenario.definition);
    if (!read) return read.error();
    definition = std::move(*read);
  }
  script::ScriptHostSettings scripts;
  scripts.script_folders = scenario.script_folders;
  scripts.world_limits = settings.limits;
  if (definition) scripts.turn_ticks = definition->turn_ticks;
  impl->scripts = std::make_unique<script::ScriptHost>(impl->world, scripts, impl->minds.get(), *impl);
  impl->minds->SetSenseScript([self = impl.get()](world::EntityId agent) { return self->scripts->SenseAgent(agent); });
  impl->minds->SetSenseSandbox(
      [self = impl.get()](world::EntityId agent) { return self->scripts->SenseBySandbox(agent); });
  if (!impl->scripts->LoadSandbox(scenario.script.filename().string())) {
    for (const RunEvent& event : impl->events) {
      if (event.kind == EventKind::kDiagnostic && event.diagnostic.severity == Severity::kError)
        return event.diagnostic;
    }
    return ProblemIn(scenario.script.string(), "this script did not load");
  }
  impl->scripts->Initialize();
  if (definition) {
    ScenarioBuild build{impl->world, *impl->arena, *impl->minds, scenario};
    if (const Result<void> built = BuildScenario(*definition, build); !built) return built.error();
    impl->end = std::make_unique<ScenarioEnd>(*definition, impl->world, *impl->arena);
  }
  if (const Result<void> known = CheckReplacements(scenario, impl->world); !known) return known.error();
  impl->ReportNewAgents();
  impl->scripts->TellTroubles();
  impl->ReportWarningsOfWorld();
  impl->ReportEndOfScripts();
  return std::unique_ptr<Simulation>(new Simulation(std::move(impl)));
}

void Simulation::Tick() {
  Impl& s = *impl_;
  Stopwatch watch;
  s.ServeClients();
  s.KeepConnected();
  s.minds->SetOtherMemory(s.scripts->memory_bytes(), s.world.AgentIds().size() * script::kAgentBodyBytes +
                                                         s.world.ObjectIds().size() * script::kObjectBodyBytes);

  // Events.
  s.EndRemoved(s.scripts->BeginTick());
  s.door.BeginTick(s.world.tick());
  s.ApplyInputs();
  s.scripts->DeliverEvents();
  watch.Lap(s.costs.events_s);
  // Sense and decide.
  s.minds->Decide();
  watch.Lap(s.costs.decide_s);
  // Act, and wait until the minds of scripted bodies have decided.
  s.order.assign(s.world.AgentIds().begin(), s.world.AgentIds().end());
  for (std::size_t i = 0; i < s.order.size(); ++i) {
    s.scripts->Foresee(s.order, i);
    s.Act(s.order[i]);
  }
  s.minds->LookAhead();
  s.arena->Step();
  s.foreign->Move();
  const world::Workers free_threads = s.minds->Answer();
  watch.Lap(s.costs.act_s);
  // Move.
  s.world.Step(free_threads);
  s.minds->EndAnswers();
  watch.Lap(s.costs.move_s);
  s.arena->HearCollisions();
  s.scripts->HandleCollisions();
  s.scripts->UpdateSandbox();

  s.ReportNewAgents();
  s.scripts->TellTroubles();
  s.ReportWarningsOfWorld();
  if (s.end) {
    if (const std::string reached = s.end->Check(); !reached.empty()) s.ReportEnd(reached);
  }
  s.ReportEndOfScripts();
  watch.Lap(s.costs.rest_s);
}

bool Simulation::HasEnded() const {
  return impl_->scripts->End() || impl_->ended_by_script || (impl_->end != nullptr && impl_->end->IsOver());
}

int Simulation::ExitCode() const {
  return impl_->scripts->End() ? impl_->scripts->End()->exit_code : 0;
}

void Simulation::Idle() {
  impl_->ServeClients();
  impl_->KeepConnected();
}

std::uint64_t Simulation::tick() const {
  return impl_->world.tick();
}
double Simulation::time_s() const {
  return impl_->world.time_s();
}
const TickCosts& Simulation::costs() const {
  return impl_->costs;
}
const world::World& Simulation::world() const {
  return impl_->world;
}
const Arena& Simulation::arena() const {
  return *impl_->arena;
}
const ForeignBodies& Simulation::foreign() const {
  return *impl_->foreign;
}
world::SceneSnapshot Simulation::Snapshot() const {
  return impl_->world.Snapshot();
}
void Simulation::Snapshot(world::SceneSnapshot& scene, world::HungThings hung) const {
  impl_->world.Snapshot(scene, hung);
}
world::OverlaySnapshot Simulation::Overlays(const world::OverlayWants& wants) const {
  return TakeOverlays(*impl_->arena, *impl_->minds, wants);
}
std::uint64_t Simulation::StateHash() const {
  world::StateHash hash;
  if (impl_->arena->actors().empty()) return impl_->world.Hash();
  hash.Add(impl_->world.Hash());
  impl_->arena->AddTo(hash);
  impl_->foreign->AddTo(hash);
  return hash.value();
}
std::size_t Simulation::soar_agents() const {
  return impl_->minds->size();
}
std::size_t Simulation::present_soar_agents() const {
  return static_cast<std::size_t>(std::ranges::count_if(
      impl_->minds->all(), [this](const Minds::Mind& mind) { return !impl_->world.FindAgent(mind.agent)->IsGone(); }));
}
MindReport Simulation::Mind(std::size_t index) const {
  const Minds::Mind& mind = impl_->minds->all()[index];
  return {AgentOfMind(index), mind.soar.record().events, mind.decide_s};
}
const std::string& Simulation::AgentOfMind(std::size_t index) const {
  return impl_->world.FindAgent(impl_->minds->all()[index].agent)->name();
}
bool Simulation::HasMind(std::string_view agent) const {
  const Minds::Mind* mind = impl_->minds->FindNamed(agent);
  return mind != nullptr && !impl_->world.FindAgent(mind->agent)->IsGone();
}
std::unique_ptr<explain::Inspector> Simulation::Inspect(std::string_view agent) const {
  Minds::Mind* mind = impl_->minds->FindNamed(agent);
  if (mind == nullptr || mind->lost || !impl_->soar->IsConnected()) return nullptr;
  std::unique_ptr<explain::Inspector> inspector = explain::MakeInspector(mind->soar.agent());
  inspector->origins.time = [minds = impl_->minds.get(), name = std::string(agent)](std::uint64_t decision) {
    const Minds::Mind* const asked = minds->FindNamed(name);
    return asked == nullptr ? std::nullopt : asked->clock.TimeOf(decision);
  };
  return inspector;
}
bool Simulation::NoteMind(std::string_view agent, MindDetail detail) {
  Minds::Mind* mind = impl_->minds->FindNamed(agent);
  if (mind == nullptr || mind->gone) return false;
  mind->settings.detail = detail;
  mind->settings.origins = true;
  mind->soar.SetDetail(detail, true);
  return true;
}
EventList Simulation::TakeEvents() {
  return std::exchange(impl_->events, {});
}

void Simulation::EndScripts() {
  script::LuaMachine::InterruptAll();
}

void Simulation::Submit(Input input) {
  const auto* const line = std::get_if<CommandInput>(&input.value);
  if (line != nullptr && !line->agent.empty()) {
    if (impl_->elsewhere) return impl_->ReportAnswer(*line, impl_->elsewhere(line->agent, line->line));
  }
  if (impl_->door.Submit(std::move(input))) return;
  Diagnostic warning;
  warning.severity = Severity::kWarning;
  warning.message =
      "more than " + std::to_string(InputDoor::kMostPerTick) + " inputs for one tick: the rest is left out";
  if (impl_->flood_told_at != tick()) impl_->ReportDiagnostic(warning);
  impl_->flood_told_at = tick();
}

Result<std::string> Simulation::Command(const std::string& agent, const std::string& line) {
  if (impl_->elsewhere) return impl_->elsewhere(agent, line);
  Result<std::string> answer = impl_->soar->Execute(agent, line, impl_->settings.typed_by_strangers);
  impl_->answered.emplace_back(CommandInput{agent, line}, answer);
  impl_->door.Note(impl_->answered.back().first);
  return answer;
}

std::span<const Input> Simulation::LastInputs() const {
  return impl_->door.taken();
}

std::size_t Simulation::waiting_inputs() const {
  return impl_->door.waiting();
}

std::vector<WatchedFile> Simulation::Files(bool with_scenario) {
  std::vector<WatchedFile> files;
  std::map<std::string, std::filesystem::path, std::less<>> found;  // Many agents share their scripts.
  const auto add_scripts = [&](world::EntityId id, const std::string& agent) {
    for (const std::string& script : impl_->scripts->FilesOf(id)) {
      const auto [at, is_new] = found.try_emplace(script);
      if (is_new) at->second = FindInFolders(script, impl_->scenario.script_folders);
      if (!at->second.empty()) files.push_back({agent, at->second, false, script});
    }
  };
  add_scripts(world::EntityId::kSandbox, "");
  for (const world::EntityId id : impl_->world.AgentIds()) {
    const std::string& name = std::as_const(impl_->world).FindAgent(id)->name();
    add_scripts(id, name);
    if (const Minds::Mind* mind = impl_->minds->Find(id)) files.push_back({name, mind->rules, true});
  }
  if (with_scenario && !impl_->scenario.definition.empty()) files.push_back({"", impl_->scenario.definition, false});
  for (WatchedFile& file : files) file.file = impl_->scenario.Original(file.file);
  return files;
}

std::optional<explain::WhyNode> Simulation::Why(std::string_view agent, bool with_operators) const {
  return impl_->minds->Why(agent, with_operators);
}

Result<std::vector<explain::WhyNode>> Simulation::WhyTopic(std::string_view agent, const std::string& topic) {
  return impl_->minds->WhyTopic(agent, topic);
}

std::vector<Diagnostic> Simulation::SlipsOf(std::string_view agent, const std::set<std::string>& rules) const {
  return impl_->minds->SlipsOf(agent, rules);
}

void ObserveScripts(Simulation& simulation, script::ScriptObserver* observer) {
  if (MayObserveScripts()) script::ObserveScripts(*simulation.impl_->scripts, observer);
}

bool MayObserveScripts() {
  return script::ObserveNewHosts::Current() == nullptr;
}

void Simulation::Finish() {
  if (std::exchange(impl_->finished, true)) return;
  impl_->minds->TellCounts();
  impl_->scripts->Cleanup();
  impl_->scripts->TellTroubles();
  impl_->scripts->TellCounts();
}

}  // namespace soarbox::sim
