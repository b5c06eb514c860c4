// SPDX-License-Identifier: BSD-2-Clause
//
// Explains why something happened or did not happen, as a tree of lines: the command, the rules that give it, the
// operator that they apply, the rules that propose it, and the elements that these depend on or require.
#include <algorithm>

#include "diagnostics/diagnostic.h"
#include "explain/reasons.h"
#include "explain/rule_makers.h"
#include "sml_Client.h"
#include "wording/sentences.h"
#ifdef SOARBOX_OWN_KERNEL
#include "soarbox_Inspection.h"
#endif

namespace soarbox::explain {
namespace {

constexpr int kDeepest = 6;

void Append(const WhyNode& node, std::size_t indent, std::vector<std::string>& lines) {
  lines.push_back(std::string(2 * indent, ' ') + node.text);
  for (const WhyNode& below : node.below) Append(below, indent + 1, lines);
}

}  // namespace

std::vector<std::string> Lines(const WhyNode& node, std::size_t indent) {
  std::vector<std::string> lines;
  Append(node, indent, lines);
  return lines;
}

std::vector<std::string> AccountLines(const std::optional<WhyNode>& account) {
  std::vector<std::string> lines;
  if (!account) return lines;
  lines.push_back(account->text);
  for (const WhyNode& below : account->below) Append(below, 0, lines);
  return lines;
}

/// What has already been explained, so that circles end.
struct MindReasons::Told {
  const std::set<std::string>& known;
  std::set<std::string> names;  ///< Of operators and rules.
};

void MindReasons::TellRule(const RuleText& rule, int depth, Told& told, std::vector<WhyNode>& into) {
  if (depth > kDeepest || !told.names.insert("rule " + rule.name).second) return;
  const std::optional<RuleWait> waiting = ExplainRule(rule, told.known);
  WhyNode& node = into.emplace_back(WhyNode{
      waiting ? waiting->Text() : "rule " + rule.name + ": all its conditions hold now", WhyKind::kRule, rule.name});
  node.wait = waiting;
  if (!waiting) return;
  const std::vector<ConditionText> waits = ReadCondition(rule, view_.Match(rule.name).failing);
  if (!waits.empty() && AsksForSelected(rule, waits.front())) {
    for (const std::string& name : rule.applies)
      if (!name.empty()) TellOperator(name, depth + 1, told, node.below);
  } else if (const std::optional<ConditionText> wait = WaitOf(rule); wait && CircleFrom(rule, *wait).empty()) {
    const Makers makers = MakersOf(rule, *wait);
    if (const RuleText* maker = makers.sure != nullptr ? makers.sure : makers.maybe)
      TellRule(*maker, depth + 1, told, node.below);
  }
}

WhyNode MindReasons::OfPreference(const std::string& state, const PreferenceFact& preference, PreferenceWords words) {
  const std::string& rule = preference.maker.rule;
  std::string text = preference.type;
  if (text == "indifferent") text = "unary indifferent";
  if (text == "numeric") text = "numeric indifferent";
  if (text == "equal") text = "binary indifferent";
  text += ":";
  if (words != PreferenceWords::kRuleAndElements) text += " " + PreferenceText(preference);
  if (!rule.empty()) text += " by rule " + rule;
  WhyNode node{std::move(text), WhyKind::kPreference, rule};
  if (words == PreferenceWords::kAlone || preference.type != "acceptable") return node;
  for (std::string& element : view_.Elements(state, preference))
    node.below.push_back({std::move(element), WhyKind::kElement});
  return node;
}

void MindReasons::TellOperator(const std::string& name, int depth, Told& told, std::vector<WhyNode>& into) {
  if (depth > kDeepest || !told.names.insert("operator " + name).second) return;
  std::string state = "S1";
  for (const StackEntry& entry : view_.Stack()) {
    if (entry.is_state) {
      state = entry.id;
      continue;
    }
    if (entry.about != name) continue;
    WhyNode& node = into.emplace_back(WhyNode{
        "operator " + view_.DescribeOperator(entry.id) + " is selected in " + state, WhyKind::kOperator, entry.id});
    for (const PreferenceFact& preference : view_.Preferences(state))
      if (preference.value == entry.id)
        node.below.push_back(OfPreference(state, preference, PreferenceWords::kRuleAndElements));
    return;
  }
  // It may be proposed while another operator is preferred.
  const std::vector<StackEntry> stack = view_.Stack();
  const std::string top = stack.empty() ? "S1" : stack.front().id;
  const std::string chosen = stack.size() > 1 && !stack[1].is_state ? stack[1].about : std::string();
  const std::vector<PreferenceFact> preferences = view_.Preferences(top);
  if (std::ranges::find(preferences, name, &PreferenceFact::name) != preferences.end()) {
    WhyNode& node =
        into.emplace_back(WhyNode{"operator " + name + " is proposed in " + top +
                                      (chosen.empty() ? ", and none is selected" : ", and " + chosen + " is selected"),
                                  WhyKind::kOperator, name});
    for (const PreferenceFact& preference : preferences)
      if (preference.type != "acceptable" || preference.name == name)
        node.below.push_back(OfPreference(top, preference, PreferenceWords::kAlone));
    return;
  }
  WhyNode& node = into.emplace_back(
      WhyNode{"operator " + name + " is not proposed now" + (chosen.empty() ? "" : "; " + chosen + " is selected"),
              WhyKind::kOperator, name});
  RuleList proposers;
  for (const RuleText& rule : rules())
    if (rule.proposes.contains(name) || rule.proposes.contains("")) proposers.push_back(&rule);
  const std::string failed = WhatFailed();
  if (proposers.empty())
    node.below.push_back({failed.empty() ? "no rule proposes it" : "no rule that loaded proposes it"});
  if (!failed.empty()) node.below.push_back({failed});
  for (std::size_t i = 0; i < proposers.size() && i < 5; ++i) {
    const std::size_t before = node.below.size();
    TellRule(*proposers[i], depth + 1, told, node.below);
    if (node.below.size() > before && !node.below.back().wait && ProposesWithoutName(*proposers[i]))
      node.below.back().text += ", but the operator that it proposes has no ^name";
  }
}

void MindReasons::TellCommand(const std::string& command, Told& told, std::vector<WhyNode>& into) {
  const bool was_given = std::ranges::any_of(
      rules(), [&](const RuleText& rule) { return rule.says.contains(command) && view_.HasFired(rule.name); });
  if (was_given) {
    into = CommandTree(command, {});
  } else {
    into.push_back({wording::Say(wording::Situation::kNeverGiven, {{"command", command}})});
  }
  for (const RuleText& rule : rules()) {
    if (!rule.says.contains(command)) continue;
    WhyNode& node = into.emplace_back(
        WhyNode{"rule " + rule.name + " gives it" + (rule.applies.empty() ? "" : " when it applies an operator"),
                WhyKind::kRule, rule.name});
    for (const std::string& name : rule.applies)
      if (!name.empty()) TellOperator(name, 2, told, node.below);
    // Requirements on an operator were reported above.
    const std::vector<ConditionText> waits = ReadCondition(rule, view_.Match(rule.name).failing);
    if (waits.empty() || waits.front().path.front() != "operator") TellRule(rule, 2, told, node.below);
  }
}

Result<std::vector<WhyNode>> MindReasons::WhyTopic(const std::string& topic, const std::set<std::string>& known) {
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
  Told told{known, {}};
  std::vector<WhyNode> reasons;
  if (is_command) TellCommand(topic, told, reasons);
  if (is_operator) TellOperator(topic, 1, told, reasons);
  if (const RuleText* rule = view_.FindRule(topic)) TellRule(*rule, 1, told, reasons);
  const std::vector<FailedRule> failed = StillFailed();
  if (std::ranges::find(failed, topic, &FailedRule::rule) != failed.end()) reasons.push_back({WhatFailed()});
  if (!reasons.empty()) return reasons;
  Diagnostic problem;
  problem.message =
      failed.empty() ? "no rule gives or proposes '" + topic + "', and no rule has that name"
                     : "no rule that loaded gives or proposes '" + topic + "', and none has that name; " + WhatFailed();
  const std::string_view near = Suggest(topic, names);
  problem.hint = near.empty() ? "name a command, an operator or a rule" : "did you mean " + std::string(near) + "?";
  return problem;
}

std::vector<WhyNode> MindReasons::CommandTree(const std::string& command, const DecisionTime& time) {
#ifdef SOARBOX_OWN_KERNEL
  const mind::OriginFacts facts = AskCommandOrigin(agent_, command);
#else
  const mind::OriginFacts facts;
#endif
  std::vector<WhyNode> nodes = OriginTree(facts, time, true);
  if (!nodes.empty()) {
    std::vector<std::string> selected;
    for (const StackEntry& entry : view_.Stack())
      if (!entry.is_state) selected.push_back(entry.id);
    for (WhyNode& reason : PresentReason(facts, selected)) nodes.push_back(std::move(reason));
    return nodes;
  }
  // Reports what the rules show. They do not show which operator was selected at that time.
  std::vector<std::string> speakers;
  for (const RuleText& rule : rules())
    if (rule.says.contains(command) && view_.HasFired(rule.name)) speakers.push_back(rule.name);
  if (speakers.size() == 1)
    nodes.push_back(
        {wording::Say(wording::Situation::kSaidBy, {{"rule", speakers.front()}}), WhyKind::kRule, speakers.front()});
  if (speakers.size() > 1)
    nodes.push_back({wording::Say(wording::Situation::kSaidByOneOf, {{"rules", wording::Listed(speakers)}})});
  nodes.push_back(
      {wording::Say(facts.noted ? wording::Situation::kOriginNotNoted : wording::Situation::kOriginUnknown)});
  return nodes;
}

std::vector<WhyNode> MindReasons::OperatorTree() {
  std::vector<WhyNode> nodes;
  const std::vector<StackEntry> stack = view_.Stack();
  const auto selected =
      std::find_if(stack.begin(), stack.end(), [](const StackEntry& entry) { return !entry.is_state; });
  if (selected == stack.end()) {
    nodes.push_back({"no operator is selected now"});
    return nodes;
  }
  const std::string state = stack.front().is_state ? stack.front().id : "S1";
  WhyNode& node = nodes.emplace_back(
      WhyNode{"operator " + view_.DescribeOperator(selected->id) + " (" + selected->id + "), selected in " + state,
              WhyKind::kOperator, selected->id});
  for (const PreferenceFact& preference : view_.Preferences(state)) {
    const bool is_mine = preference.value == selected->id;
    if (preference.type == "acceptable" && !is_mine) {
      node.below.push_back(
          {"also proposed: " + view_.DescribeOperator(preference.value) + " (" + preference.value + ")",
           WhyKind::kOperator, preference.value});
    } else {
      node.below.push_back(
          OfPreference(state, preference, is_mine ? PreferenceWords::kWithElements : PreferenceWords::kAlone));
    }
  }
  return nodes;
}

}  // namespace soarbox::explain
