// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/episode_store.h"

#include <algorithm>

namespace soarbox::kernel {
namespace {

std::uint64_t ChildKey(EpisodeNode parent, EpisodeTerm attribute) {
  return (std::uint64_t{parent} << 32) | attribute;
}

}  // namespace

void EpisodeStore::Clear() {
  facts_.clear();
  now_.clear();
  intervals_.Clear();
  by_content_.clear();
  by_content_.resize(64);
  children_.clear();
  changes_.clear();
  begins_.clear();
  begins_.emplace_back() = 0;
  frame_facts_.clear();
  frames_.clear();
  changes_since_frame_ = 0;
  touched_.clear();
  live_.clear();
  links_.clear();
  set_links_.clear();
  node_count_ = 1;
}

// Facts ---------------------------------------------------------------------------------------------------------------

std::size_t EpisodeStore::HashOf(const EpisodeTriple& triple) {
  std::uint64_t hash = (std::uint64_t{triple.parent} << 32 | triple.value.bits()) * 0x9E3779B97F4A7C15u;
  hash ^= hash >> 29;
  hash = (hash + triple.attribute) * 0xBF58476D1CE4E5B9u;
  return static_cast<std::size_t>(hash ^ (hash >> 32));
}

EpisodeFact EpisodeStore::Find(const EpisodeTriple& triple) const {
  const std::size_t mask = by_content_.size() - 1;
  for (std::size_t at = HashOf(triple) & mask; by_content_[at] != 0; at = (at + 1) & mask) {
    const EpisodeFact fact = by_content_[at] - 1;
    if (this->triple(fact) == triple) return fact;
  }
  return kNoEpisodeFact;
}

void EpisodeStore::Rehash() {
  PlainVector<std::uint32_t> table;
  table.resize(by_content_.size() * 2);
  const std::size_t mask = table.size() - 1;
  for (EpisodeFact fact = 0; fact < facts_.size(); ++fact) {
    std::size_t at = HashOf(triple(fact)) & mask;
    while (table[at] != 0) at = (at + 1) & mask;
    table[at] = fact + 1;
  }
  by_content_ = std::move(table);
}

EpisodeFact EpisodeStore::Intern(const EpisodeTriple& triple) {
  if (const EpisodeFact known = Find(triple); known != kNoEpisodeFact) return known;
  if ((facts_.size() + 1) * 4 > by_content_.size() * 3) Rehash();
  const EpisodeFact fact = static_cast<EpisodeFact>(facts_.size());
  Fact& made = facts_.emplace_back();
  made.parent = triple.parent;
  made.attribute = triple.attribute;
  made.value = triple.value;
  now_.emplace_back();
  const std::size_t mask = by_content_.size() - 1;
  std::size_t at = HashOf(triple) & mask;
  while (by_content_[at] != 0) at = (at + 1) & mask;
  by_content_[at] = fact + 1;
  node_count_ = std::max(node_count_, triple.parent + 1);
  if (triple.value.IsNode()) {
    node_count_ = std::max(node_count_, triple.value.node() + 1);
    children_[ChildKey(triple.parent, triple.attribute)].push_back(fact);
  }
  return fact;
}

std::span<const EpisodeFact> EpisodeStore::Children(EpisodeNode parent, EpisodeTerm attribute) const {
  const auto found = children_.find(ChildKey(parent, attribute));
  if (found == children_.end()) return {};
  return found->second;
}

// Recording -----------------------------------------------------------------------------------------------------------

void EpisodeStore::Touch(EpisodeFact fact) {
  if (now_[fact].touched) return;
  now_[fact].touched = 1;
  touched_.push_back(fact);
}

void EpisodeStore::Hold(EpisodeFact fact) {
  if (now_[fact].holders++ == 0) Touch(fact);
}

void EpisodeStore::Release(EpisodeFact fact) {
  if (--now_[fact].holders == 0) Touch(fact);
}

void EpisodeStore::ReleaseAll() {
  for (const EpisodeFact fact : live_) Touch(fact);
  for (const EpisodeFact fact : touched_) now_[fact].holders = 0;
}

void EpisodeStore::SetLink(EpisodeNode node, std::uint64_t lti) {
  const auto found = links_.find(node);
  const std::uint64_t before = found == links_.end() ? 0 : found->second.back().lti;
  if (before == lti) return;
  std::vector<Link_>& history = found == links_.end() ? links_[node] : found->second;
  const EpisodeNumber next = last() + 1;
  if (!history.empty() && history.back().from == next) {
    history.back().lti = lti;
  } else {
    history.push_back({next, lti});
  }
  set_links_.push_back({next, node, lti});
}

void EpisodeStore::Log(EpisodeFact fact, bool comes) {
  changes_.emplace_back() = fact << 1 | (comes ? 1u : 0u);
}

EpisodeNumber EpisodeStore::Commit() {
  const EpisodeNumber episode = last() + 1;
  for (const EpisodeFact fact : touched_) {
    Fact& f = facts_[fact];
    Now& now = now_[fact];
    now.touched = 0;
    const bool was = f.open != 0, is = now.holders != 0;
    if (was == is) continue;
    Log(fact, is);
    if (is) {
      f.open = episode;
      now.live_at = static_cast<std::uint32_t>(live_.size()) & 0x7FFFFFFFu;
      live_.push_back(fact);
    } else {
      intervals_.Append(f.intervals, {f.open, episode - 1});
      f.open = 0;
      const EpisodeFact moved = live_.back();
      live_[now.live_at] = moved;
      now_[moved].live_at = now.live_at;
      live_.pop_back();
    }
  }
  touched_.clear();
  begins_.emplace_back() = static_cast<std::uint32_t>(changes_.size());
  WriteFrameIfDue();
  return episode;
}

void EpisodeStore::WriteFrameIfDue() {
  constexpr std::size_t kFewest = 16;
  changes_since_frame_ += LastChanges().size();
  if (changes_since_frame_ < std::max(live_.size(), kFewest)) return;
  Frame frame{last(), frame_facts_.size(), 0};
  for (const EpisodeFact fact : live_) frame_facts_.emplace_back() = fact;
  frame.end = frame_facts_.size();
  frames_.push_back(frame);
  changes_since_frame_ = 0;
}

std::span<const std::uint32_t> EpisodeStore::ChangesOf(EpisodeNumber episode) const {
  return {changes_.data() + begins_[episode - 1], begins_[episode] - begins_[episode - 1]};
}

std::span<const std::uint32_t> EpisodeStore::LastChanges() const {
  if (last() == 0) return {};
  return ChangesOf(last());
}

// Reading -------------------------------------------------------------------------------------------------------------

EpisodeNumber EpisodeStore::LatestClosed(const Fact& fact, EpisodeNumber episode) const {
  const std::span<const EpisodeInterval> all = intervals_.Of(fact.intervals);
  if (all.empty() || all.front().start > episode) return 0;
  if (all.back().start <= episode) return std::min(all.back().end, episode);
  const auto after = std::upper_bound(all.begin(), all.end(), episode,
                                      [](EpisodeNumber e, const EpisodeInterval& i) { return e < i.start; });
  return std::min(std::prev(after)->end, episode);
}

EpisodeNumber EpisodeStore::SameSince(EpisodeFact fact, EpisodeNumber episode) const {
  const Fact& f = facts_[fact];
  if (f.open != 0 && f.open <= episode) return f.open;
  const std::span<const EpisodeInterval> all = intervals_.Of(f.intervals);
  const auto after = std::upper_bound(all.begin(), all.end(), episode,
                                      [](EpisodeNumber e, const EpisodeInterval& i) { return e < i.start; });
  if (after == all.begin()) return 1;
  const EpisodeInterval& before = *std::prev(after);
  return before.end >= episode ? before.start : before.end + 1;
}

std::vector<EpisodeFact> EpisodeStore::Replay(EpisodeNumber episode) const {
  const auto after = std::upper_bound(frames_.begin(), frames_.end(), episode,
                                      [](EpisodeNumber e, const Frame& frame) { return e < frame.episode; });
  std::vector<EpisodeFact> facts;
  EpisodeNumber at = 0;
  if (after != frames_.begin()) {
    const Frame& frame = *std::prev(after);
    facts.assign(frame_facts_.data() + frame.begin, frame_facts_.data() + frame.end);
    at = frame.episode;
  }
  // Adds all facts that became true after the frame. One pass then removes those that are false in the episode.
  const std::size_t from_frame = facts.size();
  while (at < episode) {
    for (const std::uint32_t change : ChangesOf(++at)) {
      if ((change & 1) != 0) facts.push_back(change >> 1);
    }
  }
  std::sort(facts.begin() + static_cast<std::ptrdiff_t>(from_frame), facts.end());
  std::sort(facts.begin(), facts.begin() + static_cast<std::ptrdiff_t>(from_frame));
  std::inplace_merge(facts.begin(), facts.begin() + static_cast<std::ptrdiff_t>(from_frame), facts.end());
  facts.erase(std::unique(facts.begin(), facts.end()), facts.end());
  std::erase_if(facts, [&](EpisodeFact fact) { return !Holds(fact, episode); });
  return facts;
}

std::uint64_t EpisodeStore::Link(EpisodeNode node, EpisodeNumber episode) const {
  const auto found = links_.find(node);
  if (found == links_.end()) return 0;
  std::uint64_t lti = 0;
  for (const Link_& link : found->second) {
    if (link.from > episode) break;
    lti = link.lti;
  }
  return lti;
}

std::vector<std::pair<EpisodeNode, std::uint64_t>> EpisodeStore::LinksOf(EpisodeNumber episode) const {
  std::vector<std::pair<EpisodeNode, std::uint64_t>> links;
  const auto first = std::lower_bound(set_links_.begin(), set_links_.end(), episode,
                                      [](const SetLink_& link, EpisodeNumber e) { return link.from < e; });
  for (auto link = first; link != set_links_.end() && link->from == episode; ++link) {
    links.emplace_back(link->node, link->lti);
  }
  return links;
}

std::size_t EpisodeStore::MemoryBytes() const {
  std::size_t children = 0;
  for (const auto& [key, facts] : children_) children += 64 + facts.capacity() * sizeof(EpisodeFact);
  return facts_.capacity() * sizeof(Fact) + now_.capacity() * sizeof(Now) + intervals_.MemoryBytes() +
         by_content_.capacity() * 4 + changes_.capacity() * 4 + begins_.capacity() * 4 + frame_facts_.capacity() * 4 +
         frames_.capacity() * sizeof(Frame) + live_.capacity() * 4 + children;
}

const char* EpisodeStore::CheckInvariants() const {
  for (EpisodeFact fact = 0; fact < facts_.size(); ++fact) {
    EpisodeNumber free_from = 1;
    for (const EpisodeInterval& interval : Intervals(fact)) {
      if (interval.start < free_from || interval.end < interval.start) return "intervals of a fact are out of order";
      free_from = interval.end + 2;
    }
    const EpisodeNumber open = facts_[fact].open;
    if (open != 0 && open < free_from) return "an open interval begins before the last one ends";
    if (open > last()) return "an open interval begins in the future";
    if (open != 0 && live_[now_[fact].live_at] != fact) return "an open fact is not in the list of open facts";
  }
  if (last() == 0) return "";
  const std::vector<EpisodeFact> replayed = Replay(last());
  if (replayed.size() != live_.size()) return "replay of the newest episode differs from the facts that are true";
  return "";
}

}  // namespace soarbox::kernel
