// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace soarbox::sim {

/// The number of a rule that learns by reward: what it expects at once (`current`) and of what follows (`future`).
struct NumberFact {
  std::string rule;
  double value = 0, current = 0, future = 0;
  std::uint64_t updates = 0;
};

struct LearningFacts {
  bool by_reward = false;  ///< Switched on.
  double last_reward = 0;  ///< Of the last decision that collected any.
  double total_reward = 0;
  std::vector<NumberFact> numbers;  ///< Of each rule that can learn, in the order of loading.
};

/// What inspectors of living minds are besides, see Inspector.
class LearningSource {
 public:
  virtual ~LearningSource() = default;

  virtual LearningFacts Learning() = 0;
};

}  // namespace soarbox::sim
