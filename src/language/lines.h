// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace soarbox::language {

/// A range of a text, in bytes: [begin, end).
struct Span {
  std::size_t begin = 0, end = 0;
  bool Holds(std::size_t offset) const { return begin <= offset && offset <= end; }
  friend bool operator==(const Span&, const Span&) = default;
};

/// A position as in editors: a line from 0, and a number of UTF-16 code units in the line, from 0.
struct Position {
  std::size_t line = 0, character = 0;
  friend bool operator==(const Position&, const Position&) = default;
};

/// Converts between offsets in a text and positions. Accepts any text; a byte that is not valid UTF-8 counts as one
/// unit. Lines end with LF; a CR before it belongs to the line end. The text must outlive this object and not change.
class Lines {
 public:
  explicit Lines(std::string_view text);

  std::size_t count() const { return begins_.size(); }
  /// The line without its end; empty after the last line.
  std::string_view Line(std::size_t line) const;
  std::size_t Begin(std::size_t line) const { return line < begins_.size() ? begins_[line] : text_.size(); }
  std::size_t LineOf(std::size_t offset) const;

  Position PositionOf(std::size_t offset) const;
  /// A position after the end of a line is converted to that end; one after the last line, to the end of the text.
  std::size_t OffsetOf(Position position) const;

 private:
  std::string_view text_;
  std::vector<std::size_t> begins_;
};

}  // namespace soarbox::language
