// SPDX-License-Identifier: BSD-2-Clause
#include "language/lines.h"

#include <algorithm>

namespace soarbox::language {
namespace {

/// Bytes of the character that begins here; 1 for invalid UTF-8.
std::size_t BytesAt(std::string_view text, std::size_t at) {
  const auto first = static_cast<unsigned char>(text[at]);
  const std::size_t length = first < 0xC0 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : first < 0xF8 ? 4 : 1;
  if (at + length > text.size()) return 1;
  for (std::size_t i = 1; i < length; ++i)
    if ((static_cast<unsigned char>(text[at + i]) & 0xC0) != 0x80) return 1;
  return length;
}

std::size_t UnitsOf(std::size_t bytes) {
  return bytes == 4 ? 2 : 1;
}

}  // namespace

Lines::Lines(std::string_view text) : text_(text), begins_{0} {
  for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1))
    begins_.push_back(at + 1);
}

std::string_view Lines::Line(std::size_t line) const {
  if (line >= begins_.size()) return {};
  std::string_view found = text_.substr(begins_[line], Begin(line + 1) - begins_[line]);
  if (found.ends_with('\n')) found.remove_suffix(1);
  if (found.ends_with('\r')) found.remove_suffix(1);
  return found;
}

std::size_t Lines::LineOf(std::size_t offset) const {
  const auto behind = std::upper_bound(begins_.begin(), begins_.end(), offset);
  return static_cast<std::size_t>(behind - begins_.begin()) - 1;
}

Position Lines::PositionOf(std::size_t offset) const {
  offset = std::min(offset, text_.size());
  Position position{LineOf(offset), 0};
  for (std::size_t at = begins_[position.line]; at < offset;) {
    const std::size_t bytes = BytesAt(text_, at);
    position.character += UnitsOf(bytes);
    at += bytes;
  }
  return position;
}

std::size_t Lines::OffsetOf(Position position) const {
  if (position.line >= begins_.size()) return text_.size();
  const std::size_t begin = begins_[position.line], end = begin + Line(position.line).size();
  std::size_t at = begin;
  for (std::size_t units = 0; at < end && units < position.character;) {
    const std::size_t bytes = BytesAt(text_, at);
    units += UnitsOf(bytes);
    at += bytes;
  }
  return at;
}

}  // namespace soarbox::language
