// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/learning_log.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "wording/mind_words.h"

namespace soarbox::debugger {
namespace {

constexpr std::size_t kMostLearned = 20'000, kMostFired = 1000, kMostPoints = 1000, kMostEpisodes = 2000;

/// Adds a point; only the last one of a tick is kept. If there are too many, removes every second one of the older
/// half.
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

void LearningLog::Fired(std::uint64_t tick, std::string_view rule) {
  const auto found = numbers_.find(rule);
  if (found == numbers_.end()) return;
  std::deque<std::uint64_t>& fired = rules_[found->second - forgotten_].fired;
  fired.push_back(tick);
  if (fired.size() > kMostFired) fired.pop_front();
}

void LearningLog::Add(std::uint64_t tick, const record::MindRecord& mind) {
  mind::Event event;
  for (std::size_t at = 0; mind.events.Next(at, event);) {
    if (const auto* learned = std::get_if<mind::RuleLearned>(&event)) {
      LearnedRule& rule = rules_.emplace_back();
      rule.name = learned->rule;
      rule.tick = tick;
      rule.reason = wording::ReasonText(event);
      numbers_[rule.name] = forgotten_ + rules_.size() - 1;
    } else if (const auto* update = std::get_if<mind::ValueUpdated>(&event)) {
      AddPoint(values_[std::string(update->rule)], tick, update->value);
    } else if (const auto* received = std::get_if<mind::RewardReceived>(&event)) {
      const double before = rewards_.empty() ? 0 : rewards_.back().second;
      AddPoint(rewards_, tick, before + received->reward);
      if (!std::exchange(is_in_episode_, true)) episode_begin_ = tick;
    } else if (std::holds_alternative<mind::EpisodeEnded>(event)) {
      if (!std::exchange(is_in_episode_, false)) continue;
      const double all = rewards_.empty() ? 0 : rewards_.back().second;
      const double before = episodes_.empty() ? 0 : episodes_.back().total;
      episodes_.push_back({episode_begin_, tick, all - before, all});
      if (episodes_.size() > kMostEpisodes) episodes_.pop_front();
    }
  }
  mind.events.ForEachOf<mind::RuleFired>([&](const mind::RuleFired& fired) {
    if (!fired.retracts) Fired(tick, fired.rule);
  });
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
  // Reward after the last remaining end belongs to the current episode.
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
