// SPDX-License-Identifier: BSD-2-Clause
#include "sml/wire/decision_element.h"

#include <array>
#include <charconv>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace soarbox::wire {
namespace {

using mind::Decision;

constexpr std::array<std::string_view, 11> kKinds = {"acceptable",  "require", "reject", "prohibit",
                                                     "best",        "worst",   "better", "worse",
                                                     "indifferent", "numeric", "equal"};
constexpr std::array<std::string_view, 7> kStages = {"forced",    "require", "prohibit", "reject",
                                                     "dominated", "best",    "worst"};
constexpr std::array<std::string_view, 4> kImpasses = {"none", "tie", "conflict", "constraint-failure"};
constexpr std::array<std::string_view, 5> kPolicies = {"boltzmann", "epsilon-greedy", "softmax", "first", "last"};
constexpr std::array<std::string_view, 3> kDecisives = {"unknown", "yes", "no"};

template <typename Enum, std::size_t kCount>
std::string DecisionWord(const std::array<std::string_view, kCount>& words, Enum value) {
  return std::string(words[static_cast<std::size_t>(value)]);
}

std::string DecisionNumber(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

/// Reads attributes; once one is missing or wrong, failed.
class DecisionFields {
 public:
  bool failed = false;

  template <typename Enum, std::size_t kCount>
  Enum Kind(const Element& from, std::string_view name, const std::array<std::string_view, kCount>& words) {
    const std::string* text = from.Attribute(name);
    for (std::size_t i = 0; text != nullptr && i < kCount; ++i)
      if (words[i] == *text) return static_cast<Enum>(i);
    failed = true;
    return Enum{};
  }
  double Real(const Element& from, std::string_view name) {
    const std::string* text = from.Attribute(name);
    double value = 0;
    if (text == nullptr || std::from_chars(text->data(), text->data() + text->size(), value).ec != std::errc())
      failed = true;
    return value;
  }
  std::string Text(const Element& from, std::string_view name) {
    const std::string* text = from.Attribute(name);
    return text == nullptr ? std::string() : *text;
  }
  /// A place below `end`.
  std::uint32_t Place(std::string_view text, std::size_t end) {
    std::uint32_t value = 0;
    const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc() && rest == text.data() + text.size() && value < end) return value;
    failed = true;
    return 0;
  }
};

}  // namespace

void AddDecision(Element& parent, const mind::Decision& decision) {
  Element& root = parent.Add("decision");
  root.Set("impasse", DecisionWord(kImpasses, decision.impasse))
      .Set("policy", DecisionWord(kPolicies, decision.policy));
  if (decision.selected != Decision::kNoOperator) root.Set("selected", std::to_string(decision.selected));
  if (decision.is_forced) root.Set("forced", "true");
  if (decision.has_changed) root.Set("changed", "true");
  for (const Decision::Operator& op : decision.operators) root.Add("operator").Set("id", op.id).Set("name", op.name);
  for (const Decision::Preference& p : decision.preferences) {
    Element& to =
        root.Add("preference").Set("kind", DecisionWord(kKinds, p.kind)).Set("operator", std::to_string(p.op));
    if (p.referent != Decision::kNoOperator) to.Set("referent", std::to_string(p.referent));
    if (p.kind == mind::PreferenceKind::kNumeric) to.Set("number", DecisionNumber(p.number));
    to.Set("rule", p.rule);
  }
  for (const Decision::Drop& drop : decision.drops) {
    Element& to =
        root.Add("drop").Set("operator", std::to_string(drop.op)).Set("stage", DecisionWord(kStages, drop.stage));
    to.Set("decisive", DecisionWord(kDecisives, drop.decisive));
    for (const std::uint32_t place : std::span(decision.by).subspan(drop.first, drop.count))
      to.Add("by").Set("preference", std::to_string(place));
  }
  for (const Decision::Chance& chance : decision.left) {
    root.Add("left")
        .Set("operator", std::to_string(chance.op))
        .Set("value", DecisionNumber(chance.value))
        .Set("probability", DecisionNumber(chance.probability));
  }
}

std::optional<mind::Decision> ReadDecision(const Element& parent) {
  const Element* root = parent.Child("decision");
  if (root == nullptr) return std::nullopt;
  DecisionFields in;
  Decision decision;
  decision.impasse = in.Kind<mind::Impasse>(*root, "impasse", kImpasses);
  decision.policy = in.Kind<mind::Policy>(*root, "policy", kPolicies);
  decision.is_forced = root->Attribute("forced") != nullptr;
  decision.has_changed = root->Attribute("changed") != nullptr;
  // Operators first: the others name them.
  for (const Element& child : root->children)
    if (child.tag == "operator") decision.operators.push_back({in.Text(child, "id"), in.Text(child, "name")});
  const std::size_t operators = decision.operators.size();
  if (const std::string* selected = root->Attribute("selected")) decision.selected = in.Place(*selected, operators);
  for (const Element& child : root->children) {
    if (child.tag != "preference") continue;
    Decision::Preference& p = decision.preferences.emplace_back();
    p.kind = in.Kind<mind::PreferenceKind>(child, "kind", kKinds);
    p.op = in.Place(in.Text(child, "operator"), operators);
    if (p.kind == mind::PreferenceKind::kNumeric) p.number = in.Real(child, "number");
    const bool is_binary = p.kind == mind::PreferenceKind::kBetter || p.kind == mind::PreferenceKind::kWorse ||
                           p.kind == mind::PreferenceKind::kEqual;
    if (is_binary) p.referent = in.Place(in.Text(child, "referent"), operators);
    p.rule = in.Text(child, "rule");
  }
  for (const Element& child : root->children) {
    if (child.tag == "drop") {
      Decision::Drop& drop = decision.drops.emplace_back();
      drop.op = in.Place(in.Text(child, "operator"), operators);
      drop.stage = in.Kind<mind::Stage>(child, "stage", kStages);
      drop.decisive = in.Kind<mind::Decisive>(child, "decisive", kDecisives);
      drop.first = static_cast<std::uint32_t>(decision.by.size());
      for (const Element& by : child.children)
        decision.by.push_back(in.Place(in.Text(by, "preference"), decision.preferences.size()));
      drop.count = static_cast<std::uint32_t>(decision.by.size()) - drop.first;
    } else if (child.tag == "left") {
      decision.left.push_back(
          {in.Place(in.Text(child, "operator"), operators), in.Real(child, "value"), in.Real(child, "probability")});
    }
  }
  if (in.failed) return std::nullopt;
  return decision;
}

}  // namespace soarbox::wire
