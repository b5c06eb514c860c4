// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/percept_help.h"

#include <algorithm>

namespace soarbox::debugger {

const vocabulary::PerceptRow* PerceptOf(std::string_view path) {
  std::string plain;
  while (!path.empty()) {
    const std::string_view part = path.substr(0, path.find('.'));
    path.remove_prefix(std::min(part.size() + 1, path.size()));
    plain.append(plain.empty() ? "" : ".").append(part.substr(0, part.find('#')));
  }
  const auto rows = vocabulary::Percepts();
  const auto row =
      std::find_if(rows.begin(), rows.end(), [&](const vocabulary::PerceptRow& r) { return r.path == plain; });
  return row == rows.end() ? nullptr : &*row;
}

std::string DescribePercept(std::string_view path) {
  const vocabulary::PerceptRow* row = PerceptOf(path);
  if (row == nullptr) return {};
  std::string text(row->meaning);
  const std::string range = vocabulary::DescribeRange(row->unit, row->min, row->max, row->words);
  if (!range.empty()) text.append(text.empty() ? "" : "\n").append(range);
  return text;
}

}  // namespace soarbox::debugger
