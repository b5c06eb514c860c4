// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "script/command_answer.h"
#include "script/game_answer.h"
#include "script/input_event.h"
#include "script/mind_factory.h"
#include "script/percept_graph.h"
#include "script/script_context.h"
#include "script/script_path.h"
#include "script/script_reporter.h"
#include "script/script_table.h"
#include "world/world.h"

namespace soarbox::script {

class ScriptObserver;

struct ScriptHostSettings {
  /// The search path of scripts: first the scenario's folder, last the library's.
  std::vector<std::filesystem::path> script_folders;
  MachineLimits sandbox_limits{std::size_t{256} << 20, 200'000'000};
  MachineLimits agent_limits{std::size_t{64} << 20, 20'000'000};
  std::size_t max_agents = 20'000;
  WorldLimits world_limits;  ///< Of all machines together.
  int turn_ticks = 1;        ///< The value of Sandbox_TurnTicks in the sandbox's script.
};

/// All scripts of a world: the sandbox's machine and one machine for each agent, with the API between them and the
/// world. It does not depend on minds: the MindFactory creates them, and the simulation passes their commands to
/// UpdateAgent.
///
/// One tick, in the sandbox's order:
///   host.BeginTick();                    // also begins the tick of the world and removes agents and objects
///   host.HandleInput(event) ...          // keys and mouse
///   host.DeliverEvents();                // custom events
///   for each agent, in creation order (a copy of world.AgentIds(): scripts may create more):
///     host.UpdateAgent(id[, command]);  world.SyncAgent(id);
///   world.Step();
///   host.HandleCollisions();
///   host.UpdateSandbox();
///   host.TellTroubles();                 // reports failures, each error once
///
/// No script can end the world. An error ends only the call in which it occurs, and the agent continues with its next
/// call. Each error is reported once, with the agents in which it occurred. An agent is stopped only if its script does
/// not load or its mind cannot be created: it is marked (world::Agent::Failed) and no longer updated. Use it only on
/// the world's thread.
class ScriptHost final : private AgentMaker {
 public:
  /// `minds` may be null: then creating an agent with a mind is a Lua error. All arguments must outlive the host.
  ScriptHost(world::World& world, ScriptHostSettings settings, MindFactory* minds, ScriptListener& listener);
  ~ScriptHost() override;
  ScriptHost(const ScriptHost&) = delete;
  ScriptHost& operator=(const ScriptHost&) = delete;

  /// Runs the sandbox's main script ("Sandbox.lua"). False if it is missing or fails; the listener gets the error.
  bool LoadSandbox(std::string_view script);
  /// Calls Sandbox_Initialize. False if it failed; the things that it created are kept.
  bool Initialize();

  /// Begins the world's tick. Calls Agent_Cleanup of agents that are removed, and ends their scripts. Returns the ids
  /// of the removed agents and objects in ascending order.
  std::vector<world::EntityId> BeginTick();
  /// Calls Sandbox_HandleEvent, then Agent_HandleEvent of each agent.
  void HandleInput(const InputEvent& event);
  /// Calls the function of the button with this name, if the button is shown. False if there is no such button.
  bool PressButton(std::string_view name);
  /// Adds a custom event of the type "Order", for an order of the user. Its fields are `agent` and `order`.
  void AddOrder(world::EntityId agent, const std::string& order);
  void DeliverEvents();
  /// Calls Agent_Update(agent, milliseconds [, command, parameters]). Does nothing for failed agents. False if it
  /// failed.
  bool UpdateAgent(world::EntityId agent, std::optional<std::string_view> command = std::nullopt,
                   const Table& parameters = {});
  /// Calls Agent_Update(agent, milliseconds, command, parameters) for a new command of the agent's mind.
  CommandAnswer CommandAgent(world::EntityId agent, std::uint64_t tag, std::string_view command,
                             const Table& parameters);
  /// Repeats the call for a running command, with the same table of parameters.
  CommandAnswer ContinueCommand(world::EntityId agent, std::uint64_t tag, std::string_view command);
  /// Calls Agent_Withdraw(agent, command, parameters): the mind has withdrawn a running command.
  void WithdrawCommand(world::EntityId agent, std::uint64_t tag, std::string_view command);
  /// Calls Agent_Tick(agent, milliseconds) for agents whose mind gives the commands: in every tick, whatever the mind
  /// does.
  void TickAgent(world::EntityId agent);
  /// Agents will be updated in this order, starting with `next`. Prefetches the memory of the ones after it, so that
  /// the scripts of a crowd, each in its own memory, do not wait for it.
  void Foresee(std::span<const world::EntityId> order, std::size_t next) const;
  /// Returns the result of Agent_Sense(agent); nothing if the function does not exist, fails or returns no table.
  std::optional<Table> SenseAgent(world::EntityId agent);
  /// Returns the result of Sandbox_Sense(sandbox, agent), for agents whose bodies the sandbox controls. Nothing if the
  /// function does not exist, fails or returns no table: then the agent's mind has no turn.
  std::optional<PerceptGraph> SenseBySandbox(world::EntityId agent);
  /// Calls Sandbox_Command(sandbox, agent, command, parameters). If it fails, the reason is "script-failed".
  GameAnswer CommandBySandbox(world::EntityId agent, std::string_view command, const Table& parameters);
  /// Calls the callbacks of collisions. Also adds the events "SensorEntered" and "SensorLeft" of the last step.
  void HandleCollisions();
  /// Calls Sandbox_Update(sandbox, milliseconds).
  void UpdateSandbox();
  /// Calls Agent_Cleanup for each agent in creation order, then Sandbox_Cleanup.
  void Cleanup();
  /// Reports to the listener the failures since the previous call. Call it after new agents have been announced.
  void TellTroubles() { reporter_.TellTroubles(); }
  /// Reports errors that occurred more often than was reported. Call it at the end of a run.
  void TellCounts() { reporter_.TellCounts(); }

  /// Memory of all machines.
  std::size_t memory_bytes() const { return budget_.used_bytes(); }

  /// How a script ended all scripts (os.exit); no script is called any more. Nothing if none did.
  const std::optional<ScriptsEnd>& End() const { return budget_.end(); }

  /// True if only its script controls the agent, false if a mind decides.
  bool IsLuaAgent(world::EntityId agent) const;
  /// The request that created the agent; null for unknown ids.
  const AgentCreationRequest* RequestOf(world::EntityId agent) const;
  /// The script files that the machine of the sandbox or of an agent has run, by the names that scripts use: the main
  /// script, and those loaded with require.
  std::span<const std::string> FilesOf(world::EntityId agent_or_sandbox) const;
  /// Runs a text in the machine of the sandbox or of an agent: for consoles, edits of files (keep_state.h) and tests.
  /// Except in edits, the variables `sandbox` and `agent` are defined. If `answer` is given and the text is an
  /// expression, `answer` becomes its value as print shows it.
  std::optional<ScriptError> RunText(world::EntityId agent_or_sandbox, std::string_view text,
                                     std::string* answer = nullptr);
  ScriptPath& path() { return path_; }

 private:
  friend void ObserveScripts(ScriptHost& host, ScriptObserver* observer);
  struct AgentScript;

  Result<world::EntityId> MakeAgent(const AgentCreationRequest& request) override;
  /// Counts the memory of minds and bodies.
  void CountOthers();
  void InitializeAgent(AgentScript& script);
  void CleanUpAgent(const AgentScript& script);
  void FileSensorEvents();
  /// Ends the script of an agent that was removed.
  void EndScript(world::EntityId agent);
  AgentScript* Find(world::EntityId agent);
  /// Passes a command to Agent_Update. `kept` is the reference of its table of parameters; LUA_NOREF: none yet.
  CommandAnswer AskForCommand(AgentScript& script, std::string_view command, const Table* parameters, int& kept);
  const AgentScript* Find(world::EntityId agent) const;
  std::string NameFor(const AgentCreationRequest& request);
  /// Adds the place where a script requested the agent, if the problem has no place.
  Diagnostic PlacedAt(const AgentCreationRequest& request, Diagnostic problem) const;
  /// Warns of options about the body if the script moves and shows the body itself.
  void WarnOfBodyOptions(const AgentCreationRequest& request);
  /// Warns of functions whose names are nearly those that a sandbox calls; once for each script.
  void WarnOfSlips(std::string_view script);
  bool MayRun(const LuaMachine& machine) const;
  /// Notes the result of a call. False if it failed.
  bool NoteResult(world::EntityId agent, const char* callback, const std::optional<ScriptError>& error);
  /// Does the same for functions that scripts registered.
  Callbacks::OnResult NoteResultsOf(const char* callback);
  void StopAgent(AgentScript& script, const ScriptError& error);
  std::unique_ptr<LuaMachine> MakeMachine(std::string_view script, world::EntityId owner, MachineLimits limits,
                                          RandomSource& random);
  void CallSandbox(const char* function, bool with_time);

  world::World& world_;
  ScriptObserver* observer_;  ///< Of all machines; null: none.
  ScriptHostSettings settings_;
  MindFactory* minds_;
  ScriptPath path_;
  WorldBudget budget_;
  ScriptReporter reporter_;
  ScriptContext context_;
  std::unique_ptr<RandomSource> sandbox_random_;
  std::unique_ptr<LuaMachine> sandbox_;
  std::vector<std::unique_ptr<AgentScript>> agents_;  // In creation order, so in ascending id.
  std::vector<AgentScript*> by_id_;                   // Null for ids without a script.
  std::map<std::string, int> names_;                  // Number of agents for each stem of a name.
  std::set<std::string, std::less<>> looked_over_;    // Scripts whose slips were reported.
  int creation_depth_ = 0;
};

}  // namespace soarbox::script
