// SPDX-License-Identifier: BSD-2-Clause
#include "record/event_delta.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

#include "mind/event_log.h"

namespace soarbox::record {
namespace {

// An encoded log is a list of steps. 0: the end. 1: a new event (a text). 2: the remaining events are similar to the
// remaining events of the log before, and the log ends. 3 or more: an event that is similar to one of the log before,
// after skipping step - 3 events of that log. The difference from a similar text is its size (0 if equal to that of the
// other text), then alternating counts of bytes that are equal at the same position and of new bytes, until the size is
// reached.
constexpr std::uint64_t kEnd = 0, kNew = 1, kRest = 2, kLike = 3;

/// Removes the first event from a log. If the log does not begin with an event, removes everything.
std::string_view TakeEvent(std::string_view& log) {
  mind::EventFrame frame;
  return mind::TakeFrame(log, frame) ? frame.whole : std::exchange(log, {});
}

/// Number of equal bytes of two texts from a position on.
std::size_t EqualRun(std::string_view a, std::string_view b, std::size_t from) {
  const std::size_t end = std::min(a.size(), b.size());
  std::size_t at = from;
  while (end >= 8 && at <= end - 8) {
    std::uint64_t x, y;
    std::memcpy(&x, a.data() + at, sizeof x);
    std::memcpy(&y, b.data() + at, sizeof y);
    if (x != y) break;
    at += 8;
  }
  while (at < end && a[at] == b[at]) ++at;
  return at > from ? at - from : 0;
}

/// Whether it is worth storing an event as the difference from another.
bool AreLike(std::string_view before, std::string_view now) {
  if (before.front() != now.front()) return false;
  constexpr char kLastPercept = 1;
  constexpr std::size_t kHead = 3, kNames = 12;
  if (now.front() > kLastPercept || before.size() < kHead || now.size() < kHead) return true;
  // Percepts begin with their paths and names. Percepts with other names have little in common.
  return before.substr(kHead, kNames) == now.substr(kHead, kNames);
}

void WriteDifference(ByteWriter& out, std::string_view before, std::string_view now) {
  constexpr std::size_t kWorth = 3;  // Shorter runs of equal bytes are stored as new bytes.
  out.Number(before.size() == now.size() ? 0 : now.size());
  for (std::size_t at = 0; at < now.size();) {
    const std::size_t same = EqualRun(before, now, at);
    out.Number(same);
    at += same;
    if (at == now.size()) return;
    std::size_t end = at + 1, equal = 0;
    for (; end < now.size() && equal < kWorth; ++end)
      equal = end < before.size() && before[end] == now[end] ? equal + 1 : 0;
    end -= equal;
    out.Text(now.substr(at, end - at));
    at = end;
  }
}

/// Appends an event to a log.
void ReadDifference(ByteReader& in, std::string_view before, std::string& log) {
  const std::uint64_t given = in.Number();
  const std::uint64_t size = given == 0 ? before.size() : given;
  in.Charge(size);
  for (std::uint64_t at = 0; at < size && !in.failed();) {
    const std::uint64_t same = in.Number();
    if (same > size - at || (same > 0 && (at >= before.size() || same > before.size() - at))) return in.Fail();
    if (same > 0) log.append(before.substr(static_cast<std::size_t>(at), static_cast<std::size_t>(same)));
    at += same;
    if (at == size) return;
    const std::string_view fresh = in.Text();
    if (fresh.empty() || fresh.size() > size - at) return in.Fail();
    log.append(fresh);
    at += fresh.size();
  }
}

}  // namespace

void WriteEventDelta(ByteWriter& out, std::string_view before, std::string_view now) {
  constexpr int kMostPassed = 24;
  if (!now.empty() && before.size() == now.size()) {
    // Almost always only numbers differ.
    out.Number(kRest);
    return WriteDifference(out, before, now);
  }
  while (!now.empty()) {
    const std::string_view event = TakeEvent(now);
    std::string_view ahead = before;
    int passed = 0;
    std::string_view other;
    for (; !ahead.empty() && passed < kMostPassed; ++passed) {
      other = TakeEvent(ahead);
      if (AreLike(other, event)) break;
      other = {};
    }
    if (other.empty()) {
      out.Number(kNew);
      out.Text(event);
      continue;
    }
    before = ahead;
    out.Number(kLike + static_cast<std::uint64_t>(passed));
    WriteDifference(out, other, event);
  }
  out.Number(kEnd);
}

std::string ReadEventDelta(ByteReader& in, std::string_view before) {
  std::string log;
  while (!in.failed()) {
    std::uint64_t step = in.Number();
    if (in.failed() || step == kEnd) break;
    if (step == kNew) {
      const std::string_view event = in.Text();
      in.Charge(event.size());
      log.append(event);
      continue;
    }
    if (step == kRest) {
      ReadDifference(in, before, log);
      break;
    }
    std::string_view other;
    for (step -= kLike; !before.empty(); --step) {
      other = TakeEvent(before);
      if (step == 0) break;
      other = {};
    }
    if (other.empty()) {
      in.Fail();
    } else {
      ReadDifference(in, other, log);
    }
  }
  return log;
}

}  // namespace soarbox::record
