// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "kernel/io/output_link.h"
#include "sml/server/event_set.h"
#include "sml/wire/input_wme.h"

namespace soarbox::server {

class HostedAgent;

/// The data that a client reports about itself.
struct ConnectionInfo {
  std::string id;
  std::string name = "unknown";
  std::string status = "created";
  std::string agent_status;
};

/// A kernel's identifier ("F12") as a number for maps; never 0.
inline long long IdentifierKey(char letter, unsigned long long number) {
  return (static_cast<long long>(letter) << 56) | static_cast<long long>(number);
}

/// The name for such a number; empty for 0.
inline std::string IdentifierName(long long key) {
  if (key == 0) return {};
  return static_cast<char>(key >> 56) + std::to_string(key & ((1LL << 56) - 1));
}

using wire::InputWme;

/// A client of a kernel: the program that contains the kernel, or one connected by a socket. The kernel calls the
/// functions for events that the client registered for, always on the thread that holds the kernel.
class Connection {
 public:
  virtual ~Connection() = default;

  ConnectionInfo info;
  EventSet kernel_events;          ///< Registered events that belong to no agent.
  long long initial_time_tag = 0;  ///< 0: it has not requested one.
  bool takes_part = false;         ///< It receives output or creates input, so it does not only watch.

  virtual bool embedded() const = 0;

  virtual void OnSystemEvent(int event) = 0;
  virtual void OnUpdateEvent(int event, int run_flags) = 0;
  virtual void OnAgentEvent(HostedAgent& agent, int event) = 0;
  virtual void OnRunEvent(HostedAgent& agent, int event, int phase) = 0;
  virtual void OnProductionEvent(HostedAgent& agent, int event, std::string_view name) = 0;
  virtual void OnPrint(HostedAgent& agent, const std::string& text) = 0;
  /// `self`: the echo is of this client's own command line.
  virtual void OnEcho(HostedAgent& agent, const std::string& text, bool self) = 0;
  /// `pieces` are the children of <trace> in the form of a document.
  virtual void OnXmlTrace(HostedAgent& agent, std::string_view pieces) = 0;
  virtual void OnXmlInput(HostedAgent& agent, std::span<const InputWme> wmes) = 0;
  virtual void OnOutput(HostedAgent& agent, std::span<const kernel::OutputChange> changes) = 0;
  virtual void OnOutputInit(HostedAgent& agent) = 0;
  /// Returns the client's answer; none if it does not answer.
  virtual std::optional<std::string> OnFunction(HostedAgent* agent, int event, std::string_view name,
                                                std::string_view argument) = 0;
};

}  // namespace soarbox::server
