// SPDX-License-Identifier: BSD-2-Clause
#include "cli/setting_store.h"

#include <algorithm>
#include <cstdlib>
#include <string>

#include "cli/lookup.h"
#include "cli/summary.h"

namespace soarbox::cli {
namespace {

using enum SettingKind;

/// The smallest allowed value above zero.
constexpr double kAboveZero = 1e-300;

constexpr SettingInfo kSettings[] = {
    {"soar", "max-memory-usage", kInteger, "100000000", {}, 1},
    {"soar", "tcl", kSwitch, "off"},
    {"soar", "timers", kSwitch, "on"},

    {"chunk", "mode", kChoice, "never", "always never only except flagged unflagged"},
    {"chunk", "bottom-only", kSwitch, "off"},
    {"chunk", "naming-style", kChoice, "rule", "rule numbered"},
    {"chunk", "max-chunks", kInteger, "50", {}, 1},
    {"chunk", "max-dupes", kInteger, "3", {}, 1},
    {"chunk", "interrupt", kSwitch, "off"},
    {"chunk", "explain-interrupt", kSwitch, "off"},
    {"chunk", "warning-interrupt", kSwitch, "off"},
    {"chunk", "automatically-create-singletons", kSwitch, "on"},
    {"chunk", "add-ltm-links", kSwitch, "off"},
    {"chunk", "add-osk", kSwitch, "on"},
    {"chunk", "allow-local-negations", kSwitch, "on"},
    {"chunk", "allow-opaque", kSwitch, "on"},

    {"explain", "all", kSwitch, "off"},
    {"explain", "justifications", kSwitch, "off"},
    {"explain", "only-chunk-identities", kSwitch, "on"},

    {"rl", "learning", kSwitch, "off"},
    {"rl", "temporal-extension", kSwitch, "on"},
    {"rl", "discount-rate", kReal, "0.9", {}, 0, 1},
    {"rl", "learning-policy", kChoice, "sarsa", "sarsa q-learning off-policy-gq-lambda on-policy-gq-lambda"},
    {"rl", "learning-rate", kReal, "0.3", {}, 0, 1},
    {"rl", "hrl-discount", kSwitch, "off"},
    {"rl", "step-size-parameter", kReal, "1", {}, 0, 1},
    {"rl", "eligibility-trace-decay-rate", kReal, "0", {}, 0, 1},
    {"rl", "eligibility-trace-tolerance", kReal, "0.001", {}, 0},
    {"rl", "chunk-stop", kSwitch, "on"},
    {"rl", "decay-mode", kChoice, "normal", "normal exp log delta-bar-delta"},
    {"rl", "meta", kSwitch, "off"},
    {"rl", "meta-learning-rate", kReal, "0.1", {}, 0, 1},
    {"rl", "update-log-path", kText, ""},
    // These two come before `apoptosis`, because a saved file sets them in this order, and they cannot change while it
    // is on.
    {"rl", "apoptosis-decay", kReal, "0.5", {}, 0, 1},
    {"rl", "apoptosis-thresh", kReal, "-2"},
    {"rl", "apoptosis", kChoice, "none", "none chunks rl-chunks"},
    {"rl", "temporal-discount", kSwitch, "on"},
    {"rl", "trace", kSwitch, "off"},

    {"smem", "learning", kSwitch, "off"},
    {"smem", "database", kChoice, "memory", "memory file"},
    {"smem", "append", kSwitch, "on"},
    {"smem", "path", kText, ""},
    {"smem", "activation-mode", kChoice, "recency", "recency frequency base-level"},
    {"smem", "activate-on-query", kSwitch, "on"},
    {"smem", "activate-on-add", kSwitch, "off"},
    {"smem", "base-decay", kReal, "0.5", {}, kAboveZero},
    {"smem", "base-update-policy", kChoice, "stable", "stable naive incremental"},
    {"smem", "base-incremental-threshes", kText, "10"},
    {"smem", "thresh", kInteger, "100", {}, 0},
    {"smem", "base-inhibition", kSwitch, "off"},
    {"smem", "initial-variable-id", kInteger, "1", {}, 1},
    {"smem", "base-unused-age-offset", kInteger, "0", {}, 0},
    {"smem", "spreading", kSwitch, "off"},
    {"smem", "spreading-limit", kInteger, "300", {}, 0},
    {"smem", "spreading-depth-limit", kInteger, "10", {}, 0},
    {"smem", "spreading-baseline", kReal, "0.0001", {}, kAboveZero},
    {"smem", "spreading-continue-probability", kReal, "0.9", {}, kAboveZero},
    {"smem", "spreading-loop-avoidance", kSwitch, "off"},
    {"smem", "spreading-edge-updating", kSwitch, "off"},
    {"smem", "spreading-wma-source", kSwitch, "off"},
    {"smem", "spreading-edge-update-factor", kReal, "0.99", {}, kAboveZero},
    {"smem", "lazy-commit", kSwitch, "on"},
    {"smem", "optimization", kChoice, "performance", "safety performance"},
    {"smem", "cache-size", kInteger, "10000", {}, 1},
    {"smem", "page-size", kChoice, "8k", "1k 2k 4k 8k 16k 32k 64k"},
    {"smem", "timers", kChoice, "off", "off one two three"},

    {"epmem", "learning", kSwitch, "off"},
    {"epmem", "phase", kChoice, "output", "output selection"},
    {"epmem", "trigger", kChoice, "dc", "none output dc"},
    {"epmem", "force", kChoice, "off", "off remember ignore"},
    {"epmem", "exclusions", kText, "epmem, smem"},
    {"epmem", "database", kChoice, "memory", "memory file"},
    {"epmem", "append", kSwitch, "off"},
    {"epmem", "path", kText, ""},
    {"epmem", "lazy-commit", kSwitch, "on"},
    {"epmem", "balance", kReal, "1", {}, 0, 1},
    {"epmem", "graph-match", kSwitch, "on"},
    {"epmem", "graph-match-ordering", kChoice, "undefined", "undefined dfs mcv"},
    {"epmem", "page-size", kChoice, "8k", "1k 2k 4k 8k 16k 32k 64k"},
    {"epmem", "cache-size", kInteger, "10000", {}, 1},
    {"epmem", "optimization", kChoice, "performance", "safety performance"},
    {"epmem", "timers", kChoice, "off", "off one two three"},
    {"epmem", "merge", kChoice, "none", "none add"},

    {"wma", "activation", kSwitch, "off"},
    {"wma", "decay-rate", kReal, "-0.5", {}, -1, 0},
    {"wma", "petrov-approx", kSwitch, "off"},
    {"wma", "decay-thresh", kReal, "-2"},
    {"wma", "forgetting", kChoice, "off", "off naive bsearch on"},
    {"wma", "forget-wme", kChoice, "all", "all lti"},
    {"wma", "fake-forgetting", kSwitch, "off"},
    {"wma", "timers", kChoice, "off", "off one"},
    {"wma", "max-pow-cache", kInteger, "10", {}, 1},

    {"visualize", "rule-format", kChoice, "full", "name full"},
    {"visualize", "memory-format", kChoice, "record", "node record"},
    {"visualize", "line-style", kText, "polyline"},
    {"visualize", "separate-states", kSwitch, "on"},
    {"visualize", "architectural-wmes", kSwitch, "off"},
    {"visualize", "color-identities", kSwitch, "off"},
    {"visualize", "use-joined-identities", kSwitch, "on"},
    {"visualize", "file-name", kText, "soar_viz"},
    {"visualize", "use-same-file", kSwitch, "off"},
    {"visualize", "generate-image", kSwitch, "on"},
    {"visualize", "image-type", kText, "svg"},
    {"visualize", "viewer-launch", kSwitch, "on"},
    {"visualize", "editor-launch", kSwitch, "off"},
    {"visualize", "print-debug", kSwitch, "off"},
};

std::string Key(std::string_view group, std::string_view name) {
  return std::string(group) + " " + std::string(name);
}

bool IsChoice(std::string_view choices, std::string_view value) {
  if (value.empty() || value.find(' ') != std::string_view::npos) return false;
  const std::string padded = " " + std::string(choices) + " ";
  return padded.find(" " + std::string(value) + " ") != std::string::npos;
}

/// The settings of long-term memories and of activation use the numeric prefix of a word, as in Soar 9.6.3: 8k is 8,
/// and a word without a number is 0.
std::string AsNumber(const SettingInfo& info, const std::string& value) {
  // Limits of learning use the part before the decimal point.
  if (info.group == "chunk" && info.kind == kInteger && ParseDouble(value)) return value.substr(0, value.find('.'));
  if (info.group != "smem" && info.group != "epmem" && info.group != "wma") return value;
  if (info.kind == kInteger) return std::to_string(ParseLeadingInteger(value).value_or(0));
  if (info.kind != kReal) return value;
  return Shortest(std::clamp(std::strtod(value.c_str(), nullptr), -1e300, 1e300));
}

bool Fits(const SettingInfo& info, const std::string& value) {
  switch (info.kind) {
    case kSwitch:
      return value == "on" || value == "off";
    case kChoice:
      return IsChoice(info.choices, value);
    case kText:
      return true;
    case kInteger: {
      const auto number = ParseInteger(value);
      return number && static_cast<double>(*number) >= info.minimum && static_cast<double>(*number) <= info.maximum;
    }
    case kReal: {
      const auto number = ParseDouble(value);
      return number && *number >= info.minimum && *number <= info.maximum;
    }
  }
  return false;
}

}  // namespace

std::span<const SettingInfo> SettingStore::All() {
  return kSettings;
}

const SettingInfo* SettingStore::Find(std::string_view group, std::string_view name, bool prefix) {
  const SettingInfo* found = nullptr;
  for (const SettingInfo& info : kSettings) {
    if (info.group != group) continue;
    if (info.name == name) return &info;
    if (!prefix || name.empty() || !info.name.starts_with(name)) continue;
    if (found) return nullptr;
    found = &info;
  }
  return found;
}

std::string SettingStore::Get(std::string_view group, std::string_view name) const {
  if (const auto set = values_.find(Key(group, name)); set != values_.end()) return set->second;
  const SettingInfo* info = Find(group, name);
  return info ? std::string(info->initial) : std::string();
}

SettingStore::SetResult SettingStore::Set(std::string_view group, std::string_view name, const std::string& value) {
  const SettingInfo* info = Find(group, name);
  if (!info) return SetResult::kUnknown;
  const std::string kept = AsNumber(*info, value);
  if (!Fits(*info, kept)) return SetResult::kInvalid;
  values_[Key(group, name)] = kept;
  return SetResult::kOk;
}

std::vector<SettingStore::Changed> SettingStore::Differences() const {
  std::vector<Changed> changed;
  for (const SettingInfo& info : kSettings) {
    const std::string value = Get(info.group, info.name);
    if (value != info.initial) changed.push_back({std::string(info.group), std::string(info.name), value});
  }
  return changed;
}

}  // namespace soarbox::cli
