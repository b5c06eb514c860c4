// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "explain/failed_rule.h"
#include "explain/origin_tree.h"
#include "explain/rule_surroundings.h"
#include "explain/why_node.h"
#include "script/mind_factory.h"
#include "script/percept_graph.h"
#include "script/script_table.h"
#include "script/world_budget.h"
#include "sim/agent_options.h"
#include "sim/arena.h"
#include "sim/decision_clock.h"
#include "sim/run_event.h"
#include "sim/scenario.h"
#include "sim/soar_host.h"
#include "sim/soar_mind.h"
#include "sim/worker_pool.h"
#include "world/world.h"

namespace soarbox::explain {
class MindReasons;
}

namespace soarbox::sim {

class ClientPercepts;
class ClientScene;

/// The Soar minds of a world. Creates them when scripts or scenario files create agents with a mind, and lets them
/// perceive and decide once per tick.
class Minds final : public script::MindFactory {
 public:
  /// Receives an event without time and tick, which the receiver sets.
  using Report = std::function<void(RunEvent)>;
  /// The percepts that an agent's script returns; nothing if it returns none.
  using SenseScript = std::function<std::optional<script::Table>(world::EntityId)>;
  /// The percepts of an agent that the sandbox's script returns; nothing if the agent does not decide in this tick.
  using SenseSandbox = std::function<std::optional<script::PerceptGraph>(world::EntityId)>;

  Minds(world::World& world, const Scenario& scenario, SoarHost& host, Arena& arena, Report report);

  void SetSenseScript(SenseScript sense) { sense_script_ = std::move(sense); }
  void SetSenseSandbox(SenseSandbox sense) { sense_sandbox_ = std::move(sense); }
  /// How much is recorded of minds that are created from now on, and whether that includes origins.
  void SetDetail(MindDetail detail, bool origins) {
    detail_ = detail;
    records_origins_ = origins;
  }
  /// The memory limit of the world. If the world exceeds it, the mind that uses most memory is halted.
  void SetMemoryLimit(std::size_t bytes) { memory_limit_ = bytes; }
  /// How much of that memory scripts and bodies use.
  void SetOtherMemory(std::size_t scripts_bytes, std::size_t bodies_bytes) {
    scripts_bytes_ = scripts_bytes;
    bodies_bytes_ = bodies_bytes;
  }
  std::size_t MemoryBytes() const override { return memory_bytes_; }
  /// Kinds of bodies that options can name.
  std::vector<BodyKind>& body_kinds() { return body_kinds_; }

  /// Loads the rules that the request names, or the default rules of its kind: seekingagent.soar, followeragent.soar,
  /// waypointagent.soar. Reports rules with errors and loads the others. An agent without a script gets a body that
  /// commands of the vocabulary control. Without rules, that body does nothing.
  Result<void> MakeMind(world::EntityId agent, const script::AgentCreationRequest& request) override;

  /// All minds perceive and decide. They perceive the world before any of them acts, so their order does not matter.
  /// Minds whose bodies a script controls may still be deciding when this returns, while the world's thread runs
  /// scripts.
  void Decide();
  struct Mind;
  /// Waits until a mind has decided. Call it before its body acts.
  void Await(Mind& mind);
  /// Lets bodies that no script controls compute searches in advance, on all threads (Arena::Foresee). Call it before
  /// they act.
  void LookAhead();
  /// Stores the outcome of a command of a mind with a scripted body, for Answer.
  /// `is_news`: report it even if the command succeeded.
  void NoteAnswer(Mind& mind, Outcome outcome, bool is_news = false);
  /// Reports the outcomes of commands to the minds, after the bodies have acted. Scripted minds on other threads have
  /// received them only when EndAnswers returns; until then, no mind may be queried. Returns the threads that are free
  /// until then: all or none.
  world::Workers Answer();
  void EndAnswers() { pool_.Join(); }

  /// Reports likely slips in rules that loaded, once per file of rules. Called after the set-up, when all agents exist,
  /// because their rules and scripts determine the known words.
  void TellSlips();
  /// The same for some rules of an agent, as they run now. Returns warnings with positions.
  std::vector<Diagnostic> SlipsOf(std::string_view agent, const std::set<std::string>& rules);

  /// Reports how often each cause occurred that was reported only the first time.
  void TellCounts();
  /// Explains the present behaviour of an agent; nothing if there is no such agent with a mind.
  /// `with_operators`: include the operators that are selected now, as reported by commands.
  std::optional<explain::WhyNode> Why(std::string_view agent, bool with_operators = true);
  /// Explains why an agent gives a command or not, selects an operator or not, or why a rule matches or not. Fails if
  /// there is no such agent, or if its rules do not contain the name.
  Result<std::vector<explain::WhyNode>> WhyTopic(std::string_view agent, const std::string& topic);

  /// Lines of the log of a client that controls Soar agents itself (sml/server/client_log.h). The next Decide executes
  /// them. They can create agents, whose bodies do nothing.
  std::string client_acts;

  /// Creates all minds again in the host's kernel, with the same rules. Reports those that fail; they stay idle.
  void Restore();

  struct Mind {
    world::EntityId agent;
    MindSettings settings;
    bool follows_leader = false;  ///< It perceives its leader; otherwise its target.
    bool is_scripted = true;      ///< A script executes its commands.
    bool by_client = false;       ///< A client's log controls it. by_sandbox is then also true, because its world is
                                  ///< not ours.
    bool by_sandbox = false;      ///< The sandbox's script determines its percepts and the ticks in which it decides.
    std::filesystem::path rules;
    SoarMind soar;
    std::size_t thread = 0;  ///< The thread on which it decides.
    enum class Turn : unsigned char { kOver, kWaits, kHasDecided };
    Turn turn = Turn::kOver;  ///< State of a scripted mind in this tick.
    std::size_t place = 0;    ///< Index among the minds of its thread that decide in parallel to scripts in this tick.
    /// A command that its script executes over several ticks.
    struct UnderWay {
      std::uint64_t tag = 0;
      std::string name;
    };
    std::vector<UnderWay> under_way = {};
    std::vector<Outcome> answers = {};  ///< Outcomes from its script that were not reported yet.
    float distance_squared_m2 = 0;
    bool decided = false;           ///< In this tick.
    bool lost = false;              ///< Its program has run out of memory or work, or could not be created again.
    bool gone = false;              ///< Its agent was destroyed; there is no program to query.
    std::string gone_because = {};  ///< Why its agent was destroyed, as a sentence.
    std::size_t memory_bytes = 0;   ///< As last measured.
    bool told_memory = false;       ///< High memory use was reported.
    bool told_learned = false;      ///< A large number of learned rules was reported.
    bool in_gap = false;
    bool told_halt = false;
    int gaps = 0;                  ///< Number of times that it was idle.
    std::uint64_t idle_ticks = 0;  ///< Number of ticks without a command, new or running.
    std::string last_command = {};
    std::map<std::string, int> told = {};    ///< How often each of its faults occurred; reported the first time.
    std::map<std::string, int> causes = {};  ///< How often each cause prevented an action; reported the first
                                             ///< time.
    std::optional<vocabulary::SaidCommand> last_said = {};
    std::string last_answer = {};     ///< The outcome of the last command.
    std::string failed_command = {};  ///< The name of the last command, if its outcome is an error.
    double last_said_s = 0;
    DecisionClock clock = {};                       ///< If what it does is noted (MindSettings::detail).
    double decide_s = 0;                            ///< Real time that the last tick's decisions took.
    std::shared_ptr<ClientPercepts> percepts = {};  ///< The percepts that its client has sent, if a client drives it.
    std::shared_ptr<ClientScene> scene = {};        ///< The picture that its client describes.
  };
  /// Null if the agent has no mind. Valid until the next MakeMind.
  Mind* Find(world::EntityId agent);
  /// Finds a mind by the name of its agent; null if there is none.
  Mind* FindNamed(std::string_view agent);
  /// Ends the mind of an agent that was removed from the world. Does nothing for a mind that a client controls: the
  /// client ends it.
  void EndRemoved(world::EntityId agent);
  std::span<Mind> all() { return minds_; }
  std::size_t size() const { return minds_.size(); }

 private:
  /// Gives a mind the percepts of the sandbox's script. Returns false if it does not decide in this tick.
  bool PerceiveGraph(Mind& mind);
  Result<std::filesystem::path> FindRules(const std::string& agent, const AgentKind& kind, const std::string& named);
  Result<void> MakeBody(world::Agent& body, const AgentOptions& options);
  Result<SoarHost::Loaded> Load(const std::string& agent, const std::filesystem::path& rules,
                                const MindSettings& settings, bool is_scripted);
  void PlayClientActs();
  void PlayClientAct(const std::vector<std::string>& parts);
  void MakeClientMind(const std::string& name);
  /// Adds the mind of an agent of another program's kernel (`soarbox watch`). Its own program runs it; it is only
  /// inspected here.
  void AttachMind(const std::string& name);
  /// Adds a mind that a client controls, and places its body in the row of such bodies.
  void AddClientMind(const std::string& name, world::Agent& body, sml::Agent& agent, std::size_t thread);
  void EndClientMind(const std::string& name);
  /// Reports the commands of a mind after a run.
  void ReportClientCommands(Mind& mind);
  /// Replaces files of the recorded run in a command line by their copies.
  std::string WithCopies(Mind& mind, const std::string& line) const;
  void DecideNow(Mind& mind);
  /// Records the times of this tick's decisions, for Why.
  void NoteDecisions(Mind& mind);
  explain::DecisionTime TimeOf(const Mind& mind) const;
  /// Explains the last command: its outcome, and what made it.
  explain::WhyNode WhyCommand(Mind& mind, explain::MindReasons& reasons, bool is_dead, bool has_ended);
  /// Waits until all scripted minds have decided. The minds then do nothing until Answer.
  void AwaitAll();
  void BeginBesideScripts();
  void DecideBesideScripts(std::size_t thread);
  void TellScripts(std::size_t thread);
  void TellOutcome(Mind& mind, const Outcome& outcome, bool is_news);
  /// Prepares a mind to decide. Returns false if it does not decide in this tick.
  bool Prepare(Mind& mind);
  /// Called after it has decided.
  void Conclude(Mind& mind);
  void Notice();
  bool PerceiveDistance(Mind& mind, const world::Agent& body);
  void PerceiveWorld(Mind& mind);
  void LimitMemory();
  void KeepWithinMemory();
  void HaltForMemory(Mind& mind);
  /// Ends its program and reports the reason.
  void Halt(Mind& mind, RunEvent reason);
  /// Removes it from the kernel and sets `gone`.
  void End(Mind& mind);
  void TellMemory(Mind& mind);
  void TellLearned(Mind& mind);
  void TellGap(Mind& mind, const world::Agent& body);
  void TellIdle(Mind& mind, const world::Agent& body);
  void TellHalt(Mind& mind, const world::Agent& body);
  void TellCause(Mind& mind, const world::Agent& body, std::string text);
  bool TellBreakdown(Mind& mind, const world::Agent& body);
  /// Halts a mind whose rules fired more than kMostFirings times in this tick. Returns true if they did.
  bool HaltForWork(Mind& mind);
  void TellWritten(Mind& mind, const world::Agent& body);
  /// Reports the rules whose actions failed, each once.
  void TellFailures(Mind& mind, const world::Agent& body);
  /// Attributes that reach the mind from outside the vocabulary: from scripts and messages of others.
  std::set<std::string> KnownAttributes();
  std::vector<explain::FailedRule> FailedIn(const std::filesystem::path& rules) const;
  void Tell(EventKind kind, const world::Agent& body, std::string text);
  /// The other files in folders of rules, as they are now. Minds of one world share folders.
  using Neighbours = std::map<std::filesystem::path, explain::Surroundings>;
  std::vector<Diagnostic> FindSlips(Mind& mind, const std::set<std::string>& rules, Neighbours& beside);

  world::World& world_;
  const Scenario& scenario_;
  SoarHost& host_;
  Arena& arena_;
  Report report_;
  SenseScript sense_script_;
  SenseSandbox sense_sandbox_;
  MindDetail detail_ = MindDetail::kNone;
  bool records_origins_ = true;
  std::vector<BodyKind> body_kinds_;
  std::vector<Mind> minds_;                 ///< In the order of creation, which may differ from the order of agent ids.
  std::vector<std::uint32_t> place_by_id_;  ///< Index in minds_ plus 1; 0 for agents without a mind.
  std::vector<std::size_t> ready_;          ///< Temporary: indices of the minds that decide in this tick.
  const std::function<void(std::size_t)> decide_beside_scripts_ = [this](std::size_t thread) {
    DecideBesideScripts(thread);
  };
  const std::function<void(std::size_t)> tell_scripts_ = [this](std::size_t thread) { TellScripts(thread); };
  std::vector<std::atomic<std::size_t>> decided_;  ///< By thread: number of minds that have decided in parallel to
                                                   ///< scripts.
  std::vector<std::size_t> places_;                ///< Temporary, by thread.
  WorkerPool pool_;
  int asked_ = 0;  ///< Number of times that a mind was asked why it is idle.
  /// The threads that the world's thread can use while no mind decides.
  world::Workers AllThreads();
  std::size_t MemoryLeft() const {
    return memory_limit_ - std::min(memory_limit_, memory_bytes_ + scripts_bytes_ + bodies_bytes_);
  }
  std::size_t memory_limit_ = script::WorldLimits{}.memory_bytes;
  std::size_t scripts_bytes_ = 0, bodies_bytes_ = 0;
  std::size_t memory_bytes_ = 0;                                          ///< Total of all minds, as last measured.
  std::map<std::filesystem::path, std::set<std::string>> made_by_rules_;  ///< By file: attributes that its rules make.
  std::set<std::string> script_rows_;             ///< Attributes that Agent_Sense of scripts returned.
  std::set<std::string> reported_;                ///< Problems that were already reported. Many agents share one file.
  std::map<std::string, std::size_t> by_client_;  ///< Index in minds_, by the client's name of the agent.
  bool has_new_rules_ = false;                    ///< Minds were created whose rules have not been checked for slips.
  std::set<std::filesystem::path> looked_over_;   ///< Files of rules that were checked for slips.
  /// Files with rules that did not load, with the errors.
  std::map<std::filesystem::path, std::vector<explain::FailedRule>> failed_;
};

/// Conversion of a script's table to percepts, and of parameters to a script's table.
vocabulary::PerceptList ToPercepts(const script::Table& table);
script::Table ToTable(const vocabulary::PerceptList& list);

}  // namespace soarbox::sim
