// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/learning_log.h"

#include <algorithm>
#include <charconv>
#include <utility>

namespace soarbox::debugger {
namespace {

constexpr std::size_t kMostLearned = 20'000, kMostFired = 1000, kMostPoints = 1000, kMostEpisodes = 2000;
constexpr std::string_view kLearnWord = "learn ", kValueWord = "value ", kRewardWord = "reward ",
                           kEpisodeEnds = "episode ends";

double LearnedNumber(std::string_view text) {
  double number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

/// The rule of a detail: "3 fire RULE".
std::string_view RuleThatFired(std::string_view detail) {
  constexpr std::string_view kFire = " fire ";
  const std::size_t at = detail.find(' ');
  if (at == std::string_view::npos || !detail.substr(at).starts_with(kFire)) return {};
  return detail.substr(at + kFire.size());
}

/// One point for each tick: the last. Of too many, every second of the older half goes.
void AddPoint(LearningLog::Points& points, std::uint64_t tick, double value) {
  if (!points.empty() && points.back().first == tick) {
    points.back().second = value;
    return;
  }
  points.emplace_back(tick, value);
  if (points.size() <= kMostPoints) return;
  LearningLog::Points thin;
  for (std::size_t n = 0; n < points.size(); ++n) {
    if (n >= points.size() / 2 || n % 2 == 0) thin.push_back(points[n]);
  }
  points.swap(thin);
}

void CutPoints(LearningLog::Points& points, std::uint64_t tick) {
  while (!points.empty() && points.back().first >= tick) points.pop_back();
}

}  // namespace

bool TellsOfReward(std::string_view line) {
  return line.starts_with(kValueWord) || line.starts_with(kRewardWord) || line == kEpisodeEnds;
}

void LearningLog::Fired(std::uint64_t tick, std::string_view rule) {
  const auto found = numbers_.find(rule);
  if (found == numbers_.end()) return;
  std::deque<std::uint64_t>& fired = rules_[found->second - forgotten_].fired;
  fired.push_back(tick);
  if (fired.size() > kMostFired) fired.pop_front();
}

void LearningLog::Add(std::uint64_t tick, const record::MindRecord& mind) {
  for (std::size_t n = 0; n < mind.decisions.size(); ++n) {
    std::string_view line = mind.decisions[n];
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    if (line.starts_with(kLearnWord)) {
      LearnedRule& rule = rules_.emplace_back();
      rule.name = line.substr(kLearnWord.size());
      rule.tick = tick;
      if (n < mind.reasons.size()) rule.reason = mind.reasons[n];
      numbers_[rule.name] = forgotten_ + rules_.size() - 1;
    } else if (line.starts_with(kValueWord)) {
      const std::size_t blank = line.rfind(' ');
      if (blank <= kValueWord.size()) continue;
      const std::string name(line.substr(kValueWord.size(), blank - kValueWord.size()));
      AddPoint(values_[name], tick, LearnedNumber(line.substr(blank + 1)));
    } else if (line.starts_with(kRewardWord)) {
      const double before = rewards_.empty() ? 0 : rewards_.back().second;
      AddPoint(rewards_, tick, before + LearnedNumber(line.substr(kRewardWord.size())));
      if (!std::exchange(is_in_episode_, true)) episode_begin_ = tick;
    } else if (line == kEpisodeEnds && std::exchange(is_in_episode_, false)) {
      const double all = rewards_.empty() ? 0 : rewards_.back().second;
      const double before = episodes_.empty() ? 0 : episodes_.back().total;
      episodes_.push_back({episode_begin_, tick, all - before, all});
      if (episodes_.size() > kMostEpisodes) episodes_.pop_front();
    }
  }
  for (const std::string& detail : mind.details) {
    if (const std::string_view rule = RuleThatFired(detail); !rule.empty()) Fired(tick, rule);
  }
  while (rules_.size() > kMostLearned) {
    const auto number = numbers_.find(rules_.front().name);
    if (number != numbers_.end() && number->second == forgotten_) numbers_.erase(number);
    rules_.pop_front();
    ++forgotten_;
  }
}

void LearningLog::CutFrom(std::uint64_t tick) {
  while (!rules_.empty() && rules_.back().tick >= tick) {
    numbers_.erase(rules_.back().name);
    rules_.pop_back();
  }
  for (LearnedRule& rule : rules_) {
    while (!rule.fired.empty() && rule.fired.back() >= tick) rule.fired.pop_back();
  }
  for (auto value = values_.begin(); value != values_.end();) {
    CutPoints(value->second, tick);
    value = value->second.empty() ? values_.erase(value) : std::next(value);
  }
  CutPoints(rewards_, tick);
  while (!episodes_.empty() && episodes_.back().last_tick >= tick) episodes_.pop_back();
  // Reward after the last end that stays is that of an episode under way.
  const std::uint64_t end = episodes_.empty() ? 0 : episodes_.back().last_tick;
  const auto first = std::ranges::upper_bound(rewards_, end, {}, &std::pair<std::uint64_t, double>::first);
  is_in_episode_ = first != rewards_.end();
  if (is_in_episode_) episode_begin_ = first->first;
}

const LearnedRule* LearningLog::Find(std::string_view rule) const {
  const auto found = numbers_.find(rule);
  return found == numbers_.end() ? nullptr : &rules_[found->second - forgotten_];
}

}  // namespace soarbox::debugger
