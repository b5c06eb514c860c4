// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace soarbox::cli {

/// What the trace of one agent can show, in the order in which `trace` reports changes.
enum class TraceFlag {
  kAssertions,
  kBacktracing,
  kChunks,
  kChunkWarnings,
  kConsistency,
  kDecisions,
  kDefaultRules,
  kGdsWmes,
  kGds,
  kIndifferent,
  kRl,
  kEpmem,
  kJustifications,
  kTemplates,
  kPhases,
  kPreferences,
  kSmem,
  kUserRules,
  kWmes,
  kWaterfall,
  kWma,
};
inline constexpr int kTraceFlagCount = static_cast<int>(TraceFlag::kWma) + 1;

/// How the trace shows the elements that a rule matched when it fired.
enum class WmeDetail { kNone, kTimetags, kFull };

/// A part of the trace: the option that switches it, and its descriptions.
struct TraceFlagInfo {
  TraceFlag flag;
  char letter;
  std::string_view option;    ///< The long option.
  std::string_view title;     ///< Its name in the table that `trace` prints.
  std::string_view message;   ///< "Now printing <message>." and "Will not print <message>."
  std::string_view argument;  ///< Its name in the structured answer; empty if it has none.
};

/// Which parts of the trace are on.
class TraceSettings {
 public:
  static constexpr int kMaxLevel = 5;

  /// The trace of level 1.
  TraceSettings();

  /// Turns on what the levels 1 to `level` show, and turns off what higher levels show; level 0 turns everything off.
  void SetLevel(int level);

  /// The level that was set last.
  int level() const { return level_; }
  bool On(TraceFlag flag) const { return flags_[static_cast<std::size_t>(flag)]; }
  void Set(TraceFlag flag, bool on) { flags_[static_cast<std::size_t>(flag)] = on; }
  WmeDetail wme_detail() const { return wme_detail_; }
  void SetWmeDetail(WmeDetail detail) { wme_detail_ = detail; }
  /// 0: nothing about learned rules, 1: their names, 2: their full text.
  int learning() const { return learning_; }
  void SetLearning(int learning) { learning_ = learning; }

  static std::span<const TraceFlagInfo> Infos();

 private:
  std::array<bool, kTraceFlagCount> flags_{};
  WmeDetail wme_detail_ = WmeDetail::kNone;
  int learning_ = 0;
  int level_ = 1;
};

}  // namespace soarbox::cli
