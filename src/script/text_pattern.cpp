// SPDX-License-Identifier: BSD-2-Clause
#include "script/text_pattern.h"

namespace soarbox::script {
namespace {

constexpr int kMaxDepth = 200;

bool IsBetween(unsigned char c, char low, char high) {
  return c >= static_cast<unsigned char>(low) && c <= static_cast<unsigned char>(high);
}
bool IsDigit(unsigned char c) {
  return IsBetween(c, '0', '9');
}
bool IsLower(unsigned char c) {
  return IsBetween(c, 'a', 'z');
}
bool IsUpper(unsigned char c) {
  return IsBetween(c, 'A', 'Z');
}
bool IsAlpha(unsigned char c) {
  return IsLower(c) || IsUpper(c);
}
bool IsSpace(unsigned char c) {
  return c == ' ' || (c >= 9 && c <= 13);
}
bool IsPrintable(unsigned char c) {
  return c > 32 && c < 127;
}

/// %a and similar; a letter that names no class is itself.
bool IsInClass(unsigned char c, unsigned char name) {
  bool inside = false;
  switch (IsUpper(name) ? name + ('a' - 'A') : name) {
    case 'a':
      inside = IsAlpha(c);
      break;
    case 'c':
      inside = c < 32 || c == 127;
      break;
    case 'd':
      inside = IsDigit(c);
      break;
    case 'g':
      inside = IsPrintable(c);
      break;
    case 'l':
      inside = IsLower(c);
      break;
    case 'p':
      inside = IsPrintable(c) && !IsAlpha(c) && !IsDigit(c);
      break;
    case 's':
      inside = IsSpace(c);
      break;
    case 'u':
      inside = IsUpper(c);
      break;
    case 'w':
      inside = IsAlpha(c) || IsDigit(c);
      break;
    case 'x':
      inside = IsDigit(c) || IsBetween(c, 'a', 'f') || IsBetween(c, 'A', 'F');
      break;
    case 'z':
      inside = c == 0;
      break;
    default:
      return c == name;
  }
  return IsUpper(name) ? !inside : inside;
}

}  // namespace

std::size_t TextPattern::MatchAt(std::size_t start) {
  count_ = 0;
  depth_ = 0;
  const std::size_t end = Match(start, 0);
  if (end == kNone || error_) return kNone;
  for (int i = 0; i < count_; ++i)
    if (capture(i).open) return Fail("unfinished capture");
  return end;
}

std::size_t TextPattern::Fail(const char* error) {
  if (!error_) error_ = error;
  return kNone;
}

std::size_t TextPattern::Match(std::size_t at, std::size_t item) {
  if (depth_ >= kMaxDepth) return Fail("pattern too complex");
  ++depth_;
  const std::size_t end = MatchItems(at, item);
  --depth_;
  return end;
}

std::size_t TextPattern::MatchItems(std::size_t at, std::size_t item) {
  while (item < pattern_.size()) {
    if (++steps_ > max_steps_ || error_) return kNone;
    const char c = pattern_[item];
    if (c == '(') return OpenCapture(at, item);
    if (c == ')') return CloseCapture(at, item);
    if (c == '$' && item + 1 == pattern_.size()) return at == subject_.size() ? at : kNone;
    if (c == '%' && item + 1 < pattern_.size()) {
      const char kind = pattern_[item + 1];
      if (kind == 'b') {
        at = MatchBalanced(at, item);
        if (at == kNone) return kNone;
        item += 4;
        continue;
      }
      if (kind == 'f') {
        if (item + 2 >= pattern_.size() || pattern_[item + 2] != '[') return Fail("missing '[' after '%f' in pattern");
        const std::size_t end = EndOfItem(item + 2);
        if (end == kNone || !IsFrontier(at, item + 2)) return kNone;
        item = end;
        continue;
      }
      if (IsDigit(static_cast<unsigned char>(kind))) {
        at = MatchAgain(at, kind);
        if (at == kNone) return kNone;
        item += 2;
        continue;
      }
    }
    const std::size_t item_end = EndOfItem(item);
    if (item_end == kNone) return kNone;
    const char repeat = item_end < pattern_.size() ? pattern_[item_end] : '\0';
    if (repeat == '*') return MatchLongest(at, item, item_end);
    if (repeat == '-') return MatchShortest(at, item, item_end);
    const bool matched = MatchesSingle(at, item, item_end);
    if (repeat == '+') return matched ? MatchLongest(at + 1, item, item_end) : kNone;
    if (repeat == '?') {
      if (matched) {
        const std::size_t end = Match(at + 1, item_end + 1);
        if (end != kNone || error_) return end;
      }
      item = item_end + 1;
      continue;
    }
    if (!matched) return kNone;
    ++at;
    item = item_end;
  }
  return at;
}

std::size_t TextPattern::MatchLongest(std::size_t at, std::size_t item, std::size_t item_end) {
  std::size_t count = 0;
  while (MatchesSingle(at + count, item, item_end)) ++count;
  steps_ += count;
  while (true) {
    const std::size_t end = Match(at + count, item_end + 1);
    if (end != kNone || error_ || out_of_steps()) return end;
    if (count == 0) return kNone;
    --count;
  }
}

std::size_t TextPattern::MatchShortest(std::size_t at, std::size_t item, std::size_t item_end) {
  while (true) {
    const std::size_t end = Match(at, item_end + 1);
    if (end != kNone || error_ || ++steps_ > max_steps_) return end;
    if (!MatchesSingle(at, item, item_end)) return kNone;
    ++at;
  }
}

std::size_t TextPattern::OpenCapture(std::size_t at, std::size_t item) {
  if (count_ >= kMaxCaptures) return Fail("too many captures");
  const bool is_position = item + 1 < pattern_.size() && pattern_[item + 1] == ')';
  captures_[static_cast<std::size_t>(count_)] = {at, 0, is_position, !is_position};
  ++count_;
  const std::size_t end = Match(at, item + (is_position ? 2 : 1));
  if (end == kNone) --count_;
  return end;
}

std::size_t TextPattern::CloseCapture(std::size_t at, std::size_t item) {
  int index = count_ - 1;
  while (index >= 0 && !capture(index).open) --index;
  if (index < 0) return Fail("invalid pattern capture");
  Capture& closed = captures_[static_cast<std::size_t>(index)];
  closed.open = false;
  closed.length = at - closed.start;
  const std::size_t end = Match(at, item + 1);
  if (end == kNone) closed.open = true;
  return end;
}

std::size_t TextPattern::MatchBalanced(std::size_t at, std::size_t item) {
  if (item + 3 >= pattern_.size()) return Fail("unbalanced pattern");
  const char open = pattern_[item + 2], close = pattern_[item + 3];
  if (at >= subject_.size() || subject_[at] != open) return kNone;
  int depth = 1;
  for (std::size_t i = at + 1; i < subject_.size(); ++i) {
    ++steps_;
    if (subject_[i] == close) {
      if (--depth == 0) return i + 1;
    } else if (subject_[i] == open) {
      ++depth;
    }
  }
  return kNone;
}

/// %1 to %9: matches the text of an earlier capture.
std::size_t TextPattern::MatchAgain(std::size_t at, char digit) {
  const int index = digit - '1';
  if (index < 0 || index >= count_ || capture(index).open) return Fail("invalid capture index");
  const Capture& earlier = capture(index);
  if (earlier.is_position) return kNone;  // A position capture has no text.
  const std::string_view text = subject_.substr(earlier.start, earlier.length);
  steps_ += text.size();
  return subject_.substr(at).starts_with(text) ? at + text.size() : kNone;
}

/// %f[set]: a position where the set begins to match. Both ends of the subject count as the character 0.
bool TextPattern::IsFrontier(std::size_t at, std::size_t set) {
  const std::size_t end = EndOfItem(set);
  const auto before = static_cast<unsigned char>(at == 0 ? '\0' : subject_[at - 1]);
  const auto here = static_cast<unsigned char>(at < subject_.size() ? subject_[at] : '\0');
  return !IsInSet(before, set, end - 1) && IsInSet(here, set, end - 1);
}

bool TextPattern::MatchesSingle(std::size_t at, std::size_t item, std::size_t item_end) const {
  if (at >= subject_.size()) return false;
  const auto c = static_cast<unsigned char>(subject_[at]);
  switch (pattern_[item]) {
    case '.':
      return true;
    case '%':
      return IsInClass(c, static_cast<unsigned char>(pattern_[item + 1]));
    case '[':
      return IsInSet(c, item, item_end - 1);
    default:
      return c == static_cast<unsigned char>(pattern_[item]);
  }
}

/// `set` is the index of '[', `set_end` that of the closing ']'.
bool TextPattern::IsInSet(unsigned char c, std::size_t set, std::size_t set_end) const {
  std::size_t i = set + 1;
  const bool negated = pattern_[i] == '^';
  if (negated) ++i;
  while (i < set_end) {
    const auto first = static_cast<unsigned char>(pattern_[i]);
    if (first == '%' && i + 1 < set_end) {
      if (IsInClass(c, static_cast<unsigned char>(pattern_[i + 1]))) return !negated;
      i += 2;
    } else if (i + 2 < set_end && pattern_[i + 1] == '-') {
      if (c >= first && c <= static_cast<unsigned char>(pattern_[i + 2])) return !negated;
      i += 3;
    } else {
      if (c == first) return !negated;
      ++i;
    }
  }
  return negated;
}

std::size_t TextPattern::EndOfItem(std::size_t item) {
  if (pattern_[item] == '%') {
    if (item + 1 >= pattern_.size()) return Fail("malformed pattern (ends with '%')");
    return item + 2;
  }
  if (pattern_[item] != '[') return item + 1;
  std::size_t i = item + 1;
  if (i < pattern_.size() && pattern_[i] == '^') ++i;
  // A ']' in the first position is itself.
  for (bool first = true; i < pattern_.size(); first = false) {
    if (pattern_[i] == ']' && !first) return i + 1;
    i += pattern_[i] == '%' ? 2 : 1;
  }
  return Fail("malformed pattern (missing ']')");
}

}  // namespace soarbox::script
