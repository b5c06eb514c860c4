// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "record/tick_record.h"

namespace soarbox::record {

/// Where a run differs from a recording of it, or one future from another.
struct Difference {
  std::uint64_t tick = 0;
  std::string agent;     ///< The first body that differs; empty if none does.
  std::string element;   ///< The first thing that differs: "position", "inputs", "the state's hash", ...
  std::string recorded;  ///< Its value in the recording, and ...
  std::string now;       ///< ... what it is now.
};

/// The first difference between two records of one tick, minds before bodies; none if everything that both hold is
/// equal. Without `with_minds`, only what can be seen counts.
std::optional<Difference> FirstDifference(const TickRecord& recorded, const TickRecord& now, bool with_minds = true);
/// The first mind, in A's order, that decided or said something else in A than in B.
std::optional<Difference> DecisionThatDiffers(const TickRecord& a, const TickRecord& b);

}  // namespace soarbox::record
