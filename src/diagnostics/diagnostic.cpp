// SPDX-License-Identifier: BSD-2-Clause
#include "diagnostics/diagnostic.h"

#include <algorithm>
#include <numeric>

namespace soarbox {
namespace {

const char* Word(Severity severity) {
  switch (severity) {
    case Severity::kNote:
      return "note";
    case Severity::kWarning:
      return "warning";
    case Severity::kError:
      break;
  }
  return "error";
}

// Optimal string alignment: insertions, deletions, replacements and swapped neighbours each cost 1.
std::size_t EditDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last.swap(last);
    last.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return row[b.size()];
}

}  // namespace

std::string Format(const Diagnostic& diagnostic) {
  std::string text = diagnostic.file;
  if (diagnostic.line > 0) {
    if (!text.empty()) text += ':';
    text += std::to_string(diagnostic.line);
    if (diagnostic.column > 0) text += ':' + std::to_string(diagnostic.column);
  }
  if (!text.empty()) text += ": ";
  text += Word(diagnostic.severity);
  text += ": " + diagnostic.message + '\n';
  if (!diagnostic.excerpt.empty()) {
    text += "   " + diagnostic.excerpt + '\n';
    if (diagnostic.column > 0) {
      // Tabs are kept, so that the caret stands under its character whatever a tab's width.
      std::string pad;
      for (int i = 0; i + 1 < diagnostic.column; ++i) {
        const bool is_tab = i < static_cast<int>(diagnostic.excerpt.size()) && diagnostic.excerpt[i] == '\t';
        pad += is_tab ? '\t' : ' ';
      }
      text += "   " + pad + '^' + std::string(std::max(0, diagnostic.excerpt_length - 1), '~') + '\n';
    }
  }
  if (!diagnostic.hint.empty()) text += "   note: " + diagnostic.hint + '\n';
  if (diagnostic.more > 0) {
    text += "   note: the same in " + std::to_string(diagnostic.more) + " more place" +
            (diagnostic.more == 1 ? "" : "s") + '\n';
  }
  return text;
}

std::string_view Suggest(std::string_view word, const std::vector<std::string_view>& candidates) {
  std::string_view best;
  std::size_t best_distance = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (std::string_view candidate : candidates) {
    const std::size_t distance = EditDistance(word, candidate);
    if (distance < best_distance) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

}  // namespace soarbox
