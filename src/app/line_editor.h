// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox::app {

/// Reads lines from a terminal with editing, history (kept between sessions) and completion by Tab. Only one may exist
/// at a time.
class LineEditor {
 public:
  /// Returns the complete words that the last word of a line may become.
  using Completer = std::function<std::vector<std::string>(std::string_view line)>;

  explicit LineEditor(Completer completer);
  ~LineEditor();
  LineEditor(const LineEditor&) = delete;
  LineEditor& operator=(const LineEditor&) = delete;

  /// Returns the next line without its newline; nothing at the end of input (Ctrl-D).
  std::optional<std::string> Read(std::string_view prompt);
  void Remember(const std::string& line);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace soarbox::app
