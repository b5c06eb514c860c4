// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <map>
#include <string>

#include "debugger/agents.h"
#include "debugger/learning_log.h"
#include "debugger/messages.h"
#include "debugger/plots.h"
#include "debugger/recall.h"
#include "debugger/rules.h"
#include "debugger/run_trace.h"
#include "debugger/timeline.h"
#include "record/tick_record.h"

namespace soarbox::debugger {

/// The models that grow with a run. Add its ticks in order: live (record::Observe after each tick) or from a recording.
struct RunModels {
  AgentTroubles troubles;
  Timeline timeline;
  MessageLog messages;
  Trace trace;
  Plots plots;
  std::map<std::string, Coverage, std::less<>> coverage;     ///< By agent.
  std::map<std::string, RecallLog, std::less<>> recalls;     ///< By agent.
  std::map<std::string, LearningLog, std::less<>> learning;  ///< By agent.

  void Add(const record::TickRecord& tick);
};

}  // namespace soarbox::debugger
