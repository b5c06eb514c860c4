// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sml/client/handler_table.h"
#include "sml/client/link.h"
#include "sml/client/sml_ClientAgent.h"
#include "sml/client/sml_ClientKernel.h"

namespace sml {

/// The implementation of a Kernel object. Links call the On... functions to report events of the kernel.
struct KernelData {
  explicit KernelData(Kernel& owner) : kernel(owner) {}

  Kernel& kernel;
  std::unique_ptr<KernelLink> link;  ///< Null if the kernel could not be reached.
  bool direct = false;               ///< Created with `optimized`: runs return a fixed text.
  bool ignore_output = false;
  bool auto_commit = true;
  bool filtering = true;
  bool trace_communications = false;
  bool shut_down = false;
  bool last_line_ok = false;
  std::string buffer;  ///< The text of the last command line or run.
  int next_callback = 0;
  long long next_tag = 0;  ///< The last time tag that was used.
  long long next_name = 0;

  std::map<std::string, std::unique_ptr<Agent>> agents;
  std::list<std::unique_ptr<Agent>> graveyard;  ///< Destroyed agents, kept so that stale pointers answer with errors.
  std::vector<ConnectionInfo> connections;
  bool connections_changed = false;

  HandlerTable<SystemEventHandler> system_handlers;
  HandlerTable<UpdateEventHandler> update_handlers;
  HandlerTable<StringEventHandler> string_handlers;
  HandlerTable<AgentEventHandler> agent_handlers;
  struct Function {
    int event = 0;
    int id = 0;
    std::string name;
    RhsEventHandlerCpp handler;
    RhsEventHandler pointer = nullptr;
    void* data = nullptr;
  };
  std::vector<Function> functions;

  /// Returns null, and sets an error, if the kernel can no longer be used.
  KernelLink* Usable();
  Agent* Adopt(const std::string& name);
  void Bury(const std::string& name);
  char const* Answer(std::string text);
  static KernelData& Of(Kernel& owner) { return *owner.data_; }

  void OnSystem(int event);
  void OnUpdate(int event, int flags);
  void OnAgent(const std::string& name, int event);
  std::optional<std::string> OnString(int event, std::string_view value);
  std::optional<std::string> OnFunction(Agent* agent, int event, std::string_view name, std::string_view argument);
};

}  // namespace sml
