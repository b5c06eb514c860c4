// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "debugger/json.h"
#include "debugger/learning_log.h"
#include "debugger/why.h"
#include "explain/inspector.h"
#include "explain/learning_facts.h"

namespace soarbox::debugger {

/// A rule that the agent made of what it worked out in a substate.
struct LearnedRuleRow {
  std::string name;
  std::uint64_t firings = 0;
  std::optional<std::uint64_t> tick;  ///< In which it was learned, if that is known.
  std::string source;                 ///< "S2: operator no-change in S1, where price was selected"; empty: not known.
  std::string purpose;                ///< "makes ^cost"; likewise.
  bool is_gone = false;               ///< It was excised since.
};

/// What an agent has learned: numbers by reward, and rules.
struct LearningView {
  bool by_reward = false;  ///< Reinforcement learning is on.
  double last_reward = 0, total_reward = 0;
  std::size_t learners = 0;                  ///< Rules that can learn by reward, whatever is shown of them.
  std::vector<explain::NumberFact> numbers;  ///< The highest first.
  std::vector<LearnedRuleRow> rules;         ///< The newest first.
  std::string note;                          ///< What a reader should know: nothing learns, not told there.
};

/// Only rules with this text in their names or purposes. `log`: what was learned when, up to
/// `until`; of a recorded mind that is not simulated again all comes from there.
LearningView LookAtLearning(explain::Inspector& mind, std::string_view text = {}, const LearningLog* log = nullptr,
                            std::uint64_t until = ~std::uint64_t{0});

/// Why a learned rule is as it is; where it fired since, by ticks.
struct LearnedRuleView {
  std::string name;  ///< Empty: none.
  WhyNode why;
  std::vector<std::uint64_t> fired;
  std::string fired_note;  ///< Why no tick is known; empty: some are.
};
LearnedRuleView LookAtLearnedRule(explain::Inspector& mind, const std::string& rule, const LearningLog* log,
                                  std::uint64_t until = ~std::uint64_t{0});

/// The rules whose values moved most often, at most so many.
std::vector<std::string> MostMoved(const LearningView& view, std::size_t most);

std::string ToText(const LearningView& view);
Json ToJson(const LearningView& view);
std::string ToText(const LearnedRuleView& view);
Json ToJson(const LearnedRuleView& view);
/// Reward per episode, a line each.
std::string ToText(const std::deque<RewardEpisode>& episodes);
Json ToJson(const std::deque<RewardEpisode>& episodes);

}  // namespace soarbox::debugger
