// SPDX-License-Identifier: BSD-2-Clause
#include "vocabulary/percept.h"

#include <algorithm>
#include <cstdio>

#include "vocabulary/percept_sink.h"

namespace soarbox::vocabulary {

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
    std::string value = DescribeValue(percept);
    // Bars around a value that contains text like an attribute.
    if (percept.Text() != nullptr && value.find(" ^") != std::string::npos) value = "|" + value + "|";
    text += "^" + percept.attribute + " " + value;
  }
  return text;
}

Percept& PerceptLister::Add(std::string_view attribute, std::uint32_t key) {
  Percept& made = open_.back()->emplace_back();
  made.attribute = attribute;
  made.key = key;
  return made;
}

void PerceptLister::Word(const PerceptRow& row, std::string_view value, std::uint32_t key) {
  Add(row.Attribute(), key).value.emplace<std::string>(value);
}

void PerceptLister::Other(std::string_view attribute, const ConstantValue& value) {
  Percept& made = Add(attribute, 0);
  std::visit([&made](const auto& constant) { made.value = constant; }, value);
}

void PerceptLister::Open(const PerceptRow& row, std::uint32_t key) {
  open_.push_back(&Add(row.Attribute(), key).value.emplace<PerceptList>());
}

}  // namespace soarbox::vocabulary
