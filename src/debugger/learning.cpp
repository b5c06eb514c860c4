// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/learning.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace soarbox::debugger {

LearningView LookAtLearning(sim::Inspector& mind, std::string_view text) {
  LearningView view;
  const auto wanted = [&](const std::string& name) { return name.find(text) != std::string::npos; };
  for (const sim::RuleFact& rule : mind.Rules()) {
    if (rule.type == "chunk" && wanted(rule.name)) view.rules.push_back({rule.name, rule.firings});
  }
  std::ranges::reverse(view.rules);
  auto* const source = dynamic_cast<sim::LearningSource*>(&mind);
  if (source == nullptr) {
    view.note = "this kernel does not report numbers learned by reward";
    return view;
  }
  sim::LearningFacts facts = source->Learning();
  view.by_reward = facts.by_reward;
  view.last_reward = facts.last_reward;
  view.total_reward = facts.total_reward;
  view.learners = facts.numbers.size();
  for (sim::NumberFact& number : facts.numbers) {
    if (wanted(number.rule)) view.numbers.push_back(std::move(number));
  }
  std::ranges::stable_sort(view.numbers, std::ranges::greater(), &sim::NumberFact::value);
  if (!view.by_reward && view.learners > 0) {
    view.note = "reinforcement learning is off: rl --set learning on";
  } else if (view.by_reward && view.learners == 0) {
    view.note = "no rule can learn by reward: its only action must be a numeric preference for an operator";
  }
  return view;
}

std::string ToText(const LearningView& view) {
  std::string text;
  if (!view.note.empty()) text += view.note + "\n";
  if (view.learners > 0) {
    text += fmt::format("reward: {:g} at the last decision, {:g} in all\n", view.last_reward, view.total_reward);
    text += fmt::format("{:>12} {:>8}  {}\n", "number", "updates", "rule");
  }
  for (const sim::NumberFact& number : view.numbers) {
    text += fmt::format("{:>12.6f} {:>8}  {}\n", number.value, number.updates, number.rule);
  }
  if (!view.rules.empty()) text += fmt::format("{:>12} {:>8}  {}\n", "", "firings", "learned rule");
  for (const LearnedRuleRow& rule : view.rules) text += fmt::format("{:>12} {:>8}  {}\n", "", rule.firings, rule.name);
  if (text.empty()) text = "nothing has been learned\n";
  return text;
}

Json ToJson(const LearningView& view) {
  Json json;
  json["by_reward"] = view.by_reward;
  json["last_reward"] = view.last_reward;
  json["total_reward"] = view.total_reward;
  json["numbers"] = Json::array();
  for (const sim::NumberFact& number : view.numbers) {
    Json one;
    one["rule"] = number.rule;
    one["value"] = number.value;
    one["current"] = number.current;
    one["future"] = number.future;
    one["updates"] = number.updates;
    json["numbers"].push_back(std::move(one));
  }
  json["rules"] = Json::array();
  for (const LearnedRuleRow& rule : view.rules) {
    Json one;
    one["rule"] = rule.name;
    one["firings"] = rule.firings;
    json["rules"].push_back(std::move(one));
  }
  if (!view.note.empty()) json["note"] = view.note;
  return json;
}

}  // namespace soarbox::debugger
