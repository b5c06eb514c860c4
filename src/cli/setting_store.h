// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox::cli {

enum class SettingKind { kSwitch, kInteger, kReal, kChoice, kText };

/// A setting that is stored as a text. The command of its group applies it to the kernel.
struct SettingInfo {
  std::string_view group;  ///< The command it belongs to: "chunk", "rl", "smem", ...
  std::string_view name;
  SettingKind kind;
  std::string_view initial;
  std::string_view choices = {};  ///< For kChoice: the words, separated by blanks.
  double minimum = -1e300;        ///< For kInteger and kReal.
  double maximum = 1e300;
};

/// The values of the settings of one agent, as text. Invalid values are refused and change nothing.
class SettingStore {
 public:
  enum class SetResult { kOk, kUnknown, kInvalid };

  /// The value; empty for an unknown setting.
  std::string Get(std::string_view group, std::string_view name) const;
  bool IsOn(std::string_view group, std::string_view name) const { return Get(group, name) == "on"; }
  SetResult Set(std::string_view group, std::string_view name, const std::string& value);

  /// The setting with this name, or with `prefix` the one with this unique prefix; null if there is none.
  static const SettingInfo* Find(std::string_view group, std::string_view name, bool prefix = false);
  static std::span<const SettingInfo> All();

  /// Settings that differ from their initial value: group, name, value.
  struct Changed {
    std::string group, name, value;
  };
  std::vector<Changed> Differences() const;

 private:
  std::map<std::string, std::string> values_;  ///< "group name" -> value; only settings that were set.
};

}  // namespace soarbox::cli
