// SPDX-License-Identifier: BSD-2-Clause
#include "cli/run_text.h"

#include <fmt/format.h>

namespace soarbox::cli {

RunCounts RunCounts::Of(const kernel::Agent& agent) {
  return {agent.counters().decision_cycles, agent.counters().firings, agent.counters().chunks};
}

std::vector<std::string> RunLines(const kernel::Agent& agent, const RunCounts& before, const kernel::RunResult& run) {
  // Soar's counter is one more than the number of completed output phases, and starts at 0 only for its first run.
  const std::uint64_t cycles = agent.counters().decision_cycles + 1 - (before.cycles == 0 ? 0 : before.cycles + 1);
  const std::uint64_t firings = agent.counters().firings - before.firings;
  std::vector<std::string> lines;
  lines.push_back(fmt::format("\n\n--> {} decision cycle{} executed. {} fired. ", cycles, cycles <= 1 ? "" : "s",
                              firings == 0   ? std::string("No rules")
                              : firings == 1 ? std::string("1 rule")
                                             : fmt::format("{} rules", firings)));
  const std::uint64_t learned = agent.counters().chunks - before.chunks;
  if (learned > 0) lines.back() += fmt::format("{} new rule{} learned.", learned, learned == 1 ? "" : "s");
  const bool stopped = run.reason == kernel::StopReason::kInterrupted || run.reason == kernel::StopReason::kLimit;
  if (stopped) lines.push_back("\nRun stopped (interrupted).");
  if (agent.halted()) lines.push_back("\nAn agent halted during the run.");
  if (agent.out_of_memory()) lines.push_back(fmt::format("\nThe agent ran out of memory: {}.", agent.breakdown()));
  return lines;
}

std::string RunText(const kernel::Agent& agent, const RunCounts& before, const kernel::RunResult& run) {
  std::string text;
  for (const std::string& line : RunLines(agent, before, run)) text += line;
  return text;
}

}  // namespace soarbox::cli
