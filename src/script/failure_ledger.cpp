// SPDX-License-Identifier: BSD-2-Clause
#include "script/failure_ledger.h"

#include <algorithm>

namespace soarbox::script {

void FailureLedger::Failed(world::EntityId agent, std::string_view callback, const ScriptError& error) {
  const std::string text = Format(error.diagnostic);
  auto found = errors_.find(text);
  if (found == errors_.end() && errors_.size() < kMostErrors)
    found = errors_.emplace(text, Count{error.diagnostic, {}}).first;
  if (found != errors_.end()) {
    Count& count = found->second;
    ++count.count;
    ++count.agents[agent];
    // Reported once: agents in which it occurs in a later tick are counted for the end of the run.
    if (count.told == 0 || count.news) {
      count.news = true;
      ++count.told;
      AddNews(ScriptTrouble::Kind::kError, agent, callback, error, text);
    }
  }

  Callback key{agent, std::string(callback)};
  Failing& failing = failing_[key];
  if (++failing.in_a_row < kKeepsFailing || failing.told) return;
  failing.told = true;
  if (++times_told_[std::move(key)] <= kMostTold)
    AddNews(ScriptTrouble::Kind::kKeepsFailing, agent, callback, error, text);
}

void FailureLedger::NoteSuccess(world::EntityId agent, std::string_view callback) {
  const Callback key{agent, std::string(callback)};
  const auto found = failing_.find(key);
  if (found == failing_.end()) return;
  const bool told = found->second.told;
  failing_.erase(found);
  if (told && times_told_[key] <= kMostTold)
    AddNews(ScriptTrouble::Kind::kWorksAgain, agent, callback, ScriptError{}, {});
}

void FailureLedger::AddNews(ScriptTrouble::Kind kind, world::EntityId agent, std::string_view callback,
                            const ScriptError& error, const std::string& text) {
  const auto same = std::find_if(news_.begin(), news_.end(), [&](const auto& entry) {
    return entry.second.kind == kind && entry.second.callback == callback && entry.first == text;
  });
  if (same == news_.end()) {
    news_.emplace_back(text, ScriptTrouble{kind, {agent}, std::string(callback), error});
    return;
  }
  std::vector<world::EntityId>& agents = same->second.agents;
  const auto place = std::lower_bound(agents.begin(), agents.end(), agent);
  if (place == agents.end() || *place != agent) agents.insert(place, agent);
}

std::vector<ScriptTrouble> FailureLedger::TakeNews() {
  std::vector<ScriptTrouble> news;
  news.reserve(news_.size());
  for (auto& [text, trouble] : news_) {
    if (const auto found = errors_.find(text); found != errors_.end()) found->second.news = false;
    news.push_back(std::move(trouble));
  }
  news_.clear();
  return news;
}

std::vector<ErrorCount> FailureLedger::Untold() const {
  std::vector<ErrorCount> counts;
  for (const auto& [text, count] : errors_) {
    if (count.count == count.told) continue;
    ErrorCount entry{count.error, {}, count.count};
    for (const auto& [agent, times] : count.agents) entry.agents.push_back(agent);
    counts.push_back(std::move(entry));
  }
  return counts;
}

}  // namespace soarbox::script
