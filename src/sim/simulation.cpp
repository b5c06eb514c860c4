// SPDX-License-Identifier: BSD-2-Clause
#include "sim/simulation.h"

#include <algorithm>
#include <utility>

#include "script/script_host.h"
#include "sim/minds.h"
#include "world/world.h"

namespace soarbox::sim {

struct Simulation::Impl final : script::ScriptListener {
  Impl(const Scenario& given, const SimulationSettings& given_settings)
      : scenario(given), settings(given_settings), world(WorldSettingsOf(given_settings)) {}

  // script::ScriptListener
  void OnPrint(std::string_view script, std::string_view text) override;
  void OnScriptError(world::EntityId agent, const script::ScriptError& error) override;
  void OnScriptWarning(const Diagnostic& warning) override;

  static world::WorldSettings WorldSettingsOf(const SimulationSettings& settings) {
    world::WorldSettings result;
    result.seed = settings.seed;
    result.screen_width_px = settings.screen_width_px;
    result.screen_height_px = settings.screen_height_px;
    return result;
  }

  void Report(Event event);
  void ReportDiagnostic(const Diagnostic& diagnostic);
  /// Tells when the minds' kernel has gone, and brings the minds back once there is one again.
  void KeepConnected();
  void ReportNewAgents();
  void ReportWarningsOfWorld();
  void ReportCommand(Minds::Mind& mind, const world::Agent& body, const std::string& command);
  /// Carries out what the agent's mind decided, or just updates an agent that its script alone drives.
  void Act(world::EntityId id);

  const Scenario scenario;
  const SimulationSettings settings;
  world::World world;
  // The kernel outlives the minds, which outlive the scripts that ask for them.
  std::unique_ptr<SoarHost> soar;
  std::unique_ptr<Minds> minds;
  std::unique_ptr<script::ScriptHost> scripts;
  std::vector<script::InputEvent> input;
  std::vector<world::EntityId> order;  ///< Scratch: agents to update in this tick.
  EventList events;
  std::size_t agents_reported = 0;
  bool connected = true;
  bool finished = false;
};

void Simulation::Impl::OnPrint(std::string_view script, std::string_view text) {
  Event event;
  event.kind = EventKind::kLog;
  event.text = std::string(script) + ": " + std::string(text);
  Report(std::move(event));
}

void Simulation::Impl::OnScriptError(world::EntityId agent, const script::ScriptError& error) {
  Event event;
  event.diagnostic = error.diagnostic;
  const world::Agent* body = world.FindAgent(agent);
  event.kind = body != nullptr ? EventKind::kAgentFailed : EventKind::kDiagnostic;
  if (body != nullptr) event.agent = body->name();
  event.text = error.traceback;
  Report(std::move(event));
}

void Simulation::Impl::OnScriptWarning(const Diagnostic& warning) {
  ReportDiagnostic(warning);
}

void Simulation::Impl::Report(Event event) {
  event.tick = world.tick();
  event.time_s = world.time_s();
  events.push_back(std::move(event));
}

void Simulation::Impl::ReportDiagnostic(const Diagnostic& diagnostic) {
  Event event;
  event.kind = EventKind::kDiagnostic;
  event.diagnostic = diagnostic;
  Report(std::move(event));
}

void Simulation::Impl::KeepConnected() {
  if (soar->IsConnected()) return;
  const std::string address = soar->settings().remote_host + ":" + std::to_string(soar->settings().remote_port);
  Event event;
  if (std::exchange(connected, false)) {
    event.kind = EventKind::kMindLost;
    event.text = "the Soar kernel at " + address + " has gone; its agents stand still until one answers there";
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

void Simulation::Impl::ReportNewAgents() {
  const std::span<const world::EntityId> ids = world.AgentIds();
  for (; agents_reported < ids.size(); ++agents_reported) {
    const world::Agent& body = *world.FindAgent(ids[agents_reported]);
    Event event;
    event.kind = EventKind::kAgentCreated;
    event.agent = body.name();
    event.text = body.kind() + ", " + body.script();
    Report(std::move(event));
  }
}

void Simulation::Impl::ReportWarningsOfWorld() {
  for (const Diagnostic& warning : world.TakeWarnings()) ReportDiagnostic(warning);
}

void Simulation::Impl::ReportCommand(Minds::Mind& mind, const world::Agent& body, const std::string& command) {
  if (command == mind.last_command && !settings.every_command) return;
  mind.last_command = command;
  Event event;
  event.kind = EventKind::kCommand;
  event.agent = body.name();
  event.text = command;
  event.perceived = mind.distance_squared_m2;
  event.position = body.Position();
  Report(std::move(event));
}

void Simulation::Impl::Act(world::EntityId id) {
  world::Agent& body = *world.FindAgent(id);
  if (Minds::Mind* mind = minds->Find(id)) {
    // Nobody steers a body whose mind has gone with its kernel: it stops where it is, and falls if it was in the air.
    if (!connected || mind->lost) body.SetVelocity({0, std::min(body.Velocity().y, 0.0f), 0});
    // One update per command, as the thesis has it; none in a gap.
    for (std::size_t i = 0; mind->decided && i < mind->soar.commands().size(); ++i) {
      const std::string& command = mind->soar.commands()[i];
      body.SetLastCommand(command);
      ReportCommand(*mind, body, command);
      scripts->UpdateAgent(id, command);
      mind = minds->Find(id);  // The script may have made agents with minds.
      mind->soar.Answer(i, !body.Failed());
    }
  } else {
    scripts->UpdateAgent(id);
  }
  world.SyncAgent(id);
}

Simulation::Simulation(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Simulation::~Simulation() = default;

Result<std::unique_ptr<Simulation>> Simulation::Create(const Scenario& scenario, const SimulationSettings& settings) {
  auto impl = std::make_unique<Impl>(scenario, settings);
  SoarSettings soar = settings.soar;
  soar.seed = settings.seed;
  Result<std::unique_ptr<SoarHost>> host = SoarHost::Create(soar);
  if (!host) return host.error();
  impl->soar = std::move(*host);
  impl->minds = std::make_unique<Minds>(impl->world, impl->scenario, *impl->soar,
                                        [self = impl.get()](Event event) { self->Report(std::move(event)); });
  script::ScriptHostSettings scripts;
  scripts.script_folders = scenario.script_folders;
  impl->scripts = std::make_unique<script::ScriptHost>(impl->world, scripts, impl->minds.get(), *impl);
  if (!impl->scripts->LoadSandbox(scenario.script.filename().string())) {
    for (const Event& event : impl->events) {
      if (event.kind == EventKind::kDiagnostic && event.diagnostic.severity == Severity::kError)
        return event.diagnostic;
    }
    Diagnostic problem;
    problem.file = scenario.script.string();
    problem.message = "this script did not load";
    return problem;
  }
  impl->scripts->Initialize();
  impl->ReportNewAgents();
  impl->ReportWarningsOfWorld();
  return std::unique_ptr<Simulation>(new Simulation(std::move(impl)));
}

void Simulation::Tick() {
  Impl& s = *impl_;
  s.soar->ServeClients();
  s.KeepConnected();

  // Events.
  s.scripts->BeginTick(s.world.BeginTick());
  for (const script::InputEvent& event : std::exchange(s.input, {})) s.scripts->HandleInput(event);
  s.scripts->DeliverEvents();
  // Sense and decide.
  s.minds->Decide();
  // Act.
  s.order.assign(s.world.AgentIds().begin(), s.world.AgentIds().end());
  for (const world::EntityId id : s.order) s.Act(id);
  // Move.
  s.world.Step();
  s.scripts->HandleCollisions();
  s.scripts->UpdateSandbox();

  s.ReportNewAgents();
  s.ReportWarningsOfWorld();
}

void Simulation::Idle() {
  impl_->soar->ServeClients();
  impl_->KeepConnected();
}

std::uint64_t Simulation::tick() const {
  return impl_->world.tick();
}
double Simulation::time_s() const {
  return impl_->world.time_s();
}
world::World& Simulation::world() {
  return impl_->world;
}
const world::World& Simulation::world() const {
  return impl_->world;
}
world::SceneSnapshot Simulation::Snapshot() const {
  return impl_->world.Snapshot();
}
std::uint64_t Simulation::StateHash() const {
  return impl_->world.Hash();
}
std::size_t Simulation::soar_agents() const {
  return impl_->minds->size();
}
EventList Simulation::TakeEvents() {
  return std::exchange(impl_->events, {});
}

void Simulation::Key(std::string_view key, bool pressed) {
  impl_->input.push_back(script::KeyEvent(std::string(key), pressed));
}

void Simulation::MouseButton(std::string_view button, bool pressed) {
  script::InputEvent event;
  event.source = script::InputEvent::Source::kMouse;
  event.button = button;
  event.pressed = pressed;
  impl_->input.push_back(std::move(event));
}

void Simulation::ReportTimes(double frame_us, double tick_us) {
  const double between_ticks_us = static_cast<double>(impl_->world.settings().step_s) * 1e6;
  impl_->scripts->SetProfileTimes({frame_us, tick_us, between_ticks_us});
}

void Simulation::Finish() {
  if (!std::exchange(impl_->finished, true)) impl_->scripts->Cleanup();
}

}  // namespace soarbox::sim
