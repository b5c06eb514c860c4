// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <set>
#include <span>
#include <vector>

#include "kernel/rules/draft.h"

namespace soarbox::kernel {

/// The cost of a condition whose identifier no earlier condition binds.
inline constexpr std::int64_t kInfiniteCost = 10000005;
/// The factor for each field that is not bound yet.
inline constexpr std::int64_t kUnboundCost = 8;

/// What the order of conditions depends on, for one condition.
struct QueuedCondition {
  bool positive = true;
  std::array<std::uint32_t, 3> fields = {kNoVariable, kNoVariable, kNoVariable};  ///< Variables; positive ones only.
  std::int64_t expected = 1;             ///< Expected number of values under its attribute, less than kInfiniteCost.
  std::uint64_t age = 0;                 ///< Of positive ones: ties go to the greater age. 0 if negated.
  std::span<const std::uint32_t> needs;  ///< Its variables, each once; see ListReorderer.
};

/// Chooses the next condition of a long list: the cheapest, with one step of look-ahead. It chooses what a scan of all
/// waiting conditions chooses (ListReorderer::Choose), but it recomputes only what a new binding changes: n conditions
/// that share few variables take O(n log n). Binding a variable never makes a condition more expensive, so that the
/// look-ahead of a condition is the least of its cost and of what its variables make of the conditions that use them.
///
/// If no waiting condition can be reached, which is an error in the rule, it scans all of them.
class ConditionQueue {
 public:
  /// From this number of conditions on the queue is used.
  static constexpr std::size_t kFewest = 64;

  /// `conditions` in text order; they must outlive the queue. `variables`: the number of variables.
  ConditionQueue(std::span<const QueuedCondition> conditions, std::uint32_t variables);

  /// Before Start(): the variable is bound, or it is a root, which counts as bound until all roots are.
  void SetBound(std::uint32_t variable) { bound_[variable] = true; }
  void SetRoot(std::uint32_t variable) { root_[variable] = true; }
  /// `roots_wait`: not every root is bound.
  void Start(bool roots_wait);

  struct Choice {
    std::size_t at = 0;
    std::int64_t cost = 0;
  };
  /// Removes the next condition; at least one must be waiting. The caller binds its variables.
  Choice Choose();
  void Bind(std::uint32_t variable);
  /// From now on roots count as bound only if they are, and the expected numbers of values count.
  void EndRoots();

  /// How many conditions were looked at so far, for tests.
  std::uint64_t work() const { return work_; }

 private:
  struct Key {
    std::int64_t cost = 0, ahead = 0;
    bool positive = true;
    std::uint64_t age = 0;
    std::uint32_t at = 0;
    /// Of a max-heap: true if `other` comes first.
    bool operator<(const Key& other) const;
  };
  /// Over the conditions that use a variable: the least costs once it is bound.
  struct Least {
    std::int64_t first = kInfiniteCost, second = kInfiniteCost;
    std::uint32_t of = kNoVariable;  ///< The condition with the first.
  };
  using Missing = std::array<std::uint32_t, 3>;  ///< Sorted; unused entries are kNoVariable.

  void FindUsers();
  std::span<const std::uint32_t> Users(std::uint32_t variable) const;
  void ComputeAll();
  bool IsKnown(std::uint32_t variable) const;
  /// The cost of a condition if these variables were bound as well.
  std::int64_t Cost(std::uint32_t at, std::span<const std::uint32_t> added);
  void Recompute(std::uint32_t at);
  void NoteLeast(std::uint32_t at);
  void ReevaluateUsers(std::uint32_t variable);
  void ReevaluatePair(std::uint32_t a, std::uint32_t b);
  void CountMissing(std::uint32_t at);
  void Evaluate(std::uint32_t at);
  std::int64_t LeastWithBoth(std::uint32_t at, std::uint32_t a, std::uint32_t b);
  bool CompletesNegated(std::uint32_t at) const;
  std::size_t ScanAll();
  std::int64_t LookAheadByScan(std::uint32_t at);

  std::span<const QueuedCondition> conditions_;
  std::vector<bool> bound_, root_, placed_;
  bool roots_wait_ = false;
  bool started_ = false;
  std::vector<std::int64_t> cost_;
  std::vector<std::int64_t> ahead_;       ///< Look-ahead as queued; 0: not queued with the current cost.
  std::vector<std::uint32_t> missing_;    ///< Of negated conditions: how many of their needs are not bound.
  std::vector<Least> least_;              ///< By variable.
  std::vector<std::uint32_t> users_;      ///< By variable, the conditions that need it, in text order.
  std::vector<std::uint32_t> users_end_;  ///< Where those of each variable end in users_.
  std::multiset<Missing> negated_;        ///< What negated conditions miss that miss three variables at most.
  std::vector<Missing> noted_;            ///< Of negated conditions: their entry in negated_; else all kNoVariable.
  std::priority_queue<Key> ready_;        ///< Conditions with a finite cost; entries that changed are skipped.
  std::uint64_t work_ = 0;
};

}  // namespace soarbox::kernel
