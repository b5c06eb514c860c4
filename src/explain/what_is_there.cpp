// SPDX-License-Identifier: BSD-2-Clause
#include "explain/what_is_there.h"

#include <cstddef>
#include <set>

#include "explain/rule_makers.h"
#include "wording/number_words.h"
#include "wording/sentences.h"

namespace soarbox::explain {
namespace {

using wording::Listed;
using wording::WithoutZeros;

/// "^name, ^place and 2 more"
std::string AttributeList(const std::vector<std::string>& attributes) {
  constexpr std::size_t kMost = 6;
  std::vector<std::string> shown;
  for (std::size_t i = 0; i < attributes.size() && i < kMost; ++i) shown.push_back("^" + attributes[i]);
  if (attributes.size() > kMost) shown.push_back(std::to_string(attributes.size() - kMost) + " more");
  return Listed(shown);
}

/// The attributes of an identifier, each once.
std::set<std::string> AttributesOf(Inspector& inspector, const std::string& id) {
  std::set<std::string> attributes;
  for (const ElementFact& element : inspector.ElementsOf(id)) attributes.insert(element.attribute);
  return attributes;
}

}  // namespace

std::vector<std::string> FromLink(const std::vector<std::string>& path) {
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
    if (path[i] == "io" && path[i + 1] == "input-link")
      return {path.begin() + static_cast<std::ptrdiff_t>(i), path.end()};
  return {};
}

const vocabulary::PerceptRow* RowAt(const std::vector<std::string>& from_state) {
  const std::vector<std::string> path = FromLink(from_state);
  constexpr std::size_t kLink = 2;  // io.input-link
  if (path.size() <= kLink) return nullptr;
  std::string dotted;
  for (std::size_t i = kLink; i < path.size(); ++i) dotted += (i == kLink ? "" : ".") + path[i];
  for (const vocabulary::PerceptRow& row : vocabulary::Percepts())
    if (row.path == dotted) return &row;
  return nullptr;
}

std::string RelatedPercepts(MindView& view, Inspector& inspector, const std::string& state,
                            const std::vector<std::string>& path) {
  constexpr std::size_t kLink = 2;  // io.input-link
  const std::vector<std::string> on_link = FromLink(path);
  if (on_link.size() <= kLink) return {};
  const std::vector<std::string> above(path.begin(), path.end() - 1);
  std::string text;
  for (const std::string& object : view.ValuesAt(state, above)) {
    if (!IsIdentifier(object)) continue;
    for (const ElementFact& element : inspector.ElementsOf(object))
      if (element.attribute.starts_with(path.back() + "-") && !element.is_object)
        text +=
            (text.empty() ? "" : ", ") + Dotted(above) + "." + element.attribute + " is " + WithoutZeros(element.value);
  }
  return text;
}

std::string AttributeWithWord(MindView& view, Inspector& inspector, const std::string& state,
                              const ConditionText& condition) {
  for (const std::string& object : view.ValuesAt(state, condition.path)) {
    if (!IsIdentifier(object)) continue;
    for (const ElementFact& element : inspector.ElementsOf(object)) {
      if (element.is_object || element.value.empty()) continue;
      // The test is a word, or a list of words: << normalfood bonusfood >>.
      const std::string words = " " + condition.value + " ";
      const bool is_test = words.find_first_of("<>") == std::string::npos || words.find("<<") != std::string::npos;
      if (is_test && words.find(" " + element.value + " ") != std::string::npos) return element.attribute;
    }
  }
  return {};
}

RuleWait::Found WhatIsThere(MindView& view, Inspector& inspector, const std::string& state,
                            const ConditionText& condition) {
  using enum RuleWait::Kind;
  const RuleWait::Found nothing = {"", kAbsent};
  const std::string& attribute = condition.path.back();
  if (!IsConstantAttribute(attribute)) return nothing;
  if (condition.path.size() == 1) {
    if (IsArchitectureAttribute(attribute)) return nothing;
    // The state has no such element, but one of its own objects does now, or other rules test it there.
    std::set<std::string> places;
    const auto add = [&](const std::string& object) {
      if (IsConstantAttribute(object) && !IsArchitectureAttribute(object))
        places.insert("^" + object + "." + attribute);
    };
    for (const std::string& object : AttributesOf(inspector, state))
      if (!view.ValuesAt(state, {object, attribute}).empty()) add(object);
    for (const RuleText& other : view.rules()) {
      for (const RuleAttribute& tested : other.conditions) {
        const auto path = other.paths.find(tested.id);
        if (tested.attribute != attribute || path == other.paths.end()) continue;
        if (const std::vector<std::string> below = FromTop(path->second); below.size() == 1) add(below.front());
      }
    }
    if (places.empty()) return nothing;
    return {"; it is " + Listed(std::vector<std::string>(places.begin(), places.end()))};
  }
  // Answers of the world and of memories may come later, and percepts change. Their absence means nothing.
  const bool is_answer = IsArchitectureAttribute(attribute) && attribute != "name" && attribute != "value";
  if (is_answer || condition.path.front() == "io") return nothing;
  const std::vector<std::string> above(condition.path.begin(), condition.path.end() - 1);
  const std::vector<std::string> objects = view.ValuesAt(state, above);
  if (objects.empty()) return nothing;
  const std::string path = Dotted(above);
  std::set<std::string> found;
  for (const std::string& object : objects) {
    if (!IsIdentifier(object)) return {"; " + path + " is " + object + ", a value without attributes"};
    for (const std::string& each : AttributesOf(inspector, object)) found.insert(each);
  }
  // The attributes of a state are too many to list.
  if (found.empty() || found.contains("superstate")) return nothing;
  return {"; " + path + " has only " + AttributeList({found.begin(), found.end()}), kAbsent};
}

}  // namespace soarbox::explain
