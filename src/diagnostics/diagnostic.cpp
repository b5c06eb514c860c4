// SPDX-License-Identifier: BSD-2-Clause
#include "diagnostics/diagnostic.h"

#include <algorithm>

#include "diagnostics/plain_text.h"

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

/// Optimal string alignment distance: insertions, deletions, replacements and swaps of neighbours each cost 1. Returns
/// `most` + 1 if it is greater. Computes only the band of the table that can lead to small values.
std::size_t EditDistance(std::string_view a, std::string_view b, std::size_t most) {
  const std::size_t beyond = most + 1;
  std::vector<std::size_t> before_last(b.size() + 1, beyond), last(b.size() + 1, beyond), row(b.size() + 1, beyond);
  for (std::size_t j = 0; j <= std::min(most, b.size()); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last.swap(last);
    last.swap(row);
    std::fill(row.begin(), row.end(), beyond);
    if (i <= most) row[0] = i;
    const std::size_t from = i > most ? i - most : 1, to = std::min(b.size(), i + most);
    std::size_t least = row[0];
    for (std::size_t j = from; j <= to; ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1), beyond});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
      least = std::min(least, row[j]);
    }
    // A swap refers to the row before the last one.
    if (least > most && *std::min_element(last.begin(), last.end()) > most) return beyond;
  }
  return row[b.size()];
}

/// Truncates a message, which may contain a long text of an untrusted author.
std::string Bounded(const std::string& text) {
  constexpr std::size_t kMost = 4'000, kShown = 1'000;
  if (text.size() <= kMost) return text;
  return text.substr(0, kShown) + "... (" + std::to_string(text.size()) + " bytes)";
}

constexpr int kWidestExcerpt = 300;
constexpr int kBeforeColumn = 100;

/// The source line with a mark below the position. A long line is reduced to the part around the position. Each control
/// character except tabs is replaced by one character, so that the mark is aligned.
std::string FormatExcerpt(const Diagnostic& diagnostic) {
  std::string excerpt = diagnostic.excerpt;
  int column = diagnostic.column;
  if (column > kBeforeColumn && static_cast<int>(excerpt.size()) > kWidestExcerpt) {
    const int cut = std::min(column, static_cast<int>(excerpt.size())) - kBeforeColumn;
    excerpt.erase(0, static_cast<std::size_t>(cut));
    column -= cut;
  }
  if (static_cast<int>(excerpt.size()) > kWidestExcerpt) excerpt.resize(kWidestExcerpt);
  for (char& c : excerpt) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte < 0x20 && byte != '\t') || byte == 0x7F) c = '?';
  }
  std::string text = "   " + excerpt + '\n';
  if (column <= 0) return text;
  // Tabs are kept, so that the caret is below its character for any tab width.
  std::string pad;
  for (int i = 0; i + 1 < column; ++i) {
    const bool is_tab = i < static_cast<int>(excerpt.size()) && excerpt[static_cast<std::size_t>(i)] == '\t';
    pad += is_tab ? '\t' : ' ';
  }
  const int marked = std::min(diagnostic.excerpt_length, kWidestExcerpt);
  text += "   " + pad + '^' + std::string(static_cast<std::size_t>(std::max(0, marked - 1)), '~') + '\n';
  return text;
}

}  // namespace

std::string Format(const Diagnostic& diagnostic) {
  std::string text = Printable(diagnostic.file, nullptr);
  if (diagnostic.line > 0) {
    if (!text.empty()) text += ':';
    text += std::to_string(diagnostic.line);
    if (diagnostic.column > 0) text += ':' + std::to_string(diagnostic.column);
  }
  if (!text.empty()) text += ": ";
  text += Word(diagnostic.severity);
  text += ": " + Printable(Bounded(diagnostic.message)) + '\n';
  if (!diagnostic.excerpt.empty()) text += FormatExcerpt(diagnostic);
  if (!diagnostic.hint.empty()) text += "   note: " + Printable(diagnostic.hint) + '\n';
  if (diagnostic.more > 0) {
    text += "   note: the same in " + std::to_string(diagnostic.more) + " more place" +
            (diagnostic.more == 1 ? "" : "s") + '\n';
  }
  return text;
}

std::string_view Suggest(std::string_view word, const std::vector<std::string_view>& candidates) {
  std::string_view best;
  // Words may come from untrusted authors and have any length. No real name is longer than kLongestName, and no typing
  // mistake changes more than kMostChanges characters.
  constexpr std::size_t kLongestName = 100, kMostChanges = 6;
  if (word.size() > kLongestName) return best;
  std::size_t most = std::clamp<std::size_t>(word.size() / 3, 1, kMostChanges);
  for (const std::string_view candidate : candidates) {
    const std::size_t longer = std::max(word.size(), candidate.size()) - std::min(word.size(), candidate.size());
    if (longer > most) continue;
    const std::size_t distance = EditDistance(word, candidate, most);
    if (distance > most) continue;
    best = candidate;
    if (distance == 0) return best;
    most = distance - 1;
  }
  return best;
}

}  // namespace soarbox
