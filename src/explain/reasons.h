// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "diagnostics/result.h"
#include "explain/failed_rule.h"
#include "explain/mind_view.h"
#include "explain/origin_tree.h"
#include "explain/why_node.h"
#include "mind/decision.h"

namespace soarbox::explain {

/// Why a Soar program does what it does, or does not, in sentences (tell/sentences.h). Costs nothing until somebody
/// asks.
class MindReasons {
 public:
  explicit MindReasons(sml::Agent& agent, std::vector<FailedRule> failed = {})
      : agent_(agent), view_(agent), failed_(std::move(failed)) {}

  /// Why it does nothing, most telling first; each a whole sentence or two. `known`: attributes that are made
  /// elsewhere (percepts of scripts, other agents' messages).
  std::vector<std::string> WhyIdle(const std::set<std::string>& known);
  /// Attributes that its rules test and that no percept, rule or answer ever writes.
  std::vector<std::string> UnwrittenAttributes(const std::set<std::string>& known);
  /// How a command came to be, as it was then, and why it is still there. Without an origin: that it is not known.
  std::vector<WhyNode> CommandTree(const std::string& command, const DecisionTime& time);
  /// What led to the operator that is selected: proposals, preferences and the elements that they rest on.
  std::vector<WhyNode> OperatorTree();
  /// Why a command is or is not given, an operator is or is not selected, or a rule does or does not match. An error if
  /// its rules know nothing of that name.
  Result<std::vector<WhyNode>> WhyTopic(const std::string& topic, const std::set<std::string>& known);
  /// The rules that call (halt), for a program that has halted.
  std::string WhyHalted();

  const std::vector<RuleText>& rules() { return view_.rules(); }

 private:
  using RuleList = std::vector<const RuleText*>;

  /// The rules that make what a condition waits for, as far as the rules show.
  struct Makers {
    const RuleText* sure = nullptr;   ///< Makes it whenever it fires.
    const RuleText* maybe = nullptr;  ///< Makes it if the value fits.
    const RuleText* other = nullptr;  ///< Makes another value, `other_value`.
    std::string other_value;
    RuleList all;          ///< All that may make it, or might elsewhere; those that wait for it themselves, too.
    bool is_known = true;  ///< No rule is missing, and none makes attributes that only a firing names.
  };
  /// A rule that waits, and what for.
  struct Wait {
    const RuleText* rule;
    ConditionText condition;
  };

  /// "rule x requires ^io.input-link.self.health < 50, but it is 100"; empty if all its conditions match.
  std::string ExplainRule(const RuleText& rule, const std::set<std::string>& known);
  /// A negated condition about the state above that something matches: the kernel looks on at the top state, which has
  /// no state above it, and names a later condition. Empty: there is none.
  std::string WhatExcludesAbove(const RuleText& rule, const ConditionText& failing);
  /// The substate in which the operator that a rule applies is selected; empty: there is none.
  std::string SubstateOfSelected(const RuleText& rule);
  std::string ExplainAbsence(const RuleText& rule, const ConditionText& condition, const std::set<std::string>& known);
  /// The nearest of these rules, each explained, and the rules that make what they wait for.
  std::vector<std::string> Nearest(const RuleList& candidates, const std::set<std::string>& known);
  /// "the operator selected in S1 is rest (O1)", for a condition about another one.
  std::string ExplainSelected(const RuleText& rule, const ConditionText& condition);
  /// `below`: the state that the impasse led to.
  std::vector<std::string> ExplainTie(const std::string& state, const std::string& below);
  std::vector<std::string> ExplainConflict(const std::string& state, const StackEntry& below);
  std::vector<std::string> WhyNotApplied(const StackEntry& selected, const std::string& state, bool is_below,
                                         const std::set<std::string>& known);
  /// Why all that are proposed in a state were dropped; empty if none is proposed, or if that is not reported.
  std::string WhyAllDropped(const std::string& state);
  /// What the decision procedure says of a state's operators; empty if the kernel does not report it.
  mind::Decision DecisionOf(const std::string& state);
  Makers MakersOf(const RuleText& rule, const ConditionText& condition);
  /// Goes from what a rule waits for to the only rule that makes it, and on. If that ends in a circle: who waits for
  /// what in it; else empty.
  std::vector<Wait> CircleFrom(const RuleText& rule, const ConditionText& condition);
  /// The condition at which a rule stops, if another rule could make what it asks for.
  std::optional<ConditionText> WaitOf(const RuleText& rule);
  /// " when it applies fetch", or nothing.
  static std::string Applying(const RuleText& maker);
  /// Errors of rules that are missing now.
  std::vector<FailedRule> StillFailed();
  /// "rule x in hero.soar:7 failed to parse: ..."; empty if all loaded.
  std::string WhatFailed();
  std::string StateOf(const RuleText& rule);
  /// If a state above has a path that a substate lacks: where, and how to test it; else empty.
  std::string WhichStateAboveHas(const std::string& state, const std::vector<std::string>& path);

  struct Told;
  void TellCommand(const std::string& command, Told& told, std::vector<WhyNode>& into);
  void TellOperator(const std::string& name, int depth, Told& told, std::vector<WhyNode>& into);
  void TellRule(const RuleText& rule, int depth, Told& told, std::vector<WhyNode>& into);
  WhyNode OfPreference(const std::string& state, const Preference& preference, bool with_elements);

  sml::Agent& agent_;
  MindView view_;
  std::vector<FailedRule> failed_;
};

/// "did you mean ^distance?" or nothing, from percepts and these.
std::string SuggestAttribute(std::string_view attribute, const std::set<std::string>& known);

}  // namespace soarbox::explain
