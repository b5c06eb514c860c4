// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "record/tick_record.h"

namespace soarbox::record {

/// The first difference between a run and a recording of it, or between two futures.
struct Difference {
  std::uint64_t tick = 0;
  std::string agent;     ///< The first body that differs; empty if none does.
  std::string element;   ///< The first thing that differs: "position", "inputs", "the state's hash", ...
  std::string recorded;  ///< Its value in the recording (or in A).
  std::string now;       ///< Its value now (or in B).
};

/// The first difference between two records of one tick; minds come before bodies. Compares only data that both records
/// contain. Without `with_minds`, minds are not compared.
std::optional<Difference> FirstDifference(const TickRecord& recorded, const TickRecord& now, bool with_minds = true);
/// The first mind, in A's order, whose decisions or commands differ between A and B.
std::optional<Difference> DecisionThatDiffers(const TickRecord& a, const TickRecord& b);

}  // namespace soarbox::record
