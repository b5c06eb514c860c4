// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "mission/evaluator.h"
#include "mission/mission.h"
#include "sim/run_event.h"

namespace soarbox::mission {

/// The state of a check as an event of a run (sim::CheckReport). Windows show it and recordings store it.
sim::RunEvent CheckNews(const Mission& mission, std::size_t check, const Verdict& verdict, std::uint64_t tick,
                        double time_s);

}  // namespace soarbox::mission
