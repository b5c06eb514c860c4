// SPDX-License-Identifier: BSD-2-Clause
#include "record/minds_codec.h"

#include <algorithm>
#include <utility>

#include "mind/event_log.h"
#include "record/byte_difference.h"

namespace soarbox::record {
namespace {

// The events of a mind are a sequence of numbers and what follows them. 0: the end. 1: a new event (a text). 2: the
// remaining events, as one text, are similar to the remaining earlier events, and the log ends. 3: a percept changed
// that this mind has not had yet in the block: its path, its value. 4: a percept is gone: 0 and its path if this mind
// has not had it, else 1 plus its step. From 5 on, odd: an event that is similar to an earlier one; half of the rest is
// the number of earlier events to skip. From 6 on, even: a percept changed: half of the rest is its step, and its value
// follows.
//
// A step is the difference of its place among the mind's percepts from the expected place, which is the next one. A
// path is 0 and its text, or 1 plus the difference of its number from the expected number.
constexpr std::uint64_t kEnd = 0, kNew = 1, kRest = 2, kNewPercept = 3, kGone = 4, kLike = 5, kPercept = 6;
constexpr char kChangedKind = 0, kGoneKind = 1;
constexpr std::size_t kHead = 3;  ///< Kind and size of an event, in the form that logs contain.

/// One event in the form that logs contain nearly always: with a size of two bytes.
struct Frame {
  std::string_view whole, fields;
  bool is_usual = false;
};

/// Removes the first event. If the log does not begin with an event, removes everything.
Frame Take(std::string_view& log) {
  Frame frame;
  if (log.size() >= kHead && (log[1] & 0x80) != 0 && (log[2] & 0x80) == 0) {
    const std::size_t size = static_cast<std::size_t>(log[1] & 0x7f) | static_cast<std::size_t>(log[2]) << 7;
    if (log.size() - kHead >= size) {
      frame = {log.substr(0, kHead + size), log.substr(kHead, size), true};
      log.remove_prefix(kHead + size);
      return frame;
    }
  }
  if (mind::EventFrame other; mind::TakeFrame(log, other)) {
    frame.whole = other.whole;
    frame.fields = other.fields;
  } else {
    frame.whole = std::exchange(log, {});
  }
  return frame;
}

/// Splits the fields of a percept into its path, attribute and key, and its value. Accepts short names only.
bool Split(std::string_view fields, std::string_view& path, std::string_view& value) {
  std::size_t at = 0;
  for (int texts = 0; texts < 2; ++texts) {
    if (at >= fields.size() || (fields[at] & 0x80) != 0) return false;
    at += 1 + static_cast<std::size_t>(fields[at]);
  }
  while (at < fields.size() && (fields[at] & 0x80) != 0) ++at;
  if (at >= fields.size()) return false;
  path = fields.substr(0, at + 1);
  value = fields.substr(at + 1);
  return true;
}

}  // namespace

void MindsEncoder::Clear() {
  names_.Clear();
  paths_.Clear();
  places_.Clear();
  minds_.clear();
}

/// Writes which mind follows: 0 and its name if it is new in the block, else 1 plus the difference of its number from
/// the expected number.
std::uint32_t MindsEncoder::FindMind(BufferedWriter& out, const std::string& agent, std::uint32_t expected) {
  std::uint32_t number = expected;
  if (expected >= minds_.size() || minds_[expected].agent != agent) {
    const std::uint32_t hash = TextBook::Hash(agent);
    if (const auto found = names_.Find(agent, hash)) {
      number = *found;
    } else {
      out.Number(0);
      out.Text(agent);
      minds_.emplace_back().agent = agent;
      return names_.AddFindable(agent, hash);
    }
  }
  out.Number(1 + Zigzag(static_cast<std::int64_t>(number) - expected));
  return number;
}

void MindsEncoder::Write(BufferedWriter& out, const std::vector<MindRecord>& minds) {
  out.Number(minds.size());
  std::uint32_t expected = 0;
  for (const MindRecord& mind : minds) {
    const std::uint32_t number = FindMind(out, mind.agent, expected);
    WriteEvents(out, number, mind.events.bytes());
    expected = number + 1;
  }
}

void MindsEncoder::WriteEvents(BufferedWriter& out, std::uint32_t mind, std::string_view log) {
  next_percept_ = next_path_ = 0;
  std::string_view earlier = minds_[mind].others;
  std::string& now = minds_[mind].new_others;
  now.clear();
  while (!log.empty()) {
    std::string_view rest = log;
    const Frame frame = Take(rest);
    const char kind = frame.whole.front();
    if (std::string_view path, value; frame.is_usual && (kind == kChangedKind || kind == kGoneKind) &&
                                      Split(frame.fields, path, value) &&
                                      WritePercept(out, mind, kind == kGoneKind, path, value)) {
      log = rest;
      continue;
    }
    if (log.size() == earlier.size()) {
      // Almost always only numbers differ.
      out.Number(kRest);
      WriteDifference(out, earlier, log);
      now += log;
      std::swap(minds_[mind].others, now);
      return;
    }
    WriteOther(out, frame.whole, earlier, now);
    log = rest;
  }
  out.Number(kEnd);
  if (!now.empty()) std::swap(minds_[mind].others, now);
}

/// Returns false, and writes nothing, if it cannot be stored in this way.
bool MindsEncoder::WritePercept(BufferedWriter& out, std::uint32_t mind, bool is_gone, std::string_view path,
                                std::string_view value) {
  constexpr std::uint32_t kAhead = 8;
  std::vector<MindMemory::Percept>& percepts = minds_[mind].percepts;
  const auto count = static_cast<std::uint32_t>(percepts.size());
  if (is_gone && !value.empty()) return false;
  std::uint32_t place = next_percept_;
  const std::uint32_t end = std::min(count, place + kAhead);
  const std::uint32_t hash = TextBook::Hash(path);
  while (place < end && (percepts[place].hash != hash || paths_.At(percepts[place].path) != path)) ++place;
  std::optional<std::uint32_t> number;
  if (place == end) {
    number = paths_.Find(path, hash);
    const auto found = number ? places_.Find(mind, *number) : std::nullopt;
    place = found ? *found : count;
  }
  const std::uint64_t step = Zigzag(static_cast<std::int64_t>(place) - next_percept_);
  ShortWriter head;
  const auto write_new_path = [&] {
    if (number) {
      out.Number(1 + Zigzag(static_cast<std::int64_t>(*number) - next_path_));
    } else {
      out.Number(0);
      out.Text(path);
      number = paths_.AddFindable(path, hash);
    }
    places_.Add(mind, *number, count);
    percepts.push_back({*number, hash, {}});
  };
  if (is_gone) {
    out.Number(kGone);
    out.Number(place == count ? 0 : 1 + step);
    if (place == count) write_new_path();
  } else {
    // The value is written first to `head`, because it can be refused.
    LastValue last = place == count ? LastValue{} : percepts[place].last;
    if (place != count) head.Number(kPercept + 2 * step);
    const Stored stored = WriteValue(head, value, last);
    if (stored == Stored::kNot) return false;
    if (place == count) {
      out.Number(kNewPercept);
      write_new_path();
    }
    out.Append(head.bytes());
    if (stored == Stored::kNotItsBytes) out.Append(value);
    percepts[place].last = last;
  }
  next_percept_ = place + 1;
  next_path_ = percepts[place].path + 1;
  return true;
}

void MindsEncoder::WriteOther(BufferedWriter& out, std::string_view event, std::string_view& earlier,
                              std::string& now) {
  constexpr std::uint64_t kMostPassed = 24;
  now += event;
  std::string_view ahead = earlier;
  for (std::uint64_t passed = 0; !ahead.empty() && passed < kMostPassed; ++passed) {
    const std::string_view other = Take(ahead).whole;
    if (other.front() != event.front()) continue;
    earlier = ahead;
    out.Number(kLike + 2 * passed);
    return WriteDifference(out, other, event);
  }
  out.Number(kNew);
  out.Text(event);
}

void MindsDecoder::Clear() {
  paths_.Clear();
  minds_.clear();
}

void MindsDecoder::Read(ByteReader& in, std::vector<MindRecord>& minds) {
  // A mind uses at least two bytes.
  minds.resize(in.CountOf(sizeof(MindRecord), 2));
  std::int64_t expected = 0;
  for (MindRecord& mind : minds) {
    std::int64_t number = static_cast<std::int64_t>(minds_.size());
    if (const std::uint64_t step = in.Number(); step == 0) {
      const std::string_view agent = in.Text();
      in.Charge(sizeof(MindMemory) + agent.size());
      if (in.failed()) return;
      minds_.emplace_back().agent = agent;
    } else {
      const std::int64_t difference = Unzigzag(step - 1);
      if (difference < -expected || difference >= number - expected) return in.Fail();
      number = expected + difference;
    }
    MindMemory& memory = minds_[static_cast<std::size_t>(number)];
    mind.agent = memory.agent;
    in.Charge(mind.agent.size());
    std::string log;
    ReadEvents(in, memory, log);
    if (in.failed()) return;
    mind.events = mind::EventLog(log);
    if (!mind.events.IsSound()) return in.Fail();
    expected = number + 1;
  }
}

void MindsDecoder::ReadEvents(ByteReader& in, MindMemory& mind, std::string& log) {
  next_percept_ = next_path_ = 0;
  std::string_view earlier = mind.others;
  std::string& now = mind.new_others;
  now.clear();
  const auto add_other = [&](std::size_t from) { now.append(log, from); };
  while (!in.failed()) {
    const std::size_t begin = log.size();
    const std::uint64_t step = in.Number();
    if (in.failed() || step == kEnd) break;
    if (step == kNew) {
      const std::string_view event = in.Text();
      in.Charge(event.size());
      log.append(event);
      add_other(begin);
    } else if (step == kRest) {
      ReadDifference(in, earlier, log);
      add_other(begin);
      break;
    } else if (step >= kLike && step % 2 == kLike % 2) {
      std::string_view other;
      for (std::uint64_t passed = (step - kLike) / 2; !earlier.empty(); --passed) {
        other = Take(earlier).whole;
        if (passed == 0) break;
        other = {};
      }
      if (other.empty()) return in.Fail();
      ReadDifference(in, other, log);
      add_other(begin);
    } else {
      const bool is_gone = step == kGone;
      const std::uint64_t head = is_gone ? in.Number() : step;
      const bool is_new = is_gone ? head == 0 : head == kNewPercept;
      MindMemory::Percept* percept = ReadPercept(in, mind, is_new, is_gone ? head - 1 : (head - kPercept) / 2);
      if (percept == nullptr) return in.Fail();
      const std::string_view path = paths_.At(percept->path);
      in.Charge(kHead + path.size());
      log += {is_gone ? kGoneKind : kChangedKind, 0, 0};
      log += path;
      if (!is_gone) ReadValue(in, percept->last, log);
      const std::size_t size = log.size() - begin - kHead;
      if (size >= (std::size_t{1} << 14)) return in.Fail();
      log[begin + 1] = static_cast<char>(size | 0x80);
      log[begin + 2] = static_cast<char>(size >> 7);
    }
  }
  if (!now.empty()) std::swap(mind.others, now);
}

/// Null if the input is not valid.
MindMemory::Percept* MindsDecoder::ReadPercept(ByteReader& in, MindMemory& mind, bool is_new, std::uint64_t step) {
  auto place = static_cast<std::int64_t>(mind.percepts.size());
  if (is_new) {
    const auto paths = static_cast<std::int64_t>(paths_.size());
    std::int64_t number = paths;
    if (const std::uint64_t head = in.Number(); head == 0) {
      const std::string_view path = in.Text();
      in.Charge(sizeof(std::size_t) + path.size());
      if (in.failed()) return nullptr;
      paths_.Add(path);
    } else {
      const std::int64_t difference = Unzigzag(head - 1);
      if (difference < -std::int64_t{next_path_} || difference >= paths - std::int64_t{next_path_}) return nullptr;
      number = next_path_ + difference;
    }
    in.Charge(sizeof(MindMemory::Percept));
    if (in.failed()) return nullptr;
    mind.percepts.push_back({static_cast<std::uint32_t>(number), 0, {}});
  } else {
    const std::int64_t difference = Unzigzag(step);
    if (difference < -std::int64_t{next_percept_} || difference >= place - std::int64_t{next_percept_}) return nullptr;
    place = next_percept_ + difference;
  }
  MindMemory::Percept& percept = mind.percepts[static_cast<std::size_t>(place)];
  next_percept_ = static_cast<std::uint32_t>(place) + 1;
  next_path_ = percept.path + 1;
  return &percept;
}

}  // namespace soarbox::record
