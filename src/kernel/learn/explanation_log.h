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

/// Stores explanations until init-soar, even of rules that have been excised since. Stores nothing while disabled.
class ExplanationLog {
 public:
  /// The parts of the agent that it uses.
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
  /// `explain record`: names of rules. Rules marked with :explain are recorded, too.
  std::vector<std::string> watched;
  std::vector<std::string> watched_learned;  ///< Rules learned from the watched ones.

  /// An observer is attached: explanations of all learned rules are stored in noted(), regardless of the settings. This
  /// changes neither the settings nor the output of `explain`.
  bool noting = false;
  static constexpr std::size_t kMostNoted = 1000;  ///< Maximum size of noted(); the oldest are removed.

  bool WantsChunkOf(InstantiationId base) const;
  /// The rule that was just built.
  struct Made {
    std::string_view name;
    ProductionPtr rule;  ///< None for justifications.
    InstantiationId instance = InstantiationId::kNone;
    GoalLevel level = 0;  ///< Level of the state that it matched.
    bool repaired = false;
  };
  /// Returns the number for an attempt to learn a rule whose explanation would be kept. Unsuccessful attempts use up a
  /// number, too.
  std::uint32_t TakeNumber() { return ++last_number_; }
  /// Stores the explanation of the rule that was just built.
  void Add(const Explanation& explanation, std::uint32_t number, const Made& made);
  /// Like Add, but stores it in noted().
  void Note(const Explanation& explanation, const Made& made);
  void CountDuplicate(std::string_view name);
  const std::vector<ExplainedRule>& rules() const { return rules_; }
  const std::deque<ExplainedRule>& noted() const { return noted_; }  ///< init-soar keeps them, like the rules.
  void Clear();
  std::size_t MemoryBytes() const { return bytes_; }  ///< Size of all explanations.

 private:
  void Describe(ExplainedRule& out, const Explanation& explanation, const Made& made);
  ExplainedRule::Firing Describe(InstantiationId firing, const Explanation& explanation);
  /// The architecture's firing for an item of the impasse.
  ExplainedRule::Firing Describe(WmeId item, std::uint32_t serial, const Explanation& explanation);
  /// Describes each part of a test except equality. `referent` returns the text of a comparison's right side.
  std::vector<std::string> Comparisons(const Test& test, bool with_state,
                                       const std::function<std::string(const Test&)>& referent) const;
  ExplainedRule::Field DescribeTest(const Test* test, Symbol value, InstantiationId firing, std::size_t condition,
                                    Field field);
  /// `own`: include the identities before they were joined.
  ExplainedRule::Action DescribeAction(PreferenceId preference, bool own);
  std::string FunctionText(const RhsValue& function, InstantiationId firing, bool identities);
  void DescribeLearned(ExplainedRule& out, const Explanation& explanation);
  /// Describes a negated condition: as in the learned rule, as in the rule that fired, and with the matched values.
  ExplainedRule::Condition DescribeNegated(const Condition& written, const Condition& source, const Condition& literal,
                                           InstantiationId firing, GoalLevel level);
  std::string IdentityText(const Test& test, InstantiationId firing);
  /// A negated condition with the values of a firing in place of variables.
  ProductionPtr Instantiated(const Condition& negation, InstantiationId firing);
  std::string Number(IdentityGraph::Node node);
  std::string Name(Symbol symbol) const;
  std::string NumberOfVariable(Symbol symbol) const;

  Uses uses_;
  FiringReader& reader_;
  IdentityAnalysis& analysis_;
  RuleBuilder& builder_;
  std::vector<ExplainedRule> rules_;
  std::unordered_set<std::uint32_t> explained_firings_;  ///< Serial numbers of all firings in the explanations.
  std::deque<ExplainedRule> noted_;
  std::size_t bytes_ = 0;
  std::uint32_t last_number_ = 0;
  std::map<std::uint32_t, std::uint32_t> number_of_variable_;  ///< Scratch.
  std::vector<std::uint32_t> negated_identities_;              ///< Scratch: the identities in negated conditions.
};

}  // namespace soarbox::kernel
