// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "kernel/base/symbol.h"

namespace soarbox::kernel {

/// The states in which rules are learned.
enum class LearnMode : std::uint8_t {
  kNever,
  kAlways,
  kOnly,    ///< Only states named by (force-learn <s>).
  kExcept,  ///< All states except those named by (dont-learn <s>).
};

/// The settings of `chunk`. Changes take effect at the next firing.
struct LearnSettings {
  LearnMode mode = LearnMode::kNever;
  bool bottom_only = false;          ///< Learn only in the lowest state.
  bool numbered_names = false;       ///< chunk7 instead of chunk*RULE*t3-1.
  std::uint32_t max_chunks = 50;     ///< Maximum number of rules learned in one decision cycle.
  std::uint32_t max_duplicates = 3;  ///< Maximum number of duplicates of one rule in one decision cycle.
  bool interrupt = false;            ///< Interrupt the run after a rule was learned.
  bool explain_interrupt = false;    ///< Interrupt the run after a rule with a recorded explanation was learned.
  bool warning_interrupt = false;    ///< Interrupt the run after a rule was repaired or could not be repaired.
  bool automatic_singletons = true;  ///< Treat every string attribute as a singleton.
  bool add_ltm_links = false;
  bool add_selection_knowledge = true;  ///< Rules depend on the preferences that selected their operators.
  bool allow_local_negations = true;    ///< Rules may depend on the absence of local elements.
  bool allow_opaque = true;             ///< Rules may depend on results of long-term memory.

  bool learning() const { return mode != LearnMode::kNever; }
};

/// Counters of `chunk stats`, since the agent was created or initialized.
struct LearnStatistics {
  std::uint64_t chunks = 0, justifications = 0;
  std::uint64_t analyzed = 0;  ///< Number of firings with results, including those from which nothing was learned.
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

/// The number of learned rules that are not excised, and the rule that most of them were learned from.
struct LearnedRules {
  std::size_t count = 0;
  std::string source;  ///< If several rules have the maximum, the first by name.
  std::size_t of_source = 0;
};

}  // namespace soarbox::kernel
