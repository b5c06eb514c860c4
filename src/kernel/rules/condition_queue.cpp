// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/rules/condition_queue.h"

#include <algorithm>
#include <tuple>

namespace soarbox::kernel {

namespace {

constexpr std::array<std::uint32_t, 3> kNothing = {kNoVariable, kNoVariable, kNoVariable};

bool Has(std::span<const std::uint32_t> variables, std::uint32_t variable) {
  return std::ranges::find(variables, variable) != variables.end();
}

}  // namespace

bool ConditionQueue::Key::operator<(const Key& other) const {
  return std::tuple(cost, ahead, positive, ~age, ~at) >
         std::tuple(other.cost, other.ahead, other.positive, ~other.age, ~other.at);
}

ConditionQueue::ConditionQueue(std::span<const QueuedCondition> conditions, std::uint32_t variables)
    : conditions_(conditions),
      bound_(variables),
      root_(variables),
      placed_(conditions.size()),
      cost_(conditions.size()),
      ahead_(conditions.size()),
      missing_(conditions.size()),
      least_(variables),
      users_end_(variables + 1u),
      noted_(conditions.size(), kNothing) {
  FindUsers();
}

void ConditionQueue::FindUsers() {
  for (const QueuedCondition& condition : conditions_) {
    for (const std::uint32_t variable : condition.needs) {
      ++users_end_[variable + 1];
    }
  }
  for (std::size_t n = 1; n < users_end_.size(); ++n) {
    users_end_[n] += users_end_[n - 1];
  }
  users_.resize(users_end_.back());
  for (std::uint32_t at = 0; at < conditions_.size(); ++at) {
    for (const std::uint32_t variable : conditions_[at].needs) {
      users_[users_end_[variable]++] = at;
    }
  }
}

std::span<const std::uint32_t> ConditionQueue::Users(std::uint32_t variable) const {
  const std::uint32_t begin = variable == 0 ? 0 : users_end_[variable - 1];
  return std::span(users_).subspan(begin, users_end_[variable] - begin);
}

void ConditionQueue::Start(bool roots_wait) {
  roots_wait_ = roots_wait;
  ComputeAll();
}

void ConditionQueue::EndRoots() {
  roots_wait_ = false;
  ComputeAll();
}

/// Computes the costs first, then the look-aheads, which depend on them.
void ConditionQueue::ComputeAll() {
  started_ = false;
  ready_ = {};
  negated_.clear();
  std::ranges::fill(noted_, kNothing);
  std::ranges::fill(least_, Least());
  for (std::uint32_t at = 0; at < conditions_.size(); ++at) {
    if (!placed_[at]) {
      Recompute(at);
    }
  }
  started_ = true;
  for (std::uint32_t at = 0; at < conditions_.size(); ++at) {
    if (!placed_[at]) {
      Evaluate(at);
    }
  }
}

bool ConditionQueue::IsKnown(std::uint32_t variable) const {
  return variable == kNoVariable || bound_[variable] || (roots_wait_ && root_[variable]);
}

std::int64_t ConditionQueue::Cost(std::uint32_t at, std::span<const std::uint32_t> added) {
  ++work_;
  const QueuedCondition& condition = conditions_[at];
  if (!condition.positive) {
    if (missing_[at] > added.size()) {
      return kInfiniteCost;
    }
    const bool covered = std::ranges::all_of(
        condition.needs, [&](std::uint32_t variable) { return bound_[variable] || Has(added, variable); });
    return covered ? 1 : kInfiniteCost;
  }
  const auto is_known = [&](std::uint32_t variable) { return IsKnown(variable) || Has(added, variable); };
  if (!is_known(condition.fields[0])) {
    return kInfiniteCost;
  }
  const std::int64_t values = roots_wait_ ? 1 : condition.expected;
  return (is_known(condition.fields[1]) ? values : kUnboundCost) * (is_known(condition.fields[2]) ? 1 : kUnboundCost);
}

/// Recomputes the cost of a condition and its effect on the look-ahead of others.
void ConditionQueue::Recompute(std::uint32_t at) {
  ahead_[at] = 0;
  if (conditions_[at].positive) {
    cost_[at] = Cost(at, {});
    NoteLeast(at);
  } else {
    CountMissing(at);
    cost_[at] = missing_[at] == 0 ? 1 : kInfiniteCost;
  }
  if (started_) {
    Evaluate(at);
  }
}

void ConditionQueue::NoteLeast(std::uint32_t at) {
  std::array<std::uint32_t, 3> unknown = kNothing;
  std::size_t count = 0;
  for (const std::uint32_t variable : conditions_[at].needs) {
    if (!IsKnown(variable)) {
      unknown[count++] = variable;
    }
  }
  for (std::size_t n = 0; n < count; ++n) {
    Least& least = least_[unknown[n]];
    const std::int64_t cost = Cost(at, std::span(unknown).subspan(n, 1));
    const Least before = least;
    if (least.of == at) {
      least.first = std::min(least.first, cost);
    } else if (cost < least.first) {
      least = {cost, least.first, at};
    } else {
      least.second = std::min(least.second, cost);
    }
    if (started_ && (before.first != least.first || before.second != least.second)) {
      ReevaluateUsers(unknown[n]);
    }
  }
  for (std::size_t n = 0; started_ && count > 1 && n < count; ++n) {
    for (std::size_t other = n + 1; other < count; ++other) {
      ReevaluatePair(unknown[n], unknown[other]);
    }
  }
}

void ConditionQueue::ReevaluateUsers(std::uint32_t variable) {
  for (const std::uint32_t user : Users(variable)) {
    if (!placed_[user] && conditions_[user].positive && cost_[user] > 1 && cost_[user] < kInfiniteCost) {
      Evaluate(user);
    }
  }
}

void ConditionQueue::ReevaluatePair(std::uint32_t a, std::uint32_t b) {
  if (Users(b).size() < Users(a).size()) {
    std::swap(a, b);
  }
  for (const std::uint32_t user : Users(a)) {
    if (!placed_[user] && conditions_[user].positive && Has(conditions_[user].needs, b)) {
      Evaluate(user);
    }
  }
}

/// Records the unbound variables of a negated condition if there are three or fewer, so that one condition can bind
/// them.
void ConditionQueue::CountMissing(std::uint32_t at) {
  std::uint32_t& count = missing_[at];
  if (started_ && count > kNothing.size() + 1) {
    --count;
    return;
  }
  Missing missing = kNothing;
  count = 0;
  for (const std::uint32_t variable : conditions_[at].needs) {
    ++work_;
    if (!bound_[variable]) {
      missing[std::min<std::size_t>(count, missing.size() - 1)] = variable;
      ++count;
    }
  }
  if (count == 0 || count > missing.size()) {
    return;
  }
  std::ranges::sort(missing);
  const bool is_new = !negated_.contains(missing);
  negated_.insert(missing);
  noted_[at] = missing;
  if (!started_ || !is_new) {
    return;
  }
  std::uint32_t rarest = missing[0];
  for (std::uint32_t n = 1; n < count; ++n) {
    rarest = Users(missing[n]).size() < Users(rarest).size() ? missing[n] : rarest;
  }
  ReevaluateUsers(rarest);
}

/// Computes the look-ahead of a condition from the costs of the others, and queues the condition.
void ConditionQueue::Evaluate(std::uint32_t at) {
  ++work_;
  if (cost_[at] >= kInfiniteCost) {
    return;
  }
  std::int64_t least = cost_[at];
  if (least > 1) {
    const std::uint32_t a = conditions_[at].fields[1], b = conditions_[at].fields[2];
    for (const std::uint32_t variable : {a, b}) {
      if (!IsKnown(variable)) {
        const Least& known = least_[variable];
        least = std::min(least, known.of == at ? known.second : known.first);
      }
    }
    if (least > 1 && a != b && !IsKnown(a) && !IsKnown(b)) {
      least = std::min(least, LeastWithBoth(at, a, b));
    }
    if (least > 1 && !negated_.empty() && CompletesNegated(at)) {
      least = 1;
    }
  }
  if (ahead_[at] == least) {
    return;
  }
  ahead_[at] = least;
  ready_.push({cost_[at], least, conditions_[at].positive, conditions_[at].age, at});
}

/// The lowest cost of another condition that uses both variables, computed with both bound.
std::int64_t ConditionQueue::LeastWithBoth(std::uint32_t at, std::uint32_t a, std::uint32_t b) {
  if (Users(b).size() < Users(a).size()) {
    std::swap(a, b);
  }
  std::int64_t least = kInfiniteCost;
  const std::array<std::uint32_t, 2> both = {a, b};
  for (const std::uint32_t user : Users(a)) {
    if (user != at && !placed_[user] && conditions_[user].positive && Has(conditions_[user].needs, b)) {
      least = std::min(least, Cost(user, both));
      if (least == 1) {
        break;
      }
    }
  }
  return least;
}

/// Returns true if the condition binds all unbound variables of some negated condition.
bool ConditionQueue::CompletesNegated(std::uint32_t at) const {
  std::array<std::uint32_t, 3> unbound = kNothing;
  std::size_t count = 0;
  for (const std::uint32_t variable : conditions_[at].needs) {
    if (!bound_[variable]) {
      unbound[count++] = variable;
    }
  }
  for (std::uint32_t chosen = 1; chosen < (1u << count); ++chosen) {
    Missing missing = kNothing;
    for (std::size_t n = 0; n < count; ++n) {
      missing[n] = (chosen >> n & 1u) != 0 ? unbound[n] : kNoVariable;
    }
    std::ranges::sort(missing);
    if (negated_.contains(missing)) {
      return true;
    }
  }
  return false;
}

ConditionQueue::Choice ConditionQueue::Choose() {
  std::size_t at = conditions_.size();
  while (!ready_.empty() && at == conditions_.size()) {
    const Key top = ready_.top();
    ready_.pop();
    if (!placed_[top.at] && cost_[top.at] == top.cost && ahead_[top.at] == top.ahead) {
      at = top.at;
    }
  }
  if (at == conditions_.size()) {
    at = ScanAll();
  }
  placed_[at] = true;
  if (noted_[at] != kNothing && missing_[at] != 0) {
    // It is placed too early, so no condition can complete it any more.
    negated_.erase(negated_.find(noted_[at]));
    ReevaluateUsers(noted_[at][0]);
  }
  return {at, cost_[at]};
}

void ConditionQueue::Bind(std::uint32_t variable) {
  if (variable == kNoVariable || bound_[variable]) {
    return;
  }
  bound_[variable] = true;
  for (const std::uint32_t user : Users(variable)) {
    if (!placed_[user]) {
      Recompute(user);
    }
  }
}

/// Chooses the next condition if none is connected to a bound variable.
std::size_t ConditionQueue::ScanAll() {
  std::size_t best = conditions_.size();
  std::int64_t best_ahead = 0;
  for (std::size_t at = conditions_.size(); at-- > 0;) {
    if (placed_[at]) {
      continue;
    }
    const std::int64_t ahead = LookAheadByScan(static_cast<std::uint32_t>(at));
    const QueuedCondition& candidate = conditions_[at];
    if (best == conditions_.size() || ahead < best_ahead ||
        (ahead == best_ahead && conditions_[best].positive && candidate.positive &&
         conditions_[best].age < candidate.age)) {
      best = at;
      best_ahead = ahead;
    }
  }
  return best;
}

std::int64_t ConditionQueue::LookAheadByScan(std::uint32_t at) {
  std::array<std::uint32_t, 3> added = kNothing;
  std::size_t count = 0;
  for (const std::uint32_t field : conditions_[at].fields) {
    if (field != kNoVariable && !bound_[field] && !Has(added, field)) {
      added[count++] = field;
    }
  }
  const std::span<const std::uint32_t> bound = std::span(added).first(count);
  std::int64_t least = kInfiniteCost;
  for (const std::uint32_t variable : bound) {
    for (const std::uint32_t user : Users(variable)) {
      if (user != at && !placed_[user] && least > 1) {
        least = std::min(least, Cost(user, bound));
      }
    }
  }
  return least;
}

}  // namespace soarbox::kernel
