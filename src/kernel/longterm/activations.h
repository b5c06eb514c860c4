// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "kernel/longterm/flat_map.h"
#include "kernel/longterm/knowledge.h"
#include "kernel/longterm/smem_settings.h"

namespace soarbox::kernel {

/// The activation of each object for one agent. Only objects that were touched have a record; all others have
/// activation 0.
///
/// The clock counts the touches that advance it (uses), not decisions. init-soar does not reset it. The activation is,
/// by mode: recency: the clock at the last touch. frequency: the number of uses. base-level: ln(s / (1 + s)), where s
/// is the sum of age^-decay over the last ten uses; older uses are estimated by Petrov's approximation.
class Activations {
 public:
  static constexpr std::size_t kHistory = 10;

  struct Touched {
    std::uint32_t object = 0;
    bool forget_last = false;  ///< Prohibited since its last touch: the next touch undoes the last one.
    double activation = 0;
    std::uint64_t count = 0;
    std::uint64_t first = 0;                      ///< Tick of the first touch.
    std::array<std::uint64_t, kHistory> ticks{};  ///< Of the last touches, newest first.
  };

  explicit Activations(const SmemSettings& settings) : settings_(settings) {}

  double Of(std::uint32_t object) const {
    const Touched* const record = Find(object);
    return record == nullptr ? 0 : record->activation;
  }
  const Touched* Find(std::uint32_t object) const {
    const std::uint32_t at = by_object_.Find(object + 1ull);
    return at == FlatMap::kNone ? nullptr : &records_[at];
  }
  /// The strength s of an object that was never used: as if it had been used once, base-unused-age-offset ticks before
  /// the clock started.
  double UnusedStrength() const;
  /// Touches an object. With `advance` (a use), the clock advances by one, and the use counts. Without (storing), only
  /// the activation is recomputed, for the time of the next use. Returns true if it is the object's first touch.
  bool Touch(std::uint32_t object, bool advance = true);
  /// Recomputes a base-level activation for the current time, without a touch.
  void Update(std::uint32_t object);
  void Prohibit(std::uint32_t object);
  std::uint64_t tick() const { return tick_; }
  /// Number of computed activations (`smem --stats act_updates`).
  std::uint64_t updates() const { return updates_; }
  std::span<const Touched> records() const { return records_; }

  /// Restores everything from stored data.
  void Restore(std::uint64_t tick, std::span<const Touched> records);
  void Clear();
  std::size_t MemoryBytes() const {
    return records_.capacity() * sizeof(Touched) + by_object_.MemoryBytes() + object_of_tick_.capacity() * 4;
  }

 private:
  Touched& RecordOf(std::uint32_t object);
  double BaseLevel(const Touched& record) const;

  const SmemSettings& settings_;
  std::vector<Touched> records_;
  FlatMap by_object_;                          ///< Object + 1 -> index of records_.
  std::vector<std::uint32_t> object_of_tick_;  ///< Incremental policy: objects by tick of touch, from first_tick_.
  std::uint64_t first_tick_ = 0;
  std::uint64_t tick_ = 0;
  std::uint64_t updates_ = 0;
};

}  // namespace soarbox::kernel
