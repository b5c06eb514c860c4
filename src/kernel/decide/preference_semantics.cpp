// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/decide/preference_semantics.h"

#include <algorithm>

#include "kernel/decide/decision_trace.h"

namespace soarbox::kernel {

PreferenceSemantics::Outcome PreferenceSemantics::Decide(std::span<const SlotPreference> preferences, Symbol forced,
                                                         DecisionTrace* trace) {
  trace_ = trace;
  if (trace_ != nullptr) trace_->Clear();
  bool types_present[static_cast<std::size_t>(PreferenceType::kWorse) + 1] = {};
  for (const SlotPreference& p : preferences) types_present[static_cast<std::size_t>(p.type)] = true;
  const auto has = [&](PreferenceType type) { return types_present[static_cast<std::size_t>(type)]; };

  CollectCandidates(preferences);
  if (forced) {
    if (const std::uint32_t at = Find(forced); at != kNowhere) {
      if (trace_ != nullptr) NoteForced(forced);
      candidates_ = {candidates_[at]};
      return {ImpasseType::kNone, candidates_};
    }
  }
  if (has(PreferenceType::kRequire)) {
    if (trace_ != nullptr) NoteRequired(preferences);
    return DecideRequired(preferences);
  }

  if (has(PreferenceType::kProhibit) || has(PreferenceType::kReject)) {
    MarkLosers(preferences, DecisionStage::kReject);
    if (trace_ != nullptr) NoteLosers(preferences, DecisionStage::kReject);
    Keep(false);
  }
  if (candidates_.size() > 1 && (has(PreferenceType::kBetter) || has(PreferenceType::kWorse)) &&
      DropDominated(preferences)) {
    AddNumbers(preferences);
    return {ImpasseType::kConflict, candidates_};
  }
  if (candidates_.size() > 1 && has(PreferenceType::kBest)) KeepBest(preferences);
  if (candidates_.size() > 1 && has(PreferenceType::kWorst)) DropWorst(preferences);
  if (has(PreferenceType::kNumericIndifferent)) AddNumbers(preferences);
  if (candidates_.size() <= 1) return {ImpasseType::kNone, candidates_};
  if (AllIndifferent(preferences)) {
    if (trace_ != nullptr) NoteSettling(preferences);
    return {ImpasseType::kNone, candidates_};
  }
  return {ImpasseType::kTie, candidates_};
}

void PreferenceSemantics::CollectCandidates(std::span<const SlotPreference> preferences) {
  candidates_.clear();
  IndexCandidates();
  by_position_ = preferences.size() > kFewPreferences;
  // Candidates have the reverse order of the list. Each value is one candidate, with the preference that is first in
  // the list.
  for (const SlotPreference& p : preferences) {
    if (p.type != PreferenceType::kAcceptable) continue;
    if (Find(p.value) != kNowhere) continue;
    candidates_.push_back({p.value, p.preference});
    if (by_position_ && p.value.IsIdentifier()) {
      if (position_.size() <= p.value.index()) position_.resize(p.value.index() + 1, kNowhere);
      position_[p.value.index()] = static_cast<std::uint32_t>(candidates_.size() - 1);
      indexed_.push_back(p.value.index());
    }
  }
  std::reverse(candidates_.begin(), candidates_.end());
  IndexCandidates();
}

PreferenceSemantics::Outcome PreferenceSemantics::DecideRequired(std::span<const SlotPreference> preferences) {
  candidates_.clear();
  for (const SlotPreference& p : preferences) {
    if (p.type != PreferenceType::kRequire) continue;
    const bool known =
        std::any_of(candidates_.begin(), candidates_.end(), [&](const Candidate& c) { return c.value == p.value; });
    if (!known) candidates_.push_back({p.value, p.preference});
  }
  std::reverse(candidates_.begin(), candidates_.end());
  IndexCandidates();
  AddNumbers(preferences);
  if (candidates_.size() > 1) return {ImpasseType::kConstraintFailure, candidates_};
  const Symbol required = candidates_.front().value;
  const bool prohibited = std::any_of(preferences.begin(), preferences.end(), [&](const SlotPreference& p) {
    return p.type == PreferenceType::kProhibit && p.value == required;
  });
  return {prohibited ? ImpasseType::kConstraintFailure : ImpasseType::kNone, candidates_};
}

bool PreferenceSemantics::DropDominated(std::span<const SlotPreference> preferences) {
  // Only candidates dominate candidates. A dominated candidate dominates others, too.
  MarkLosers(preferences, DecisionStage::kDominated);
  if (trace_ != nullptr) NoteLosers(preferences, DecisionStage::kDominated);
  if (std::all_of(marks_.begin(), marks_.end(), [](std::uint8_t m) { return m != 0; })) return true;
  Keep(false);
  return false;
}

void PreferenceSemantics::KeepBest(std::span<const SlotPreference> preferences) {
  MarkValuesOf(preferences, PreferenceType::kBest);
  if (std::find(marks_.begin(), marks_.end(), 1) == marks_.end()) return;
  if (trace_ != nullptr) NoteBest(preferences);
  Keep(true);
}

void PreferenceSemantics::DropWorst(std::span<const SlotPreference> preferences) {
  MarkLosers(preferences, DecisionStage::kWorst);
  if (std::find(marks_.begin(), marks_.end(), 0) == marks_.end()) return;
  if (trace_ != nullptr) NoteLosers(preferences, DecisionStage::kWorst);
  Keep(false);
}

bool PreferenceSemantics::AllIndifferent(std::span<const SlotPreference> preferences) {
  MarkValuesOf(preferences, PreferenceType::kUnaryIndifferent);
  bool all_marked = true;
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    if (candidates_[i].is_numeric) marks_[i] = 1;
    all_marked = all_marked && marks_[i] != 0;
  }
  if (all_marked) return true;

  // A candidate without a mark needs a binary preference with every other candidate. Collects the pairs, then counts
  // them per candidate.
  pairs_.clear();
  for (const SlotPreference& p : preferences) {
    if (p.type != PreferenceType::kBinaryIndifferent) continue;
    const std::uint32_t a = Find(p.value), b = Find(p.referent);
    if (a == kNowhere || b == kNowhere || a == b) continue;
    pairs_.push_back(static_cast<std::uint64_t>(a) << 32 | b);
    pairs_.push_back(static_cast<std::uint64_t>(b) << 32 | a);
  }
  std::sort(pairs_.begin(), pairs_.end());
  pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
  auto pair = pairs_.begin();
  for (std::uint32_t i = 0; i < candidates_.size(); ++i) {
    std::size_t partners = 0;
    for (; pair != pairs_.end() && *pair >> 32 == i; ++pair) ++partners;
    if (marks_[i] == 0 && partners + 1 < candidates_.size()) return false;
  }
  return true;
}

void PreferenceSemantics::AddNumbers(std::span<const SlotPreference> preferences) {
  for (const SlotPreference& p : preferences) {
    const bool is_number = p.type == PreferenceType::kNumericIndifferent;
    if (!is_number && p.type != PreferenceType::kBinaryIndifferent) continue;
    const std::uint32_t at = Find(p.value);
    if (at == kNowhere) continue;
    candidates_[at].is_numeric |= is_number;
    candidates_[at].number_sum += p.number;
    ++candidates_[at].number_count;
  }
}

void PreferenceSemantics::MarkValuesOf(std::span<const SlotPreference> preferences, PreferenceType type) {
  marks_.assign(candidates_.size(), 0);
  for (const SlotPreference& p : preferences) {
    if (p.type != type) continue;
    if (const std::uint32_t at = Find(p.value); at != kNowhere) marks_[at] = 1;
  }
}

std::uint32_t PreferenceSemantics::Loser(const SlotPreference& p, DecisionStage stage) const {
  switch (p.type) {
    case PreferenceType::kProhibit:
    case PreferenceType::kReject:
      return stage == DecisionStage::kReject ? Find(p.value) : kNowhere;
    case PreferenceType::kBetter:
    case PreferenceType::kWorse: {
      if (stage != DecisionStage::kDominated) return kNowhere;
      const bool is_better = p.type == PreferenceType::kBetter;
      const std::uint32_t winner = Find(is_better ? p.value : p.referent);
      const std::uint32_t loser = Find(is_better ? p.referent : p.value);
      return winner != kNowhere && winner != loser ? loser : kNowhere;
    }
    case PreferenceType::kWorst:
      return stage == DecisionStage::kWorst ? Find(p.value) : kNowhere;
    default:
      return kNowhere;
  }
}

void PreferenceSemantics::MarkLosers(std::span<const SlotPreference> preferences, DecisionStage stage) {
  marks_.assign(candidates_.size(), 0);
  for (const SlotPreference& p : preferences) {
    if (const std::uint32_t at = Loser(p, stage); at != kNowhere) marks_[at] = 1;
  }
}

void PreferenceSemantics::NoteLosers(std::span<const SlotPreference> preferences, DecisionStage stage) {
  pairs_.clear();
  for (std::uint32_t place = 0; place < preferences.size(); ++place) {
    const std::uint32_t at = Loser(preferences[place], stage);
    if (at != kNowhere) pairs_.push_back(static_cast<std::uint64_t>(at) << 32 | place);
  }
  std::sort(pairs_.begin(), pairs_.end());
  std::uint32_t last = kNowhere;
  for (const std::uint64_t pair : pairs_) {
    const auto at = static_cast<std::uint32_t>(pair >> 32), place = static_cast<std::uint32_t>(pair);
    if (at != last) {
      trace_->drops.push_back({candidates_[at].value, stage, static_cast<std::uint32_t>(trace_->by.size()), 0});
    }
    last = at;
    DecisionTrace::Drop& drop = trace_->drops.back();
    ++drop.count;
    trace_->by.push_back(place);
    if (preferences[place].type == PreferenceType::kProhibit) drop.stage = DecisionStage::kProhibit;
  }
}

void PreferenceSemantics::NoteBest(std::span<const SlotPreference> preferences) {
  const auto first = static_cast<std::uint32_t>(trace_->by.size());
  for (std::uint32_t place = 0; place < preferences.size(); ++place) {
    if (preferences[place].type == PreferenceType::kBest && Find(preferences[place].value) != kNowhere) {
      trace_->by.push_back(place);
    }
  }
  const std::uint32_t count = static_cast<std::uint32_t>(trace_->by.size()) - first;
  bool are_dropped = false;
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    if (marks_[i] != 0) continue;
    trace_->drops.push_back({candidates_[i].value, DecisionStage::kBest, first, count});
    are_dropped = true;
  }
  if (!are_dropped) trace_->by.resize(first);
}

void PreferenceSemantics::NoteRequired(std::span<const SlotPreference> preferences) {
  const auto is_required = [&](Symbol value) {
    return std::ranges::any_of(
        preferences, [&](const SlotPreference& p) { return p.type == PreferenceType::kRequire && p.value == value; });
  };
  for (std::uint32_t place = 0; place < preferences.size(); ++place) {
    const SlotPreference& p = preferences[place];
    if (p.type == PreferenceType::kRequire) trace_->by.push_back(place);
    if (p.type == PreferenceType::kRequire || (p.type == PreferenceType::kProhibit && is_required(p.value))) {
      trace_->settling.push_back(place);
    }
  }
  const auto count = static_cast<std::uint32_t>(trace_->by.size());
  for (const Candidate& candidate : candidates_) {
    if (!is_required(candidate.value)) trace_->drops.push_back({candidate.value, DecisionStage::kRequire, 0, count});
  }
}

void PreferenceSemantics::NoteForced(Symbol forced) {
  for (const Candidate& candidate : candidates_) {
    if (candidate.value != forced) trace_->drops.push_back({candidate.value, DecisionStage::kForced, 0, 0});
  }
}

void PreferenceSemantics::NoteSettling(std::span<const SlotPreference> preferences) {
  for (std::uint32_t place = 0; place < preferences.size(); ++place) {
    const PreferenceType type = preferences[place].type;
    const bool settles = type == PreferenceType::kUnaryIndifferent || type == PreferenceType::kNumericIndifferent ||
                         type == PreferenceType::kBinaryIndifferent;
    if (settles && Find(preferences[place].value) != kNowhere) trace_->settling.push_back(place);
  }
}

void PreferenceSemantics::Keep(bool marked) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    if ((marks_[i] != 0) == marked) candidates_[kept++] = candidates_[i];
  }
  candidates_.resize(kept);
  IndexCandidates();
}

void PreferenceSemantics::IndexCandidates() {
  if (!by_position_) return;
  for (const std::uint32_t index : indexed_) position_[index] = kNowhere;
  indexed_.clear();
  for (std::uint32_t i = 0; i < candidates_.size(); ++i) {
    if (!candidates_[i].value.IsIdentifier()) continue;
    const std::uint32_t index = candidates_[i].value.index();
    if (position_.size() <= index) position_.resize(index + 1, kNowhere);
    position_[index] = i;
    indexed_.push_back(index);
  }
}

std::uint32_t PreferenceSemantics::Find(Symbol value) const {
  if (by_position_ && value.IsIdentifier()) {
    return value.index() < position_.size() ? position_[value.index()] : kNowhere;
  }
  for (std::uint32_t i = 0; i < candidates_.size(); ++i) {
    if (candidates_[i].value == value) return i;
  }
  return kNowhere;
}

bool IsDecisive(std::span<const SlotPreference> preferences, const DecisionTrace& trace,
                const DecisionTrace::Drop& drop) {
  std::vector<SlotPreference> others;
  others.reserve(preferences.size());
  const std::span<const std::uint32_t> by = trace.By(drop);
  for (std::uint32_t place = 0; place < preferences.size(); ++place) {
    if (std::ranges::find(by, place) == by.end()) others.push_back(preferences[place]);
  }
  PreferenceSemantics with, without;
  const PreferenceSemantics::Outcome now = with.Decide(preferences), then = without.Decide(others);
  return now.impasse != then.impasse ||
         !std::ranges::equal(now.candidates, then.candidates, {}, &Candidate::value, &Candidate::value);
}

}  // namespace soarbox::kernel
