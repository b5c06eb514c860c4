// SPDX-License-Identifier: BSD-2-Clause
#include "sml/server/run_text.h"

namespace soarbox::server {

std::string RunText(const kernel::AgentCounters& before, const kernel::Agent& agent, const kernel::RunResult& result) {
  const kernel::AgentCounters& now = agent.counters();
  const std::uint64_t start = before.decision_cycles == 0 ? 0 : before.decision_cycles + 1;
  const std::uint64_t cycles = now.decision_cycles + 1 - start;
  const std::uint64_t firings = now.firings - before.firings;
  std::string text = "\n\n--> " + std::to_string(cycles) + (cycles <= 1 ? " decision cycle executed. " : " decision cycles executed. ");
  if (firings == 0) {
    text += "No rules fired. ";
  } else {
    text += std::to_string(firings) + (firings == 1 ? " rule fired. " : " rules fired. ");
  }
  if (result.reason == kernel::StopReason::kInterrupted || result.reason == kernel::StopReason::kLimit) {
    text += "\nRun stopped (interrupted).";
  }
  if (agent.halted()) text += "\nAn agent halted during the run.";
  return text;
}

}  // namespace soarbox::server
