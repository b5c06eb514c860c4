// SPDX-License-Identifier: BSD-2-Clause
#include "record/client_ticks.h"

#include <utility>

#include "diagnostics/number_from_chars.h"
#include "sim/client_world.h"

namespace soarbox::record {
namespace {

/// Phases as the log numbers them. A decision is made when the apply phase comes next.
constexpr std::uint64_t kApply = 3;

/// Number of decisions that an agent has made when it is in this cycle and phase.
std::uint64_t DecisionsAt(std::uint64_t cycles, std::uint64_t phase) {
  return cycles + (phase >= kApply ? 1 : 0);
}

std::uint64_t CountIn(const std::string& text) {
  std::uint64_t number = 0;
  (void)NumberFromChars(text, number);
  return number;
}

}  // namespace

void ClientTicks::Add(std::string_view line) {
  const std::vector<std::string> parts = sim::PartsOfClientLine(line);
  const std::string& kind = parts.front();
  if (parts.size() < 2 || kind == "soarbox-client") return;
  if (kind == "gone") {
    gone_.emplace_back(line);
    return;
  }
  for (const std::string& gone : std::exchange(gone_, {})) {
    const std::string agent = sim::PartsOfClientLine(gone)[1];
    // The agent is removed in the next tick, so that its last decision can still be inspected.
    if (in_this_tick_.contains(agent)) Flush();
    Put(gone);
    decided_.erase(agent);
  }
  if (kind == "file") {
    if (parts.size() > 2) on_file_(parts[1], parts[2]);
  } else if (kind == "function") {
    functions_.push_back(parts[1]);
    for (const auto& [agent, decisions] : decided_) TellFunction(agent, parts[1]);
  } else if (kind == "go") {
    if (parts.size() > 5) Go(parts);
  } else {
    Put(line);
    if (kind != "agent") return;
    decided_[parts[1]] = 0;
    for (const std::string& function : functions_) TellFunction(parts[1], function);
  }
}

void ClientTicks::Flush() {
  in_this_tick_.clear();
  if (!before_next_.empty()) {
    if (!ticks_.back().empty()) ticks_.emplace_back();
    ticks_.back() = std::exchange(before_next_, {});
  }
  if (!ticks_.back().empty()) ticks_.emplace_back();
}

/// Lines after a decision belong to the tick of the next decision.
void ClientTicks::Put(std::string_view line) {
  (in_this_tick_.empty() ? ticks_.back() : before_next_).append(line).append("\n");
}

void ClientTicks::PutDecision(const std::string& agent, std::string_view line) {
  const bool is_next = !in_this_tick_.insert(agent).second;
  if (is_next) {
    ticks_.emplace_back();
    in_this_tick_ = {agent};
  }
  ticks_.back().append(std::exchange(before_next_, {})).append(line).append("\n");
}

/// Adds a function of the client for one agent. Each agent needs its own line, because it may be in another kernel.
void ClientTicks::TellFunction(const std::string& agent, const std::string& function) {
  Put(sim::ClientLine({"function", agent, function}));
}

void ClientTicks::Go(const std::vector<std::string>& parts) {
  const std::string& agent = parts[1];
  const std::string line = sim::ClientLine({"go", agent, parts[2], parts[3], parts[4], parts[5]});
  const std::uint64_t goal = DecisionsAt(CountIn(parts[2]), CountIn(parts[3]));
  std::uint64_t& decided = decided_[agent];
  if (goal < decided) decided = goal;  // init-soar.
  // Each decision but the last ends a tick.
  for (; decided + 1 < goal; ++decided)
    PutDecision(agent, sim::ClientLine({"go", agent, std::to_string(decided), std::to_string(kApply), "0", "-"}));
  if (decided == goal) return Put(line);
  ++decided;
  PutDecision(agent, line);
}

}  // namespace soarbox::record
