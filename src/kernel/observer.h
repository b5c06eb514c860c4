// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

class Agent;

enum class Phase : std::uint8_t { kInput, kPropose, kDecide, kApply, kOutput };

/// What an observer wants to hear, as a bit mask: the kernel builds nothing for an event that nobody listens to.
enum class Event : std::uint32_t {
  kPhase = 1u << 0,           ///< Begin and end of each phase.
  kElaboration = 1u << 1,     ///< Begin and end of each elaboration, and of each inner one.
  kFiring = 1u << 2,          ///< Rules that fire and retract.
  kWme = 1u << 3,             ///< Elements added to and removed from working memory.
  kPreference = 1u << 4,      ///< Preferences made by a firing.
  kDecision = 1u << 5,        ///< Operators selected, states made and removed.
  kPrint = 1u << 6,           ///< Text that rules write and warnings of the architecture.
  kProduction = 1u << 7,      ///< Rules added and excised.
  kRun = 1u << 8,             ///< Run control: start, stop, decision cycles.
  kOutput = 1u << 9,          ///< The output link changed.
};

/// Sees what an agent does, in the order in which it happens. Callbacks run on the agent's thread, between steps of the
/// cycle; they may read everything and change nothing, except that they may request a stop.
///
/// The engine's engineer completes this list with what the trace (cli_commands.md section 5), the client API's events
/// (sml_client_api.md section 12) and the recording need.
class Observer {
 public:
  virtual ~Observer() = default;
};

}  // namespace soarbox::kernel
