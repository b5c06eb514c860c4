// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "record/tick_record.h"

namespace soarbox::record {

/// Where a run goes another way than a recording of it, or one future another than the other.
struct Difference {
  std::uint64_t tick = 0;
  std::string agent;     ///< The first body that differs; empty if none does.
  std::string element;   ///< What differs first: "position", "inputs", "the state's hash", ...
  std::string recorded;  ///< Its value in the recording, and ...
  std::string now;       ///< ... what it is now.
};

/// The first thing in which two records of one tick differ, minds before bodies; none if they are equal in all that
/// both hold. Without `with_minds` only what there is to see of them counts.
std::optional<Difference> FirstDifference(const TickRecord& recorded, const TickRecord& now, bool with_minds = true);
/// The first mind, in A's order, that decided or said something else in A than in B.
std::optional<Difference> DecisionThatDiffers(const TickRecord& a, const TickRecord& b);

}  // namespace soarbox::record
