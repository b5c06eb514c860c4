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
/// The factor for each unbound field.
inline constexpr std::int64_t kUnboundCost = 8;

/// The properties of a condition that determine its place in the order.
struct QueuedCondition {
  bool positive = true;
  std::array<std::uint32_t, 3> fields = {kNoVariable, kNoVariable, kNoVariable};  ///< Variables of positive conditions.
  std::int64_t expected = 1;             ///< Expected number of values of its attribute, less than kInfiniteCost.
  std::uint64_t age = 0;                 ///< For positive conditions: the greater age wins ties. 0 if negated.
  std::span<const std::uint32_t> needs;  ///< Its variables, each once; see ListReorderer.
};

/// Chooses the next condition of a long list: the cheapest, with one step of look-ahead. The result equals that of a
/// scan of all waiting conditions (ListReorderer::Choose). But only costs that a new binding changes are recomputed: n
/// conditions that share few variables take O(n log n). Binding a variable never makes a condition more expensive.
/// Therefore the look-ahead of a condition is a minimum: that of its own cost and of the costs of the conditions that
/// use its variables, computed with these variables bound.
///
/// If no waiting condition is connected to a bound variable, which is an error in the rule, it scans all of them.
class ConditionQueue {
 public:
  /// Minimum number of conditions for which the queue is used.
  static constexpr std::size_t kFewest = 64;

  /// `conditions` is in text order and must outlive the queue. `variables` is the number of variables.
  ConditionQueue(std::span<const QueuedCondition> conditions, std::uint32_t variables);

  /// Call both before Start(). SetBound: the variable is bound. SetRoot: it is a root, which counts as bound until all
  /// roots are bound.
  void SetBound(std::uint32_t variable) { bound_[variable] = true; }
  void SetRoot(std::uint32_t variable) { root_[variable] = true; }
  /// `roots_wait`: some roots are not bound yet.
  void Start(bool roots_wait);

  struct Choice {
    std::size_t at = 0;
    std::int64_t cost = 0;
  };
  /// Removes the next condition; at least one must be waiting. The caller then binds its variables.
  Choice Choose();
  void Bind(std::uint32_t variable);
  /// All roots are bound. From now on a root counts as bound only if it is, and expected numbers of values count.
  void EndRoots();

  /// Number of conditions examined so far, for tests.
  std::uint64_t work() const { return work_; }

 private:
  struct Key {
    std::int64_t cost = 0, ahead = 0;
    bool positive = true;
    std::uint64_t age = 0;
    std::uint32_t at = 0;
    /// Order of a max-heap: returns true if `other` is to be chosen first.
    bool operator<(const Key& other) const;
  };
  /// The two smallest costs among the conditions that use a variable, computed as if it were bound.
  struct Least {
    std::int64_t first = kInfiniteCost, second = kInfiniteCost;
    std::uint32_t of = kNoVariable;  ///< The condition with the smallest cost, `first`.
  };
  using Missing = std::array<std::uint32_t, 3>;  ///< Sorted; unused entries are kNoVariable.

  void FindUsers();
  std::span<const std::uint32_t> Users(std::uint32_t variable) const;
  void ComputeAll();
  bool IsKnown(std::uint32_t variable) const;
  /// The cost of a condition if the variables `added` were bound as well.
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
  std::vector<std::int64_t> ahead_;       ///< Look-ahead as queued; 0: not queued with its current cost.
  std::vector<std::uint32_t> missing_;    ///< For negated conditions: number of unbound variables in their needs.
  std::vector<Least> least_;              ///< By variable.
  std::vector<std::uint32_t> users_;      ///< By variable, the conditions that need it, in text order.
  std::vector<std::uint32_t> users_end_;  ///< By variable: the end of its conditions in users_.
  std::multiset<Missing> negated_;        ///< The unbound variables of negated conditions that have three or fewer.
  std::vector<Missing> noted_;            ///< For negated conditions: their entry in negated_; else all kNoVariable.
  std::priority_queue<Key> ready_;        ///< Conditions with a finite cost. Outdated entries are skipped.
  std::uint64_t work_ = 0;
};

}  // namespace soarbox::kernel
