// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>

#include "diagnostics/diagnostic.h"

namespace soarbox::editors {

/// Thrown to refuse a request of the Debug Adapter Protocol with this message.
struct DapRefusal {
  std::string message;
};

inline std::string WithHint(const Diagnostic& problem) {
  return problem.message + (problem.hint.empty() ? "" : ": " + problem.hint);
}

/// The thread number of the sandbox's script. The script of an agent has this number plus the agent's id.
inline constexpr std::uint32_t kFirstScriptThread = 1'000'000;

}  // namespace soarbox::editors
