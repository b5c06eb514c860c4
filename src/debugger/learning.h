// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "debugger/learning_log.h"
#include "debugger/why.h"
#include "explain/inspector.h"
#include "explain/learning_facts.h"

namespace soarbox::debugger {

/// A chunk: a rule that the agent learned from the result of a substate.
struct LearnedRuleRow {
  std::string name;
  std::uint64_t firings = 0;
  std::optional<std::uint64_t> tick;  ///< The tick in which it was learned, if that is known.
  std::string source;                 ///< "S2: operator no-change in S1, where price was selected"; empty if it is not
                                      ///< known.
  std::string purpose;                ///< "makes ^cost"; empty if it is not known.
  bool is_gone = false;               ///< It has been excised since.
};

/// What an agent has learned: values by reinforcement learning, and rules.
struct LearningView {
  bool by_reward = false;  ///< Reinforcement learning is on.
  double last_reward = 0, total_reward = 0;
  std::size_t learners = 0;                  ///< Number of rules that can learn by reward, whatever the filter.
  std::vector<explain::NumberFact> numbers;  ///< The highest value first.
  std::vector<LearnedRuleRow> rules;         ///< The newest first.
  std::string note;                          ///< A remark for the reader: nothing learns, or the kernel does not report
                                             ///< it.
};

/// Shows only rules with `text` in their names or purposes. `log`: what was learned when; entries after tick `until`
/// are ignored. For a recorded mind that is not simulated again, all data come from `log`.
LearningView LookAtLearning(explain::Inspector& mind, std::string_view text = {}, const LearningLog* log = nullptr,
                            std::uint64_t until = ~std::uint64_t{0});

/// The explanation of a learned rule, and the ticks in which it has fired since.
struct LearnedRuleView {
  std::string name;  ///< Empty if there is no such rule.
  WhyNode why;
  std::vector<std::uint64_t> fired;
  std::string fired_note;  ///< Why no ticks are listed; empty if some are.
};
LearnedRuleView LookAtLearnedRule(explain::Inspector& mind, const std::string& rule, const LearningLog* log,
                                  std::uint64_t until = ~std::uint64_t{0});

/// The rules whose values were updated most often; at most `most`.
std::vector<std::string> MostMoved(const LearningView& view, std::size_t most);

std::string ToText(const LearningView& view);
std::string ToText(const LearnedRuleView& view);
/// The reward of each episode, one line per episode.
std::string ToText(const std::deque<RewardEpisode>& episodes);

}  // namespace soarbox::debugger
