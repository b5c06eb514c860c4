// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>

#include "diagnostics/diagnostic.h"

namespace soarbox::editors {

/// A request of the Debug Adapter Protocol is refused with this message.
struct DapRefusal {
  std::string message;
};

inline std::string WithHint(const Diagnostic& problem) {
  return problem.message + (problem.hint.empty() ? "" : ": " + problem.hint);
}

/// The number of the thread of the sandbox's script. That of an agent's script is higher by the agent's number.
inline constexpr std::uint32_t kFirstScriptThread = 1'000'000;

}  // namespace soarbox::editors
