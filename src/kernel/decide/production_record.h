// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

namespace soarbox::kernel {

/// The agent's data on one rule, apart from the rule itself: flags and the number of firings. Packed into one number,
/// because every agent has a record of each of its rules.
class ProductionRecord {
 public:
  static constexpr std::uint64_t kLive = 1;
  static constexpr std::uint64_t kBreaks = 2;
  static constexpr std::uint64_t kHasNegations = 4;  ///< It has negated conditions, which justifications depend on.
  static constexpr std::uint64_t kLearned = 8;       ///< It was added while the agent ran: no other agent shares it.

  bool Is(std::uint64_t flag) const { return (word_ & flag) != 0; }
  void Set(std::uint64_t flag, bool on) { word_ = on ? word_ | flag : word_ & ~flag; }
  std::uint64_t firings() const { return word_ / kFiring; }
  void CountFiring() { word_ += kFiring; }
  void ResetFirings() { word_ %= kFiring; }

 private:
  static constexpr std::uint64_t kFiring = 16;
  std::uint64_t word_ = 0;
};

}  // namespace soarbox::kernel
