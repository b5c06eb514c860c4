// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/learn/apoptosis.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace soarbox::kernel {

void Apoptosis::Set(const RlSettings& settings) {
  const bool was_on = on();
  mode_ = settings.apoptosis;
  if (on() && !was_on) {
    decay_ = settings.apoptosis_decay;
    lowest_ = std::exp(settings.apoptosis_threshold);
  }
  if (on() != was_on) Clear();
}

void Apoptosis::Clear() {
  decision_ = 1;
  used_.clear();
  histories_.clear();
  schedule_.clear();
}

double Apoptosis::Activation(const History& history, std::uint64_t decision) const {
  double sum = 0;
  std::uint64_t recent = 0, oldest = 0;
  for (std::size_t n = 0; n < history.kept; ++n) {
    const Use& use = history.uses[(history.next + kKept - 1 - n) % kKept];
    oldest = decision - use.decision;
    sum += static_cast<double>(use.count) * std::pow(static_cast<double>(oldest), -decay_);
    recent += use.count;
  }
  // The uses before the stored ones are assumed to be evenly distributed between the first use and the oldest stored
  // one (Petrov 2006).
  const std::uint64_t age = decision - history.first;
  if (history.total > recent && age > oldest) {
    const double power = 1 - decay_;
    const double area = std::pow(static_cast<double>(age), power) - std::pow(static_cast<double>(oldest), power);
    sum += static_cast<double>(history.total - recent) * area / (power * static_cast<double>(age - oldest));
  }
  return sum;
}

bool Apoptosis::IsDue(const History& history, std::uint64_t decision) const {
  return Activation(history, decision) < lowest_;
}

/// The first decision in which the activation will be below the threshold if the rule is not used again.
std::uint64_t Apoptosis::FindDue(const History& history) const {
  constexpr std::uint64_t kFarthest = std::uint64_t{1} << 40;
  std::uint64_t reach = 1;
  while (reach < kFarthest && !IsDue(history, decision_ + reach)) reach *= 2;
  std::uint64_t low = reach / 2, high = reach;  // Not due at low (or low is 0), due at high.
  while (high - low > 1) {
    const std::uint64_t middle = low + (high - low) / 2;
    (IsDue(history, decision_ + middle) ? high : low) = middle;
  }
  return decision_ + high;
}

void Apoptosis::Schedule(ProductionId rule, History& history) {
  history.due = FindDue(history);
  schedule_[history.due].push_back(rule);
}

void Apoptosis::Unschedule(ProductionId rule, History& history) {
  const auto at = schedule_.find(history.due);
  if (at == schedule_.end()) return;
  std::erase(at->second, rule);
  if (at->second.empty()) schedule_.erase(at);
  history.due = 0;
}

void Apoptosis::RuleExcised(ProductionId rule) {
  used_.erase(rule);
  const auto found = histories_.find(rule);
  if (found == histories_.end()) return;
  Unschedule(rule, found->second);
  histories_.erase(found);
}

std::vector<ProductionId> Apoptosis::EndDecision() {
  for (const auto& [rule, count] : used_) {
    History& history = histories_[rule];
    if (history.total == 0) history.first = decision_;
    history.uses[history.next] = {decision_, count};
    history.next = (history.next + 1) % kKept;
    history.kept = std::min(history.kept + 1, kKept);
    history.total += count;
    Unschedule(rule, history);
    Schedule(rule, history);
  }
  used_.clear();
  std::vector<ProductionId> due;
  if (!schedule_.empty() && schedule_.begin()->first <= decision_) {
    due = std::move(schedule_.begin()->second);
    schedule_.erase(schedule_.begin());
    for (const ProductionId rule : due) histories_[rule].due = 0;
    std::sort(due.begin(), due.end());
  }
  ++decision_;
  return due;
}

}  // namespace soarbox::kernel
