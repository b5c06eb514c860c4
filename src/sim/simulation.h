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
#include "mind/mind_record.h"
#include "script/world_budget.h"
#include "sim/commands_elsewhere.h"
#include "sim/input.h"
#include "sim/live_edits.h"
#include "sim/run_event.h"
#include "sim/scenario.h"
#include "sim/soar_host.h"
#include "world/overlay_snapshot.h"
#include "world/scene_snapshot.h"

namespace soarbox::world {
class World;
}
namespace soarbox::script {
class ScriptObserver;
}

namespace soarbox::sim {

class Arena;
class ForeignBodies;
using mind::MindDetail;

/// What one Soar mind did in a tick.
struct MindReport {
  const std::string& agent;
  const mind::EventLog& events;
  double decide_s = 0;  ///< Real time of its decisions. Nothing in a run depends on it.
};

struct SimulationSettings {
  std::uint64_t seed = 1;      ///< For the world, the scripts and the minds.
  int screen_width_px = 1280;  ///< Reported to scripts; a window adjusts its size to it.
  int screen_height_px = 720;
  bool every_command = false;                  ///< Report each command in each tick, not only changes.
  SoarSettings soar;                           ///< Its seed is ignored; `seed` is used.
  MindDetail mind_detail = MindDetail::kNone;  ///< How much Mind() reports.
  /// Whether minds on which Mind() reports also record the origins of elements, which answers to *why* contain. Turn it
  /// off if nothing can ask during the run: a recording does not contain them.
  bool records_origins = true;
  script::WorldLimits limits;       ///< For all scripts and minds together.
  bool typed_by_strangers = false;  ///< Typed commands are restricted like those of a recording.
};

/// Total real time of each part of all ticks so far, in seconds. For benchmarks and panels. Nothing in a run depends on
/// it.
struct TickCosts {
  double events_s = 0;  ///< Debuggers, inputs, custom events.
  double decide_s = 0;  ///< Minds perceive; minds without scripted bodies also decide.
  double act_s = 0;     ///< Commands and scripts of agents; includes waiting for the minds of scripted bodies.
  double move_s = 0;    ///< Physics.
  double rest_s = 0;    ///< Collisions, the sandbox's script, reports.
};

/// A running scenario: the world, its scripts and its minds, advanced tick by tick.
///
/// All inputs from outside enter through Submit, as values with a tick. Observers have const access to the world. The
/// same scenario, settings and inputs give the same run, bit for bit. Not thread-safe.
class Simulation {
 public:
  /// Builds the world and runs the scenario's set-up. Fails if the kernel cannot start, if the sandbox script cannot be
  /// read or compiled, if the scenario file is invalid, or if replaced rules name an agent that does not exist. All
  /// other problems are reported as events.
  static Result<std::unique_ptr<Simulation>> Create(const Scenario& scenario, const SimulationSettings& settings);
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// Advances the world by one step: events, sense, decide, act, move.
  void Tick();
  /// Serves attached debuggers while the world is paused. Tick does this itself.
  void Idle();

  /// Whether the scenario has reached its end: a condition in its file, or Sandbox.End or os.exit in a script. Further
  /// ticks are possible.
  bool HasEnded() const;
  /// The exit code that a script passed to os.exit; 0 if none did.
  int ExitCode() const;
  std::uint64_t tick() const;
  double time_s() const;
  const world::World& world() const;
  /// Places, items, and what actors carry and know, for observers.
  const Arena& arena() const;
  /// Bodies that other simulations own.
  const ForeignBodies& foreign() const;
  world::SceneSnapshot Snapshot() const;
  /// The same. Reuses the memory of `scene`.
  void Snapshot(world::SceneSnapshot& scene, world::HungThings hung = world::HungThings::kPlaced) const;
  /// The additional data that overlays draw.
  world::OverlaySnapshot Overlays(const world::OverlayWants& wants) const;
  /// Hash of all state that determines the world's future (World::Hash, and the commands of bodies).
  std::uint64_t StateHash() const;
  /// Number of minds, including those of removed agents.
  std::size_t soar_agents() const;
  /// Number of minds without those of removed agents.
  std::size_t present_soar_agents() const;
  /// What a mind did in the last tick. `index` counts the minds in creation order. Valid until the next tick.
  MindReport Mind(std::size_t index) const;
  const std::string& AgentOfMind(std::size_t index) const;
  /// Whether there is an agent of this name with a Soar mind. False if it was removed.
  bool HasMind(std::string_view agent) const;
  /// Inspects the mind of an agent. Null if there is no such agent with a Soar mind, or if its kernel is lost. Valid
  /// until the next tick.
  std::unique_ptr<explain::Inspector> Inspect(std::string_view agent) const;
  /// Sets how much Mind() reports about this agent from the next tick on; origins are recorded, too. Does not change
  /// the run. Returns false if it has no Soar mind.
  bool NoteMind(std::string_view agent, MindDetail detail);

  const TickCosts& costs() const;

  /// The events since the last call.
  EventList TakeEvents();

  /// Accepts an input from outside. It takes effect at the beginning of its tick, before anything else happens, in the
  /// order of the calls. An input for a past tick (0: now) takes effect in the next one. If an input cannot be applied,
  /// for example because there is no such agent, an event reports it.
  void Submit(Input input);
  void Submit(InputValue value) { Submit(Input{0, std::move(value)}); }
  /// Executes a line of the Soar command language for an agent's mind now, between two ticks, and returns its output.
  /// The line is recorded as an input of the next tick, which also reports it as an event, so that a recording of the
  /// inputs replays it.
  Result<std::string> Command(const std::string& agent, const std::string& line);
  /// Redirects command lines for its agents (Command and Submit) to `elsewhere`, because its agents mirror those of
  /// another kernel. Redirected lines are not inputs of the simulation. Their output is reported as the answer. An
  /// empty function ends the redirection.
  void SendCommandsElsewhere(CommandsElsewhere elsewhere);
  /// Whether command lines are redirected: the simulation mirrors the agents of another kernel.
  bool sends_commands_elsewhere() const;
  /// The inputs of the last tick, in the order in which they took effect, including commands of attached debuggers to
  /// the minds. Submitting the same inputs to another simulation of the same scenario and seed gives the same run.
  /// Valid until the next tick.
  std::span<const Input> LastInputs() const;
  /// Number of inputs that are queued for later ticks.
  std::size_t waiting_inputs() const;

  /// The files that its minds and scripts were loaded from. `with_scenario`: also the scenario file (TOML), as the last
  /// one; its `agent` is empty.
  std::vector<WatchedFile> Files(bool with_scenario = false);
  /// Explains the present behaviour of an agent; nothing if there is no such agent with a mind.
  /// `with_operators`: include the operators that are selected now, as reported by commands of any kernel.
  std::optional<explain::WhyNode> Why(std::string_view agent, bool with_operators = true) const;
  /// Explains why it gives this command, selects this operator or matches this rule now, or why not.
  Result<std::vector<explain::WhyNode>> WhyTopic(std::string_view agent, const std::string& topic);
  /// Likely slips in these rules of an agent, as they run now. Returns warnings with positions.
  std::vector<Diagnostic> SlipsOf(std::string_view agent, const std::set<std::string>& rules) const;
  /// Ends the scripts of all simulations as soon as possible, because the process is about to exit. Can be called from
  /// a signal handler.
  static void EndScripts();

  /// Runs the scripts' clean-up once. Do not call Tick afterwards.
  void Finish();

 private:
  friend void ObserveScripts(Simulation& simulation, script::ScriptObserver* observer);
  struct Impl;
  explicit Simulation(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// Lets this observer, instead of the previous one, observe all scripts from now on. Null: nobody observes them. An
/// observer does not change the run. It must exist until another one replaces it or the simulation is destroyed. Do not
/// call it during a tick. Has no effect if MayObserveScripts() is false.
void ObserveScripts(Simulation& simulation, script::ScriptObserver* observer);
/// False while another observer, such as a profiler, observes all scripts of this thread.
bool MayObserveScripts();

}  // namespace soarbox::sim
