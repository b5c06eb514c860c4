// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <mutex>

#include "sml/client/agent_data.h"
#include "sml/client/hold.h"
#include "sml/client/sml_ClientXML.h"

namespace sml {

namespace {

/// Adds a handler. Registers with the kernel for the first handler of an event.
template <typename Handler>
int AddHandler(AgentData& data, HandlerTable<Handler>& table, int event, Handler handler, void* user_data, bool to_back,
               bool flag, bool tell_kernel) {
  const Lock lock = Hold(data);
  AgentLink* link = data.Usable();
  if (!link) return 0;
  if (!handler) {
    data.SetError(kNullArgument, "The handler is NULL");
    return 0;
  }
  if (const int known = table.Find(event, handler, user_data)) return known;
  if (tell_kernel && table.Empty(event)) link->Register(event);
  const int id = ++data.next_callback;
  table.Add({event, id, handler, user_data, flag, false}, to_back);
  return id;
}

template <typename Handler>
bool RemoveHandler(AgentData& data, HandlerTable<Handler>& table, int id, bool tell_kernel) {
  const Lock lock = Hold(data);
  const int event = table.Remove(id);
  if (event == 0) {
    data.SetError(kCallbackNotFound, nullptr);
    return false;
  }
  if (tell_kernel && table.Empty(event) && data.link) data.link->Unregister(event);
  return true;
}

/// The only event of tables without events.
constexpr int kAnyEvent = 1;

}  // namespace

int Agent::RegisterForRunEvent(smlRunEventId id, RunEventHandler handler, void* pUserData, bool addToBack) {
  return AddHandler(*data_, data_->run_handlers, id, handler, pUserData, addToBack, false, true);
}
bool Agent::UnregisterForRunEvent(int callbackID) {
  return RemoveHandler(*data_, data_->run_handlers, callbackID, true);
}

int Agent::RegisterForProductionEvent(smlProductionEventId id, ProductionEventHandler handler, void* pUserData,
                                      bool addToBack) {
  return AddHandler(*data_, data_->production_handlers, id, handler, pUserData, addToBack, false, true);
}
bool Agent::UnregisterForProductionEvent(int callbackID) {
  return RemoveHandler(*data_, data_->production_handlers, callbackID, true);
}

int Agent::RegisterForPrintEvent(smlPrintEventId id, PrintEventHandler handler, void* pUserData, bool ignoreOwnEchos,
                                 bool addToBack) {
  return AddHandler(*data_, data_->print_handlers, id, handler, pUserData, addToBack, ignoreOwnEchos, true);
}
bool Agent::UnregisterForPrintEvent(int callbackID) {
  return RemoveHandler(*data_, data_->print_handlers, callbackID, true);
}

int Agent::RegisterForXMLEvent(smlXMLEventId id, XMLEventHandler handler, void* pUserData, bool addToBack) {
  return AddHandler(*data_, data_->xml_handlers, id, handler, pUserData, addToBack, false, true);
}
bool Agent::UnregisterForXMLEvent(int callbackID) {
  return RemoveHandler(*data_, data_->xml_handlers, callbackID, true);
}

int Agent::RegisterForOutputNotification(OutputNotificationHandler handler, void* pUserData, bool addToBack) {
  return AddHandler(*data_, data_->notification_handlers, kAnyEvent, handler, pUserData, addToBack, false, false);
}
bool Agent::UnregisterForOutputNotification(int callbackID) {
  return RemoveHandler(*data_, data_->notification_handlers, callbackID, false);
}

int Agent::AddOutputHandler(char const* pAttributeName, OutputEventHandler handler, void* pUserData, bool addToBack) {
  const Lock lock = Hold(*data_);
  if (!pAttributeName || !handler) {
    SetDetailedError(kNullArgument, "The attribute or the handler is NULL");
    return 0;
  }
  if (!data_->Usable()) return 0;
  data_->memory.EnableTracking(true);
  auto& handlers = data_->output_handlers;
  for (const AgentData::OutputHandler& known : handlers) {
    if (known.attribute == pAttributeName && known.handler == handler && known.data == pUserData) return known.id;
  }
  const int id = ++data_->next_callback;
  handlers.insert(addToBack ? handlers.end() : handlers.begin(), {id, pAttributeName, handler, pUserData});
  return id;
}

bool Agent::RemoveOutputHandler(int callbackID) {
  const Lock lock = Hold(*data_);
  if (std::erase_if(data_->output_handlers, [&](const auto& handler) { return handler.id == callbackID; }) > 0)
    return true;
  SetError(kCallbackNotFound);
  return false;
}

void AgentData::OnRun(int event, int phase) {
  run_handlers.ForEach(event, [&](const auto& entry) {
    entry.handler(static_cast<smlRunEventId>(event), entry.data, &agent, static_cast<smlPhase>(phase));
  });
}

void AgentData::OnProduction(int event, std::string_view production) {
  const std::string text(production);
  production_handlers.ForEach(event, [&](const auto& entry) {
    entry.handler(static_cast<smlProductionEventId>(event), entry.data, &agent, text.c_str(), nullptr);
  });
}

void AgentData::OnPrint(int event, const std::string& text, bool self) {
  print_handlers.ForEach(event, [&](const auto& entry) {
    if (self && entry.flag) return;
    entry.handler(static_cast<smlPrintEventId>(event), entry.data, &agent, text.c_str());
  });
}

void AgentData::OnXml(int event, const std::shared_ptr<const soarbox::wire::Element>& element) {
  xml_handlers.ForEach(event, [&](const auto& entry) {
    ClientXML xml{soarxml::ElementXML(element)};
    entry.handler(static_cast<smlXMLEventId>(event), entry.data, &agent, &xml);
  });
}

void AgentData::OnOutputReceived(bool complete) {
  if (!complete) SetError(kOutputError, nullptr);
  if (!memory.tracking()) return;
  if (notification_handlers.empty() && output_handlers.empty()) return;
  notification_handlers.ForEach(kAnyEvent, [&](const auto& entry) { entry.handler(entry.data, &agent); });
  if (output_handlers.empty() || !memory.OutputLink()) return;
  // Handlers may register others and change both lists, so the lists are read again each time.
  OutputDeltaList& changes = memory.changes();
  IdentifierSymbol* root = memory.OutputLink()->GetSymbol();
  for (int i = 0; i < changes.GetSize(); ++i) {
    WMDelta* delta = changes.GetDeltaWME(i);
    WMElement* wme = delta->getWME();
    if (delta->getChangeType() != WMDelta::kAdded || wme->GetParent() != root) continue;
    for (std::size_t h = 0; h < output_handlers.size(); ++h) {
      const OutputHandler handler = output_handlers[h];
      if (handler.attribute == wme->GetAttribute()) handler.handler(handler.data, &agent, wme->GetAttribute(), wme);
    }
  }
}

void AgentData::RefreshInput() {
  memory.Refresh();
  if (write_direct_input && Usable() != nullptr) write_direct_input();
}

}  // namespace sml
