// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/activations.h"

#include <algorithm>
#include <cmath>

namespace soarbox::kernel {

Activations::Touched& Activations::RecordOf(std::uint32_t object) {
  const auto next = static_cast<std::uint32_t>(records_.size());
  const std::uint32_t at = by_object_.FindOrAdd(object + 1ull, next);
  if (at == next) {
    records_.emplace_back();
    records_.back().object = object;
  }
  return records_[at];
}

double Activations::UnusedStrength() const {
  return std::pow(static_cast<double>(tick_ + 1) + settings_.base_unused_age_offset, -settings_.base_decay);
}

double Activations::BaseLevel(const Touched& record) const {
  const double d = settings_.base_decay;
  const auto power = [&](double age) {
    age = std::max(age, 1.0);
    return d == 0.5 ? 1 / std::sqrt(age) : std::pow(age, -d);
  };
  const double now = static_cast<double>(tick_ + 1);
  double sum = 0;
  if (record.count == 0) {
    sum = power(now + settings_.base_unused_age_offset);
  } else {
    const std::size_t kept = std::min<std::size_t>(record.count, kHistory);
    for (std::size_t n = 0; n < kept; ++n) sum += power(now - static_cast<double>(record.ticks[n]));
    if (record.count > kHistory) {
      // The older touches are assumed to be evenly distributed between the first one and the oldest stored one.
      const double oldest = now - static_cast<double>(record.first);
      const double recent = now - static_cast<double>(record.ticks[kHistory - 1]);
      const double older = static_cast<double>(record.count - kHistory);
      if (oldest > recent) {
        sum += d == 1 ? older * std::log(oldest / recent) / (oldest - recent)
                      : older * (std::pow(oldest, 1 - d) - std::pow(recent, 1 - d)) / ((1 - d) * (oldest - recent));
      }
    }
  }
  const double base = std::log(sum / (1 + sum));
  if (!settings_.base_inhibition || record.count == 0) return base;
  // A recently used object is inhibited for a while.
  const double odds = 1 / (1 + 10 / (now - static_cast<double>(record.ticks[0])));
  return base + std::log(odds / (1 + odds));
}

bool Activations::Touch(std::uint32_t object, bool advance) {
  const bool first = Find(object) == nullptr;
  Touched& record = RecordOf(object);
  if (!advance) {
    // Storing does not count as a use: it only recomputes the activation. An object that was never used is as old as
    // the clock.
    ++updates_;
    const bool is_counted = settings_.activation_mode == ActivationMode::kFrequency && record.count > 0;
    record.activation = settings_.activation_mode == ActivationMode::kRecency ? static_cast<double>(tick_ + 1)
                        : is_counted                                          ? static_cast<double>(record.count)
                                                                              : BaseLevel(record);
    return first;
  }
  if (record.forget_last) {
    record.forget_last = false;
    // (Frequency counts all uses, including undone ones.)
    if (record.count > 0 && settings_.activation_mode == ActivationMode::kBaseLevel) {
      std::copy(record.ticks.begin() + 1, record.ticks.end(), record.ticks.begin());
      --record.count;
    }
  }
  const std::uint64_t now = ++tick_;
  std::copy_backward(record.ticks.begin(), record.ticks.end() - 1, record.ticks.end());
  record.ticks[0] = now;
  if (record.count++ == 0) record.first = now;
  ++updates_;
  switch (settings_.activation_mode) {
    case ActivationMode::kRecency:
      record.activation = static_cast<double>(now);
      break;
    case ActivationMode::kFrequency:
      record.activation = static_cast<double>(record.count);
      break;
    case ActivationMode::kBaseLevel:
      record.activation = BaseLevel(record);
      if (settings_.base_update_policy != BaseUpdatePolicy::kIncremental) break;
      if (object_of_tick_.empty()) first_tick_ = tick_;
      object_of_tick_.push_back(object);
      for (const std::uint64_t age : settings_.base_incremental_threshes) {
        if (age == 0 || tick_ < first_tick_ + age) continue;
        const std::uint64_t then = tick_ - age;
        if (then - first_tick_ >= object_of_tick_.size()) continue;
        const std::uint32_t other = object_of_tick_[then - first_tick_];
        if (other != object && Find(other)->ticks[0] == then) Update(other);
      }
      break;
  }
  return first;
}

void Activations::Update(std::uint32_t object) {
  Touched& record = RecordOf(object);
  record.activation = BaseLevel(record);
  ++updates_;
}

void Activations::Prohibit(std::uint32_t object) {
  // If an object was never used, there is no use to undo.
  if (Find(object) != nullptr) RecordOf(object).forget_last = true;
}

void Activations::Restore(std::uint64_t tick, std::span<const Touched> records) {
  Clear();
  tick_ = tick;
  for (const Touched& record : records) RecordOf(record.object) = record;
}

void Activations::Clear() {
  records_.clear();
  by_object_.Clear();
  object_of_tick_.clear();
  tick_ = updates_ = 0;
}

}  // namespace soarbox::kernel
