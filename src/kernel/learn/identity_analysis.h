// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/learn/explanation.h"
#include "kernel/learn/firing_reader.h"
#include "kernel/learn/identity_graph.h"

namespace soarbox::kernel {

class Chunker;
class GoalStack;
class InstantiationTable;
class Singletons;
class WorkingMemory;

/// Why two identities are one, or why one stands for a literal value only.
enum class JoinReason : std::uint8_t {
  kRule,              ///< A condition tests what an action of another rule made.
  kSingleton,         ///< Two conditions test one element that is the only one of its kind.
  kChild,             ///< A result is part of another one.
  kConstantTested,    ///< A rule tests a constant where another one made a variable value.
  kConstantMade,      ///< A rule made a constant that another one tests by variable.
  kFunctionResult,    ///< A rule tests the value of a function.
  kFunctionArgument,  ///< It is an argument of a function that was evaluated.
  kSingletonLiteral,  ///< A condition on the same singleton tests a constant.
  kMarkedLiteral,     ///< A rule marks the variable: `$ <x>`.
};

/// What the third stage did, in order; kept only while somebody wants an explanation.
struct JoinEvent {
  JoinReason reason = JoinReason::kRule;
  InstantiationId firing = InstantiationId::kNone;
  IdentityGraph::Node from = IdentityGraph::kNone;
  IdentityGraph::Node to = IdentityGraph::kNone;  ///< kNone: literalized.
};

/// The third stage of learning: which variables of the rules behind the results must be one variable of the learned
/// rule, and which must be constants.
class IdentityAnalysis {
 public:
  /// What it uses of the agent.
  struct Uses {
    const WorkingMemory& memory;
    const GoalStack& goals;
    const InstantiationTable& instantiations;
    const Singletons& singletons;
    const Chunker& chunker;
  };
  IdentityAnalysis(const Uses& uses, FiringReader& reader) : uses_(uses), reader_(reader) {}

  void Analyze(const Explanation& explanation, bool log);

  IdentityGraph& graph() { return graph_; }
  const std::vector<JoinEvent>& events() const { return events_; }
  /// How often one of them found that something becomes a constant, but for singletons.
  std::uint32_t CountLiteralized() const;
  /// The identity of a field of a condition; kNone if the condition tests a constant there, or nothing is known of it.
  IdentityGraph::Node OfField(InstantiationId firing, std::size_t condition, Field field);
  IdentityGraph::Node OfClass(InstantiationId firing, std::uint16_t identity_class);
  IdentityGraph::Node OfTerm(const FiringReader::Term& term, InstantiationId firing);
  /// The number of a set, as explanations show it. Only after an analysis with a log.
  std::uint32_t NumberOf(IdentityGraph::Node node) { return NumberOfOwn(graph_.Root(node)); }
  /// The number that an identity had before it was joined with others.
  std::uint32_t NumberOfOwn(IdentityGraph::Node node);
  IdentityGraph::Node OfGround(const Explanation::Ground& ground, Field field);
  /// The same for id, attribute and value.
  void OfCondition(const Explanation::Ground& ground, std::array<IdentityGraph::Node, 3>& out);

 private:
  /// As OfClass, without a look at what is known already.
  IdentityGraph::Node FindOrigin(InstantiationId firing, std::uint16_t identity_class);
  void Join(InstantiationId firing, IdentityGraph::Node a, IdentityGraph::Node b, JoinReason reason);
  void Literalize(InstantiationId firing, IdentityGraph::Node node, JoinReason reason);
  void FollowLink(const Explanation::Link& link);
  /// Literalizes what the rule of a firing marks in one of its conditions, unless it is an identifier.
  void LiteralizeMarked(InstantiationId firing, std::size_t condition);
  void LiteralizeArguments(const RhsValue& function, InstantiationId firing, InstantiationId tester);
  void JoinSingletons(const Explanation& explanation);

  Uses uses_;
  FiringReader& reader_;
  IdentityGraph graph_;
  std::vector<JoinEvent> events_;
  bool log_ = false;

  /// What this analysis found last: each class is asked for by many conditions, and finding its identity goes from
  /// firing to firing.
  struct KnownClass {
    std::uint32_t analysis = 0, serial = 0;
    std::uint16_t identity_class = 0;
    IdentityGraph::Node node = IdentityGraph::kNone;
  };
  static constexpr unsigned kKnownBits = 10;
  std::uint32_t analysis_ = 1;
  std::vector<KnownClass> known_;  ///< Empty until first asked.

  std::unordered_map<std::uint32_t, InstantiationId> firing_of_serial_;         ///< Of identities; only with a log.
  std::unordered_map<std::uint32_t, const Explanation::Ground*> first_ground_;  ///< By element; scratch.
};

}  // namespace soarbox::kernel
