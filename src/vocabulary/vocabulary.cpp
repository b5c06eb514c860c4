// SPDX-License-Identifier: BSD-2-Clause
#include "vocabulary/vocabulary.h"

#include <algorithm>
#include <cstdio>

#include "diagnostics/diagnostic.h"

namespace soarbox::vocabulary {
namespace {

template <class Rows>
auto FindByName(const Rows& rows, std::string_view name) {
  const auto at = std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.name == name; });
  return at == rows.end() ? nullptr : &*at;
}

std::string Short(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

}  // namespace

const CommandRow* FindCommand(std::string_view name) {
  return FindByName(Commands(), name);
}
const SenseRow* FindSense(std::string_view name) {
  return FindByName(Senses(), name);
}
const ReasonRow* FindReason(std::string_view name) {
  return FindByName(Reasons(), name);
}

std::string_view NearestCommand(std::string_view word) {
  std::vector<std::string_view> names;
  for (const CommandRow& row : Commands()) names.push_back(row.name);
  return Suggest(word, names);
}

std::string_view NearestAttribute(std::string_view word, std::span<const std::string> more) {
  std::vector<std::string_view> names;
  for (const PerceptRow& row : Percepts()) names.push_back(row.Attribute());
  names.insert(names.end(), more.begin(), more.end());
  return Suggest(word, names);
}

bool IsPerceptAttribute(std::string_view attribute) {
  return std::any_of(Percepts().begin(), Percepts().end(),
                     [&](const PerceptRow& row) { return row.Attribute() == attribute; });
}

std::string_view NameOf(BodyPart part) {
  constexpr std::string_view kNames[] = {"legs", "head", "hands", "voice", "posture", "none"};
  return kNames[static_cast<std::size_t>(part)];
}

std::string_view NameOf(ValueType type) {
  constexpr std::string_view kNames[] = {"number", "integer", "word", "object"};
  return kNames[static_cast<std::size_t>(type)];
}

std::string DescribeRange(std::string_view unit, double min, double max, std::string_view words) {
  std::string text;
  if (!words.empty()) return "one of: " + std::string(words);
  if (!unit.empty()) text = unit;
  constexpr double kShown = 1e5;  // Larger limits only keep numbers finite, so they are not shown.
  if (min == max || max >= kShown) return text;
  if (!text.empty()) text += ", ";
  return text + Short(min) + " to " + Short(max);
}

bool HoldsWord(std::string_view list, std::string_view word) {
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(' '), list.size());
    if (list.substr(0, end) == word) return true;
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return false;
}

}  // namespace soarbox::vocabulary
