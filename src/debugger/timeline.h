// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "debugger/json.h"
#include "record/tick_record.h"

namespace soarbox::debugger {

/// An operator that was selected, or a state, from the tick in which it came to the last one that saw it.
struct TimelineSpan {
  bool is_state = false;
  int level = 1;
  std::string id;                               ///< "O3", "S2"
  std::string text;                             ///< The operator's name, or "operator tie".
  std::uint64_t first_tick = 0, last_tick = 0;  ///< In the last one it went, unless it is open.
  bool open = true;                             ///< It is still there.
  int line = 0;  ///< On which it is drawn: two for each level, the state's and the operator's.
};

enum class MarkKind : std::uint8_t { kCommand, kOutcome, kMessage, kEvent, kError, kEdit, kLearned };
std::string_view NameOf(MarkKind kind);

/// Something at one tick.
struct TimelineMark {
  std::uint64_t tick = 0;
  MarkKind kind = MarkKind::kEvent;
  std::string text;
};

struct TimelineTrack {
  std::string agent;               ///< Empty: the world itself.
  std::deque<TimelineSpan> spans;  ///< That are over, in the order in which they ended.
  std::vector<TimelineSpan> open;  ///< That are still there, by line.
  std::deque<TimelineMark> marks;
  std::deque<std::pair<std::uint64_t, std::uint32_t>> firings;  ///< Tick, rules that fired in it (MindDetail::kAll).
};

/// What each agent was about, over the ticks that were added: live or from a recording.
class Timeline {
 public:
  /// Ticks come in order; an earlier one takes back what was added from there on (somebody went back and goes on).
  void Add(const record::TickRecord& tick);
  void Clear();

  bool empty() const { return tracks_.empty(); }
  std::uint64_t first_tick() const { return first_tick_; }
  std::uint64_t last_tick() const { return last_tick_; }
  double step_s() const { return step_s_; }
  /// By name; null if nothing is known of it.
  const TimelineTrack* Find(std::string_view agent) const;
  /// In the order in which they first came up.
  std::vector<const TimelineTrack*> tracks() const;
  /// Spans that a tick lies in, by line.
  std::vector<TimelineSpan> At(std::string_view agent, std::uint64_t tick) const;

  /// Spans or marks of one agent, and of all together; the oldest go.
  static constexpr std::size_t kMostPerTrack = 20'000, kMostOfAll = 400'000;

 private:
  void CutFrom(std::uint64_t tick);
  TimelineTrack& Track(const std::string& agent);
  static void Read(TimelineTrack& track, const mind::Event& event, std::uint64_t tick);
  static void Close(TimelineTrack& track, int level, std::uint64_t tick, bool state_too);
  static void Open(TimelineTrack& track, TimelineSpan span);

  std::vector<std::string> order_;
  std::map<std::string, TimelineTrack, std::less<>> tracks_;
  std::uint64_t first_tick_ = 0, last_tick_ = 0;
  double step_s_ = 0;
};

/// Spans of which something lies between two ticks, open ones too: costs as much as there are, however long the run.
void ForSpansWithin(const TimelineTrack& track, std::uint64_t first, std::uint64_t last,
                    const std::function<void(const TimelineSpan&)>& see);

/// Ticks `first` to `last`; an empty agent: all.
std::string ToText(const Timeline& timeline, std::string_view agent, std::uint64_t first, std::uint64_t last);
Json ToJson(const Timeline& timeline, std::string_view agent, std::uint64_t first, std::uint64_t last);

}  // namespace soarbox::debugger
