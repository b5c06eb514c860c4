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

/// Determines which learned rules are used so rarely that they may be forgotten (`rl --set apoptosis`). A rule is used
/// when one of its matches ends. Its activation is the logarithm of the sum over its uses of (decisions since
/// then)^-decay. The last ten decisions with uses are stored individually; earlier ones are estimated. A rule is due
/// when its activation is below the threshold.
///
/// Decisions are counted from the moment when it is enabled. It stores only numbers of rules: the caller decides which
/// of them may be removed.
class Apoptosis {
 public:
  bool on() const { return mode_ != ApoptosisMode::kNone; }
  ApoptosisMode mode() const { return mode_; }
  /// Starts from scratch when it is enabled; forgets everything when it is disabled.
  void Set(const RlSettings& settings);

  void Used(ProductionId rule) { ++used_[rule]; }
  void RuleExcised(ProductionId rule);
  /// Call at the end of a decision. Returns the rules that are due, in ascending order. A rule is returned once, and
  /// again only if it has been used since.
  std::vector<ProductionId> EndDecision();
  void Clear();

 private:
  static constexpr std::size_t kKept = 10;

  struct Use {
    std::uint64_t decision = 0;
    std::uint64_t count = 0;
  };
  struct History {
    std::array<Use, kKept> uses;     ///< A ring buffer.
    std::size_t next = 0, kept = 0;  ///< The index of the next entry; the number of entries.
    std::uint64_t total = 0;         ///< Total number of uses.
    std::uint64_t first = 0;         ///< Decision of the first use.
    std::uint64_t due = 0;           ///< Decision in which it is due; 0: it has been returned already.
  };

  double Activation(const History& history, std::uint64_t decision) const;
  bool IsDue(const History& history, std::uint64_t decision) const;
  std::uint64_t FindDue(const History& history) const;
  void Schedule(ProductionId rule, History& history);
  void Unschedule(ProductionId rule, History& history);

  ApoptosisMode mode_ = ApoptosisMode::kNone;
  double decay_ = 0.5;
  double lowest_ = 0;  ///< e to the power of the threshold.
  std::uint64_t decision_ = 1;
  std::map<ProductionId, std::uint64_t> used_;  ///< The uses in this decision.
  std::map<ProductionId, History> histories_;
  std::map<std::uint64_t, std::vector<ProductionId>> schedule_;
};

}  // namespace soarbox::kernel
