// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace soarbox::cli {

/// Builds the boxed summaries that commands print: a title between rules of `line`, rows with the value at the right.
class Summary {
 public:
  explicit Summary(int width) : width_(width) {}

  /// A line of one character.
  Summary& Rule(char line);
  /// Text in the middle of the line, with `edge` at both ends if it is not 0.
  Summary& Title(std::string_view text, char edge = 0);
  /// A name at the left, its value at the right, then `after` beyond the right edge.
  Summary& Row(std::string_view name, std::string_view value, std::string_view after = {});
  Summary& Text(std::string_view text);

  std::string Take() { return std::move(text_); }

 private:
  int width_;
  std::string text_;
};

/// Prints how long parts of a memory's work took: all of them below a title, or the one that you ask for. They are not
/// measured: all show 0, as while timers are off.
bool ShowTimers(struct CommandCall& call, std::string_view title, std::span<const std::string_view> names,
                std::string_view wanted);

/// Numbers as settings show them: the shortest text that reads back as the same number.
std::string Shortest(double value);
inline std::string_view OnOff(bool on) {
  return on ? "on" : "off";
}

}  // namespace soarbox::cli
