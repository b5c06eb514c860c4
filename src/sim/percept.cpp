// SPDX-License-Identifier: BSD-2-Clause
#include "sim/percept.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace soarbox::sim {

std::optional<double> Percept::Number() const {
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return static_cast<double>(*integer);
  if (const auto* number = std::get_if<double>(&value)) return *number;
  return std::nullopt;
}

const Percept* FindPercept(const PerceptList& list, std::string_view attribute) {
  const auto at = std::find_if(list.begin(), list.end(), [&](const Percept& p) { return p.attribute == attribute; });
  return at == list.end() ? nullptr : &*at;
}

std::string DescribeValue(const Percept& percept) {
  if (const auto* text = percept.Text()) return *text;
  if (const auto* integer = std::get_if<std::int64_t>(&percept.value)) return std::to_string(*integer);
  if (const auto* number = std::get_if<double>(&percept.value)) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", *number);
    return text;
  }
  return "(" + Describe(std::get<Percept::Object>(percept.value)) + ")";
}

std::string Describe(const PerceptList& list) {
  std::string text;
  for (const Percept& percept : list) {
    if (!text.empty()) text += ' ';
    text += "^" + percept.attribute + " " + DescribeValue(percept);
  }
  return text;
}

void AddNumber(PerceptList& list, const PerceptRow& row, double value) {
  if (!std::isfinite(value)) return;
  if (row.min != row.max) value = std::clamp(value, row.min, row.max);
  if (row.step == 1) {
    value = std::round(value) + 0.0;  // No negative zero.
  } else if (row.step > 0) {
    // Division by a whole number of steps keeps 0.1 and its like exactly what a rule's text says.
    const double per_unit = 1 / row.step;
    const double whole = std::round(per_unit);
    value = std::abs(per_unit - whole) < 1e-9 && whole > 0 ? std::round(value * whole) / whole
                                                           : std::round(value / row.step) * row.step;
    if (value == 0) value = 0;  // No negative zero.
  }
  Percept& made = list.emplace_back();
  made.attribute = row.Attribute();
  if (row.type == ValueType::kInteger) {
    made.value = static_cast<std::int64_t>(std::llround(value));
  } else {
    made.value = value;
  }
}

void AddWord(PerceptList& list, const PerceptRow& row, std::string_view value, std::uint32_t key) {
  Percept& made = list.emplace_back();
  made.attribute = row.Attribute();
  made.key = key;
  made.value.emplace<std::string>(value);
}

PerceptList& AddObject(PerceptList& list, const PerceptRow& row, std::uint32_t key, std::size_t room) {
  Percept& made = list.emplace_back();
  made.attribute = row.Attribute();
  made.key = key;
  PerceptList& below = made.value.emplace<PerceptList>();
  below.reserve(room);
  return below;
}

}  // namespace soarbox::sim
