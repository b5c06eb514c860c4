// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace soarbox::script {

/// Approximate memory of a body in physics, the scene and the senses of others.
inline constexpr std::size_t kAgentBodyBytes = std::size_t{24} << 10, kObjectBodyBytes = std::size_t{8} << 10;

/// The limits of all scripts and minds of a world together. They are counted, not timed, so that a limit is reached at
/// the same place in every run.
struct WorldLimits {
  std::uint64_t setup_instructions = 2'000'000'000;  ///< Until the first tick.
  std::uint64_t tick_instructions = 100'000'000;     ///< In each tick.
  std::size_t memory_bytes = std::size_t{2} << 30;   ///< Of all machines, Soar minds and bodies.
  std::size_t objects = 5'000;
  std::size_t nodes = 100'000;  ///< Of the scene, those of agents and objects included.
  std::size_t lights = 256;
  std::size_t panels = 2'000;
  std::size_t shapes_per_tick = 100'000;  ///< Of debug drawing.
  std::size_t waiting_events = 10'000;
  std::size_t event_bytes = std::size_t{64} << 20;  ///< Of all waiting events.
  std::size_t callbacks = 20'000;
  std::size_t print_bytes =
      std::size_t{1} << 20;  ///< Maximum that can be printed at once. Each tick restores print_bytes_per_tick of it.
  std::size_t print_bytes_per_tick = std::size_t{16} << 10;
};

/// How a script ended all scripts of its world (os.exit).
struct ScriptsEnd {
  std::string script;  ///< The script that requested it.
  int exit_code = 0;
};

/// The unused part of these limits. A call may use a tenth of the remaining instructions. A machine that has 1 MiB or
/// more may grow to at most an eighth of the memory that is still free. Therefore scripts that need more than their
/// share are stopped long before the others have too little.
class WorldBudget {
 public:
  explicit WorldBudget(const WorldLimits& limits = {})
      : limits_(limits), instructions_left_(limits.setup_instructions), print_left_(limits.print_bytes) {}

  const WorldLimits& limits() const { return limits_; }

  /// From now on no script of the world runs. Only the first call counts.
  void EndScripts(ScriptsEnd end) {
    if (!end_) end_ = std::move(end);
  }
  const std::optional<ScriptsEnd>& end() const { return end_; }

  void BeginTick() {
    instructions_left_ = limits_.tick_instructions;
    print_left_ = std::min(limits_.print_bytes, print_left_ + limits_.print_bytes_per_tick);
  }

  /// Number of instructions that the next call may use.
  std::uint64_t InstructionsForCall() const { return instructions_left_ / 10; }
  void UseInstructions(std::uint64_t count) { instructions_left_ -= std::min(count, instructions_left_); }
  std::uint64_t instructions_left() const { return instructions_left_; }

  /// Reserves memory for a machine that has `has_bytes`. Returns false and reserves nothing if a limit forbids it.
  bool TakeMemory(std::size_t bytes, std::size_t has_bytes) {
    const std::size_t left = memory_left();
    if (bytes > left || (has_bytes >= kSmallMachine && has_bytes + bytes > left / 8)) return false;
    used_bytes_ += bytes;
    return true;
  }
  /// True if a machine of this size has more than half of its share.
  bool IsNearShare(std::size_t has_bytes) const { return has_bytes >= kSmallMachine && has_bytes > memory_left() / 16; }
  void GiveMemoryBack(std::size_t bytes) { used_bytes_ -= bytes; }
  std::size_t used_bytes() const { return used_bytes_; }

  /// Sets the memory that minds and bodies currently use of the world's.
  void SetOthers(std::size_t bytes) { other_bytes_ = bytes; }
  std::size_t other_bytes() const { return other_bytes_; }
  /// An eighth is reserved for minds, so that they continue when scripts have used all of their memory.
  std::size_t memory_left() const {
    const std::size_t most = limits_.memory_bytes - limits_.memory_bytes / 8;
    return most - std::min(most, used_bytes_ + other_bytes_);
  }

  /// Reserves space for a printed text; false: there is none, and the text must be left out.
  bool TakePrint(std::size_t bytes) {
    if (bytes > print_left_) return false;
    print_left_ -= bytes;
    return true;
  }

 private:
  /// Up to this size a machine may always grow: it contains the library and a script.
  static constexpr std::size_t kSmallMachine = std::size_t{1} << 20;

  WorldLimits limits_;
  std::uint64_t instructions_left_;
  std::size_t print_left_;
  std::size_t used_bytes_ = 0, other_bytes_ = 0;
  std::optional<ScriptsEnd> end_;
};

}  // namespace soarbox::script
