// SPDX-License-Identifier: BSD-2-Clause
#include "cli/reinforcement_settings.h"

#include <cmath>
#include <cstdlib>
#include <string_view>

#include "cli/summary.h"

namespace soarbox::cli {
namespace {

using kernel::RlSettings;

template <typename Choice>
struct ChoiceName {
  std::string_view name;
  Choice choice;
};

constexpr ChoiceName<kernel::RlPolicy> kPolicies[] = {
    {"sarsa", kernel::RlPolicy::kSarsa},
    {"q-learning", kernel::RlPolicy::kQLearning},
    {"on-policy-gq-lambda", kernel::RlPolicy::kOnPolicyGqLambda},
    {"off-policy-gq-lambda", kernel::RlPolicy::kOffPolicyGqLambda},
};
constexpr ChoiceName<kernel::RlDecay> kDecays[] = {
    {"normal", kernel::RlDecay::kNormal},
    {"exp", kernel::RlDecay::kExponential},
    {"log", kernel::RlDecay::kLogarithmic},
    {"delta-bar-delta", kernel::RlDecay::kDeltaBarDelta},
};
constexpr ChoiceName<kernel::ApoptosisMode> kApoptosis[] = {
    {"none", kernel::ApoptosisMode::kNone},
    {"chunks", kernel::ApoptosisMode::kChunks},
    {"rl-chunks", kernel::ApoptosisMode::kRlChunks},
};

template <typename Choice, std::size_t N>
void Read(const SettingStore& store, std::string_view name, const ChoiceName<Choice> (&names)[N], Choice& out) {
  const std::string value = store.Get("rl", name);
  for (const ChoiceName<Choice>& entry : names) {
    if (entry.name == value) out = entry.choice;
  }
}

bool IsLocked(const SettingStore& store, const std::string& name) {
  return (name == "apoptosis-decay" || name == "apoptosis-thresh") && store.Get("rl", "apoptosis") != "none";
}

}  // namespace

RlSetResult SetReinforcement(SettingStore& store, const std::string& name, const std::string& value) {
  const SettingInfo* const info = SettingStore::Find("rl", name);
  if (info == nullptr) return RlSetResult::kUnknown;
  std::string kept = value;
  if (info->kind == SettingKind::kReal) {
    double number = std::strtod(value.c_str(), nullptr);
    const bool is_threshold = name == "apoptosis-thresh";
    if (!std::isfinite(number) || (is_threshold && !(number > 0))) return RlSetResult::kInvalid;
    if (name == "eligibility-trace-tolerance" && !(number > 0)) return RlSetResult::kInvalid;
    if (is_threshold) number = -number;
    kept = Shortest(number);
  }
  if (IsLocked(store, name)) return RlSetResult::kLocked;
  return store.Set("rl", name, kept) == SettingStore::SetResult::kOk ? RlSetResult::kOk : RlSetResult::kInvalid;
}

RlSettings ReinforcementSettings(const SettingStore& store) {
  const auto on = [&](std::string_view name) { return store.IsOn("rl", name); };
  const auto real = [&](std::string_view name) { return std::strtod(store.Get("rl", name).c_str(), nullptr); };
  RlSettings settings;
  settings.learning = on("learning");
  settings.temporal_extension = on("temporal-extension");
  settings.temporal_discount = on("temporal-discount");
  settings.hrl_discount = on("hrl-discount");
  settings.meta = on("meta");
  settings.trace = on("trace");
  Read(store, "learning-policy", kPolicies, settings.policy);
  Read(store, "decay-mode", kDecays, settings.decay);
  Read(store, "apoptosis", kApoptosis, settings.apoptosis);
  settings.discount_rate = real("discount-rate");
  settings.learning_rate = real("learning-rate");
  settings.step_size = real("step-size-parameter");
  settings.trace_decay = real("eligibility-trace-decay-rate");
  settings.trace_tolerance = real("eligibility-trace-tolerance");
  settings.meta_learning_rate = real("meta-learning-rate");
  settings.apoptosis_decay = real("apoptosis-decay");
  settings.apoptosis_threshold = real("apoptosis-thresh");
  return settings;
}

}  // namespace soarbox::cli
