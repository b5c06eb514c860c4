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

/// Why two identities were joined, or why one was literalized.
enum class JoinReason : std::uint8_t {
  kRule,              ///< A condition tests an element that an action of another rule created.
  kSingleton,         ///< Two conditions test the same singleton element.
  kChild,             ///< A result is part of another result.
  kConstantTested,    ///< A rule tests a constant; another rule created the element with a variable.
  kConstantMade,      ///< A rule created the element with a constant; another rule tests it with a variable.
  kFunctionResult,    ///< A rule tests the result of a function.
  kFunctionArgument,  ///< It is an argument of a function that was evaluated.
  kSingletonLiteral,  ///< A condition on the same singleton tests a constant.
  kMarkedLiteral,     ///< A rule marks the variable: `$ <x>`.
};

/// A step of the third stage, in order; recorded only if an explanation is wanted.
struct JoinEvent {
  JoinReason reason = JoinReason::kRule;
  InstantiationId firing = InstantiationId::kNone;
  IdentityGraph::Node from = IdentityGraph::kNone;
  IdentityGraph::Node to = IdentityGraph::kNone;  ///< kNone: the identity was literalized.
};

/// The third stage of learning. It examines the variables of the rules that led to the results. It determines which of
/// them must be the same variable in the learned rule, and which must be constants.
class IdentityAnalysis {
 public:
  /// The parts of the agent that it uses.
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
  /// Number of steps that literalized an identity, without those for singletons.
  std::uint32_t CountLiteralized() const;
  /// The identity of a field of a condition; kNone if the condition tests a constant there, or if it has none.
  IdentityGraph::Node OfField(InstantiationId firing, std::size_t condition, Field field);
  IdentityGraph::Node OfClass(InstantiationId firing, std::uint16_t identity_class);
  IdentityGraph::Node OfTerm(const FiringReader::Term& term, InstantiationId firing);
  /// The number of an identity set for explanations. Valid only after an analysis with a log.
  std::uint32_t NumberOf(IdentityGraph::Node node) { return NumberOfOwn(graph_.Root(node)); }
  /// The number of an identity before it was joined with others.
  std::uint32_t NumberOfOwn(IdentityGraph::Node node);
  IdentityGraph::Node OfGround(const Explanation::Ground& ground, Field field);
  /// The identities of id, attribute and value of a ground.
  void OfCondition(const Explanation::Ground& ground, std::array<IdentityGraph::Node, 3>& out);

 private:
  /// Like OfClass, without the cache.
  IdentityGraph::Node FindOrigin(InstantiationId firing, std::uint16_t identity_class);
  void Join(InstantiationId firing, IdentityGraph::Node a, IdentityGraph::Node b, JoinReason reason);
  void Literalize(InstantiationId firing, IdentityGraph::Node node, JoinReason reason);
  void FollowLink(const Explanation::Link& link);
  /// Literalizes the variables that the rule of a firing marks with `$` in a condition, unless they match identifiers.
  void LiteralizeMarked(InstantiationId firing, std::size_t condition);
  void LiteralizeArguments(const RhsValue& function, InstantiationId firing, InstantiationId tester);
  void JoinSingletons(const Explanation& explanation);

  Uses uses_;
  FiringReader& reader_;
  IdentityGraph graph_;
  std::vector<JoinEvent> events_;
  bool log_ = false;

  /// A cache: many conditions need the identity of the same class, and finding it follows a chain of firings.
  struct KnownClass {
    std::uint32_t analysis = 0, serial = 0;
    std::uint16_t identity_class = 0;
    IdentityGraph::Node node = IdentityGraph::kNone;
  };
  static constexpr unsigned kKnownBits = 10;
  std::uint32_t analysis_ = 1;
  std::vector<KnownClass> known_;  ///< Empty until the first use.

  std::unordered_map<std::uint32_t, InstantiationId> firing_of_serial_;         ///< For identities; only with a log.
  std::unordered_map<std::uint32_t, const Explanation::Ground*> first_ground_;  ///< Scratch: by element.
};

}  // namespace soarbox::kernel
