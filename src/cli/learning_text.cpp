// SPDX-License-Identifier: BSD-2-Clause
#include "cli/learning_text.h"

#include <fmt/format.h>

#include <cstdint>
#include <string_view>

#include "kernel/agent.h"
#include "kernel/learn/learn_settings.h"

namespace soarbox::cli {

std::string LearningStatisticsText(const kernel::Agent& agent) {
  const kernel::LearnStatistics& s = agent.learn_statistics();
  std::string text;
  const std::string thick(75, '='), thin(75, '-');
  const auto row = [&](std::string_view name, std::uint64_t value) { text += fmt::format("{:<71}{}\n", name, value); };
  const auto title = [&](std::string_view name, int indent) {
    text += "\n" + thin + "\n" + std::string(static_cast<std::size_t>(indent), ' ') + std::string(name) + "\n" + thin +
            "\n";
  };
  text += thick + "\n                  Explanation-Based Chunking Statistics\n" + thick + "\n";
  row("Rules learned", s.chunks);
  row("Justifications learned", s.justifications);
  title("Work Performed", 31);
  row("Sub-states analyzed", s.analyzed);
  row("Number of rules fired in substates analyzed", agent.instantiation_count());
  row("Number of rule firings analyzed during backtracing", s.backtraced);
  text += "\n";
  row("Conditions merged", s.merged_conditions);
  row("Disjunction tests merged", s.merged_disjunctions);
  row("Operational constraints", s.operational_constraints);
  row("Non-operational constraints detected", s.constraints_found);
  row("Non-operational constraints enforced", s.constraints_placed);
  title("Problem-Solving Characteristics", 21);
  row("Rules repaired that had unconnected conditions or actions", s.repaired);
  row("Chunk used negated reasoning about sub-state", s.chunks_with_local_negation);
  row("Chunk tested knowledge retrieved from long-term memory", s.chunks_with_long_term_memory);
  row("Justification used negated reasoning about sub-state", s.justifications_with_local_negation);
  row("Justification tested knowledge retrieved from long-term memory", s.justifications_with_long_term_memory);
  title("Identity Analysis", 27);
  row("Identities created", s.identities_created);
  row("Distinct identities in learned rules", s.identities_in_rules);
  row("Identities joined", s.identities_joined);
  row("Identities literalized", s.identities_literalized);
  title("Learning Skipped or Unsuccessful", 22);
  row("Ignored duplicate of existing rule", s.duplicates);
  row("Skipped because problem-solving tested ^quiescence true", s.tested_quiescence);
  row("Skipped because no super-state knowledge tested", s.without_grounds);
  row("Skipped because MAX-CHUNKS exceeded in a decision cycle", s.over_max_chunks);
  row("Skipped because MAX-DUPES exceeded for rule this decision cycle", s.over_max_duplicates);
  if (s.unrepairable > 0) row("Unable to repair: a justification was made instead", s.unrepairable);
  return text;
}

}  // namespace soarbox::cli
