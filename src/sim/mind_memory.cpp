// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>

#include "sim/minds.h"
#include "sim/work_limit.h"

// The total memory of all minds of a world, and limits for a tick. Limits are bytes that the kernel reports and numbers
// of firings; nothing is timed.

namespace soarbox::sim {
namespace {

/// Number of groups in which minds are measured in turn; large minds are measured in each tick.
constexpr std::size_t kTurns = 8;
constexpr std::size_t kLarge_bytes = std::size_t{4} << 20;
/// Minimum growth that is allowed to a mind in a tick.
constexpr std::size_t kLeastGrowth_bytes = std::size_t{8} << 20;
/// Size of a partial match, and its size including what results from it.
constexpr std::size_t kMatch_bytes = 64, kGrownMatch_bytes = 256;

/// A mind that uses one kMuch-th of the world's memory is reported.
constexpr std::size_t kMuch = 8;
/// A mind that has learned this many rules is reported, because each of them must be matched.
constexpr std::size_t kManyLearned = 500;
constexpr const char* kGrowingRules =
    "look for rules that add elements in each decision and never remove them; --memory gives the world more";

/// An event about a mind, with the rules that it runs.
RunEvent AboutMind(EventKind kind, const std::string& name, const std::filesystem::path& rules) {
  RunEvent event;
  event.kind = kind;
  event.agent = name;
  event.diagnostic.file = rules.string();
  return event;
}

std::string Megabytes(std::size_t bytes) {
  return std::to_string((bytes + (std::size_t{1} << 19)) >> 20) + " MB";
}

}  // namespace

/// Distributes the remaining memory among the minds that decide now, so that they cannot exceed it within one tick.
void Minds::LimitMemory() {
  if (ready_.empty()) return;
  const std::size_t left = MemoryLeft();
  const std::size_t share = std::max(kLeastGrowth_bytes, left / ready_.size());
  for (const std::size_t i : ready_) {
    minds_[i].soar.AllowMatches(minds_[i].memory_bytes / kMatch_bytes + share / kGrownMatch_bytes);
    minds_[i].soar.AllowMemory(minds_[i].memory_bytes + share);
  }
}

void Minds::KeepWithinMemory() {
  for (const std::size_t i : ready_) {
    Mind& mind = minds_[i];
    if (!mind.lost && HaltForWork(mind)) continue;
    const bool is_due = mind.memory_bytes == 0 || mind.memory_bytes > kLarge_bytes || (world_.tick() + i) % kTurns == 0;
    if (!is_due || mind.lost) continue;
    const std::size_t now = mind.soar.MemoryBytes();
    memory_bytes_ = memory_bytes_ - mind.memory_bytes + now;
    mind.memory_bytes = now;
    if (now > memory_limit_ / kMuch && !mind.told_memory) TellMemory(mind);
    if (!mind.told_learned && mind.soar.LearnedRules() >= kManyLearned) TellLearned(mind);
  }
  while (memory_bytes_ + scripts_bytes_ + bodies_bytes_ > memory_limit_) {
    Mind* largest = nullptr;
    for (Mind& mind : minds_)
      if (!mind.gone && mind.memory_bytes > 0 && (largest == nullptr || mind.memory_bytes > largest->memory_bytes))
        largest = &mind;
    if (largest == nullptr) return;
    HaltForMemory(*largest);
  }
}

void Minds::TellMemory(Mind& mind) {
  mind.told_memory = true;
  RunEvent event = AboutMind(EventKind::kDiagnostic, world_.FindAgent(mind.agent)->name(), mind.rules);
  event.diagnostic.severity = Severity::kWarning;
  event.diagnostic.message = "the mind of " + event.agent + " has grown to " + Megabytes(mind.memory_bytes) +
                             " of the " + Megabytes(memory_limit_) + " that this world may take";
  event.diagnostic.hint = kGrowingRules;
  report_(std::move(event));
}

void Minds::TellLearned(Mind& mind) {
  mind.told_learned = true;
  RunEvent event = AboutMind(EventKind::kDiagnostic, world_.FindAgent(mind.agent)->name(), mind.rules);
  event.diagnostic.severity = Severity::kWarning;
  event.diagnostic.message = "the mind of " + event.agent + " has learned " + std::to_string(mind.soar.LearnedRules()) +
                             " rules, " + mind.soar.MostLearnedFrom();
  event.diagnostic.hint =
      "let that rule's substate test nothing that is new each time, such as a counter or the time; or learn only in "
      "states in which it is useful: 'chunk only' and (force-learn <s>)";
  report_(std::move(event));
}

bool Minds::TellBreakdown(Mind& mind, const world::Agent& body) {
  if (mind.soar.Breakdown().empty()) return false;
  mind.lost = true;
  RunEvent event = AboutMind(EventKind::kMindFailed, body.name(), mind.rules);
  event.diagnostic.message =
      body.name() + " ran out of memory and stops for good: " + std::string(mind.soar.Breakdown());
  event.diagnostic.hint =
      "look for conditions that share no variable (they match in all combinations of their elements), and for rules "
      "that add elements, or lengthen texts, each time they fire";
  report_(std::move(event));
  return true;
}

bool Minds::HaltForWork(Mind& mind) {
  const std::uint64_t fired = mind.soar.fired();
  if (fired < kMostFirings) return false;
  const std::string& name = world_.FindAgent(mind.agent)->name();
  RunEvent event = AboutMind(EventKind::kMindFailed, name, mind.rules);
  event.diagnostic.topic = Topic::kHaltedAtWork;
  event.diagnostic.message = name + " stops for good: its rules fired " + std::to_string(fired) +
                             " times in one tick, most often " + mind.soar.BusiestRule();
  event.diagnostic.hint =
      "look for a rule whose action makes it match again, or match more and more elements; to count, let an operator "
      "take one step in each decision";
  Halt(mind, std::move(event));
  return true;
}

void Minds::HaltForMemory(Mind& mind) {
  const std::string& name = world_.FindAgent(mind.agent)->name();
  RunEvent event = AboutMind(EventKind::kMindFailed, name, mind.rules);
  event.diagnostic.message = name + " stops for good: this world needs more than " + Megabytes(memory_limit_) +
                             " of memory (minds " + Megabytes(memory_bytes_) + ", scripts " +
                             Megabytes(scripts_bytes_) + ", bodies " + Megabytes(bodies_bytes_) + "), and its " +
                             Megabytes(mind.memory_bytes) + " are the most of any mind";
  event.diagnostic.hint = kGrowingRules;
  Halt(mind, std::move(event));
}

void Minds::Halt(Mind& mind, RunEvent reason) {
  End(mind);
  mind.gone_because = reason.diagnostic.message;
  report_(std::move(reason));
}

void Minds::End(Mind& mind) {
  memory_bytes_ -= mind.memory_bytes;
  mind.memory_bytes = 0;
  mind.lost = mind.gone = true;
  mind.decided = false;
  mind.soar.Forget();
  host_.DestroyAgent(world_.FindAgent(mind.agent)->name());
}

void Minds::EndRemoved(world::EntityId agent) {
  Mind* mind = Find(agent);
  if (mind == nullptr || mind->gone || mind->by_client) return;
  End(*mind);
  mind->gone_because = "is no longer there: a script removed it";
}

}  // namespace soarbox::sim
