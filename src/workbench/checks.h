// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/run_event.h"
#include "workbench/contents.h"

namespace soarbox::workbench {

/// Updates `checks` from an event about a check of the run's mission: the check exists, or it has a result. Returns
/// false if the event is not about a check.
bool NoteCheck(const sim::RunEvent& event, std::vector<CheckRow>& checks);

enum class CheckResult : std::uint8_t { kOpen, kPassed, kFailed };

/// The result of a check at the moment that is shown. A check is open if it was decided after that moment, in a future
/// that was given up, or with rules that have been changed since. In a lesson, a failed check is open until the learner
/// has tried something.
CheckResult ResultOf(const CheckRow& check, const Contents& contents);

/// Whether the check is open only because it is decided after the moment that is shown.
bool IsDecidedLater(const CheckRow& check, const Contents& contents);

/// The number of checks that count, and how many of them are passed and failed at the moment that is shown.
struct CheckCounts {
  std::size_t all = 0, passed = 0, failed = 0;
};
CheckCounts CountChecks(const Contents& contents);

/// Why checks of this run stay open although something was decided; empty if they do not.
std::string WhyChecksAreOpen(const Moment& moment);

}  // namespace soarbox::workbench
