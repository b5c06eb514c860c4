// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/learn/identity_analysis.h"
#include "kernel/observer.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

/// The explanation of a learned rule as plain values, for `explain`, JSON and panels. Independent of working memory and
/// rules.
struct ExplainedRule {
  /// One field of a condition or an action.
  struct Field {
    std::string text;          ///< As in the rule: <s>, { <n> > 5 }, name.
    std::string identity;      ///< With identity numbers instead of variables: [4], { > 5 [4] }.
    std::string value;         ///< The matched value: S1, 7.
    std::uint32_t number = 0;  ///< The field's identity after all joins; 0 for none.
  };
  struct Condition {
    Field id, attribute, value;
    bool tests_state = false, acceptable = false;
    bool negated = false;       ///< Only `id.text` is set: the complete condition. `parts` contains its parts.
    bool conjunction = false;   ///< A negated conjunction of all `parts`.
    bool operational = false;   ///< It tested an element of a higher state.
    bool above_own = false;     ///< Learned rule: it tests a state above that of the rule's first instance.
    std::uint32_t creator = 0;  ///< The firing in the same state that created the element; 0: the architecture.
    std::string creator_rule;
    std::vector<std::uint32_t> path;  ///< For the learned rule: the firings from the one that tested it to a result.
    /// Part of a negated condition: as in the rule, with identities, and with values.
    struct Part {
      std::string text, identity, value;
      bool operational = false;
    };
    std::vector<Part> parts;
  };
  struct Action {
    Field id, attribute, value, referent;
    PreferenceType type = PreferenceType::kAcceptable;
  };
  struct Firing {
    std::uint32_t serial = 0;
    std::string rule;
    GoalLevel level = 0;
    bool made_result = false;
    std::vector<Condition> conditions;
    std::vector<Action> actions;
    std::vector<std::uint32_t> path;  ///< The firings from this one to one that created a result.
  };
  /// Two identities were joined, or one was literalized.
  struct Event {
    JoinReason reason = JoinReason::kRule;
    std::uint32_t firing = 0, from = 0, to = 0;  ///< `to` is 0 if it was literalized.
    std::string variable;                        ///< The variable of the learned rule for `to`.
  };
  /// A test of a local condition that the learned rule must contain, too.
  struct Constraint {
    std::uint32_t firing = 0;
    std::string text;
    bool placed = false;
  };

  std::uint32_t number = 0;  ///< "c 1"
  std::string name;
  bool justification = false;
  std::uint64_t decision = 0;
  GoalLevel level = 0;                       ///< Level of the substate.
  std::string state, superstate;             ///< The substate, and the state above it: S2, S1.
  ImpasseType impasse = ImpasseType::kNone;  ///< The impasse that created the substate.
  bool on_operator = false;
  std::string op;                            ///< Name of the operator selected in the superstate; empty for none.
  std::uint32_t base = 0;                    ///< The firing that created the results.
  std::vector<std::uint32_t> other_results;  ///< Firings that created structure below these results.
  std::uint32_t instance = 0;                ///< The firing that is the learned rule's first instance.
  GoalLevel instance_level = 0;              ///< Level of the state that this instance matched.
  ProductionPtr rule;                        ///< The learned rule; none for justifications.
  std::vector<Condition> conditions;
  std::vector<Action> actions;
  std::vector<Firing> firings;  ///< By number.
  std::vector<Event> events;
  std::vector<Constraint> constraints;
  std::vector<std::uint32_t> identities;  ///< Those in the learned rule, ascending.
  std::uint32_t literalized = 0, joined = 0;
  std::uint32_t merged_conditions = 0, merged_disjunctions = 0, operational_constraints = 0, duplicates = 0;
  bool local_negation = false, quiescence = false, long_term_memory = false, repaired = false;

  /// Approximate size in bytes. Texts are counted by their length, so that a copy has the same size.
  std::size_t MemoryBytes() const;
  /// The number of conditions. Each condition inside a negated conjunction counts.
  std::size_t CountConditions() const {
    std::size_t count = 0;
    for (const Condition& condition : conditions) count += condition.negated ? condition.parts.size() : 1;
    return count;
  }
  const Firing* FindFiring(std::uint32_t serial) const {
    for (const Firing& firing : firings) {
      if (firing.serial == serial) return &firing;
    }
    return nullptr;
  }
};

}  // namespace soarbox::kernel
