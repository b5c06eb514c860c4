// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "debugger/json.h"
#include "sim/inspector.h"
#include "sim/learning_facts.h"

namespace soarbox::debugger {

/// A rule that the agent made of what it worked out in a substate.
struct LearnedRuleRow {
  std::string name;
  std::uint64_t firings = 0;
};

/// What an agent has learned: numbers by reward, and rules.
struct LearningView {
  bool by_reward = false;  ///< Reinforcement learning is on.
  double last_reward = 0, total_reward = 0;
  std::size_t learners = 0;              ///< Rules that can learn by reward, whatever is shown of them.
  std::vector<sim::NumberFact> numbers;  ///< The highest first.
  std::vector<LearnedRuleRow> rules;     ///< The newest first.
  std::string note;                      ///< What a reader should know: nothing learns, not told there.
};

/// Of the rules with this text in their names.
LearningView LookAtLearning(sim::Inspector& mind, std::string_view text = {});

std::string ToText(const LearningView& view);
Json ToJson(const LearningView& view);

}  // namespace soarbox::debugger
