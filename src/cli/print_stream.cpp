// SPDX-License-Identifier: BSD-2-Clause
#include "cli/print_stream.h"

#include <cstdio>

namespace soarbox::cli {

void PrintStream::Print(std::string_view text) {
  if (!enabled_ || text.empty()) return;
  const std::size_t newline = text.rfind('\n');
  if (newline == std::string_view::npos) {
    column_ += static_cast<int>(text.size());
  } else {
    column_ = static_cast<int>(text.size() - newline - 1);
  }
  if (copy_) copy_(text);
  if (!targets_.empty() && targets_.back()) {
    targets_.back()->append(text);
    return;
  }
  if (console_) [[unlikely]]
    ToConsole(text);
  if (sink_ && sink_enabled_) sink_(text);
}

void PrintStream::ToConsole(std::string_view text) const {
  if (!console_ || sink_is_console_ || !enabled_) return;
  std::fwrite(text.data(), 1, text.size(), stdout);
  std::fflush(stdout);
}

void PrintStream::PrintUncounted(std::string_view text) {
  const int column = column_;
  Print(text);
  column_ = column;
}

void PrintStream::FreshLine() {
  if (column_ != 0) Print("\n");
}

}  // namespace soarbox::cli
