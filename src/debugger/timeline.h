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

#include "record/tick_record.h"

namespace soarbox::debugger {

/// The time during which an operator was selected or a state existed.
struct TimelineSpan {
  bool is_state = false;
  int level = 1;
  std::string id;                               ///< "O3", "S2"
  std::string text;                             ///< The operator's name, or "operator tie".
  std::uint64_t first_tick = 0, last_tick = 0;  ///< Ticks. Unless the span is open, it ended in last_tick.
  bool open = true;                             ///< It has not ended yet.
  int line = 0;  ///< The line on which it is drawn. Each level has two: one for states and one for operators.
};

enum class MarkKind : std::uint8_t { kCommand, kOutcome, kMessage, kEvent, kError, kEdit, kLearned };
std::string_view NameOf(MarkKind kind);

/// An event in one tick.
struct TimelineMark {
  std::uint64_t tick = 0;
  MarkKind kind = MarkKind::kEvent;
  std::string text;
};

struct TimelineTrack {
  std::string agent;               ///< Empty for the world.
  std::deque<TimelineSpan> spans;  ///< Spans that have ended, in the order of their ends.
  std::vector<TimelineSpan> open;  ///< Spans that have not ended, by line.
  std::deque<TimelineMark> marks;
  std::deque<std::pair<std::uint64_t, std::uint32_t>> firings;  ///< Tick, and number of rules that fired in it
                                                                ///< (MindDetail::kAll).
};

/// What each agent did in the ticks that were added, live or from a recording.
class Timeline {
 public:
  /// Ticks come in order. Adding an earlier tick removes everything from that tick on, because the run was continued
  /// from there.
  void Add(const record::TickRecord& tick);
  void Clear();

  bool empty() const { return tracks_.empty(); }
  std::uint64_t first_tick() const { return first_tick_; }
  std::uint64_t last_tick() const { return last_tick_; }
  double step_s() const { return step_s_; }
  /// The track of an agent; null if there is none.
  const TimelineTrack* Find(std::string_view agent) const;
  /// In the order in which the agents first occurred.
  std::vector<const TimelineTrack*> tracks() const;
  /// The spans that contain a tick, by line.
  std::vector<TimelineSpan> At(std::string_view agent, std::uint64_t tick) const;

  /// Maximum number of spans, and of marks, for one agent and for all agents together. The oldest are removed.
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

/// Calls `see` for each span that overlaps the ticks `first` to `last`, including open spans. The cost depends on the
/// number of these spans, not on the length of the run.
void ForSpansWithin(const TimelineTrack& track, std::uint64_t first, std::uint64_t last,
                    const std::function<void(const TimelineSpan&)>& see);

/// What an agent did in some ticks.
struct TrackRow {
  std::string agent;
  std::vector<TimelineSpan> spans;  ///< Including open ones, in the order in which they began.
  std::vector<TimelineMark> marks;
};

/// The ticks `first` to `last`. An empty agent means all.
std::vector<TrackRow> TracksWithin(const Timeline& timeline, std::string_view agent, std::uint64_t first,
                                   std::uint64_t last);
std::string ToText(const std::vector<TrackRow>& rows);

}  // namespace soarbox::debugger
