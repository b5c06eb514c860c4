// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "kernel/learn/explained_rule.h"
#include "kernel/learn/explanation.h"
#include "kernel/learn/rule_builder.h"

namespace soarbox::kernel {

struct AgentCounters;
class Chunker;
class Descriptions;
class GoalStack;
class InstantiationTable;
struct LearnStatistics;
class Rete;
class SymbolTable;
class WorkingMemory;

/// The explanations that are kept until init-soar, also of rules that have been excised since. Off, nothing is kept.
class ExplanationLog {
 public:
  /// What it uses of the agent.
  struct Uses {
    const SymbolTable& symbols;
    const WorkingMemory& memory;
    const GoalStack& goals;
    const InstantiationTable& instantiations;
    const Rete& rete;
    const AgentCounters& counters;
    const Descriptions& descriptions;
    const Chunker& chunker;
    LearnStatistics& statistics;
  };
  ExplanationLog(const Uses& uses, FiringReader& reader, IdentityAnalysis& analysis, RuleBuilder& builder)
      : uses_(uses), reader_(reader), analysis_(analysis), builder_(builder) {}

  bool all = false;             ///< `explain all`
  bool justifications = false;  ///< `explain justifications`
  /// `explain record`: rules by name; also those marked with :explain.
  std::vector<std::string> watched;
  std::vector<std::string> watched_learned;  ///< Rules learned from those.

  /// Somebody watches the agent: explanations of all learned rules are noted for them, whatever the settings say. This
  /// changes neither the settings nor what `explain` prints.
  bool noting = false;
  static constexpr std::size_t kMostNoted = 1000;  ///< The oldest go.

  bool WantsChunkOf(InstantiationId base) const;
  /// The rule that was just made.
  struct Made {
    std::string_view name;
    ProductionPtr rule;  ///< None for justifications.
    InstantiationId instance = InstantiationId::kNone;
    GoalLevel level = 0;  ///< Of the state that it matched.
    bool repaired = false;
  };
  /// Each attempt to learn something that would be kept takes a number, whatever becomes of it.
  std::uint32_t TakeNumber() { return ++last_number_; }
  /// Keeps what the stages found out about the rule that was just made.
  void Add(const Explanation& explanation, std::uint32_t number, const Made& made);
  /// The same for those who watch.
  void Note(const Explanation& explanation, const Made& made);
  void CountDuplicate(std::string_view name);
  const std::vector<ExplainedRule>& rules() const { return rules_; }
  const std::deque<ExplainedRule>& noted() const { return noted_; }  ///< init-soar keeps them, as it keeps the rules.
  void Clear();
  std::size_t MemoryBytes() const { return bytes_; }  ///< What all explanations take.

 private:
  void Describe(ExplainedRule& out, const Explanation& explanation, const Made& made);
  ExplainedRule::Firing Describe(InstantiationId firing, const Explanation& explanation);
  /// The firing behind an item of the impasse.
  ExplainedRule::Firing Describe(WmeId item, std::uint32_t serial, const Explanation& explanation);
  /// What a test asks for beside the value itself, part by part; `referent` says what a comparison compares with.
  std::vector<std::string> Comparisons(const Test& test, bool with_state,
                                       const std::function<std::string(const Test&)>& referent) const;
  ExplainedRule::Field DescribeTest(const Test* test, Symbol value, InstantiationId firing, std::size_t condition,
                                    Field field);
  /// `own`: also the identities that fields had before all joining.
  ExplainedRule::Action DescribeAction(PreferenceId preference, bool own);
  std::string FunctionText(const RhsValue& function, InstantiationId firing, bool identities);
  void DescribeLearned(ExplainedRule& out, const Explanation& explanation);
  /// A negated condition: as it is written, as the rule that fired has it, and what it was.
  ExplainedRule::Condition DescribeNegated(const Condition& written, const Condition& source, const Condition& literal,
                                           InstantiationId firing, GoalLevel level);
  std::string IdentityText(const Test& test, InstantiationId firing);
  /// What a negated condition of a rule was in a firing.
  ProductionPtr Instantiated(const Condition& negation, InstantiationId firing);
  std::string Number(IdentityGraph::Node node);
  std::string Name(Symbol symbol) const;
  std::string NumberOfVariable(Symbol symbol) const;

  Uses uses_;
  FiringReader& reader_;
  IdentityAnalysis& analysis_;
  RuleBuilder& builder_;
  std::vector<ExplainedRule> rules_;
  std::unordered_set<std::uint32_t> explained_firings_;  ///< Serials of all that these rest on.
  std::deque<ExplainedRule> noted_;
  std::size_t bytes_ = 0;
  std::uint32_t last_number_ = 0;
  std::map<std::uint32_t, std::uint32_t> number_of_variable_;  ///< Scratch.
  std::vector<std::uint32_t> negated_identities_;              ///< Those that negated conditions name; scratch.
};

}  // namespace soarbox::kernel
