// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace soarbox::cli {

/// Builds the boxed summaries that commands print: a title between lines of `line` characters, and rows with the value
/// on the right.
class Summary {
 public:
  explicit Summary(int width) : width_(width) {}

  /// A line of one character.
  Summary& Rule(char line);
  /// Text in the middle of the line; `edge` is printed at both ends if it is not 0.
  Summary& Title(std::string_view text, char edge = 0);
  /// A name on the left, its value on the right, then `after` beyond the right edge.
  Summary& Row(std::string_view name, std::string_view value, std::string_view after = {});
  Summary& Text(std::string_view text);

  std::string Take() { return std::move(text_); }

 private:
  int width_;
  std::string text_;
};

/// Prints the times of a memory's operations: all of them below a title, or only `wanted`. They are not measured; all
/// are 0, as when timers are off.
bool ShowTimers(struct CommandCall& call, std::string_view title, std::span<const std::string_view> names,
                std::string_view wanted);

/// The shortest text that is parsed as the same number.
std::string Shortest(double value);
inline std::string_view OnOff(bool on) {
  return on ? "on" : "off";
}

}  // namespace soarbox::cli
