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

/// The Soar minds of a world: makes them when scripts or scenario files ask for agents that have one, and lets them
/// perceive and decide once per tick.
class Minds final : public script::MindFactory {
 public:
  /// Takes an event; the caller fills in time and tick.
  using Report = std::function<void(RunEvent)>;
  /// What the script of an agent perceives; nothing if it has none.
  using SenseScript = std::function<std::optional<script::Table>(world::EntityId)>;
  /// What the sandbox's script says that an agent perceives; nothing if it has no turn.
  using SenseSandbox = std::function<std::optional<script::PerceptGraph>(world::EntityId)>;

  Minds(world::World& world, const Scenario& scenario, SoarHost& host, Arena& arena, Report report);

  void SetSenseScript(SenseScript sense) { sense_script_ = std::move(sense); }
  void SetSenseSandbox(SenseSandbox sense) { sense_sandbox_ = std::move(sense); }
  /// How much is noted of what minds do, for minds made from now on.
  void SetDetail(MindDetail detail) { detail_ = detail; }
  /// What the world may use; if it uses more, the mind that uses most is halted.
  void SetMemoryLimit(std::size_t bytes) { memory_limit_ = bytes; }
  /// How much of that scripts and bodies use.
  void SetOtherMemory(std::size_t scripts_bytes, std::size_t bodies_bytes) {
    scripts_bytes_ = scripts_bytes;
    bodies_bytes_ = bodies_bytes;
  }
  std::size_t MemoryBytes() const override { return memory_bytes_; }
  /// Kinds of bodies that options may name.
  std::vector<BodyKind>& body_kinds() { return body_kinds_; }

  /// Loads the rules that the request names, or its kind's own: seekingagent.soar, followeragent.soar,
  /// waypointagent.soar. Reports faulty rules and loads the others. An agent without a script gets a body that the
  /// vocabulary drives; without rules it just stands there.
  Result<void> MakeMind(world::EntityId agent, const script::AgentCreationRequest& request) override;

  /// Every mind perceives and decides. Minds see the world as it is before any of them acts, so their order does not
  /// matter. Minds whose bodies a script drives have only begun when this returns: they go on beside the scripts.
  void Decide();
  struct Mind;
  /// Before a body acts: its mind has decided when this returns.
  void Await(Mind& mind);
  /// Before the bodies that no script drives act: they look ahead, on all threads.
  void LookAhead();
  /// Notes how a command of a scripted mind went, for Answer.
  /// `is_news`: it is reported even if all went well.
  void NoteAnswer(Mind& mind, Outcome outcome, bool is_news = false);
  /// After the bodies have acted: reports to the minds how their commands went. Scripted minds on other threads have
  /// heard it when EndAnswers returns; until then nothing else may ask a mind for anything. Returns the threads that
  /// are free until then: all or none.
  world::Workers Answer();
  void EndAnswers() { pool_.Join(); }

  /// Reports what is most likely a slip in rules that loaded, once per file of rules: when all agents of the set-up are
  /// there, as their rules and scripts decide which words are known.
  void TellSlips();
  /// The same for some rules of an agent, by name, as they run now: warnings with their places.
  std::vector<Diagnostic> SlipsOf(std::string_view agent, const std::set<std::string>& rules);

  /// Reports how often each cause came up that was reported only once.
  void TellCounts();
  /// Why an agent does what it does now; nothing if there is no such agent with a mind.
  /// `with_operators`: with the operators that are selected now, from the answers of commands.
  std::optional<explain::WhyNode> Why(std::string_view agent, bool with_operators = true);
  /// Why it gives or does not give a command, selects or does not select an operator, or a rule matches or does not. An
  /// error if there is no such agent, or its rules know nothing of that name.
  Result<std::vector<explain::WhyNode>> WhyTopic(std::string_view agent, const std::string& topic);

  /// Lines of the log of a client that drives Soar agents itself (sml/server/client_log.h). The next Decide plays them:
  /// it makes the agents that they name, which have bodies that do nothing.
  std::string client_acts;

  /// Makes all minds again in the host's kernel, with the rules that they had. Reports those that fail; they stay idle.
  void Restore();

  struct Mind {
    world::EntityId agent;
    MindSettings settings;
    bool follows_leader = false;  ///< Perceives its leader, else its target.
    bool is_scripted = true;      ///< A script carries out its commands.
    bool by_client = false;       ///< A client's log drives it; also by_sandbox, because its world is not ours.
    bool by_sandbox = false;      ///< The sandbox's own: it decides in the ticks in which that script says so.
    std::filesystem::path rules;
    SoarMind soar;
    std::size_t thread = 0;  ///< On which it decides.
    enum class Turn : unsigned char { kOver, kWaits, kHasDecided };
    Turn turn = Turn::kOver;  ///< Of a scripted mind, in this tick.
    std::size_t place = 0;    ///< Among those of its thread that decide beside the scripts in this tick.
    /// Commands that its script carries out over time.
    struct UnderWay {
      std::uint64_t tag = 0;
      std::string name;
    };
    std::vector<UnderWay> under_way = {};
    std::vector<Outcome> answers = {};  ///< For its script, not reported yet.
    float distance_squared_m2 = 0;
    bool decided = false;          ///< In this tick.
    bool lost = false;             ///< Its program has broken down, or could not be made again.
    bool gone = false;             ///< Its agent was destroyed: there is no program to ask.
    std::size_t memory_bytes = 0;  ///< When it was last measured.
    bool told_memory = false;      ///< That it takes much.
    bool told_learned = false;     ///< That it has learned many rules.
    bool in_gap = false;
    bool told_halt = false;
    int gaps = 0;                  ///< How often it was found doing nothing.
    std::uint64_t idle_ticks = 0;  ///< Ticks without a command, new or under way.
    std::string last_command = {};
    std::map<std::string, int> told = {};          ///< How often each of its faults came up; reported the first time.
    std::map<std::string, int> causes = {};        ///< How often each cause kept it from acting, likewise.
    std::string last_said = {}, last_answer = {};  ///< The last command with its parameters, and how it went.
    double last_said_s = 0;
    DecisionClock clock = {};                       ///< If what it does is noted (MindSettings::detail).
    double decide_s = 0;                            ///< Real time that the last tick's decisions took.
    std::shared_ptr<ClientPercepts> percepts = {};  ///< What its client has told it, if a client drives it.
    std::shared_ptr<ClientScene> scene = {};        ///< The picture that its client describes.
  };
  /// Null if the agent has no mind. Valid until the next MakeMind.
  Mind* Find(world::EntityId agent);
  /// By the name of its body; null if there is none.
  Mind* FindNamed(std::string_view agent);
  /// Ends the mind of an agent that was removed from the world. A mind that a client drives ends with its client.
  void EndRemoved(world::EntityId agent);
  std::span<Mind> all() { return minds_; }
  std::size_t size() const { return minds_.size(); }

 private:
  /// Lets a mind perceive what the sandbox's script says; false if it has no turn in this tick.
  bool PerceiveGraph(Mind& mind);
  Result<std::filesystem::path> FindRules(const std::string& agent, const AgentKind& kind, const std::string& named);
  Result<void> MakeBody(world::Agent& body, const AgentOptions& options);
  Result<SoarHost::Loaded> Load(const std::string& agent, const std::filesystem::path& rules,
                                const MindSettings& settings, bool is_scripted);
  void PlayClientActs();
  void PlayClientAct(const std::vector<std::string>& parts);
  void MakeClientMind(const std::string& name);
  /// An agent of a kernel elsewhere, which its own client lets run (`soarbox watch`): it is only looked into.
  void AttachMind(const std::string& name);
  /// Gives a mind that a client drives a body in the row of such bodies.
  void AddClientMind(const std::string& name, world::Agent& body, sml::Agent& agent, std::size_t thread);
  void EndClientMind(const std::string& name);
  /// After it has run: what it commands is reported.
  void ReportClientCommands(Mind& mind);
  /// A command line that loads a recorded file loads its copy.
  std::string WithCopies(Mind& mind, const std::string& line) const;
  void DecideNow(Mind& mind);
  /// Notes when the decisions of this tick were made, for Why.
  void NoteDecisions(Mind& mind);
  explain::DecisionTime TimeOf(const Mind& mind) const;
  /// The last command: how it went, and what made it.
  explain::WhyNode WhyCommand(Mind& mind, explain::MindReasons& reasons, bool is_dead, bool has_ended);
  /// Lets the scripted minds decide that have not decided yet; until Answer, the minds then stand still.
  void AwaitAll();
  void BeginBesideScripts();
  void DecideBesideScripts(std::size_t thread);
  void TellScripts(std::size_t thread);
  void TellOutcome(Mind& mind, const Outcome& outcome, bool is_news);
  /// Before it decides: false if it does not decide in this tick.
  bool Prepare(Mind& mind);
  /// After it has decided.
  void Conclude(Mind& mind);
  void Notice();
  bool PerceiveDistance(Mind& mind, const world::Agent& body);
  void PerceiveWorld(Mind& mind);
  void LimitMemory();
  void KeepWithinMemory();
  void HaltForMemory(Mind& mind);
  /// Ends its program and reports why.
  void Halt(Mind& mind, RunEvent reason);
  /// Removes it from the kernel; from then on it is gone.
  void End(Mind& mind);
  void TellMemory(Mind& mind);
  void TellLearned(Mind& mind);
  void TellGap(Mind& mind, const world::Agent& body);
  void TellIdle(Mind& mind, const world::Agent& body);
  void TellHalt(Mind& mind, const world::Agent& body);
  void TellCause(Mind& mind, const world::Agent& body, std::string text);
  bool TellBreakdown(Mind& mind, const world::Agent& body);
  /// Halts a mind whose rules fired more often in this tick than any world can wait for. True if they did.
  bool HaltForWork(Mind& mind);
  void TellWritten(Mind& mind, const world::Agent& body);
  /// Names the rules whose actions failed, each once.
  void TellFailures(Mind& mind, const world::Agent& body);
  /// Attributes that reach the mind from outside the vocabulary: from scripts and from others' messages.
  std::set<std::string> KnownAttributes();
  std::vector<explain::FailedRule> FailedIn(const std::filesystem::path& rules) const;
  void Tell(EventKind kind, const world::Agent& body, std::string text);
  /// What is beside the rules, by folder, as it is now: minds of one world share their folders.
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
  std::vector<BodyKind> body_kinds_;
  std::vector<Mind> minds_;                 ///< In creation order, thus in ascending agent id.
  std::vector<std::uint32_t> place_by_id_;  ///< In minds_, one more than that; 0 for agents without a mind.
  std::vector<std::size_t> ready_;          ///< Scratch: places of the minds that decide in this tick.
  const std::function<void(std::size_t)> decide_beside_scripts_ = [this](std::size_t thread) {
    DecideBesideScripts(thread);
  };
  const std::function<void(std::size_t)> tell_scripts_ = [this](std::size_t thread) { TellScripts(thread); };
  std::vector<std::atomic<std::size_t>> decided_;  ///< By thread: how many minds have decided beside the scripts.
  std::vector<std::size_t> places_;                ///< Scratch: by thread.
  WorkerPool pool_;
  int asked_ = 0;  ///< How often a mind was asked why it does nothing.
  /// What the world's thread may ask to do, while no mind decides.
  world::Workers AllThreads();
  std::size_t MemoryLeft() const {
    return memory_limit_ - std::min(memory_limit_, memory_bytes_ + scripts_bytes_ + bodies_bytes_);
  }
  std::size_t memory_limit_ = script::WorldLimits{}.memory_bytes;
  std::size_t scripts_bytes_ = 0, bodies_bytes_ = 0;
  std::size_t memory_bytes_ = 0;                                          ///< Of all minds, as last measured.
  std::map<std::filesystem::path, std::set<std::string>> made_by_rules_;  ///< Per file: attributes that its rules make.
  std::set<std::string> script_rows_;             ///< Attributes that scripts' Agent_Sense returned.
  std::set<std::string> reported_;                ///< Problems already reported: many agents share one file.
  std::map<std::string, std::size_t> by_client_;  ///< Minds by the names that their client gave them.
  bool has_new_rules_ = false;                    ///< Minds were made whose rules may still have slips to report.
  std::set<std::filesystem::path> looked_over_;   ///< Files of rules whose slips were reported.
  /// Files with rules that did not load, and why.
  std::map<std::filesystem::path, std::vector<explain::FailedRule>> failed_;
};

/// A script's table as percepts, and parameters as a script's table.
vocabulary::PerceptList ToPercepts(const script::Table& table);
script::Table ToTable(const vocabulary::PerceptList& list);

}  // namespace soarbox::sim
