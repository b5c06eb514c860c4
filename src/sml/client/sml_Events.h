// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "Export.h"

/// The events of a kernel and its agents, and the numbers and names of phases, runs and stops. The values are used in
/// network messages and language bindings: they must never change.
namespace sml {

enum smlPhase {
  sml_INPUT_PHASE = 0,
  sml_PROPOSE_PHASE = 1,
  sml_DECIDE_PHASE = 2,
  sml_APPLY_PHASE = 3,
  sml_OUTPUT_PHASE = 4,
  sml_PREFERENCE_PHASE = 5,
  sml_WM_PHASE = 6,
};

enum smlRunStepSize {
  sml_PHASE = 0,
  sml_ELABORATION = 1,
  sml_DECIDE = 2,
  sml_DECISION = sml_DECIDE,
  sml_UNTIL_OUTPUT = 3,
};

enum smlRunFlags {
  sml_NONE = 0,
  sml_RUN_SELF = 1,
  sml_RUN_ALL = 2,
  sml_UPDATE_WORLD = 4,
  sml_DONT_UPDATE_WORLD = 8,
};

enum smlRunResult {
  sml_RUN_ERROR = 0,
  sml_RUN_EXECUTING = 1,
  sml_RUN_INTERRUPTED = 2,
  sml_RUN_COMPLETED = 3,
  sml_RUN_COMPLETED_AND_INTERRUPTED = 4,
  sml_RUN_ERROR_ALREADY_RUNNING = 5,
};

enum smlRunState {
  sml_RUNSTATE_STOPPED = 0,
  sml_RUNSTATE_INTERRUPTED = 1,
  sml_RUNSTATE_RUNNING = 2,
  sml_RUNSTATE_HALTED = 3,
};

enum smlStopLocationFlags {
  sml_STOP_AFTER_SMALLEST_STEP = 1,
  sml_STOP_AFTER_PHASE = 2,
  sml_STOP_AFTER_DECISION_CYCLE = 4,
};

enum smlGenericEventId {
  smlEVENT_INVALID_EVENT = 0,
  smlEVENT_LAST = 57,
};

enum smlSystemEventId {
  smlSYSTEM_EVENT_BAD = -1,
  smlEVENT_BEFORE_SHUTDOWN = 1,
  smlEVENT_AFTER_CONNECTION,
  smlEVENT_SYSTEM_START,
  smlEVENT_BEFORE_AGENTS_RUN_STEP,
  smlEVENT_SYSTEM_STOP,
  smlEVENT_INTERRUPT_CHECK,
  smlEVENT_SYSTEM_PROPERTY_CHANGED,
  smlEVENT_LAST_SYSTEM_EVENT = smlEVENT_SYSTEM_PROPERTY_CHANGED,
};

enum smlRunEventId {
  smlRUN_EVENT_BAD = -1,
  smlEVENT_BEFORE_SMALLEST_STEP = smlEVENT_LAST_SYSTEM_EVENT + 1,
  smlEVENT_AFTER_SMALLEST_STEP,
  smlEVENT_BEFORE_ELABORATION_CYCLE,
  smlEVENT_AFTER_ELABORATION_CYCLE,
  smlEVENT_BEFORE_PHASE_EXECUTED,
  smlEVENT_BEFORE_INPUT_PHASE,
  smlEVENT_BEFORE_PROPOSE_PHASE,
  smlEVENT_BEFORE_DECIDE_PHASE,
  smlEVENT_BEFORE_APPLY_PHASE,
  smlEVENT_BEFORE_OUTPUT_PHASE,
  smlEVENT_BEFORE_PREFERENCE_PHASE,
  smlEVENT_BEFORE_WM_PHASE,
  smlEVENT_AFTER_INPUT_PHASE,
  smlEVENT_AFTER_PROPOSE_PHASE,
  smlEVENT_AFTER_DECIDE_PHASE,
  smlEVENT_AFTER_APPLY_PHASE,
  smlEVENT_AFTER_OUTPUT_PHASE,
  smlEVENT_AFTER_PREFERENCE_PHASE,
  smlEVENT_AFTER_WM_PHASE,
  smlEVENT_AFTER_PHASE_EXECUTED,
  smlEVENT_BEFORE_DECISION_CYCLE,
  smlEVENT_AFTER_DECISION_CYCLE,
  smlEVENT_MAX_MEMORY_USAGE_EXCEEDED,
  smlEVENT_AFTER_INTERRUPT,
  smlEVENT_AFTER_HALTED,
  smlEVENT_BEFORE_RUN_STARTS,
  smlEVENT_AFTER_RUN_ENDS,
  smlEVENT_BEFORE_RUNNING,
  smlEVENT_AFTER_RUNNING,
  smlEVENT_LAST_RUN_EVENT = smlEVENT_AFTER_RUNNING,
};

enum smlProductionEventId {
  smlPRODUCTION_EVENT_BAD = -1,
  smlEVENT_AFTER_PRODUCTION_ADDED = smlEVENT_LAST_RUN_EVENT + 1,
  smlEVENT_BEFORE_PRODUCTION_REMOVED,
  smlEVENT_AFTER_PRODUCTION_FIRED,
  smlEVENT_BEFORE_PRODUCTION_RETRACTED,
  smlEVENT_LAST_PRODUCTION_EVENT = smlEVENT_BEFORE_PRODUCTION_RETRACTED,
};

enum smlAgentEventId {
  smlAGENT_EVENT_BAD = -1,
  smlEVENT_AFTER_AGENT_CREATED = smlEVENT_LAST_PRODUCTION_EVENT + 1,
  smlEVENT_BEFORE_AGENT_DESTROYED,
  smlEVENT_BEFORE_AGENT_REINITIALIZED,
  smlEVENT_AFTER_AGENT_REINITIALIZED,
  smlEVENT_LAST_AGENT_EVENT = smlEVENT_AFTER_AGENT_REINITIALIZED,
};

enum smlWorkingMemoryEventId {
  smlWORKING_MEMORY_EVENT_BAD = -1,
  smlEVENT_OUTPUT_PHASE_CALLBACK = smlEVENT_LAST_AGENT_EVENT + 1,
  smlEVENT_INPUT_PHASE_CALLBACK,
  smlEVENT_LAST_WM_EVENT = smlEVENT_OUTPUT_PHASE_CALLBACK,
};

enum smlPrintEventId {
  smlPRINT_EVENT_BAD = -1,
  smlEVENT_ECHO = smlEVENT_LAST_WM_EVENT + 1,
  smlEVENT_FIRST_PRINT_EVENT = smlEVENT_ECHO,
  smlEVENT_PRINT,
  smlEVENT_LAST_PRINT_EVENT = smlEVENT_PRINT,
};

enum smlRhsEventId {
  smlEVENT_RHS_USER_FUNCTION = smlEVENT_LAST_PRINT_EVENT + 1,
  smlEVENT_FILTER,
  smlEVENT_CLIENT_MESSAGE,
  smlEVENT_LAST_RHS_EVENT = smlEVENT_CLIENT_MESSAGE,
};

enum smlXMLEventId {
  smlXML_EVENT_BAD = -1,
  smlEVENT_XML_TRACE_OUTPUT = smlEVENT_LAST_RHS_EVENT + 1,
  smlEVENT_XML_INPUT_RECEIVED,
  smlEVENT_LAST_XML_EVENT = smlEVENT_XML_INPUT_RECEIVED,
};

enum smlUpdateEventId {
  smlUPDATE_EVENT_BAD = -1,
  smlEVENT_AFTER_ALL_OUTPUT_PHASES = smlEVENT_LAST_XML_EVENT + 1,
  smlEVENT_AFTER_ALL_GENERATED_OUTPUT,
  smlEVENT_LAST_UPDATE_EVENT = smlEVENT_AFTER_ALL_GENERATED_OUTPUT,
};

enum smlStringEventId {
  smlSTRING_EVENT_BAD = -1,
  smlEVENT_TCL_LIBRARY_MESSAGE = smlEVENT_LAST_UPDATE_EVENT + 1,
  smlEVENT_LOAD_LIBRARY,
  smlEVENT_LAST_STRING_EVENT = smlEVENT_LOAD_LIBRARY,
};

static_assert(smlEVENT_AFTER_RUNNING == 36 && smlEVENT_PRINT == 47 && smlEVENT_LOAD_LIBRARY + 1 == smlEVENT_LAST);

inline bool IsSystemEventID(int id) {
  return id >= smlEVENT_BEFORE_SHUTDOWN && id <= smlEVENT_LAST_SYSTEM_EVENT;
}
inline bool IsRunEventID(int id) {
  return id >= smlEVENT_BEFORE_SMALLEST_STEP && id <= smlEVENT_LAST_RUN_EVENT;
}
inline bool IsBEFOREPhaseEventID(int id) {
  return id >= smlEVENT_BEFORE_INPUT_PHASE && id <= smlEVENT_BEFORE_WM_PHASE;
}
inline bool IsAFTERPhaseEventID(int id) {
  return id >= smlEVENT_AFTER_INPUT_PHASE && id <= smlEVENT_AFTER_WM_PHASE;
}
inline bool IsPhaseEventID(int id) {
  return IsBEFOREPhaseEventID(id) || IsAFTERPhaseEventID(id);
}
inline bool IsProductionEventID(int id) {
  return id >= smlEVENT_AFTER_PRODUCTION_ADDED && id <= smlEVENT_LAST_PRODUCTION_EVENT;
}
inline bool IsAgentEventID(int id) {
  return id >= smlEVENT_AFTER_AGENT_CREATED && id <= smlEVENT_LAST_AGENT_EVENT;
}
inline bool IsWorkingMemoryEventID(int id) {
  return id == smlEVENT_OUTPUT_PHASE_CALLBACK;
}
inline bool IsPrintEventID(int id) {
  return id >= smlEVENT_ECHO && id <= smlEVENT_LAST_PRINT_EVENT;
}
inline bool IsRhsEventID(int id) {
  return id >= smlEVENT_RHS_USER_FUNCTION && id <= smlEVENT_LAST_RHS_EVENT;
}
inline bool IsXMLEventID(int id) {
  return id >= smlEVENT_XML_TRACE_OUTPUT && id <= smlEVENT_LAST_XML_EVENT;
}
inline bool IsUpdateEventID(int id) {
  return id >= smlEVENT_AFTER_ALL_OUTPUT_PHASES && id <= smlEVENT_LAST_UPDATE_EVENT;
}
inline bool IsStringEventID(int id) {
  return id >= smlEVENT_TCL_LIBRARY_MESSAGE && id <= smlEVENT_LAST_STRING_EVENT;
}

/// Converts between event numbers and their names in messages ("after-decision-cycle").
class EXPORT Events {
 public:
  Events() = default;

  /// The number of an event; smlEVENT_INVALID_EVENT if there is no event of this name.
  int ConvertToEvent(char const* pStr) const;

  /// The name of an event; NULL if there is no event of this number.
  char const* ConvertToString(int id) const;
};

}  // namespace sml
