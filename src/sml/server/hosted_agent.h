// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cli/fence.h"
#include "cli/session.h"
#include "kernel/agent.h"
#include "kernel/longterm/origins.h"
#include "sml/server/agent_input.h"
#include "sml/server/connection.h"
#include "sml/server/event_set.h"

namespace soarbox::server {

class ClientLog;
class EventRelay;
class HostedAgent;
class XmlTracer;

/// The session of a hosted agent for the command language, with a reference back to the agent.
class HostedSession : public cli::Session {
 public:
  HostedSession(HostedAgent& hosted, kernel::Agent& agent, const std::string& name)
      : cli::Session(agent, name), hosted_(hosted) {}
  HostedAgent& hosted() { return hosted_; }

 private:
  HostedAgent& hosted_;
};

/// One agent of a kernel with the data for its clients: its command line session, its input by tags, the listeners,
/// texts that wait to be sent, and the result of its last run. Events without listeners are not generated and cost
/// nothing.
///
/// Owned by KernelHost. Used only by the thread that holds the kernel, except for RequestStop().
class HostedAgent {
 public:
  explicit HostedAgent(std::string name);
  ~HostedAgent();
  HostedAgent(const HostedAgent&) = delete;
  HostedAgent& operator=(const HostedAgent&) = delete;

  const std::string& name() const { return name_; }
  /// A number that is unique among all agents that the program ever creates.
  std::uint64_t number() const { return number_; }
  kernel::Agent& agent() { return agent_; }
  const kernel::Agent& agent() const { return agent_; }
  HostedSession& session() { return session_; }
  AgentInput& input() { return input_; }

  // Listening -------------------------------------------------------------------------------------------------------

  void Register(Connection& connection, int event);
  void Unregister(Connection& connection, int event);
  /// Removes a connection from all lists.
  void Forget(Connection& connection);
  bool Listens(int event) const { return listened_.Has(event); }
  /// A client listens to single phases.
  bool ListensToPhases() const { return phase_listeners_; }
  /// A client listens to steps of runs: phases, cycles, or each turn of the agent.
  bool ListensToSteps() const {
    return phase_listeners_ || listened_.HasAnyOf({::sml::smlEVENT_BEFORE_RUNNING, ::sml::smlEVENT_AFTER_RUNNING});
  }

  // Events ----------------------------------------------------------------------------------------------------------

  void FireRun(int event, int phase) {
    if (listened_.Has(event)) TellRun(event, phase);
  }
  /// Fires the event of one phase and the general one for every phase; the one that was registered last goes first.
  void FirePhase(int specific, int general, int phase);
  void FireProduction(int event, std::string_view name);
  void FireOutput(std::span<const kernel::OutputChange> changes);
  void FireOutputInit();
  void FireXmlInput(std::span<const InputWme> wmes);
  void FireEcho(const Connection* from, const std::string& text);
  /// Sends the text printed since the last call. Called before any other event, except those within a phase and at its
  /// end.
  void FlushPrint() {
    if (!printed_.empty()) SendPrint();
  }
  /// Sends the structured trace since the last call.
  void FlushXmlTrace();
  /// Sends the output of an output phase if it changed.
  void DeliverOutput();

  /// Updates the structured trace after the trace settings may have changed. Called before runs and after command
  /// lines.
  void PrepareRun();

  // Running ---------------------------------------------------------------------------------------------------------

  /// Requests the end of the run. Callable from any thread.
  void RequestStop() { stop_.store(true, std::memory_order_release); }
  void ClearStop() { stop_.store(false, std::memory_order_release); }
  bool StopRequested() const { return stop_.load(std::memory_order_acquire); }

  ::sml::smlRunState run_state = ::sml::sml_RUNSTATE_STOPPED;
  ::sml::smlRunResult last_result = ::sml::sml_RUN_COMPLETED;  ///< Of the last completed run.
  bool in_run = false;                                         ///< It takes part in a run that has not ended yet.
  std::uint64_t last_run = 0;  ///< The last run in which it took part; 0: none since init-soar.
  bool doomed = false;         ///< Destroyed, but still in use (KernelHost::Stay).

  /// The restrictions for files that its client loads and for commands of its rules; null: those of the kernel apply.
  std::unique_ptr<const cli::Fence> fence;

  /// Records origins of elements, if enabled. Declared before the agent, which calls it until it is destroyed. Never
  /// null.
  std::unique_ptr<kernel::Origins> origins;

  /// The log of clients' acts, owned by the host; null if there is none.
  ClientLog* log = nullptr;

  /// The object for this agent in the program that contains the kernel.
  void* embedded_peer = nullptr;

 private:
  struct Listener {
    Connection* connection;
    EventSet events;
  };

  void UpdateListened();
  void SendPrint();
  void TellRun(int event, int phase);
  template <typename Call>
  void Tell(int event, Call call);

  std::string name_;
  std::uint64_t number_;
  kernel::Agent agent_;
  HostedSession session_;
  AgentInput input_;
  std::unique_ptr<EventRelay> relay_;
  std::unique_ptr<XmlTracer> tracer_;
  std::vector<Listener> listeners_;
  EventSet listened_;
  bool phase_listeners_ = false;
  std::array<std::uint32_t, ::sml::smlEVENT_LAST> registered_at_{};
  std::uint32_t registrations_ = 0;
  std::string printed_;
  std::string trace_pieces_;  ///< Parts of the structured trace while they are being sent.
  std::uint64_t output_generation_ = 0;
  std::atomic<bool> stop_{false};
};

}  // namespace soarbox::server
