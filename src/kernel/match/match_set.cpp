// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/match/match_set.h"

#include <algorithm>

namespace soarbox::kernel {

namespace {

constexpr std::size_t kFirstBuckets = 64;
/// Memory for the matches of a small agent, so that its first decisions do not allocate more than later ones.
constexpr std::size_t kUsualRecords = 32;
constexpr std::size_t kUsualMatchedElements = 128;

std::uint8_t AssertionList(bool o_support) {
  return o_support ? 1 : 0;
}

}  // namespace

// Lists ---------------------------------------------------------------------------------------------------------------

void MatchSet::Push(std::uint32_t match, std::uint8_t list) {
  Record& record = records_[match];
  std::uint32_t& head = levels_[record.level].head[list];
  record.list = list;
  record.previous = kNil;
  record.next = head;
  if (head != kNil) {
    records_[head].previous = match;
  }
  head = match;
}

void MatchSet::Unlink(std::uint32_t match) {
  Record& record = records_[match];
  if (record.next != kNil) {
    records_[record.next].previous = record.previous;
  }
  if (record.previous != kNil) {
    records_[record.previous].next = record.next;
  } else {
    levels_[record.level].head[record.list] = record.next;
  }
}

// Records -------------------------------------------------------------------------------------------------------------

inline std::uint32_t MatchSet::TakeElements(std::size_t count) {
  std::uint32_t& free = free_elements_[count];
  if (free != kNil) [[likely]] {
    const std::uint32_t place = free;
    free = Index(elements_[place]);
    return place;
  }
  if (elements_.empty()) elements_.reserve(kUsualMatchedElements);
  const auto place = static_cast<std::uint32_t>(elements_.size());
  elements_.resize(elements_.size() + count);
  return place;
}

[[gnu::always_inline]] inline std::uint32_t MatchSet::NewRecord(const Arrival& arrival) {
  std::uint32_t index = free_records_;
  if (index != kNil) {
    free_records_ = records_[index].next;
  } else {
    if (records_.empty()) records_.reserve(kUsualRecords);
    index = static_cast<std::uint32_t>(records_.size());
    records_.emplace_back();
  }

  const std::size_t count = arrival.elements.size();
  const std::uint32_t place = count == 0 ? 0 : TakeElements(count);
  // Copying a few words one by one is cheaper than a call.
  WmeId* to = elements_.data() + place;
  const WmeId* from = arrival.elements.data();
  for (std::size_t n = 0; n < count; ++n) {
    to[n] = from[n];
  }

  Record& record = records_[index];
  record.token = arrival.token;
  record.production = arrival.production;
  record.elements = place;
  record.element_count = static_cast<std::uint16_t>(count);
  record.level = arrival.level;
  record.o_support = arrival.o_support;
  record.goal = arrival.goal;
  record.instantiation = InstantiationId::kNone;
  record.hashed = false;
  record.stamp = next_stamp_++;
  if (arrival.level >= levels_.size()) {
    levels_.resize(arrival.level + 1u);
  }
  record.generation = levels_[arrival.level].generation;
  if (arrival.production != kNil) {
    ++rules_[arrival.production].live;
  }
  return index;
}

void MatchSet::FreeRecord(std::uint32_t match) {
  Record& record = records_[match];
  if (record.element_count != 0) {
    elements_[record.elements] = static_cast<WmeId>(free_elements_[record.element_count]);
    free_elements_[record.element_count] = record.elements;
  }
  if (record.production != kNil) {
    --rules_[record.production].live;
  }
  record.state = MatchState::kFree;
  record.element_count = 0;
  record.next = free_records_;
  free_records_ = match;
}

MatchId MatchSet::Assert(const Arrival& arrival) {
  const std::uint32_t match = NewRecord(arrival);
  records_[match].state = MatchState::kPendingAssertion;
  Push(match, AssertionList(arrival.o_support));
  if (rules_[arrival.production].interrupts) [[unlikely]] {
    interrupting_.push_back(arrival.production);
  }
  return static_cast<MatchId>(match);
}

MatchId MatchSet::AddFired(const Arrival& arrival, InstantiationId instantiation) {
  ExpectElements(arrival.elements.size());
  const std::uint32_t match = NewRecord(arrival);
  records_[match].state = MatchState::kFired;
  records_[match].instantiation = instantiation;
  return static_cast<MatchId>(match);
}

bool MatchSet::TokenGone(MatchId match, bool can_return, std::uint64_t last_timetag) {
  Record& record = records_[Index(match)];
  record.token = kNil;
  if (record.state == MatchState::kPendingAssertion) {
    Unlink(Index(match));
  }
  if (record.state != MatchState::kFired) {
    FreeRecord(Index(match));
    return false;
  }
  if (record.instantiation == InstantiationId::kNone) {
    FreeRecord(Index(match));  // It was released while it matched.
    return false;
  }
  record.state = MatchState::kPendingRetraction;
  record.stamp = next_stamp_++;
  record.last_timetag = last_timetag;
  if (record.generation != levels_[record.level].generation) {
    record.level = 0;
    record.generation = 0;
  }
  Push(Index(match), 2);
  if (can_return && record.production != kNil) {
    Hash(Index(match));
  }
  return true;
}

// The decision cycle's part -------------------------------------------------------------------------------------------

PendingMatch MatchSet::Describe(MatchId match) const {
  const Record& record = records_[Index(match)];
  return {match, static_cast<ProductionId>(record.production), record.goal, record.level, record.o_support};
}

PendingMatch MatchSet::TakeAssertion(GoalLevel level, bool o_support) {
  if (!HasAssertions(level, o_support)) {
    return {};
  }
  const std::uint32_t match = levels_[level].head[AssertionList(o_support)];
  Unlink(match);
  records_[match].state = MatchState::kTaken;
  return Describe(static_cast<MatchId>(match));
}

void MatchSet::PutBack(std::span<const MatchId> taken) {
  for (std::size_t n = taken.size(); n-- > 0;) {
    Record& record = records_[Index(taken[n])];
    record.state = MatchState::kPendingAssertion;
    Push(Index(taken[n]), AssertionList(record.o_support));
  }
}

void MatchSet::MarkFired(MatchId match, InstantiationId instantiation) {
  records_[Index(match)].state = MatchState::kFired;
  records_[Index(match)].instantiation = instantiation;
}

MatchId MatchSet::TakeRetraction(GoalLevel level) {
  if (!HasRetractions(level)) {
    return MatchId::kNone;
  }
  const std::uint32_t match = levels_[level].head[2];
  Unlink(match);
  if (records_[match].hashed) {
    Unhash(match);
  }
  records_[match].state = MatchState::kRetracting;
  return static_cast<MatchId>(match);
}

void MatchSet::Release(MatchId match) {
  Record& record = records_[Index(match)];
  if (record.state == MatchState::kTaken || record.state == MatchState::kFired) {
    record.state = MatchState::kFired;  // Its token stays; the record is freed with it.
    record.instantiation = InstantiationId::kNone;
    return;
  }
  if (record.state == MatchState::kPendingRetraction) {
    Unlink(Index(match));
    if (record.hashed) {
      Unhash(Index(match));
    }
  }
  FreeRecord(Index(match));
}

void MatchSet::Drop(MatchId match) {
  const MatchState state = records_[Index(match)].state;
  if (state == MatchState::kPendingAssertion || state == MatchState::kPendingRetraction) {
    Unlink(Index(match));
  }
  if (records_[Index(match)].hashed) {
    Unhash(Index(match));
  }
  FreeRecord(Index(match));
}

void MatchSet::GoalRemoved(GoalLevel level) {
  ++goals_removed_;
  if (level == 0 || level >= levels_.size()) {
    return;
  }
  ++levels_[level].generation;
  for (std::uint8_t list = 0; list < 3; ++list) {
    // Starts at the tail, so that the newest stays at the head.
    std::uint32_t last = levels_[level].head[list];
    if (last == kNil) {
      continue;
    }
    while (records_[last].next != kNil) {
      last = records_[last].next;
    }
    levels_[level].head[list] = kNil;
    for (std::uint32_t match = last; match != kNil;) {
      const std::uint32_t previous = records_[match].previous;
      records_[match].level = 0;
      records_[match].generation = 0;
      Push(match, list);
      match = previous;
    }
  }
}

std::vector<PendingMatch> MatchSet::Pending(List list) const {
  std::vector<std::uint32_t> found;
  for (const Level& level : levels_) {
    for (std::uint32_t match = level.head[static_cast<std::size_t>(list)]; match != kNil;
         match = records_[match].next) {
      found.push_back(match);
    }
  }
  std::sort(found.begin(), found.end(),
            [this](std::uint32_t a, std::uint32_t b) { return records_[a].stamp > records_[b].stamp; });
  std::vector<PendingMatch> pending;
  pending.reserve(found.size());
  for (const std::uint32_t match : found) {
    pending.push_back(Describe(static_cast<MatchId>(match)));
  }
  return pending;
}

// Retractions that can come back --------------------------------------------------------------------------------------

std::uint32_t MatchSet::HashOf(std::uint32_t production, std::span<const WmeId> elements) {
  std::uint32_t hash = production * 0x9E3779B1u;
  for (const WmeId element : elements) {
    hash = (hash ^ Index(element)) * 0x85EBCA6Bu;
    hash ^= hash >> 15;
  }
  return hash;
}

std::uint32_t& MatchSet::Bucket(const Record& record) {
  const std::uint32_t hash = HashOf(record.production, {elements_.data() + record.elements, record.element_count});
  return hash_buckets_[hash & (hash_buckets_.size() - 1)];
}

void MatchSet::Hash(std::uint32_t match) {
  if (hash_count_ >= hash_buckets_.size()) {
    GrowHash();
  }
  Record& record = records_[match];
  std::uint32_t& head = Bucket(record);
  record.hash_previous = kNil;
  record.hash_next = head;
  if (head != kNil) {
    records_[head].hash_previous = match;
  }
  head = match;
  record.hashed = true;
  ++hash_count_;
  ++rules_[record.production].returnable;
}

void MatchSet::Unhash(std::uint32_t match) {
  Record& record = records_[match];
  if (record.hash_next != kNil) {
    records_[record.hash_next].hash_previous = record.hash_previous;
  }
  if (record.hash_previous != kNil) {
    records_[record.hash_previous].hash_next = record.hash_next;
  } else {
    Bucket(record) = record.hash_next;
  }
  record.token = kNil;
  record.hashed = false;
  --hash_count_;
  --rules_[record.production].returnable;
}

void MatchSet::GrowHash() {
  const std::vector<std::uint32_t> old = std::move(hash_buckets_);
  hash_buckets_.assign(std::max(kFirstBuckets, old.size() * 2), kNil);
  for (std::uint32_t match : old) {
    while (match != kNil) {
      Record& record = records_[match];
      const std::uint32_t next = record.hash_next;
      std::uint32_t& head = Bucket(record);
      record.hash_previous = kNil;
      record.hash_next = head;
      if (head != kNil) {
        records_[head].hash_previous = match;
      }
      head = match;
      match = next;
    }
  }
}

MatchId MatchSet::Revive(const Arrival& arrival, const WmeTable& wmes) {
  if (!MayReturn(arrival.production)) {
    return MatchId::kNone;
  }
  const std::uint32_t hash = HashOf(arrival.production, arrival.elements);
  for (std::uint32_t match = hash_buckets_[hash & (hash_buckets_.size() - 1)]; match != kNil;
       match = records_[match].hash_next) {
    Record& record = records_[match];
    if (record.production != arrival.production ||
        !std::ranges::equal(Wmes(static_cast<MatchId>(match)), arrival.elements)) {
      continue;
    }
    // An index that was reused since then belongs to another element, with a larger time tag.
    const bool same = std::ranges::all_of(
        arrival.elements, [&](WmeId element) { return wmes[Index(element)].timetag <= record.last_timetag; });
    if (!same) {
      continue;
    }
    Unlink(match);
    Unhash(match);
    record.state = MatchState::kFired;
    record.token = arrival.token;
    return static_cast<MatchId>(match);
  }
  return MatchId::kNone;
}

void MatchSet::Clear() {
  records_.clear();
  free_records_ = kNil;
  levels_.assign(levels_.size(), Level());
  elements_.clear();
  std::fill(free_elements_.begin(), free_elements_.end(), kNil);
  std::fill(hash_buckets_.begin(), hash_buckets_.end(), kNil);
  hash_count_ = 0;
  for (RuleCounts& rule : rules_) {
    rule.returnable = rule.live = 0;
  }
  interrupting_.clear();
  next_stamp_ = 0;
}

std::size_t MatchSet::MemoryBytes() const {
  return records_.capacity() * sizeof(Record) + elements_.capacity() * sizeof(WmeId) +
         (free_elements_.capacity() + hash_buckets_.capacity()) * 4 + rules_.capacity() * sizeof(RuleCounts) +
         levels_.capacity() * sizeof(Level);
}

}  // namespace soarbox::kernel
