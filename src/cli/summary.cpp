// SPDX-License-Identifier: BSD-2-Clause
#include "cli/summary.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/command.h"

namespace soarbox::cli {

Summary& Summary::Rule(char line) {
  text_.append(static_cast<std::size_t>(width_), line);
  text_ += '\n';
  return *this;
}

Summary& Summary::Title(std::string_view text, char edge) {
  const int inner = width_ - (edge ? 2 : 0);
  const int free = inner - static_cast<int>(text.size());
  const int left = free > 0 ? (edge ? (free + 1) / 2 : free / 2) : 0;
  const int right = free > 0 ? free - left : 0;
  if (edge) text_ += edge;
  text_.append(static_cast<std::size_t>(left), ' ');
  text_ += text;
  if (edge) {
    text_.append(static_cast<std::size_t>(right), ' ');
    text_ += edge;
  }
  text_ += '\n';
  return *this;
}

Summary& Summary::Row(std::string_view name, std::string_view value, std::string_view after) {
  const int free = width_ - static_cast<int>(name.size()) - static_cast<int>(value.size());
  text_ += name;
  text_.append(static_cast<std::size_t>(free > 1 ? free : 1), ' ');
  text_ += value;
  text_ += after;
  text_ += '\n';
  return *this;
}

Summary& Summary::Text(std::string_view text) {
  text_ += text;
  return *this;
}

bool ShowTimers(CommandCall& call, std::string_view title, std::span<const std::string_view> names,
                std::string_view wanted) {
  if (!wanted.empty()) {
    if (std::ranges::find(names, wanted) == names.end()) return call.Fail("Invalid timer.");
    call.Out(" 0\n");
    return true;
  }
  Summary summary(40);
  summary.Rule('=').Text(title).Text("\n").Rule('=');
  for (const std::string_view name : names) summary.Row(std::string(name) + ":", "0");
  call.Out(summary.Take());
  return true;
}

std::string Shortest(double value) {
  return fmt::format("{}", value);
}

}  // namespace soarbox::cli
