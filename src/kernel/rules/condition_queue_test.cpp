// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/rules/condition_queue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace soarbox::kernel {
namespace {

/// A list of conditions as a rule passes it to the queue.
struct Conditions {
  std::vector<QueuedCondition> list;
  std::vector<std::vector<std::uint32_t>> needs;
  std::uint32_t variables = 0;
  std::vector<std::uint32_t> roots;

  void Add(std::array<std::uint32_t, 3> fields, std::uint64_t age = 0, std::int64_t expected = 1) {
    std::vector<std::uint32_t>& mine = needs.emplace_back();
    for (const std::uint32_t field : fields) {
      if (field != kNoVariable && std::ranges::find(mine, field) == mine.end()) mine.push_back(field);
    }
    list.push_back({true, fields, expected, age, {}});
  }
  void AddNegated(std::vector<std::uint32_t> variables_needed) {
    needs.push_back(std::move(variables_needed));
    list.push_back({false, {kNoVariable, kNoVariable, kNoVariable}, 1, 0, {}});
  }
  void Finish() {
    for (std::size_t n = 0; n < list.size(); ++n) list[n].needs = needs[n];
  }
};

constexpr std::uint32_t kState = 0;

/// Chooses by comparing all waiting conditions in each step.
class NaiveChooser {
 public:
  explicit NaiveChooser(const Conditions& conditions)
      : conditions_(conditions), bound_(conditions.variables), root_(conditions.variables) {
    for (std::uint32_t n = 0; n < conditions.list.size(); ++n) waiting_.push_back(n);
    for (const std::uint32_t root : conditions.roots) root_[root] = true;
    roots_wait_ = !conditions.roots.empty();
  }

  std::vector<std::uint32_t> Order() {
    std::vector<std::uint32_t> order;
    while (!waiting_.empty()) {
      const std::uint32_t next = Next();
      order.push_back(next);
      std::erase(waiting_, next);
      Bind(next);
      roots_wait_ = roots_wait_ && !std::ranges::all_of(conditions_.roots, [&](auto root) { return bound_[root]; });
    }
    return order;
  }

 private:
  bool IsKnown(std::uint32_t variable) const {
    return variable == kNoVariable || bound_[variable] || (roots_wait_ && root_[variable]);
  }
  std::int64_t Cost(std::uint32_t at) const {
    const QueuedCondition& condition = conditions_.list[at];
    if (!condition.positive) {
      return std::ranges::all_of(condition.needs, [&](auto variable) { return bound_[variable]; }) ? 1 : kInfiniteCost;
    }
    if (!IsKnown(condition.fields[0])) return kInfiniteCost;
    const std::int64_t values = roots_wait_ ? 1 : condition.expected;
    return (IsKnown(condition.fields[1]) ? values : kUnboundCost) * (IsKnown(condition.fields[2]) ? 1 : kUnboundCost);
  }
  void Bind(std::uint32_t at) {
    for (const std::uint32_t field : conditions_.list[at].fields) {
      if (field != kNoVariable) bound_[field] = true;
    }
  }
  std::int64_t LookAhead(std::uint32_t at) {
    const std::vector<bool> before = bound_;
    Bind(at);
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    for (const std::uint32_t other : waiting_) {
      if (other != at) least = std::min(least, Cost(other));
    }
    bound_ = before;
    return least;
  }
  std::uint32_t Next() {
    std::int64_t cheapest = std::numeric_limits<std::int64_t>::max();
    std::vector<std::uint32_t> tied;
    for (std::size_t n = waiting_.size(); n-- > 0;) {
      const std::int64_t cost = Cost(waiting_[n]);
      if (cost < cheapest) tied.clear();
      cheapest = std::min(cheapest, cost);
      if (cost == cheapest) tied.push_back(waiting_[n]);
    }
    std::uint32_t best = tied[0];
    const bool looks_ahead = cheapest > 1 && tied.size() > 1;
    std::int64_t best_ahead = looks_ahead ? LookAhead(best) : 0;
    for (std::size_t n = 1; n < tied.size(); ++n) {
      const QueuedCondition &held = conditions_.list[best], &candidate = conditions_.list[tied[n]];
      const bool is_newer = held.age < candidate.age;
      const std::int64_t ahead = looks_ahead ? LookAhead(tied[n]) : 0;
      const bool replaces =
          looks_ahead ? ahead < best_ahead || (ahead == best_ahead && held.positive && candidate.positive && is_newer)
                      : held.positive && (!candidate.positive || is_newer);
      if (replaces) {
        best = tied[n];
        best_ahead = ahead;
      }
    }
    return best;
  }

  const Conditions& conditions_;
  std::vector<bool> bound_, root_;
  std::vector<std::uint32_t> waiting_;
  bool roots_wait_ = false;
};

struct QueueOrder {
  std::vector<std::uint32_t> order;
  std::uint64_t work = 0;
};

QueueOrder OrderByQueue(const Conditions& conditions) {
  ConditionQueue queue(conditions.list, conditions.variables);
  std::size_t unbound = conditions.roots.size();
  std::vector<bool> bound(conditions.variables);
  for (const std::uint32_t root : conditions.roots) queue.SetRoot(root);
  queue.Start(unbound != 0);
  QueueOrder out;
  for (std::size_t n = 0; n < conditions.list.size(); ++n) {
    const ConditionQueue::Choice choice = queue.Choose();
    out.order.push_back(static_cast<std::uint32_t>(choice.at));
    const bool waited = unbound != 0;
    for (const std::uint32_t field : conditions.list[choice.at].fields) {
      if (field == kNoVariable || bound[field]) continue;
      bound[field] = true;
      unbound -= std::ranges::find(conditions.roots, field) != conditions.roots.end() ? 1 : 0;
      queue.Bind(field);
    }
    if (waited && unbound == 0) queue.EndRoots();
  }
  out.work = queue.work();
  return out;
}

Conditions RandomConditions(std::mt19937& random) {
  const auto below = [&](std::uint32_t end) { return static_cast<std::uint32_t>(random() % end); };
  Conditions out;
  const std::uint32_t count = 1 + below(14);
  out.variables = 1 + below(12);
  const auto variable = [&](std::uint32_t in_100) { return below(100) < in_100 ? below(out.variables) : kNoVariable; };
  for (std::uint32_t n = 0; n < count; ++n) {
    if (below(4) == 0) {
      std::vector<std::uint32_t> needs;
      for (std::uint32_t candidate = 0; candidate < out.variables; ++candidate) {
        if (below(4) == 0) needs.push_back(candidate);
      }
      out.AddNegated(std::move(needs));
    } else {
      const std::uint32_t attribute = variable(20);
      out.Add({variable(97), attribute, variable(70)}, below(3),
              attribute == kNoVariable && below(4) == 0 ? 1 + below(12) : 1);
    }
  }
  for (std::uint32_t root = 0; root < out.variables; ++root) {
    if (root == kState || below(8) == 0) out.roots.push_back(root);
  }
  // Roots are identifiers of positive conditions.
  std::erase_if(out.roots, [&](std::uint32_t root) {
    return std::ranges::none_of(out.list, [&](const auto& item) { return item.positive && item.fields[0] == root; });
  });
  out.Finish();
  return out;
}

TEST(ConditionQueue, ChoosesWhatAScanOfAllConditionsChooses) {
  std::mt19937 random(7);
  for (int round = 0; round < 5000; ++round) {
    const Conditions conditions = RandomConditions(random);
    ASSERT_EQ(OrderByQueue(conditions).order, NaiveChooser(conditions).Order()) << "round " << round;
  }
}

/// A path: (<s> ^a <v0>) (<v0> ^a <v1>) ...
Conditions Path(std::uint32_t length) {
  Conditions out;
  out.variables = length + 1;
  out.roots = {kState};
  for (std::uint32_t n = 0; n < length; ++n) out.Add({n, kNoVariable, n + 1});
  out.Finish();
  return out;
}

/// (<s> ^a <v0> ^a <v1> ...), each with (<v0> ^b <w0>) and a negated condition.
Conditions Star(std::uint32_t rays) {
  Conditions out;
  out.variables = 1 + 2 * rays;
  out.roots = {kState};
  for (std::uint32_t n = 0; n < rays; ++n) {
    out.Add({kState, kNoVariable, 1 + 2 * n}, n);
    out.Add({1 + 2 * n, kNoVariable, 2 + 2 * n}, n);
    out.AddNegated({1 + 2 * n, 2 + 2 * n});
  }
  out.Finish();
  return out;
}

/// Attributes that are variables: (<s> ^<a0> <b0> ^<a1> <b1> ...)
Conditions Unnamed(std::uint32_t count) {
  Conditions out;
  out.variables = 1 + 2 * count;
  out.roots = {kState};
  for (std::uint32_t n = 0; n < count; ++n) out.Add({kState, 1 + 2 * n, 2 + 2 * n});
  out.Finish();
  return out;
}

/// All conditions test one value: (<s> ^a <v> ^b <v> ...)
Conditions OneValue(std::uint32_t count) {
  Conditions out;
  out.variables = 2;
  out.roots = {kState};
  for (std::uint32_t n = 0; n < count; ++n) out.Add({kState, kNoVariable, 1}, n);
  out.Finish();
  return out;
}

TEST(ConditionQueue, TwiceAsManyConditionsTakeTwiceTheWork) {
  for (const auto make : {&Path, &Star, &Unnamed, &OneValue}) {
    const std::uint64_t once = OrderByQueue(make(2000)).work, twice = OrderByQueue(make(4000)).work;
    EXPECT_LT(twice, once * 2 + once / 10);
    EXPECT_GT(twice, 4000u);
  }
}

TEST(ConditionQueue, OrdersLongListsAsAScanDoes) {
  for (const auto make : {&Path, &Star, &Unnamed, &OneValue}) {
    const Conditions conditions = make(70);
    EXPECT_EQ(OrderByQueue(conditions).order, NaiveChooser(conditions).Order());
  }
}

}  // namespace
}  // namespace soarbox::kernel
