// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/learning.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

#include "debugger/learned_rule.h"
#include "debugger/recorded_mind.h"

namespace soarbox::debugger {

namespace {

bool Wanted(const LearnedRuleRow& row, std::string_view text) {
  return row.name.find(text) != std::string::npos || row.purpose.find(text) != std::string::npos;
}

/// Adds what the log contains about a learned rule.
void TellWhen(const LearningLog* log, std::uint64_t until, LearnedRuleRow& row) {
  const LearnedRule* const learned = log == nullptr ? nullptr : log->Find(row.name);
  if (learned == nullptr || learned->tick > until) return;
  row.tick = learned->tick;
  if (row.source.empty()) row.source = learned->reason;
}

/// Fills in the view of a mind that is not simulated again.
void LookAtLog(const LearningLog& log, std::uint64_t until, std::string_view text, LearningView& view) {
  for (auto learned = log.rules().rbegin(); learned != log.rules().rend(); ++learned) {
    if (learned->tick > until) continue;
    LearnedRuleRow row;
    row.name = learned->name;
    row.tick = learned->tick;
    row.source = learned->reason;
    row.firings = static_cast<std::uint64_t>(
        std::ranges::count_if(learned->fired, [&](std::uint64_t tick) { return tick <= until; }));
    if (Wanted(row, text)) view.rules.push_back(std::move(row));
  }
  for (const auto& [rule, points] : log.values()) {
    explain::NumberFact number;
    number.rule = rule;
    for (const auto& [tick, value] : points) {
      if (tick > until) break;
      number.value = value;
      ++number.updates;
    }
    if (number.updates == 0) continue;
    ++view.learners;
    if (rule.find(text) != std::string::npos) view.numbers.push_back(std::move(number));
  }
  view.by_reward = view.learners > 0;
  double before = 0;
  for (const auto& [tick, total] : log.rewards()) {
    if (tick > until) break;
    view.last_reward = total - before;
    view.total_reward = before = total;
  }
}

}  // namespace

LearningView LookAtLearning(explain::Inspector& mind, std::string_view text, const LearningLog* log,
                            std::uint64_t until) {
  LearningView view;
  auto* const source = dynamic_cast<explain::LearningSource*>(&mind);
  if (source == nullptr) {
    if (log != nullptr && !log->empty()) {
      LookAtLog(*log, until, text, view);
      view.note = "As recorded. What the rules do appears once this moment is simulated again.";
    } else {
      view.note = "what it has learned: " + std::string(Absence(mind));
    }
    std::ranges::stable_sort(view.numbers, std::ranges::greater(), &explain::NumberFact::value);
    return view;
  }
  std::map<std::string, const explain::LearnedRuleFact*, std::less<>> learned_rules;
  const std::vector<explain::LearnedRuleFact> told = source->LearnedRules();
  for (const explain::LearnedRuleFact& learned : told) learned_rules[learned.rule] = &learned;
  const auto add = [&](LearnedRuleRow row) {
    if (const auto learned = learned_rules.find(row.name); learned != learned_rules.end()) {
      row.source = learned->second->state + ": " + ImpasseOf(*learned->second);
      row.purpose = PurposeOf(*learned->second);
      learned_rules.erase(learned);
    }
    TellWhen(log, until, row);
    if (Wanted(row, text)) view.rules.push_back(std::move(row));
  };
  for (const explain::RuleFact& rule : mind.Rules()) {
    if (rule.type != "chunk") continue;
    LearnedRuleRow row;
    row.name = rule.name;
    row.firings = rule.firings;
    add(std::move(row));
  }
  for (const explain::LearnedRuleFact& learned : told) {
    if (!learned_rules.contains(learned.rule)) continue;
    LearnedRuleRow row;
    row.name = learned.rule;
    row.is_gone = true;
    add(std::move(row));
  }
  std::ranges::reverse(view.rules);
  explain::LearningFacts facts = source->Learning();
  view.by_reward = facts.by_reward;
  view.last_reward = facts.last_reward;
  view.total_reward = facts.total_reward;
  view.learners = facts.numbers.size();
  for (explain::NumberFact& number : facts.numbers) {
    if (number.rule.find(text) != std::string::npos) view.numbers.push_back(std::move(number));
  }
  std::ranges::stable_sort(view.numbers, std::ranges::greater(), &explain::NumberFact::value);
  if (!view.by_reward && view.learners > 0) {
    view.note = "reinforcement learning is off: rl --set learning on";
  } else if (view.by_reward && view.learners == 0) {
    view.note = "no rule can learn by reward: its only action must be a numeric preference for an operator";
  }
  return view;
}

LearnedRuleView LookAtLearnedRule(explain::Inspector& mind, const std::string& rule, const LearningLog* log,
                                  std::uint64_t until) {
  LearnedRuleView view;
  if (rule.empty()) return view;
  const LearnedRule* const learned = log == nullptr ? nullptr : log->Find(rule);
  if (std::optional<WhyNode> why = WhyLearned(mind, rule)) {
    view.why = *std::move(why);
  } else if (learned != nullptr && learned->tick <= until) {
    view.why = {rule + ": learned " + learned->reason, WhyKind::kLearned, rule};
    view.why.below.push_back({"why its conditions are there: " + std::string(Absence(mind))});
  } else {
    return view;
  }
  view.name = rule;
  if (learned != nullptr) {
    for (const std::uint64_t tick : learned->fired) {
      if (tick <= until) view.fired.push_back(tick);
    }
  }
  if (view.fired.empty()) {
    view.fired_note = "no firing noted (they are noted while the agent is selected, and at the recording level all)";
  }
  return view;
}

std::vector<std::string> MostMoved(const LearningView& view, std::size_t most) {
  std::vector<const explain::NumberFact*> moved;
  for (const explain::NumberFact& number : view.numbers)
    if (number.updates > 0) moved.push_back(&number);
  std::ranges::stable_sort(moved, std::ranges::greater(), &explain::NumberFact::updates);
  std::vector<std::string> rules;
  for (const explain::NumberFact* number : moved)
    if (rules.size() < most) rules.push_back(number->rule);
  return rules;
}

std::string ToText(const LearningView& view) {
  std::string text;
  if (!view.note.empty()) text += view.note + "\n";
  if (view.learners > 0) {
    text += fmt::format("reward: {:g} at the last decision, {:g} in all\n", view.last_reward, view.total_reward);
    text += fmt::format("{:>12} {:>8}  {}\n", "number", "updates", "rule");
  }
  for (const explain::NumberFact& number : view.numbers) {
    text += fmt::format("{:>12.6f} {:>8}  {}{}\n", number.value, number.updates, number.rule,
                        number.when.empty() ? "" : "  if " + number.when);
  }
  if (!view.rules.empty()) text += fmt::format("{:>12} {:>8}  {}\n", "", "firings", "learned rule");
  for (const LearnedRuleRow& rule : view.rules) {
    text += fmt::format("{:>12} {:>8}  {}{}\n", rule.tick ? "tick " + std::to_string(*rule.tick) : "", rule.firings,
                        rule.name, rule.is_gone ? " (excised)" : "");
    if (!rule.purpose.empty()) text += fmt::format("{:>21}    it {}\n", "", rule.purpose);
    if (!rule.source.empty()) text += fmt::format("{:>21}    {}\n", "", rule.source);
  }
  if (text.empty()) text = "nothing has been learned\n";
  return text;
}

std::string ToText(const LearnedRuleView& view) {
  if (view.name.empty()) return {};
  std::string text = ToText(view.why);
  if (!view.fired_note.empty()) return text + "fired since: " + view.fired_note + "\n";
  text += "fired since, by ticks:";
  for (const std::uint64_t tick : view.fired) text += " " + std::to_string(tick);
  return text + "\n";
}

std::string ToText(const std::deque<RewardEpisode>& episodes) {
  std::string text;
  for (std::size_t n = 0; n < episodes.size(); ++n) {
    text += fmt::format("episode {}: reward {:g}, ticks {} to {}\n", n + 1, episodes[n].reward, episodes[n].first_tick,
                        episodes[n].last_tick);
  }
  return text;
}

}  // namespace soarbox::debugger
