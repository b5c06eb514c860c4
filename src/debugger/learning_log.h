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

/// A rule that was learned in a known tick.
struct LearnedRule {
  std::string name;
  std::uint64_t tick = 0;
  std::string reason;               ///< "from RULE in S2 (operator tie)".
  std::deque<std::uint64_t> fired;  ///< The last 1,000 ticks in which it has fired since, if firings are recorded.
};

/// The reward of one episode.
struct RewardEpisode {
  std::uint64_t first_tick = 0, last_tick = 0;
  double reward = 0;
  double total = 0;  ///< Reward from the beginning of the run to the end of the episode.
};

/// What one agent learned. Add it tick by tick, live or from a recording.
class LearningLog {
 public:
  using Points = std::deque<std::pair<std::uint64_t, double>>;  ///< Tick and value.

  void Add(std::uint64_t tick, const record::MindRecord& mind);
  /// Removes everything from this tick on. Call it when the run went back.
  void CutFrom(std::uint64_t tick);

  const std::deque<LearnedRule>& rules() const { return rules_; }  ///< The oldest first; the last 20,000.
  /// Returns null if no tick is known for the rule.
  const LearnedRule* Find(std::string_view rule) const;
  /// The values of rules that learn by reward, each from its first change on. Above 1,000 points of a rule, every
  /// second point of the older half is removed.
  const std::map<std::string, Points, std::less<>>& values() const { return values_; }
  /// The total reward up to each tick; thinned out in the same way.
  const Points& rewards() const { return rewards_; }
  /// Episodes that have ended; the last 2,000.
  const std::deque<RewardEpisode>& episodes() const { return episodes_; }
  bool empty() const { return rules_.empty() && values_.empty() && rewards_.empty(); }

 private:
  void Fired(std::uint64_t tick, std::string_view rule);

  std::deque<LearnedRule> rules_;
  std::map<std::string, std::uint64_t, std::less<>> numbers_;  ///< Number of each rule by its name, counted from the
                                                               ///< first rule that was added.
  std::uint64_t forgotten_ = 0;                                ///< Number of rules that were removed from the front of
                                                               ///< rules_.
  std::map<std::string, Points, std::less<>> values_;
  Points rewards_;
  std::deque<RewardEpisode> episodes_;
  std::uint64_t episode_begin_ = 0;  ///< The tick of the first reward of the current episode.
  bool is_in_episode_ = false;
};

}  // namespace soarbox::debugger
