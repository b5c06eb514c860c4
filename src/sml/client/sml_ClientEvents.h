// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <string>

#include "Export.h"
#include "sml_Events.h"

/// The types of event handlers. Handlers run on the thread that is inside a call of the library; between calls, on the
/// kernel's own thread. They may call any function and may unregister themselves.
namespace sml {

class Agent;
class Kernel;
class WMElement;
class ClientXML;

typedef void (*RunEventHandler)(smlRunEventId id, void* pUserData, Agent* pAgent, smlPhase phase);
typedef void (*AgentEventHandler)(smlAgentEventId id, void* pUserData, Agent* pAgent);
typedef void (*PrintEventHandler)(smlPrintEventId id, void* pUserData, Agent* pAgent, char const* pMessage);
/// pInstantiation is always NULL.
typedef void (*ProductionEventHandler)(smlProductionEventId id, void* pUserData, Agent* pAgent, char const* pProdName,
                                       char const* pInstantiation);
typedef void (*SystemEventHandler)(smlSystemEventId id, void* pUserData, Kernel* pKernel);
typedef void (*OutputEventHandler)(void* pUserData, Agent* pAgent, char const* pCommandName, WMElement* pOutputWme);
typedef void (*OutputNotificationHandler)(void* pUserData, Agent* pAgent);
typedef void (*UpdateEventHandler)(smlUpdateEventId id, void* pUserData, Kernel* pKernel, smlRunFlags runFlags);
typedef std::string (*StringEventHandler)(smlStringEventId id, void* pUserData, Kernel* pKernel, char const* pString);
/// pXML belongs to the library and is valid until the handler returns.
typedef void (*XMLEventHandler)(smlXMLEventId id, void* pUserData, Agent* pAgent, ClientXML* pXML);
typedef std::string (*RhsEventHandler)(smlRhsEventId id, void* pUserData, Agent* pAgent, char const* pFunctionName,
                                       char const* pArgument);
typedef std::function<std::string(smlRhsEventId id, Agent* pAgent, char const* pFunctionName, char const* pArgument)>
    RhsEventHandlerCpp;
typedef std::string (*ClientMessageHandler)(smlRhsEventId id, void* pUserData, Agent* pAgent, char const* pClientName,
                                            char const* pMessage);
typedef std::function<std::string(smlRhsEventId id, Agent* pAgent, char const* pClientName, char const* pMessage)>
    ClientMessageHandlerCpp;

/// The data of a registered handler, which language bindings read.
class EXPORT EventHandlerPlusData {
 public:
  EventHandlerPlusData() = default;
  EventHandlerPlusData(int eventID, void* userData, int callbackID)
      : m_EventID(eventID), m_UserData(userData), m_CallbackID(callbackID) {}
  virtual ~EventHandlerPlusData() = default;
  int getEventID() const { return m_EventID; }
  void* getUserData() const { return m_UserData; }
  int getCallbackID() const { return m_CallbackID; }

  int m_EventID = 0;
  void* m_UserData = nullptr;
  int m_CallbackID = 0;
};

template <typename Handler>
class HandlerPlusUserData : public EventHandlerPlusData {
 public:
  HandlerPlusUserData() = default;
  HandlerPlusUserData(int eventID, Handler handler, void* userData, int callbackID)
      : EventHandlerPlusData(eventID, userData, callbackID), m_Handler(handler) {}

  Handler m_Handler{};
};

typedef HandlerPlusUserData<RunEventHandler> RunEventHandlerPlusData;
typedef HandlerPlusUserData<AgentEventHandler> AgentEventHandlerPlusData;
typedef HandlerPlusUserData<PrintEventHandler> PrintEventHandlerPlusData;
typedef HandlerPlusUserData<ProductionEventHandler> ProductionEventHandlerPlusData;
typedef HandlerPlusUserData<SystemEventHandler> SystemEventHandlerPlusData;
typedef HandlerPlusUserData<OutputEventHandler> OutputEventHandlerPlusData;
typedef HandlerPlusUserData<OutputNotificationHandler> OutputNotificationHandlerPlusData;
typedef HandlerPlusUserData<UpdateEventHandler> UpdateEventHandlerPlusData;
typedef HandlerPlusUserData<StringEventHandler> StringEventHandlerPlusData;
typedef HandlerPlusUserData<XMLEventHandler> XMLEventHandlerPlusData;
typedef HandlerPlusUserData<RhsEventHandlerCpp> RhsEventHandlerPlusData;

}  // namespace sml
