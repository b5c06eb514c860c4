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

/// How a rule was learned, as plain values: what `explain` prints, and what JSON and panels show. Needs neither working
/// memory nor rules any more.
struct ExplainedRule {
  /// One field of a condition or an action.
  struct Field {
    std::string text;          ///< As the rule has it: <s>, { <n> > 5 }, name.
    std::string identity;      ///< With the numbers of identities in place of variables: [4], { > 5 [4] }.
    std::string value;         ///< What it was: S1, 7.
    std::uint32_t number = 0;  ///< Of the identity that the field has after all joining; 0 for none.
  };
  struct Condition {
    Field id, attribute, value;
    bool tests_state = false, acceptable = false;
    bool negated = false;       ///< Only `id.text` is set: the whole condition. `parts` has it in pieces.
    bool conjunction = false;   ///< Negated as a whole: all of `parts` together.
    bool operational = false;   ///< It tested an element of a higher state.
    bool above_own = false;     ///< Of the learned rule's: of a state above the one that its own instance matched.
    std::uint32_t creator = 0;  ///< The firing that made the element in the firing's state; 0: the architecture.
    std::string creator_rule;
    std::vector<std::uint32_t> path;  ///< Of the learned rule's: from the firing that tested it to a result.
    /// Of a negated condition: as the rule has it, with identities, and what it was.
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
    std::vector<std::uint32_t> path;  ///< From this firing to one that made a result.
  };
  /// Two identities became one, or one became literal.
  struct Event {
    JoinReason reason = JoinReason::kRule;
    std::uint32_t firing = 0, from = 0, to = 0;  ///< `to` 0: literal.
    std::string variable;                        ///< Of the learned rule, for `to`.
  };
  /// A test of a local condition that the learned rule has to make.
  struct Constraint {
    std::uint32_t firing = 0;
    std::string text;
    bool placed = false;
  };

  std::uint32_t number = 0;  ///< "c 1"
  std::string name;
  bool justification = false;
  std::uint64_t decision = 0;
  GoalLevel level = 0;                       ///< Of the substate.
  std::string state, superstate;             ///< The substate, and the state above it: S2, S1.
  ImpasseType impasse = ImpasseType::kNone;  ///< That made the substate.
  bool on_operator = false;
  std::string op;                            ///< The name of the operator that was selected above; empty for none.
  std::uint32_t base = 0;                    ///< The firing whose results it gives.
  std::vector<std::uint32_t> other_results;  ///< Firings that made what hangs on these results.
  std::uint32_t instance = 0;                ///< The firing that the learned rule itself began with...
  GoalLevel instance_level = 0;              ///< ... and the level of the state that it matched.
  ProductionPtr rule;                        ///< As it was learned; none for justifications.
  std::vector<Condition> conditions;
  std::vector<Action> actions;
  std::vector<Firing> firings;  ///< By number.
  std::vector<Event> events;
  std::vector<Constraint> constraints;
  std::vector<std::uint32_t> identities;  ///< In the learned rule, ascending.
  std::uint32_t literalized = 0, joined = 0;
  std::uint32_t merged_conditions = 0, merged_disjunctions = 0, operational_constraints = 0, duplicates = 0;
  bool local_negation = false, quiescence = false, long_term_memory = false, repaired = false;

  /// Roughly the bytes it takes. Texts count by their length, so a copy gives the same answer.
  std::size_t MemoryBytes() const;
  /// Negated conjunctions count each of their conditions.
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
