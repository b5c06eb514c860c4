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

/// A view that can be printed.
struct ViewInfo {
  std::string_view name;
  std::string_view of;  ///< The argument: "RULE", "[STATE]"; empty if it takes none.
  std::string_view about;
  bool needs_mind = false;
};
std::span<const ViewInfo> Views();

/// The view to show.
struct ViewRequest {
  std::string view = "agents";
  std::string agent;  ///< Empty: the first agent with a Soar mind, or all if the view can show all.
  std::string of;     ///< The argument, see ViewInfo.
  std::uint64_t first_tick = 0, last_tick = 0;  ///< For views over a range of ticks.
};

/// Where a view gets its data from.
struct ViewSource {
  sim::Simulation* simulation = nullptr;  ///< The run at its last tick; null if only recorded data are available.
  const RunModels* models = nullptr;      ///< Contains all ticks up to the last one.
  const record::TickRecord* last = nullptr;
  /// Contains the same ticks, if there is no simulation; may be null.
  const RecordedMinds* recorded = nullptr;
};

struct ViewText {
  std::string text, json;
};
/// Fails if the view, the agent or the object of the argument does not exist.
Result<ViewText> ShowView(const ViewSource& source, const ViewRequest& request);

}  // namespace soarbox::debugger
