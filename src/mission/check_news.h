// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "mission/evaluator.h"
#include "mission/mission.h"
#include "sim/run_event.h"

namespace soarbox::mission {

/// How a check stands, as news of a run with the word "check": windows show it from there, and recordings hold it.
/// Its text is the check's name, its parameters the state; its reasons are what was expected, what was there, who
/// decided it and "marker" or nothing.
sim::RunEvent CheckNews(const Mission& mission, std::size_t check, const Verdict& verdict, std::uint64_t tick,
                        double time_s);

}  // namespace soarbox::mission
