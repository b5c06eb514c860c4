// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/fence.h"
#include "cli/host.h"
#include "cli/interpreter.h"
#include "cli/result_node.h"
#include "sml/server/client_log.h"
#include "sml/server/client_player.h"
#include "sml/server/connection.h"
#include "sml/server/hosted_agent.h"
#include "sml/server/run_scheduler.h"

namespace soarbox::server {

/// A kernel: its agents, the command language, the clients, and the runs.
///
/// Everything except StopAll() and the pump's flag may be used only by the thread that holds mutex(). Clients lock it
/// for each call. Handlers of clients run while it is held, on the same thread, and may call any function.
class KernelHost : public cli::Host {
 public:
  KernelHost();
  ~KernelHost() override;

  std::recursive_mutex& mutex() { return mutex_; }

  /// While a Stay exists, destroyed agents are not deleted, because the caller, or a caller of the caller, is using
  /// them. Handlers may destroy any agent at any time, so all code that calls handlers must hold a Stay.
  class Stay {
   public:
    explicit Stay(KernelHost& host) : host_(host) { ++host_.stays_; }
    ~Stay() {
      if (--host_.stays_ == 0 && !host_.doomed_.empty()) host_.BuryDoomed();
    }
    Stay(const Stay&) = delete;
    Stay& operator=(const Stay&) = delete;

   private:
    KernelHost& host_;
  };

  // Agents ----------------------------------------------------------------------------------------------------------

  /// Returns null if the name is in use. Sources settings.soar, if it exists.
  HostedAgent* CreateAgent(const std::string& name);
  /// The log of clients' acts (KeepLog); null if there is none.
  std::unique_ptr<ClientLog> log;
  /// Replays such a log; null if none was replayed.
  std::unique_ptr<ClientPlayer> player;
  /// Reports a new agent to the clients.
  void AnnounceAgent(HostedAgent& hosted) { FireAgent(hosted, ::sml::smlEVENT_AFTER_AGENT_CREATED); }
  void DestroyAgent(HostedAgent& hosted);
  void DestroyAllAgents();
  HostedAgent* Find(std::string_view name);
  /// Sorted by name.
  const std::vector<HostedAgent*>& agents() const { return order_; }

  // Command lines ---------------------------------------------------------------------------------------------------

  struct LineOptions {
    bool echo = false;
    bool filter = true;
    const Connection* from = nullptr;
    bool fenced = false;    ///< The line loads an untrusted file, or a rule gave it.
    bool recorded = false;  ///< The line comes from a recording.
  };
  /// Restricts the commands in fenced files, and the commands of rules, to these folders from now on. With
  /// `rules_only`, files are only checked: of their commands, only rules take effect.
  void SetFence(std::vector<std::filesystem::path> folders, bool rules_only);

  /// If `hosted` is null, the line is for the agent that was addressed last.
  cli::CommandResult Execute(HostedAgent* hosted, std::string_view line, const LineOptions& options);
  cli::Interpreter& interpreter() { return interpreter_; }
  /// A filter is registered: every command line must be executed by Execute.
  bool HasFilters() const { return !functions_.empty() && SearchFilters(); }

  // Runs ------------------------------------------------------------------------------------------------------------

  kernel::RunResult RunAgents(HostedAgent& addressed, const cli::RunRequest& request, bool interleave_given);
  /// `as_told`: returns false until clients have been informed that the run begins, as in Soar.
  bool running(bool as_told = false) const { return as_told ? run_.tells_running() : run_.running(); }
  /// Returns true if the agent took part in the last run.
  bool OnRunList(const HostedAgent& hosted) const { return hosted.last_run != 0 && hosted.last_run == run_.number(); }
  /// Asks all agents to stop. Callable from any thread.
  void StopAll() { stop_requests_.fetch_add(1, std::memory_order_acq_rel); }
  /// Number of stop requests; a run ends when it changes.
  std::uint64_t stop_requests() const { return stop_requests_.load(std::memory_order_acquire); }
  void SetInterruptCheckRate(int rate) { run_.SetInterruptCheckRate(rate); }
  void Initialize(HostedAgent& hosted);

  kernel::RunResult Run(cli::Session& session, const cli::RunRequest& request) override;
  void Stop(cli::Session& session, bool self_only) override;
  void Reinitialize(cli::Session& session) override;
  bool IsRunning(cli::Session& session) const override;
  int Port() const override { return port_; }
  void SetPort(int port) { port_ = port; }

  // Clients ---------------------------------------------------------------------------------------------------------

  void AddConnection(Connection& connection);
  /// Removes all registrations and functions of a client, and its range of time tags.
  void RemoveConnection(Connection& connection);
  const std::vector<Connection*>& connections() const { return connections_; }
  /// The first time tag of the client. Clients have ranges of 2^27 tags, the first of which is reserved for the program
  /// that contains the kernel. 0 if all eight ranges are in use.
  long long AssignTimeTags(Connection& connection);

  void Register(Connection& connection, HostedAgent* hosted, int event);
  void Unregister(Connection& connection, HostedAgent* hosted, int event);
  /// RHS functions, client messages and filters, by name.
  void RegisterFunction(Connection& connection, int event, const std::string& name);
  void UnregisterFunction(Connection& connection, int event, const std::string& name);

  void FireSystem(int event) {
    if (listened_.Has(event)) TellSystem(event);
  }
  void FireUpdate(int event, int run_flags);
  void FireAgent(HostedAgent& hosted, int event);
  /// Returns the answer of the first client that gives one.
  std::optional<std::string> CallFunction(HostedAgent* hosted, int event, std::string_view name,
                                          std::string_view argument);
  bool system_stop_suppressed() const { return system_stop_suppressed_; }
  void SuppressSystemStop(bool on) { system_stop_suppressed_ = on; }

  /// Sets the function that serves requests of remote clients; it is called between the steps of runs.
  void SetPump(std::function<void()> pump) { pump_ = std::move(pump); }
  /// The pump has work. Callable from any thread.
  void RequestPump() { pump_requested_.store(true, std::memory_order_release); }
  bool PumpRequested() const {
    return pump_requested_.load(std::memory_order_acquire) && !held_.load(std::memory_order_relaxed);
  }
  /// While on, runs do not serve requests of remote clients; they wait until the end of the run.
  void HoldPump(bool on) { held_.store(on, std::memory_order_relaxed); }
  /// `listener` receives each command line of a remote client, with the agent's name, before it is executed.
  void Overhear(std::function<void(char const*, char const*)> listener) { overhear_ = std::move(listener); }
  /// A listener records what remote clients do, and it supports only command lines.
  bool IsOverheard() const { return static_cast<bool>(overhear_); }
  void Pump() {
    if (PumpRequested()) ServePump();
  }
  /// A client listens to the rounds of runs.
  bool ListensToRounds() const {
    using namespace ::sml;
    return listened_.HasAnyOf({smlEVENT_INTERRUPT_CHECK, smlEVENT_BEFORE_AGENTS_RUN_STEP,
                               smlEVENT_AFTER_ALL_OUTPUT_PHASES, smlEVENT_AFTER_ALL_GENERATED_OUTPUT});
  }

 private:
  friend Result<void> KeepLog(KernelHost& host, const std::string& file, std::string_view build);
  struct Function {
    int event;
    std::string name;
    Connection* connection;
  };

  void ServePump();
  void TellSystem(int event);
  void FlushPrints();
  void BuryDoomed();
  bool SearchFilters() const;
  HostedAgent* Addressed(HostedAgent* hosted);
  void SourceSettings(HostedAgent& hosted);
  void InstallFunctions(HostedAgent& hosted);
  cli::CommandResult ExecuteUnfiltered(HostedAgent& hosted, std::string_view line, const LineOptions& options);
  std::optional<cli::CommandResult> PassFilters(HostedAgent& hosted, std::string& line);

  std::recursive_mutex mutex_;
  RunControl run_;
  cli::Interpreter interpreter_;
  std::map<std::string, std::unique_ptr<HostedAgent>, std::less<>> by_name_;
  std::vector<HostedAgent*> order_;
  std::vector<std::unique_ptr<HostedAgent>> doomed_;  ///< Destroyed while a Stay existed.
  int stays_ = 0;
  std::unique_ptr<HostedAgent> nobody_;  ///< Executes command lines while there is no agent.
  HostedAgent* last_addressed_ = nullptr;
  std::vector<Connection*> connections_;
  std::vector<Function> functions_;
  EventSet listened_;
  bool system_stop_suppressed_ = false;
  int port_ = 0;
  std::function<void()> pump_;
  std::atomic<bool> pump_requested_{false};
  std::atomic<bool> held_{false};
  const cli::Fence* FenceOf(const HostedAgent& hosted, const LineOptions& options) const;
  std::unique_ptr<const cli::Fence> fence_;  ///< Null: none.
  /// Lines of a recording are always restricted.
  std::unique_ptr<const cli::Fence> recorded_fence_ =
      std::make_unique<const cli::Fence>(std::vector<std::filesystem::path>(), cli::Fence::Source::kRecording);
  std::function<void(char const*, char const*)> overhear_;
  std::atomic<std::uint64_t> stop_requests_{0};
};

/// Logs everything that clients of the kernel do from now on, as a recording. `build` identifies this program. Fails if
/// agents exist already, if there is a log already, or if the file cannot be written.
Result<void> KeepLog(KernelHost& host, const std::string& file, std::string_view build);

}  // namespace soarbox::server
