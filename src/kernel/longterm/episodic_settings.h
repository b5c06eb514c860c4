// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace soarbox::kernel {

/// The settings of `epmem --set`.
struct EpisodicSettings {
  enum class Phase : std::uint8_t { kOutput, kSelection };
  enum class Trigger : std::uint8_t { kNone, kOutput, kDecision };
  enum class Force : std::uint8_t { kOff, kRemember, kIgnore };

  bool learning = false;
  Phase phase = Phase::kOutput;          ///< When episodes are recorded and commands answered.
  Trigger trigger = Trigger::kDecision;  ///< After each decision, or when rules created an element on the output link.
  Force force = Force::kOff;             ///< Overrides the trigger once, at the next opportunity.
  std::vector<std::string> exclusions = {"epmem", "smem"};  ///< Attributes that episodes exclude.
  double balance = 1;  ///< Below 1, the weight of a cue's leaf depends on its activation in working memory.
  bool graph_match = true;
};

/// The counters of `epmem --stats`.
struct EpisodicCounters {
  std::uint64_t retrievals = 0, queries = 0, nexts = 0, previous = 0;
  std::uint64_t last_retrieval_wmes = 0;
  std::uint64_t query_positive = 0, query_negative = 0, query_retrieved = 0, query_literals = 0;
  std::int64_t query_cardinality = 0;
};

}  // namespace soarbox::kernel
