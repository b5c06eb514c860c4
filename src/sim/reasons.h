// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "diagnostics/result.h"
#include "sim/mind_view.h"

namespace soarbox::sim {

/// Why a Soar program does what it does, or does not, in sentences. Costs nothing until somebody asks.
class MindReasons {
 public:
  /// `failed`: where rules stand that did not load, "hero.soar:12".
  explicit MindReasons(sml::Agent& agent, std::vector<std::string> failed = {})
      : view_(agent), failed_(std::move(failed)) {}

  /// Why it does nothing, most telling first; each a whole sentence or two. `known`: attributes that are made
  /// elsewhere (percepts of scripts, other agents' messages).
  std::vector<std::string> WhyIdle(const std::set<std::string>& known);
  /// Attributes that its rules test and that no sense, rule or answer ever writes.
  std::vector<std::string> UnwrittenAttributes(const std::set<std::string>& known);
  /// What led to the operator that is selected: proposals, preferences and the elements that they rest on, as lines.
  std::vector<std::string> OperatorTree(const std::string& command);
  /// Why a command is or is not said, an operator is or is not selected, or a rule does or does not match, as an
  /// indented tree of lines. An error if its rules know nothing of that name.
  Result<std::vector<std::string>> WhyTopic(const std::string& topic, const std::set<std::string>& known);
  /// The rules that call (halt), for a program that has halted.
  std::string WhyHalted();

  const std::vector<RuleText>& rules() { return view_.rules(); }

 private:
  using RuleList = std::vector<const RuleText*>;

  /// "rule x requires ^io.input-link.self.health < 50, but it is 100"; empty if all its conditions hold.
  std::string ExplainRule(const RuleText& rule, const std::set<std::string>& known);
  std::string ExplainAbsence(const RuleText& rule, const ConditionText& condition, const std::set<std::string>& known);
  /// The nearest of these rules, each explained, and the rules that make what they wait for.
  std::vector<std::string> Nearest(const RuleList& candidates, const std::set<std::string>& known);
  std::vector<std::string> ExplainTie(const std::string& state);
  std::vector<std::string> ExplainConflict(const std::string& state, const std::string& about);
  std::vector<std::string> WhyNotApplied(const StackEntry& selected, const std::string& state, bool is_below,
                                         const std::set<std::string>& known);
  /// The rule, other than this one, whose action makes what the condition waits for: there, and with a value that may
  /// pass its test. Null if none does.
  const RuleText* MakerOf(const RuleText& rule, const ConditionText& condition);
  /// "; rule x makes it", and for which operator it does.
  static std::string MadeBy(const RuleText& maker);
  /// Rules that did not load, as something to mend before others are written; empty if all did.
  std::string WhatFailed() const;
  std::string StateOf(const RuleText& rule);

  struct Tree;
  void TellCommand(const std::string& command, Tree& tree);
  void TellOperator(const std::string& name, int depth, Tree& tree);
  void TellRule(const RuleText& rule, int depth, Tree& tree);

  MindView view_;
  std::vector<std::string> failed_;
};

/// "did you mean ^distance?" or nothing, from percepts and these.
std::string SuggestAttribute(std::string_view attribute, const std::set<std::string>& known);

/// Whether a rule works in a substate: it tests a superstate.
bool IsForSubstate(const RuleText& rule);

}  // namespace soarbox::sim
