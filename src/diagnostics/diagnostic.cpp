// SPDX-License-Identifier: BSD-2-Clause
#include "diagnostics/diagnostic.h"

#include <algorithm>
#include <numeric>

namespace soarbox {
namespace {

const char* Word(Severity severity) {
  switch (severity) {
    case Severity::kNote: return "note";
    case Severity::kWarning: return "warning";
    case Severity::kError: break;
  }
  return "error";
}

std::size_t EditDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replace = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replace});
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
