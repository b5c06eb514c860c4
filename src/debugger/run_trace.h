// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "debugger/json.h"
#include "debugger/revision.h"
#include "record/tick_record.h"

namespace soarbox::debugger {

/// From the most telling on; what a level shows includes those before it.
enum class TraceKind : std::uint8_t {
  kError,
  kDecision,  ///< Operators, states.
  kCommand,   ///< Said, and how they went.
  kEvent,
  kInput,  ///< What came through the door.
  kPercept,
  kRule,  ///< Firings and retractions.
  kElement,
};
std::string_view NameOf(TraceKind kind);

struct TraceLine {
  std::uint64_t tick = 0;
  double time_s = 0;
  TraceKind kind = TraceKind::kEvent;
  int level = 0;      ///< Of the goal stack, for decisions; else 0.
  std::string agent;  ///< Empty: the world.
  std::string text;
};

struct TraceFilter {
  TraceKind most = TraceKind::kEvent;  ///< Lines of this kind and of those before it.
  std::string agent;                   ///< Empty: all.
  /// Each word of it must stand in the line. "rule:NAME", "op:NAME", "command:NAME" and "^attribute" ask for lines
  /// about these, whatever `most` says; of several of them one must hold.
  std::string text;

  bool Lets(const TraceLine& line) const;
  friend bool operator==(const TraceFilter&, const TraceFilter&) = default;
};

/// What happened, line by line, over the ticks that were added. Bounded: the oldest lines go.
class Trace {
 public:
  explicit Trace(std::size_t most = 50'000) : most_(most) {}

  /// Ticks come in order; an earlier one takes back what was added from there on.
  void Add(const record::TickRecord& tick);
  void Clear() {
    lines_.clear();
    revision_ = NewRevision();
  }
  const std::deque<TraceLine>& lines() const { return lines_; }
  /// How many lines have gone because there were too many.
  std::uint64_t forgotten() const { return forgotten_; }
  /// Another one whenever lines are taken back (see NewRevision).
  std::uint64_t revision() const { return revision_; }
  std::vector<const TraceLine*> Find(const TraceFilter& filter) const;

 private:
  std::size_t most_;
  std::uint64_t forgotten_ = 0, revision_ = NewRevision();
  std::deque<TraceLine> lines_;
};

/// The lines of a trace that a filter lets pass, kept as the trace grows: only new lines are looked at.
class TraceSearch {
 public:
  /// Valid until the trace changes.
  const std::deque<const TraceLine*>& Find(const Trace& trace, const TraceFilter& filter);

 private:
  TraceFilter filter_;
  std::uint64_t revision_ = 0;
  std::uint64_t next_ = 0;  ///< The line to look at next, counted from the run's first.
  std::deque<const TraceLine*> found_;
  std::deque<std::uint64_t> numbers_;  ///< Of the lines found.
};

std::string ToText(const std::vector<const TraceLine*>& lines);
Json ToJson(const std::vector<const TraceLine*>& lines);

}  // namespace soarbox::debugger
