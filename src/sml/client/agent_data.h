// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sml/client/client_memory.h"
#include "sml/client/handler_table.h"
#include "sml/client/kernel_data.h"
#include "sml/client/link.h"
#include "sml/client/sml_ClientAgent.h"
#include "sml/wire/element.h"

namespace sml {

/// The implementation of an Agent object.
struct AgentData {
  AgentData(Agent& owner, Kernel& owner_kernel, std::string agent_name);

  Agent& agent;
  Kernel& kernel;
  std::string name;
  std::unique_ptr<AgentLink> link;  ///< Null after the agent was destroyed.
  WorkingMemory memory;
  bool blink = true;
  int next_callback = 0;
  int debugger_process = 0;
  std::string converted;  ///< Result of ConvertIdentifier.
  std::string load_warnings;
  std::function<void()> write_direct_input;  ///< Writes the input of a DirectInput again; empty if there is none.

  HandlerTable<RunEventHandler> run_handlers;
  HandlerTable<ProductionEventHandler> production_handlers;
  HandlerTable<PrintEventHandler> print_handlers;  ///< The entry's flag: ignore own echoes.
  HandlerTable<XMLEventHandler> xml_handlers;
  HandlerTable<OutputNotificationHandler> notification_handlers;
  struct OutputHandler {
    int id = 0;
    std::string attribute;
    OutputEventHandler handler = nullptr;
    void* data = nullptr;
  };
  std::vector<OutputHandler> output_handlers;

  static AgentData& Of(Agent& owner) { return *owner.data_; }
  KernelData& kernel_data() { return KernelData::Of(kernel); }
  /// Returns null, and sets the agent's error, if the agent was destroyed.
  AgentLink* Usable();
  void SetError(ErrorCode code, char const* description) { agent.SetDetailedError(code, description); }
  void ClearError() { agent.ClearError(); }
  char const* Run(const RunSpec& spec);

  void OnRun(int event, int phase);
  void OnProduction(int event, std::string_view name);
  void OnPrint(int event, const std::string& text, bool self);
  void OnXml(int event, const std::shared_ptr<const soarbox::wire::Element>& element);
  /// Called when all changes of a message have been applied. `complete` is false if the parents of some changes are
  /// unknown.
  void OnOutputReceived(bool complete);
  /// Writes the entire input again, after init-soar.
  void RefreshInput();
};

}  // namespace sml
