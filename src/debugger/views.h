// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "debugger/recorded_mind.h"
#include "debugger/run_models.h"
#include "diagnostics/result.h"
#include "record/tick_record.h"
#include "sim/simulation.h"

namespace soarbox::debugger {

/// A model that can be printed.
struct ViewInfo {
  std::string_view name;
  std::string_view of;  ///< What may be named beside it: "RULE", "[STATE]"; empty: nothing.
  std::string_view about;
  bool needs_mind = false;
};
std::span<const ViewInfo> Views();

/// What is asked for.
struct ViewRequest {
  std::string view = "agents";
  std::string agent;  ///< Empty: the first with a Soar mind, or all where a view can show all.
  std::string of;     ///< See ViewInfo.
  std::uint64_t first_tick = 0, last_tick = 0;  ///< For views over ticks.
};

/// Where it comes from.
struct ViewSource {
  sim::Simulation* simulation = nullptr;  ///< Stands at the last tick; null: only what was recorded is known.
  const RunModels* models = nullptr;      ///< Fed with all ticks up to it.
  const record::TickRecord* last = nullptr;
  /// Fed with the same ticks, where there is no simulation; may be null.
  const RecordedMinds* recorded = nullptr;
};

struct ViewText {
  std::string text, json;
};
/// Fails if there is no such view or agent, or nothing by that name.
Result<ViewText> ShowView(const ViewSource& source, const ViewRequest& request);

}  // namespace soarbox::debugger
