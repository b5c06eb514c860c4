// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "diagnostics/result.h"
#include "explain/inspector.h"
#include "explain/why_node.h"
#include "script/world_budget.h"
#include "sim/input.h"
#include "sim/live_edits.h"
#include "sim/mind_log.h"
#include "sim/run_event.h"
#include "sim/scenario.h"
#include "sim/soar_host.h"
#include "world/overlay_snapshot.h"
#include "world/scene_snapshot.h"

namespace soarbox::world {
class World;
}

namespace soarbox::sim {

class Arena;
class ForeignBodies;

/// What one Soar mind did in a tick.
struct MindReport {
  const std::string& agent;
  const mind::EventLog& events;
  double decide_s = 0;  ///< Real time that it decided for; nothing in a run depends on it.
};

struct SimulationSettings {
  std::uint64_t seed = 1;      ///< Of the world, the scripts and the minds.
  int screen_width_px = 1280;  ///< What scripts see; the window follows it.
  int screen_height_px = 720;
  bool every_command = false;                  ///< Report each command of each tick, not only news.
  SoarSettings soar;                           ///< Its seed is taken from `seed`.
  MindDetail mind_detail = MindDetail::kNone;  ///< How much Mind() reports.
  script::WorldLimits limits;                  ///< Of all scripts and minds together.
  bool typed_by_strangers = false;             ///< Typed commands may do no more than those of a recording.
};

/// What the parts of all ticks so far have taken, in seconds of real time. For benchmarks and panels; nothing in a run
/// depends on it.
struct TickCosts {
  double events_s = 0;  ///< Debuggers, inputs, custom events.
  double decide_s = 0;  ///< Minds perceive; those whose bodies no script drives also decide.
  double act_s = 0;     ///< Commands and scripts of agents, and waiting for the minds of scripts.
  double move_s = 0;    ///< Physics.
  double rest_s = 0;    ///< Collisions, the sandbox's script, reports.
};

/// A scenario in motion: the world, its scripts and its minds, advanced tick by tick.
///
/// All that reaches it from outside comes in by one door, Submit, as values with a tick; whoever watches sees the world
/// as const. The same scenario, settings and inputs give the same run, bit for bit. Used by one thread at a time.
class Simulation {
 public:
  /// Builds the world and runs the scenario's set-up. Fails only if there is nothing to run at all (the sandbox script
  /// cannot be read or does not compile, the kernel cannot start); everything else is reported through events.
  static Result<std::unique_ptr<Simulation>> Create(const Scenario& scenario, const SimulationSettings& settings);
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// Advances the world by one step: events, sense, decide, act, move.
  void Tick();
  /// Lets attached debuggers have their say; called while the world is paused. Tick does so by itself.
  void Idle();

  /// The scenario has reached its end (its file says when, or a script calls os.exit); ticks may go on.
  bool HasEnded() const;
  /// The exit code that a script asked for (os.exit); 0 if none did.
  int ExitCode() const;
  std::uint64_t tick() const;
  double time_s() const;
  const world::World& world() const;
  /// Places, items and what actors carry and know, for whoever only looks.
  const Arena& arena() const;
  /// Bodies that other simulations own.
  const ForeignBodies& foreign() const;
  world::SceneSnapshot Snapshot() const;
  /// The same, in place of an earlier one, whose memory it uses again.
  void Snapshot(world::SceneSnapshot& scene) const;
  /// What overlays also draw.
  world::OverlaySnapshot Overlays(const world::OverlayWants& wants) const;
  /// Hash of all that decides the world's future (World::Hash, and what the bodies are doing).
  std::uint64_t StateHash() const;
  /// How many minds there are, those of removed agents included.
  std::size_t soar_agents() const;
  /// The same without those of removed agents.
  std::size_t present_soar_agents() const;
  /// What the mind of this number, in creation order, did in the last tick. Valid until the next.
  MindReport Mind(std::size_t index) const;
  const std::string& AgentOfMind(std::size_t index) const;
  /// Whether there is an agent of this name with a Soar mind. False if it was removed.
  bool HasMind(std::string_view agent) const;
  /// Looks into the mind of an agent; null if there is no such agent with a Soar mind, or its kernel has gone. Valid
  /// until the next tick.
  std::unique_ptr<explain::Inspector> Inspect(std::string_view agent) const;
  /// How much Mind() reports of this agent from the next tick on. The run stays the same. False if it has no Soar mind.
  bool NoteMind(std::string_view agent, MindDetail detail);

  const TickCosts& costs() const;

  /// What happened since the last call.
  EventList TakeEvents();

  /// Takes an input from outside. It takes effect at the beginning of its tick, before anything else happens, in the
  /// order of the calls. Inputs for ticks that are over (0: now) take effect in the next one. An event then reports
  /// what an input cannot do (no such agent).
  void Submit(Input input);
  void Submit(InputValue value) { Submit(Input{0, std::move(value)}); }
  /// Carries out a line of the Soar command language for an agent's mind now, between two ticks, and returns what it
  /// printed. It counts as an input of the next tick, which reports it as an event, so that a record of the inputs
  /// replays it too.
  Result<std::string> Command(const std::string& agent, const std::string& line);
  /// What came in for the last tick, in the order in which it took effect, including what attached debuggers said to
  /// the minds. Submitting the same to another simulation of the same scenario and seed gives the same run. Valid until
  /// the next tick.
  std::span<const Input> LastInputs() const;
  /// Inputs that wait for later ticks.
  std::size_t waiting_inputs() const;

  /// The files that its minds and scripts were made from. `with_scenario`: the scenario file (TOML), too, as the last
  /// one; it belongs to no agent.
  std::vector<WatchedFile> Files(bool with_scenario = false);
  /// Explains the present behaviour of an agent; nothing if there is no such agent with a mind.
  /// `with_operators`: include the operators that are selected now, as reported by commands of any kernel.
  std::optional<explain::WhyNode> Why(std::string_view agent, bool with_operators = true) const;
  /// Why it does or does not give this command, select this operator or match this rule now.
  Result<std::vector<explain::WhyNode>> WhyTopic(std::string_view agent, const std::string& topic);
  /// What is most likely a slip in these rules of an agent as they run now, as warnings with their places.
  std::vector<Diagnostic> SlipsOf(std::string_view agent, const std::set<std::string>& rules) const;
  /// Ends the scripts of all simulations as soon as possible, because the process is about to end. You may call it from
  /// a signal handler.
  static void EndScripts();

  /// Runs the scripts' clean-up once; no tick may follow.
  void Finish();

 private:
  struct Impl;
  explicit Simulation(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace soarbox::sim
