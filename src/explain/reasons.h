// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
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
#include "explain/reason.h"
#include "explain/why_node.h"
#include "mind/decision_facts.h"

namespace soarbox::explain {

/// Explains in sentences (wording/sentences.h) why a Soar program does something or does not. Queries the kernel only
/// during calls.
class MindReasons {
 public:
  explicit MindReasons(sml::Agent& agent, std::vector<FailedRule> failed = {})
      : agent_(agent), view_(agent), failed_(std::move(failed)) {}

  /// Explains why the program does nothing; the most informative reason first. Each reason is one or two full
  /// sentences. `known`: attributes that come from elsewhere (percepts of scripts, messages of other agents).
  std::vector<Reason> WhyIdle(const std::set<std::string>& known);
  /// Attributes that the rules test but that no percept, rule or answer ever writes.
  std::vector<Reason> UnwrittenAttributes(const std::set<std::string>& known);
  /// Explains how a command was made, as recorded at that time, and why it is still on the output link. Without an
  /// origin, the answer says that it is not known.
  std::vector<WhyNode> CommandTree(const std::string& command, const DecisionTime& time);
  /// Explains the selected operator: its proposals, preferences and the elements that they depend on.
  std::vector<WhyNode> OperatorTree();
  /// Explains why a command is or is not given, an operator is or is not selected, or a rule does or does not match.
  /// Fails if the rules contain nothing of that name.
  Result<std::vector<WhyNode>> WhyTopic(const std::string& topic, const std::set<std::string>& known);
  /// Names the rules that call (halt) and have fired. For a program that has halted.
  std::string WhyHalted();

  const std::vector<RuleText>& rules() { return view_.rules(); }

 private:
  using RuleList = std::vector<const RuleText*>;

  /// The rules that can make what a condition requires, as far as their texts show it.
  struct Makers {
    const RuleText* sure = nullptr;   ///< Makes it whenever it fires.
    const RuleText* maybe = nullptr;  ///< Makes it if the value fits.
    const RuleText* other = nullptr;  ///< Makes another value, `other_value`.
    std::string other_value;
    RuleList all;          ///< All that may make it, or may make it for another object; includes those that require it
                           ///< themselves.
    bool is_known = true;  ///< All rules are known, and none makes attributes whose names are known only when it fires.
  };
  /// A rule, and its condition that does not match yet.
  struct Wait {
    const RuleText* rule;
    ConditionText condition;
  };

  /// The first condition of a rule that does not match; nothing if all match.
  std::optional<RuleWait> ExplainRule(const RuleText& rule, const std::set<std::string>& known);
  /// Describes a negated condition about the state above that fails because an element matches it. The kernel reports a
  /// later condition instead, because the negated one holds for the top state, which has no state above it. Returns
  /// nothing if there is no such condition.
  std::optional<RuleWait> WhatExcludesAbove(const RuleText& rule, const ConditionText& failing);
  /// The substate in which the operator that a rule applies is selected; empty if there is none.
  std::string SubstateOfSelected(const RuleText& rule);
  RuleWait::Found ExplainAbsence(const RuleText& rule, const ConditionText& condition,
                                 const std::set<std::string>& known);
  /// Explains the rules among `candidates` that are nearest to a match, and the rules that make what they require.
  std::vector<Reason> Nearest(const RuleList& candidates, const std::set<std::string>& known);
  /// For a condition about an operator that is not selected: "the operator selected in S1 is rest (O1)".
  std::string ExplainSelected(const RuleText& rule, const ConditionText& condition);
  std::vector<Reason> WhyNotApplied(const StackEntry& selected, const std::string& state, bool is_below,
                                    const std::set<std::string>& known);
  Makers MakersOf(const RuleText& rule, const ConditionText& condition);
  /// Follows the chain from a condition to the only rule that makes the required element, to the condition for which
  /// that rule waits, and so on. Returns the members of a circle if the chain ends in one; else nothing.
  std::vector<Wait> CircleFrom(const RuleText& rule, const ConditionText& condition);
  /// The first condition of a rule that fails, if another rule could make the required element.
  std::optional<ConditionText> WaitOf(const RuleText& rule);
  /// " when it applies fetch", or nothing.
  static std::string Applying(const RuleText& maker);
  /// Errors of rules that are still missing.
  std::vector<FailedRule> StillFailed();
  /// Describes the rules that failed to load: "rule x in hero.soar:7 failed to parse: ...". Empty if all loaded.
  std::string WhatFailed();
  /// The state of the stack that a rule is about: for a rule for substates, the substate of the operator that it works
  /// on, or the lowest state; for other rules, the substate in which its operator is selected, or the top state.
  std::string StateOf(const RuleText& rule);
  /// If a state above has a path that a substate lacks, says which state, and how to test it; else empty.
  std::string WhichStateAboveHas(const std::string& state, const std::vector<std::string>& path);

  struct Told;
  void TellCommand(const std::string& command, Told& told, std::vector<WhyNode>& into);
  void TellOperator(const std::string& name, int depth, Told& told, std::vector<WhyNode>& into);
  void TellRule(const RuleText& rule, int depth, Told& told, std::vector<WhyNode>& into);
  enum class PreferenceWords : std::uint8_t {
    kAlone,
    kWithElements,     ///< With the elements on which a proposal depends.
    kRuleAndElements,  ///< The same, without the operator, which the step above names.
  };
  WhyNode OfPreference(const std::string& state, const PreferenceFact& preference, PreferenceWords words);

  sml::Agent& agent_;
  MindView view_;
  std::vector<FailedRule> failed_;
};

/// Returns the most similar attribute of percepts and `known`; empty if none is similar.
std::string SimilarAttribute(std::string_view attribute, const std::set<std::string>& known);
/// Returns "did you mean ^distance?"; empty without an attribute.
std::string DidYouMean(const std::string& attribute);

}  // namespace soarbox::explain
