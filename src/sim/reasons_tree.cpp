// SPDX-License-Identifier: BSD-2-Clause
//
// What led to something, or kept it from happening, as a tree of lines: the command, the rules that say it, the
// operator that they apply, the rules that propose it, and what these rest on or wait for.
#include <algorithm>

#include "diagnostics/diagnostic.h"
#include "sim/reasons.h"
#include "sim/rule_makers.h"
#include "tell/sentences.h"

namespace soarbox::sim {
namespace {

constexpr int kDeepest = 6;

std::string Indent(int depth) {
  return std::string(2 * static_cast<std::size_t>(depth), ' ');
}

}  // namespace

struct MindReasons::Tree {
  const std::set<std::string>& known;
  std::vector<std::string> lines;
  std::set<std::string> told;  ///< Operators and rules, so that no circle is followed twice.

  void Add(int depth, std::string text) { lines.push_back(Indent(depth) + std::move(text)); }
};

void MindReasons::TellRule(const RuleText& rule, int depth, Tree& tree) {
  if (depth > kDeepest || !tree.told.insert("rule " + rule.name).second) return;
  const std::string why = ExplainRule(rule, tree.known);
  if (why.empty()) return tree.Add(depth, "rule " + rule.name + ": all its conditions hold now");
  tree.Add(depth, why);
  const std::vector<ConditionText> waits = ReadCondition(rule, view_.Match(rule.name).failing);
  if (!waits.empty() && AsksForSelected(rule, waits.front())) {
    for (const std::string& name : rule.applies)
      if (!name.empty()) TellOperator(name, depth + 1, tree);
  } else if (const std::optional<ConditionText> wait = WaitOf(rule); wait && CircleFrom(rule, *wait).empty()) {
    const Makers makers = MakersOf(rule, *wait);
    if (const RuleText* maker = makers.sure != nullptr ? makers.sure : makers.maybe) TellRule(*maker, depth + 1, tree);
  }
}

void MindReasons::TellOperator(const std::string& name, int depth, Tree& tree) {
  if (depth > kDeepest || !tree.told.insert("operator " + name).second) return;
  std::string state = "S1";
  for (const StackEntry& entry : view_.Stack()) {
    if (entry.is_state) {
      state = entry.id;
      continue;
    }
    if (entry.about != name) continue;
    tree.Add(depth, "operator " + view_.DescribeOperator(entry.id) + " is selected in " + state);
    for (const Preference& preference : view_.Preferences(state, true)) {
      if (preference.operator_id != entry.id) continue;
      tree.Add(depth + 1, preference.section + ": by rule " + preference.rule);
      if (preference.section != "acceptable") continue;
      for (std::string& element : view_.Elements(preference)) tree.Add(depth + 2, std::move(element));
    }
    return;
  }
  // It may be proposed and another be preferred.
  const std::vector<StackEntry> stack = view_.Stack();
  const std::string top = stack.empty() ? "S1" : stack.front().id;
  const std::string chosen = stack.size() > 1 && !stack[1].is_state ? stack[1].about : std::string();
  bool proposed = false;
  for (const Preference& preference : view_.Preferences(top)) proposed |= preference.name == name;
  if (proposed) {
    tree.Add(depth, "operator " + name + " is proposed in " + top +
                        (chosen.empty() ? ", and none is selected" : ", and " + chosen + " is selected"));
    for (const Preference& preference : view_.Preferences(top)) {
      if (preference.section == "acceptable" && preference.name != name) continue;
      tree.Add(depth + 1, preference.section + ": " + preference.text + " by rule " + preference.rule);
    }
    return;
  }
  tree.Add(depth, "operator " + name + " is not proposed now" + (chosen.empty() ? "" : "; " + chosen + " is selected"));
  RuleList proposers;
  for (const RuleText& rule : rules())
    if (rule.proposes.contains(name) || rule.proposes.contains("")) proposers.push_back(&rule);
  const std::string failed = WhatFailed();
  if (proposers.empty())
    tree.Add(depth + 1, failed.empty() ? "no rule proposes it" : "no rule that loaded proposes it");
  if (!failed.empty()) tree.Add(depth + 1, failed);
  for (std::size_t i = 0; i < proposers.size() && i < 5; ++i) TellRule(*proposers[i], depth + 1, tree);
}

void MindReasons::TellCommand(const std::string& command, Tree& tree) {
  for (const RuleText& rule : rules()) {
    if (!rule.says.contains(command)) continue;
    tree.Add(1, "rule " + rule.name + " gives it" + (rule.applies.empty() ? "" : " when it applies an operator"));
    for (const std::string& name : rule.applies)
      if (!name.empty()) TellOperator(name, 2, tree);
    // What it waits for of an operator is told above.
    const std::vector<ConditionText> waits = ReadCondition(rule, view_.Match(rule.name).failing);
    if (waits.empty() || waits.front().path.front() != "operator") TellRule(rule, 2, tree);
  }
}

Result<std::vector<std::string>> MindReasons::WhyTopic(const std::string& topic, const std::set<std::string>& known) {
  std::vector<std::string_view> names;
  bool is_command = false, is_operator = false;
  for (const RuleText& rule : rules()) {
    names.push_back(rule.name);
    for (const auto* words : {&rule.says, &rule.proposes, &rule.applies})
      for (const std::string& word : *words)
        if (!word.empty() && word[0] != '<') names.push_back(word);
    is_command |= rule.says.contains(topic);
    is_operator |= rule.proposes.contains(topic) || rule.applies.contains(topic);
  }
  Tree tree{known, {}, {}};
  if (is_command) TellCommand(topic, tree);
  if (is_operator) TellOperator(topic, 1, tree);
  if (const RuleText* rule = view_.FindRule(topic)) TellRule(*rule, 1, tree);
  const std::vector<FailedRule> failed = StillFailed();
  if (std::ranges::find(failed, topic, &FailedRule::rule) != failed.end()) tree.Add(1, WhatFailed());
  if (!tree.lines.empty()) return std::move(tree.lines);
  Diagnostic problem;
  problem.message =
      failed.empty() ? "no rule gives or proposes '" + topic + "', and no rule has that name"
                     : "no rule that loaded gives or proposes '" + topic + "', and none has that name; " + WhatFailed();
  const std::string_view near = Suggest(topic, names);
  problem.hint = near.empty() ? "name a command, an operator or a rule" : "did you mean " + std::string(near) + "?";
  return problem;
}

std::vector<std::string> MindReasons::OperatorTree(const std::string& command) {
  std::vector<std::string> lines;
  std::vector<std::string> speakers;
  for (const RuleText& rule : rules())
    if (!command.empty() && rule.says.contains(command) && view_.HasFired(rule.name)) speakers.push_back(rule.name);
  if (speakers.size() == 1) lines.push_back("  " + tell::Say(tell::Situation::kSaidBy, {{"rule", speakers.front()}}));
  if (speakers.size() > 1)
    lines.push_back("  " + tell::Say(tell::Situation::kSaidByOneOf, {{"rules", tell::Listed(speakers)}}));
  const std::vector<StackEntry> stack = view_.Stack();
  const auto selected =
      std::find_if(stack.begin(), stack.end(), [](const StackEntry& entry) { return !entry.is_state; });
  if (selected == stack.end()) {
    lines.emplace_back("  no operator is selected now");
    return lines;
  }
  const std::string state = stack.front().is_state ? stack.front().id : "S1";
  lines.push_back("  operator " + view_.DescribeOperator(selected->id) + " (" + selected->id + "), selected in " +
                  state);
  for (const Preference& preference : view_.Preferences(state, true)) {
    const bool is_mine = preference.operator_id == selected->id;
    if (preference.section == "acceptable" && !is_mine) {
      lines.push_back("    also proposed: " + view_.DescribeOperator(preference.operator_id) + " (" +
                      preference.operator_id + ")");
      continue;
    }
    lines.push_back("    " + preference.section + ": " + preference.text +
                    (preference.rule.empty() ? "" : " by rule " + preference.rule));
    if (!is_mine || preference.section != "acceptable") continue;
    for (const std::string& element : view_.Elements(preference)) lines.push_back("        " + element);
  }
  return lines;
}

}  // namespace soarbox::sim
