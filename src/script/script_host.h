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

struct ScriptHostSettings {
  /// Where scripts are looked for: the scenario's folder first, the library's last.
  std::vector<std::filesystem::path> script_folders;
  MachineLimits sandbox_limits{std::size_t{256} << 20, 200'000'000};
  MachineLimits agent_limits{std::size_t{64} << 20, 20'000'000};
  std::size_t max_agents = 20'000;
  WorldLimits world_limits;  ///< Of all machines together.
  int turn_ticks = 1;        ///< What the sandbox's script finds in Sandbox_TurnTicks.
};

/// All scripts of one world: the sandbox's machine and one machine for each agent, with the API between them and the
/// world. It knows no minds: agents that have one are made through the MindFactory, and whoever runs the simulation
/// hands their commands to UpdateAgent.
///
/// One tick, in the sandbox's order:
///   host.BeginTick();                    // and the world's: removed agents and objects go
///   host.HandleInput(event) ...          // keys and mouse
///   host.DeliverEvents();                // custom events
///   for each agent, in creation order (a copy of world.AgentIds(): scripts may create more):
///     host.UpdateAgent(id[, command]);  world.SyncAgent(id);
///   world.Step();
///   host.HandleCollisions();
///   host.UpdateSandbox();
///   host.TellTroubles();                 // what failed, each error once
///
/// Nothing that a script does ends the world. An error costs the call in which it came, and the agent goes on with the
/// next one; each error is reported once, with the agents that had it. Only a script that does not load, or whose mind
/// cannot be made, stops its agent: it is marked (world::Agent::Failed) and no longer updated. One thread at a time,
/// the world's.
class ScriptHost final : private AgentMaker {
 public:
  /// `minds` may be null: then asking for an agent with a mind is a Lua error. All must outlive the host.
  ScriptHost(world::World& world, ScriptHostSettings settings, MindFactory* minds, ScriptListener& listener);
  ~ScriptHost() override;
  ScriptHost(const ScriptHost&) = delete;
  ScriptHost& operator=(const ScriptHost&) = delete;

  /// Runs the sandbox's main script ("Sandbox.lua"). False if it is missing or fails; the listener hears why.
  bool LoadSandbox(std::string_view script);
  /// Calls Sandbox_Initialize. False if it failed; what it made before that stays.
  bool Initialize();

  /// Begins the world's tick. Agent_Cleanup is called for agents that are removed; then their scripts end. Returns the
  /// agents and objects that went, in ascending id.
  std::vector<world::EntityId> BeginTick();
  /// First the sandbox, then each agent hears of it.
  void HandleInput(const InputEvent& event);
  /// Calls the function of the button with this name, if the button is shown. False if there is no such button.
  bool PressButton(std::string_view name);
  /// Files a custom event of the type "Order" with the fields `agent` and `order`: what a user asks an agent to do.
  void AddOrder(world::EntityId agent, const std::string& order);
  void DeliverEvents();
  /// Agent_Update(agent, milliseconds [, command, parameters]). Nothing happens for agents that failed. False if it
  /// failed.
  bool UpdateAgent(world::EntityId agent, std::optional<std::string_view> command = std::nullopt,
                   const Table& parameters = {});
  /// Agent_Update(agent, milliseconds, command, parameters) for a new command of the agent's mind.
  CommandAnswer CommandAgent(world::EntityId agent, std::uint64_t tag, std::string_view command,
                             const Table& parameters);
  /// The same call again, with the same table of parameters, for a command that is under way.
  CommandAnswer ContinueCommand(world::EntityId agent, std::uint64_t tag, std::string_view command);
  /// Agent_Withdraw(agent, command, parameters): the mind has withdrawn a command that was under way.
  void WithdrawCommand(world::EntityId agent, std::uint64_t tag, std::string_view command);
  /// Agent_Tick(agent, milliseconds), for agents whose mind gives the commands: in every tick, whatever the mind does.
  void TickAgent(world::EntityId agent);
  /// Agents are about to be updated in this order, starting with `next`: asks for the memory of those after it, so that
  /// the scripts of a crowd, each in a place of its own, need not wait for it.
  void Foresee(std::span<const world::EntityId> order, std::size_t next) const;
  /// What Agent_Sense(agent) returns; nothing if there is no such function, it fails or it returns no table.
  std::optional<Table> SenseAgent(world::EntityId agent);
  /// What Sandbox_Sense(sandbox, agent) returns, for agents whose bodies are up to the sandbox. Nothing if there is no
  /// such function, it fails or it returns no table: then the agent's mind has no turn.
  std::optional<PerceptGraph> SenseBySandbox(world::EntityId agent);
  /// Sandbox_Command(sandbox, agent, command, parameters). If it fails, the reason is "script-failed".
  GameAnswer CommandBySandbox(world::EntityId agent, std::string_view command, const Table& parameters);
  /// Also files the events "SensorEntered" and "SensorLeft" of the last step.
  void HandleCollisions();
  /// Sandbox_Update(sandbox, milliseconds).
  void UpdateSandbox();
  /// Agent_Cleanup for each agent in creation order, then Sandbox_Cleanup.
  void Cleanup();
  /// Reports to the listener what failed since the last call. Call it when new agents have been announced.
  void TellTroubles() { reporter_.TellTroubles(); }
  /// Reports what was not reported because it came again and again; call it at the end of a run.
  void TellCounts() { reporter_.TellCounts(); }

  /// What all machines take of the world's memory.
  std::size_t memory_bytes() const { return budget_.used_bytes(); }

  /// How a script ended all scripts (os.exit): none is called any more. Nothing if none did.
  const std::optional<ScriptsEnd>& End() const { return budget_.end(); }

  /// True if the agent is driven by its script alone, false if a mind decides.
  bool IsLuaAgent(world::EntityId agent) const;
  /// How the agent was asked for; null for unknown ids.
  const AgentCreationRequest* RequestOf(world::EntityId agent) const;
  /// The script files that have run in the machine of the sandbox, or of an agent, as scripts call them: the main one,
  /// and those that it loaded with require.
  std::span<const std::string> FilesOf(world::EntityId agent_or_sandbox) const;
  /// Runs a text in the machine of the sandbox, or of an agent: for consoles, edits of files (keep_state.h) and tests.
  /// In other texts than edits, `sandbox` and `agent` are known. If `answer` is given and the text is an expression, it
  /// becomes its value as print shows it.
  std::optional<ScriptError> RunText(world::EntityId agent_or_sandbox, std::string_view text,
                                     std::string* answer = nullptr);
  ScriptPath& path() { return path_; }

 private:
  struct AgentScript;

  Result<world::EntityId> MakeAgent(const AgentCreationRequest& request) override;
  /// Counts what minds and bodies take now.
  void CountOthers();
  void InitializeAgent(AgentScript& script);
  void CleanUpAgent(const AgentScript& script);
  void FileSensorEvents();
  /// Ends the script of an agent that was removed.
  void EndScript(world::EntityId agent);
  AgentScript* Find(world::EntityId agent);
  /// Hands a command to Agent_Update. `kept`: where its table of parameters is kept; LUA_NOREF: nowhere yet.
  CommandAnswer AskForCommand(AgentScript& script, std::string_view command, const Table* parameters, int& kept);
  const AgentScript* Find(world::EntityId agent) const;
  std::string NameFor(const AgentCreationRequest& request);
  /// A problem without a place gets the one where a script asked for the agent.
  Diagnostic PlacedAt(const AgentCreationRequest& request, Diagnostic problem) const;
  /// Warns of options that concern a body which a script moves and shows itself.
  void WarnOfBodyOptions(const AgentCreationRequest& request);
  /// Warns of functions that are nearly those that a sandbox calls; once for each script.
  void WarnOfSlips(std::string_view script);
  bool MayRun(const LuaMachine& machine) const;
  /// Notes how a call ended; `error` may be null. False if it failed.
  bool NoteResult(world::EntityId agent, const char* callback, const ScriptError* error);
  bool NoteResult(world::EntityId agent, const char* callback, const std::optional<ScriptError>& error) {
    return NoteResult(agent, callback, error ? &*error : nullptr);
  }
  void StopAgent(AgentScript& script, const ScriptError& error);
  std::unique_ptr<LuaMachine> MakeMachine(std::string_view script, world::EntityId owner, MachineLimits limits,
                                          RandomSource& random);
  void CallSandbox(const char* function, bool with_time);

  world::World& world_;
  ScriptHostSettings settings_;
  MindFactory* minds_;
  ScriptPath path_;
  WorldBudget budget_;
  ScriptReporter reporter_;
  ScriptContext context_;
  std::unique_ptr<RandomSource> sandbox_random_;
  std::unique_ptr<LuaMachine> sandbox_;
  std::vector<std::unique_ptr<AgentScript>> agents_;  // In creation order, thus in ascending id.
  std::vector<AgentScript*> by_id_;                   // Null for ids without a script.
  std::map<std::string, int> names_;                  // How many agents of each name's stem there are.
  std::set<std::string, std::less<>> looked_over_;    // Scripts whose slips were reported.
  int creation_depth_ = 0;
};

}  // namespace soarbox::script
