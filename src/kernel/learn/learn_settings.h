// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "kernel/base/symbol.h"

namespace soarbox::kernel {

/// In which states rules are learned.
enum class LearnMode : std::uint8_t {
  kNever,
  kAlways,
  kOnly,    ///< In states that (force-learn <s>) names.
  kExcept,  ///< In all but those that (dont-learn <s>) names.
};

/// What `chunk` sets. Changes hold from the next firing on.
struct LearnSettings {
  LearnMode mode = LearnMode::kNever;
  bool bottom_only = false;          ///< Learn in the lowest state only.
  bool numbered_names = false;       ///< chunk7 instead of chunk*RULE*t3-1.
  std::uint32_t max_chunks = 50;     ///< Rules learned in one decision cycle.
  std::uint32_t max_duplicates = 3;  ///< Of one rule in one decision cycle.
  bool interrupt = false;            ///< Stop the run after learning a rule.
  bool explain_interrupt = false;    ///< The same, for rules that are recorded.
  bool warning_interrupt = false;    ///< Stop the run after a rule that had to be repaired or could not be.
  bool automatic_singletons = true;  ///< Every attribute that is a string counts as a singleton.
  bool add_ltm_links = false;
  bool add_selection_knowledge = true;  ///< Rules rest on what made their operators better than others.
  bool allow_local_negations = true;    ///< ... on what was absent in the substate.
  bool allow_opaque = true;             ///< ... on what long-term memory recalled.

  bool learning() const { return mode != LearnMode::kNever; }
};

/// Counted since the agent was made or initialized (`chunk stats`).
struct LearnStatistics {
  std::uint64_t chunks = 0, justifications = 0;
  std::uint64_t analyzed = 0;  ///< Firings with results, whatever became of them.
  std::uint64_t backtraced = 0;
  std::uint64_t merged_conditions = 0, merged_disjunctions = 0;
  std::uint64_t operational_constraints = 0, constraints_found = 0, constraints_placed = 0;
  std::uint64_t repaired = 0;
  std::uint64_t chunks_with_local_negation = 0, chunks_with_long_term_memory = 0;
  std::uint64_t justifications_with_local_negation = 0, justifications_with_long_term_memory = 0;
  std::uint64_t identities_created = 0, identities_in_rules = 0, identities_joined = 0, identities_literalized = 0;
  std::uint64_t duplicates = 0, tested_quiescence = 0, without_grounds = 0;
  std::uint64_t over_max_chunks = 0, over_max_duplicates = 0;
  std::uint64_t unrepairable = 0, did_not_match = 0;
};

/// The rules that were learned and not excised, and the rule that most of them come from.
struct LearnedRules {
  std::size_t count = 0;
  std::string source;  ///< Of equals the first by name.
  std::size_t of_source = 0;
};

}  // namespace soarbox::kernel
