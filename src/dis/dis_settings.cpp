// SPDX-License-Identifier: BSD-2-Clause
#include "dis/dis_settings.h"

#include <algorithm>

#include "diagnostics/number_from_chars.h"
#include "diagnostics/problem.h"

namespace soarbox::dis {
namespace {

std::array<std::uint16_t, 7> PartsOf(const EntityType& type) {
  return {type.kind, type.domain, type.country, type.category, type.subcategory, type.specific, type.extra};
}

template <class Number>
bool ReadNumber(std::string_view text, Number& value) {
  const auto [end, error] = NumberFromChars(text, value);
  return error == std::errc{} && end == text.data() + text.size() && !text.empty();
}

Diagnostic Wrong(std::string_view option, std::string what) {
  return NewProblem("--dis " + std::string(option) + ": " + std::move(what),
                    "write ADDRESS:PORT, or ADDRESS:PORT,SITE,APPLICATION,EXERCISE: --dis 239.1.2.3:3000,1,7,1");
}

}  // namespace

bool TypePattern::Fits(const EntityType& type) const {
  const auto given = PartsOf(type);
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (parts[i] && *parts[i] != given[i]) return false;
  return true;
}

EntityType TypePattern::Type() const {
  const auto part = [this](std::size_t i) { return static_cast<std::uint8_t>(parts[i].value_or(0)); };
  return {part(0), part(1), parts[2].value_or(0), part(3), part(4), part(5), part(6)};
}

std::optional<TypePattern> ParseTypePattern(std::string_view text) {
  TypePattern pattern;
  for (std::size_t i = 0; i < pattern.parts.size(); ++i) {
    const std::size_t dot = text.find('.');
    const std::string_view word = text.substr(0, dot);
    if (word != "*") {
      std::uint16_t value = 0;
      if (!ReadNumber(word, value) || (i != 2 && value > 255)) return std::nullopt;
      pattern.parts[i] = value;
    }
    if (dot == std::string_view::npos) return pattern;
    text.remove_prefix(dot + 1);
  }
  return std::nullopt;
}

std::uint8_t Settings::ForceOf(const std::string& team) const {
  const auto at = forces.find(team);
  return at == forces.end() ? std::uint8_t{0} : at->second;
}

std::string Settings::TeamOf(std::uint8_t force) const {
  for (const auto& [team, number] : forces)
    if (number == force) return team;
  return "foreign";
}

EntityType Settings::TypeOf(std::string_view body) const {
  for (const EntityRow& row : entities)
    if (row.body == body) return row.type.Type();
  return {3, 1, 0, 0, 0, 0, 0};
}

std::string_view Settings::BodyOf(const EntityType& type) const {
  for (const EntityRow& row : entities)
    if (row.type.Fits(type)) return row.body;
  return "walker";
}

const MunitionRow& Settings::MunitionOf(const EntityType& type) const {
  static const MunitionRow kUnknown;
  for (const MunitionRow& row : munitions)
    if (row.type.Fits(type)) return row;
  return kUnknown;
}

Result<Settings> ParseOption(std::string_view option, Settings over) {
  const std::size_t comma = option.find(',');
  const std::string_view place = option.substr(0, comma);
  const std::size_t colon = place.rfind(':');
  if (colon == std::string_view::npos || colon == 0) return Wrong(option, "a port is missing");
  over.address = place.substr(0, colon);
  unsigned port = 0;
  if (!ReadNumber(place.substr(colon + 1), port) || port == 0 || port > 65535)
    return Wrong(option, "'" + std::string(place.substr(colon + 1)) + "' is not a port (1 to 65535)");
  over.port = static_cast<std::uint16_t>(port);
  if (comma == std::string_view::npos) return over;
  std::string_view rest = option.substr(comma + 1);
  unsigned numbers[3] = {over.site, over.application, over.exercise};
  constexpr std::string_view kNames[3] = {"site", "application", "exercise"};
  constexpr unsigned kMost[3] = {65534, 65534, 255};
  for (std::size_t i = 0;; ++i) {
    const std::size_t next = rest.find(',');
    if (i == 3) return Wrong(option, "there are more than three numbers after the address");
    if (!ReadNumber(rest.substr(0, next), numbers[i]) || numbers[i] == 0 || numbers[i] > kMost[i])
      return Wrong(option, "'" + std::string(rest.substr(0, next)) + "' is not a valid " + std::string(kNames[i]) +
                               " (1 to " + std::to_string(kMost[i]) + ")");
    if (next == std::string_view::npos) break;
    rest.remove_prefix(next + 1);
  }
  over.site = static_cast<std::uint16_t>(numbers[0]);
  over.application = static_cast<std::uint16_t>(numbers[1]);
  over.exercise = static_cast<std::uint8_t>(numbers[2]);
  return over;
}

}  // namespace soarbox::dis
