// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace soarbox::sim {

/// The simulated times of a mind's decisions. Consecutive ticks with equal numbers of decisions share an entry. A mind
/// that decides once per tick needs a single entry.
class DecisionClock {
 public:
  /// Records that the mind has made `decisions` in total by the end of the tick at this time. A smaller number than
  /// before means that it was restarted.
  void Note(std::uint64_t decisions, double time_s, double step_s) {
    if (decisions < decisions_) runs_.clear(), decisions_ = 0;
    const std::uint64_t made = decisions - decisions_;
    if (made == 0) return;
    const std::uint64_t first = decisions_ + 1;
    decisions_ = decisions;
    if (!runs_.empty()) {
      Run& last = runs_.back();
      if (last.per_tick == made && last.step_s == step_s &&
          std::abs(last.time_s + static_cast<double>(last.ticks) * step_s - time_s) < step_s / 2) {
        ++last.ticks;
        return;
      }
    }
    if (runs_.size() >= kMostRuns) runs_.erase(runs_.begin(), runs_.begin() + kMostRuns / 2);
    runs_.push_back({first, made, 1, time_s, step_s});
  }

  /// The time of a decision, counted from 1; nothing if it is no longer known.
  std::optional<double> TimeOf(std::uint64_t decision) const {
    const auto after = std::upper_bound(runs_.begin(), runs_.end(), decision,
                                        [](std::uint64_t wanted, const Run& run) { return wanted < run.first; });
    if (after == runs_.begin() || decision == 0 || decision > decisions_) return std::nullopt;
    const Run& run = *(after - 1);
    return run.time_s + static_cast<double>((decision - run.first) / run.per_tick) * run.step_s;
  }

 private:
  /// Limits memory to 640 kB for a mind whose number of decisions differs in each tick.
  static constexpr std::size_t kMostRuns = 1u << 14;

  struct Run {
    std::uint64_t first = 0;  ///< The first decision.
    std::uint64_t per_tick = 1, ticks = 1;
    double time_s = 0, step_s = 0;  ///< Time of the first tick; time between ticks.
  };
  std::vector<Run> runs_;
  std::uint64_t decisions_ = 0;
};

}  // namespace soarbox::sim
