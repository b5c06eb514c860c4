// SPDX-License-Identifier: BSD-2-Clause
#include <charconv>
#include <optional>

#include "sim/soar_host.h"

namespace soarbox::sim {
namespace {

constexpr std::size_t kMostDiagnostics = 50;

std::string_view TrimRight(std::string_view text) {
  const std::size_t end = text.find_last_not_of(" \t\r");
  return end == std::string_view::npos ? std::string_view{} : text.substr(0, end + 1);
}

std::optional<int> ReadNumber(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// Parses "FILE:LINE:COLUMN: SEVERITY: MESSAGE"; the column can be missing.
std::optional<Diagnostic> ReadHeadLine(std::string_view line) {
  for (const auto& [word, severity] : {std::pair{": error: ", Severity::kError}, {": warning: ", Severity::kWarning}}) {
    const std::size_t at = line.find(word);
    if (at == std::string_view::npos) continue;
    Diagnostic diagnostic;
    diagnostic.severity = severity;
    diagnostic.message = line.substr(at + std::string_view(word).size());
    std::string_view place = line.substr(0, at);
    std::vector<int> numbers;
    while (numbers.size() < 2) {
      const std::size_t colon = place.rfind(':');
      if (colon == std::string_view::npos) break;
      const std::optional<int> number = ReadNumber(place.substr(colon + 1));
      if (!number) break;
      numbers.insert(numbers.begin(), *number);
      place = place.substr(0, colon);
    }
    if (numbers.empty()) return std::nullopt;
    diagnostic.file = place;
    diagnostic.line = numbers[0];
    if (numbers.size() > 1) diagnostic.column = numbers[1];
    return diagnostic;
  }
  return std::nullopt;
}

}  // namespace

std::vector<Diagnostic> ParseDiagnostics(std::string_view text, const std::string& file) {
  std::vector<Diagnostic> found;
  std::string unplaced;
  while (!text.empty() && found.size() < kMostDiagnostics) {
    const std::size_t end = text.find('\n');
    const std::string_view line = TrimRight(text.substr(0, end));
    text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
    constexpr std::string_view kNote = "   note: ";
    if (auto diagnostic = ReadHeadLine(line)) {
      found.push_back(std::move(*diagnostic));
    } else if (!found.empty() && line.starts_with(kNote)) {
      found.back().hint = line.substr(kNote.size());
    } else if (!found.empty() && found.back().excerpt.empty() && line.starts_with("   ")) {
      found.back().excerpt = line.substr(3);
    } else if (found.empty() && !line.empty()) {
      if (!unplaced.empty()) unplaced += "; ";
      unplaced += line;
    }
  }
  if (found.empty() && !unplaced.empty()) {
    Diagnostic diagnostic;
    diagnostic.file = file;
    diagnostic.message = unplaced;
    found.push_back(std::move(diagnostic));
  }
  return found;
}

}  // namespace soarbox::sim
