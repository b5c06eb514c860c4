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

/// The command line's view of a hosted agent, with the way back.
class HostedSession : public cli::Session {
 public:
  HostedSession(HostedAgent& hosted, kernel::Agent& agent, const std::string& name)
      : cli::Session(agent, name), hosted_(hosted) {}
  HostedAgent& hosted() { return hosted_; }

 private:
  HostedAgent& hosted_;
};

/// One agent of a kernel, with what clients need of it: its command line session, its input by tags, who listens to
/// what, texts that wait to be sent, and how its last run ended. No subscriber, no cost: what nobody listens to is not
/// made.
///
/// Owned by KernelHost and touched only by the thread that holds the kernel, but for RequestStop().
class HostedAgent {
 public:
  explicit HostedAgent(std::string name);
  ~HostedAgent();
  HostedAgent(const HostedAgent&) = delete;
  HostedAgent& operator=(const HostedAgent&) = delete;

  const std::string& name() const { return name_; }
  /// Differs from that of every other agent of the program, those before it too.
  std::uint64_t number() const { return number_; }
  kernel::Agent& agent() { return agent_; }
  const kernel::Agent& agent() const { return agent_; }
  HostedSession& session() { return session_; }
  AgentInput& input() { return input_; }

  // Listening -------------------------------------------------------------------------------------------------------

  void Register(Connection& connection, int event);
  void Unregister(Connection& connection, int event);
  /// Takes a connection out of all lists.
  void Forget(Connection& connection);
  bool Listens(int event) const { return listened_.Has(event); }
  /// Somebody wants to hear of single phases.
  bool ListensToPhases() const { return phase_listeners_; }
  /// Somebody wants to hear of the steps of runs: phases, cycles, or each time that the agent gets its turn.
  bool ListensToSteps() const {
    return phase_listeners_ || listened_.HasAnyOf({::sml::smlEVENT_BEFORE_RUNNING, ::sml::smlEVENT_AFTER_RUNNING});
  }

  // Telling ---------------------------------------------------------------------------------------------------------

  void FireRun(int event, int phase) {
    if (listened_.Has(event)) TellRun(event, phase);
  }
  /// An event of one phase and the one for every phase: the one that was registered last comes first.
  void FirePhase(int specific, int general, int phase);
  void FireProduction(int event, std::string_view name);
  void FireOutput(std::span<const kernel::OutputChange> changes);
  void FireOutputInit();
  void FireXmlInput(std::span<const InputWme> wmes);
  void FireEcho(const Connection* from, const std::string& text);
  /// Sends the text that was printed since the last time: before any other event, but for those within a phase and at
  /// its end.
  void FlushPrint() {
    if (!printed_.empty()) SendPrint();
  }
  /// Sends the structured trace since the last time.
  void FlushXmlTrace();
  /// Delivers the output of an output phase, if it changed.
  void DeliverOutput();

  /// The trace settings may have changed: the structured trace follows. Before runs and after command lines.
  void PrepareRun();

  // Running ---------------------------------------------------------------------------------------------------------

  /// Asks for the end of the run, from any thread.
  void RequestStop() { stop_.store(true, std::memory_order_release); }
  void ClearStop() { stop_.store(false, std::memory_order_release); }
  bool StopRequested() const { return stop_.load(std::memory_order_acquire); }

  ::sml::smlRunState run_state = ::sml::sml_RUNSTATE_STOPPED;
  ::sml::smlRunResult last_result = ::sml::sml_RUN_COMPLETED;  ///< Of the last run that has ended.
  bool in_run = false;                                         ///< A run that it takes part in has not ended yet.
  std::uint64_t last_run = 0;  ///< The number of the last run that it took part in; 0 for none since init-soar.
  bool doomed = false;         ///< Destroyed, but still in use (KernelHost::Stay).

  /// What holds for the files that its client loads, and for what its rules carry out; null: what holds in the kernel.
  std::unique_ptr<const cli::Fence> fence;

  /// What made elements, if somebody asked to note it. Before the agent, which calls it until it ends. Never null.
  std::unique_ptr<kernel::Origins> origins;

  /// The log of what clients do; null: nobody keeps one. The host's.
  ClientLog* log = nullptr;

  /// The object that stands for this agent in the program that the kernel lives in.
  void* embedded_peer = nullptr;

  /// The decision counter that Soar reports: begins with 1, grows at the end of each output phase.
  std::uint64_t decision_count() const { return agent_.counters().decision_cycles + 1; }

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
  std::string trace_pieces_;  ///< Of the structured trace, while they are handed out.
  std::uint64_t output_generation_ = 0;
  std::atomic<bool> stop_{false};
};

}  // namespace soarbox::server
