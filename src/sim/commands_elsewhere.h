// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <string>

#include "diagnostics/result.h"

namespace soarbox::sim {

/// Executes a command line for an agent in another kernel and returns what it printed.
using CommandsElsewhere = std::function<Result<std::string>(const std::string& agent, const std::string& line)>;

}  // namespace soarbox::sim
