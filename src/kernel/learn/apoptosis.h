// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/learn/rl_settings.h"

namespace soarbox::kernel {

/// Which of the learned rules are used so little that they may be forgotten (`rl --set apoptosis`). A rule is used when
/// a match of it ends. Its activation is the sum over its uses of (decisions since then)^-decay, of which the last ten
/// decisions with uses are kept one by one and those before are estimated; when its logarithm falls below the threshold
/// the rule is due.
///
/// Counts decisions from when it was switched on. It knows numbers of rules only: the caller decides which may go.
class Apoptosis {
 public:
  bool on() const { return mode_ != ApoptosisMode::kNone; }
  ApoptosisMode mode() const { return mode_; }
  /// Begins anew when it is switched on; forgets everything when it is switched off.
  void Set(const RlSettings& settings);

  void Used(ProductionId rule) { ++used_[rule]; }
  void RuleExcised(ProductionId rule);
  /// At the end of a decision: the rules that are due, in order of their numbers. A rule is due once; later only if it
  /// is used again.
  std::vector<ProductionId> EndDecision();
  void Clear();

 private:
  static constexpr std::size_t kKept = 10;

  struct Use {
    std::uint64_t decision = 0;
    std::uint64_t count = 0;
  };
  struct History {
    std::array<Use, kKept> uses;     ///< A ring.
    std::size_t next = 0, kept = 0;  ///< Where the next one goes; how many there are.
    std::uint64_t total = 0;         ///< Uses ever.
    std::uint64_t first = 0;         ///< Decision of the first.
    std::uint64_t due = 0;           ///< When it is to be forgotten; 0: it was told.
  };

  double Activation(const History& history, std::uint64_t decision) const;
  bool IsDue(const History& history, std::uint64_t decision) const;
  std::uint64_t FindDue(const History& history) const;
  void Schedule(ProductionId rule, History& history);
  void Unschedule(ProductionId rule, History& history);

  ApoptosisMode mode_ = ApoptosisMode::kNone;
  double decay_ = 0.5;
  double lowest_ = 0;  ///< e to the threshold.
  std::uint64_t decision_ = 1;
  std::map<ProductionId, std::uint64_t> used_;  ///< In this decision.
  std::map<ProductionId, History> histories_;
  std::map<std::uint64_t, std::vector<ProductionId>> schedule_;
};

}  // namespace soarbox::kernel
