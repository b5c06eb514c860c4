// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "debugger/revision.h"
#include "record/tick_record.h"

namespace soarbox::debugger {

/// Kinds of lines, the most important first. A user who chooses a kind also sees all kinds before it.
enum class TraceKind : std::uint8_t {
  kError,
  kDecision,  ///< Operators and states.
  kCommand,   ///< Commands that were given, and their results.
  kEvent,
  kInput,  ///< Inputs from outside (sim::Input).
  kPercept,
  kRule,  ///< Firings and retractions.
  kElement,
};
std::string_view NameOf(TraceKind kind);

struct TraceLine {
  std::uint64_t tick = 0;
  double time_s = 0;
  TraceKind kind = TraceKind::kEvent;
  int level = 0;      ///< For decisions: the level of the goal stack; else 0.
  std::string agent;  ///< Empty for the world.
  std::string text;
};

struct TraceFilter {
  TraceKind most = TraceKind::kEvent;  ///< The least important kind to show.
  std::string agent;                   ///< Empty: all agents.
  /// Each word must occur in the line. "rule:NAME", "op:NAME", "command:NAME" and "^attribute" select lines about
  /// these, whatever `most` is. If there are several of them, one must apply.
  std::string text;

  bool Lets(const TraceLine& line) const;
  friend bool operator==(const TraceFilter&, const TraceFilter&) = default;
};

/// What happened, line by line, in the ticks that were added. At most `most` lines; the oldest are removed.
class Trace {
 public:
  explicit Trace(std::size_t most = 50'000) : most_(most) {}

  /// Ticks come in order. Adding an earlier tick removes everything from that tick on.
  void Add(const record::TickRecord& tick);
  void Clear() {
    lines_.clear();
    revision_ = NewRevision();
  }
  const std::deque<TraceLine>& lines() const { return lines_; }
  /// Number of lines that were removed because there were too many.
  std::uint64_t forgotten() const { return forgotten_; }
  /// Changes whenever lines are removed from the end (see NewRevision).
  std::uint64_t revision() const { return revision_; }
  std::vector<const TraceLine*> Find(const TraceFilter& filter) const;

 private:
  std::size_t most_;
  std::uint64_t forgotten_ = 0, revision_ = NewRevision();
  std::deque<TraceLine> lines_;
};

/// The lines of a trace that pass a filter. As the trace grows, only new lines are tested.
class TraceSearch {
 public:
  /// The result is valid until the trace changes.
  const std::deque<const TraceLine*>& Find(const Trace& trace, const TraceFilter& filter);

 private:
  TraceFilter filter_;
  std::uint64_t revision_ = 0;
  std::uint64_t next_ = 0;  ///< The next line to test, counted from the first line of the run.
  std::deque<const TraceLine*> found_;
  std::deque<std::uint64_t> numbers_;  ///< Numbers of the lines in found_.
};

std::string ToText(const std::vector<const TraceLine*>& lines);

}  // namespace soarbox::debugger
