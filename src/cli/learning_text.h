// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

namespace soarbox::kernel {
class Agent;
}

namespace soarbox::cli {

/// What `chunk stats` and `stats --learning` print.
std::string LearningStatisticsText(const kernel::Agent& agent);

}  // namespace soarbox::cli
