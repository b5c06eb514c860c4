// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace soarbox::language {

/// A part of a text, in bytes: [begin, end).
struct Span {
  std::size_t begin = 0, end = 0;
  bool Holds(std::size_t offset) const { return begin <= offset && offset <= end; }
  friend bool operator==(const Span&, const Span&) = default;
};

/// A place as editors count: lines from 0, and in a line the units of UTF-16 from 0.
struct Position {
  std::size_t line = 0, character = 0;
  friend bool operator==(const Position&, const Position&) = default;
};

/// Turns offsets of a text into positions and back. Any text has them: a byte that is no UTF-8 counts as one unit.
/// Lines end with \n; a \r before it belongs to the line's end. The text must stay as it is.
class Lines {
 public:
  explicit Lines(std::string_view text);

  std::size_t count() const { return begins_.size(); }
  /// Without its end; empty behind the last.
  std::string_view Line(std::size_t line) const;
  std::size_t Begin(std::size_t line) const { return line < begins_.size() ? begins_[line] : text_.size(); }
  std::size_t LineOf(std::size_t offset) const;

  Position PositionOf(std::size_t offset) const;
  /// A position behind a line's end is that end, one behind the last line the end of the text.
  std::size_t OffsetOf(Position position) const;

 private:
  std::string_view text_;
  std::vector<std::size_t> begins_;
};

}  // namespace soarbox::language
