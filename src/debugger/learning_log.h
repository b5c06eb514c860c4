// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "record/tick_record.h"

namespace soarbox::debugger {

/// A rule that was learned in a tick that is known.
struct LearnedRule {
  std::string name;
  std::uint64_t tick = 0;
  std::string reason;               ///< "from RULE in S2 (operator tie)".
  std::deque<std::uint64_t> fired;  ///< Ticks in which it fired since, where firings are noted; the last 1,000.
};

/// What was earned from one end of an episode to the next.
struct RewardEpisode {
  std::uint64_t first_tick = 0, last_tick = 0;
  double reward = 0;
  double total = 0;  ///< Earned until its end since the agent began.
};

/// What one agent learned, fed tick by tick, live or from a recording.
class LearningLog {
 public:
  using Points = std::deque<std::pair<std::uint64_t, double>>;  ///< Tick and value.

  void Add(std::uint64_t tick, const record::MindRecord& mind);
  /// Forgets what came from this tick on: the run went back.
  void CutFrom(std::uint64_t tick);

  const std::deque<LearnedRule>& rules() const { return rules_; }  ///< The oldest first; the last 20,000.
  /// Null if it is not known when.
  const LearnedRule* Find(std::string_view rule) const;
  /// The numbers of rules that learn by reward, each from its first change on. The older half of many is thinned out.
  const std::map<std::string, Points, std::less<>>& values() const { return values_; }
  const Points& rewards() const { return rewards_; }                       ///< The sum so far.
  const std::deque<RewardEpisode>& episodes() const { return episodes_; }  ///< That have ended; the last 2,000.
  bool empty() const { return rules_.empty() && values_.empty() && rewards_.empty(); }

 private:
  void Fired(std::uint64_t tick, std::string_view rule);

  std::deque<LearnedRule> rules_;
  std::map<std::string, std::uint64_t, std::less<>> numbers_;  ///< By name: counted from the first that there was.
  std::uint64_t forgotten_ = 0;                                ///< Of rules_, at its front.
  std::map<std::string, Points, std::less<>> values_;
  Points rewards_;
  std::deque<RewardEpisode> episodes_;
  std::uint64_t episode_begin_ = 0;  ///< The tick of the first reward after the last end.
  bool is_in_episode_ = false;
};

}  // namespace soarbox::debugger
