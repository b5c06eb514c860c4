// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <cstdio>
#include <mutex>

#include "sml/client/agent_data.h"
#include "sml/client/hold.h"
#include "sml/client/kernel_data.h"

namespace sml {

namespace {

/// Returns true for events that the library itself listens to.
bool IsOwnEvent(int event) {
  return event == smlEVENT_BEFORE_AGENT_DESTROYED || event == smlEVENT_AFTER_AGENT_REINITIALIZED;
}

}  // namespace

// The four kinds of kernel events differ only in the type of their handlers.
#define SOARBOX_SML_KERNEL_EVENTS(Family, IdType, HandlerType, table)                                       \
  int Kernel::RegisterFor##Family##Event(IdType id, HandlerType handler, void* pUserData, bool addToBack) { \
    const Lock lock = Hold(*data_);                                                                         \
    KernelLink* link = data_->Usable();                                                                     \
    if (!link) return 0;                                                                                    \
    if (!handler) {                                                                                         \
      SetDetailedError(kNullArgument, "The handler is NULL");                                               \
      return 0;                                                                                             \
    }                                                                                                       \
    if (const int known = data_->table.Find(id, handler, pUserData)) return known;                          \
    if (data_->table.Empty(id) && !(IsOwnEvent(id) && !link->remote())) link->Register(id);                 \
    const int callback = ++data_->next_callback;                                                            \
    data_->table.Add({id, callback, handler, pUserData, false, false}, addToBack);                          \
    return callback;                                                                                        \
  }                                                                                                         \
  bool Kernel::UnregisterFor##Family##Event(int callbackID) {                                               \
    const Lock lock = Hold(*data_);                                                                         \
    const int event = data_->table.Remove(callbackID);                                                      \
    if (event == 0) {                                                                                       \
      SetError(kCallbackNotFound);                                                                          \
      return false;                                                                                         \
    }                                                                                                       \
    if (data_->table.Empty(event) && !IsOwnEvent(event) && data_->link) data_->link->Unregister(event);     \
    return true;                                                                                            \
  }

SOARBOX_SML_KERNEL_EVENTS(System, smlSystemEventId, SystemEventHandler, system_handlers)
SOARBOX_SML_KERNEL_EVENTS(Update, smlUpdateEventId, UpdateEventHandler, update_handlers)
SOARBOX_SML_KERNEL_EVENTS(String, smlStringEventId, StringEventHandler, string_handlers)
SOARBOX_SML_KERNEL_EVENTS(Agent, smlAgentEventId, AgentEventHandler, agent_handlers)
#undef SOARBOX_SML_KERNEL_EVENTS

// Functions and messages ----------------------------------------------------------------------------------------------

namespace {

int AddFunction(Kernel& kernel, KernelData& data, KernelData::Function function, bool to_back) {
  const Lock lock = Hold(data);
  KernelLink* link = data.Usable();
  static_cast<void>(kernel);
  if (!link || function.name.empty() || !function.handler) return 0;
  bool first = true;
  for (const KernelData::Function& known : data.functions) {
    if (known.event != function.event || known.name != function.name) continue;
    if (function.pointer && known.pointer == function.pointer && known.data == function.data) return known.id;
    first = false;
  }
  if (!first && function.event == smlEVENT_RHS_USER_FUNCTION) {
    std::fprintf(stderr, "sml: the function %s has a handler already; only the first one is called\n",
                 function.name.c_str());
  }
  if (first) link->RegisterFunction(function.event, function.name);
  function.id = ++data.next_callback;
  const int id = function.id;
  data.functions.insert(to_back ? data.functions.end() : data.functions.begin(), std::move(function));
  return id;
}

bool RemoveFunction(KernelData& data, int id) {
  const Lock lock = Hold(data);
  const auto found = std::find_if(data.functions.begin(), data.functions.end(),
                                  [&](const KernelData::Function& function) { return function.id == id; });
  if (found == data.functions.end()) return false;
  const int event = found->event;
  const std::string name = found->name;
  data.functions.erase(found);
  const bool others = std::any_of(
      data.functions.begin(), data.functions.end(),
      [&](const KernelData::Function& function) { return function.event == event && function.name == name; });
  if (!others && data.link) data.link->UnregisterFunction(event, name);
  return true;
}

KernelData::Function MakeFunction(int event, char const* name, RhsEventHandler handler, void* user_data) {
  KernelData::Function function;
  function.event = event;
  function.name = name ? name : "";
  function.pointer = handler;
  function.data = user_data;
  if (handler) {
    function.handler = [handler, user_data](smlRhsEventId id, Agent* agent, char const* called, char const* argument) {
      return handler(id, user_data, agent, called, argument);
    };
  }
  return function;
}

KernelData::Function MakeFunction(int event, char const* name, RhsEventHandlerCpp handler) {
  KernelData::Function function;
  function.event = event;
  function.name = name ? name : "";
  function.handler = std::move(handler);
  return function;
}

}  // namespace

int Kernel::AddRhsFunction(char const* pRhsFunctionName, RhsEventHandler handler, void* pUserData, bool addToBack) {
  return AddFunction(*this, *data_, MakeFunction(smlEVENT_RHS_USER_FUNCTION, pRhsFunctionName, handler, pUserData),
                     addToBack);
}

int Kernel::AddRhsFunction(char const* pRhsFunctionName, RhsEventHandlerCpp handler, bool addToBack) {
  return AddFunction(*this, *data_, MakeFunction(smlEVENT_RHS_USER_FUNCTION, pRhsFunctionName, std::move(handler)),
                     addToBack);
}

bool Kernel::RemoveRhsFunction(int callbackID) {
  if (RemoveFunction(*data_, callbackID)) return true;
  SetError(kCallbackNotFound);
  return false;
}

int Kernel::RegisterForClientMessageEvent(char const* pClientName, ClientMessageHandler handler, void* pUserData,
                                          bool addToBack) {
  return AddFunction(*this, *data_, MakeFunction(smlEVENT_CLIENT_MESSAGE, pClientName, handler, pUserData), addToBack);
}

int Kernel::RegisterForClientMessageEvent(char const* pClientName, ClientMessageHandlerCpp handler, bool addToBack) {
  return AddFunction(*this, *data_, MakeFunction(smlEVENT_CLIENT_MESSAGE, pClientName, std::move(handler)), addToBack);
}

bool Kernel::UnregisterForClientMessageEvent(int callbackID) {
  if (RemoveFunction(*data_, callbackID)) return true;
  SetError(kCallbackNotFound);
  return false;
}

std::string Kernel::SendClientMessage(Agent* pAgent, char const* pClientName, char const* pMessage) {
  const Lock lock = Hold(*data_);
  KernelLink* link = data_->Usable();
  if (!link || !pClientName || !pMessage) return {};
  return link->SendClientMessage(pAgent, pClientName, pMessage).value_or("**NOBODY RESPONDED**");
}

// Events of the kernel ------------------------------------------------------------------------------------------------

void KernelData::OnSystem(int event) {
  system_handlers.ForEach(
      event, [&](const auto& entry) { entry.handler(static_cast<smlSystemEventId>(event), entry.data, &kernel); });
}

void KernelData::OnUpdate(int event, int flags) {
  update_handlers.ForEach(event, [&](const auto& entry) {
    entry.handler(static_cast<smlUpdateEventId>(event), entry.data, &kernel, static_cast<smlRunFlags>(flags));
  });
}

void KernelData::OnAgent(const std::string& name, int event) {
  Agent* agent = nullptr;
  if (event == smlEVENT_AFTER_AGENT_CREATED) {
    agent = Adopt(name);
  } else {
    const auto found = agents.find(name);
    if (found != agents.end()) agent = found->second.get();
  }
  if (!agent) return;
  if (event == smlEVENT_AFTER_AGENT_REINITIALIZED) agent->data_->RefreshInput();
  agent_handlers.ForEach(
      event, [&](const auto& entry) { entry.handler(static_cast<smlAgentEventId>(event), entry.data, agent); });
  if (event == smlEVENT_BEFORE_AGENT_DESTROYED) Bury(name);
}

std::optional<std::string> KernelData::OnString(int event, std::string_view value) {
  const std::string text(value);
  std::optional<std::string> answer;
  string_handlers.ForEach(event, [&](const auto& entry) {
    if (!answer) answer = entry.handler(static_cast<smlStringEventId>(event), entry.data, &kernel, text.c_str());
  });
  return answer;
}

std::optional<std::string> KernelData::OnFunction(Agent* agent, int event, std::string_view name,
                                                  std::string_view argument) {
  for (const Function& function : functions) {
    // A filter may be registered as a client message with the name of filters.
    if (function.name != name || (function.event != event && event != smlEVENT_FILTER)) continue;
    const RhsEventHandlerCpp handler = function.handler;
    const std::string called(name);
    const std::string text(argument);
    return handler(static_cast<smlRhsEventId>(event), agent, called.c_str(), text.c_str());
  }
  return std::nullopt;
}

}  // namespace sml
