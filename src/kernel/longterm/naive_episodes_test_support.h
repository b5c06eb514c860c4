// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <set>
#include <tuple>
#include <vector>

#include "kernel/longterm/episode_query.h"

namespace soarbox::kernel {

/// Episodes as full copies, and queries by exhaustive search: the reference for tests of the store and the matchers.
class NaiveEpisodes {
 public:
  using Fact = std::tuple<EpisodeNode, EpisodeTerm, std::uint32_t>;  ///< The value as EpisodeValue::bits().

  void Hold(const EpisodeTriple& triple) { now_.insert(Key(triple)); }
  void Release(const EpisodeTriple& triple) { now_.erase(Key(triple)); }
  bool Holds(const EpisodeTriple& triple) const { return now_.contains(Key(triple)); }
  void Commit() { episodes_.push_back(now_); }
  const std::set<Fact>& Episode(EpisodeNumber number) const { return episodes_[number - 1]; }

  EpisodeAnswer Answer(const EpisodeQuery& query) const;
  /// Whether these nodes, by variable, match the cue in this episode.
  static bool IsMatch(const std::set<Fact>& episode, const EpisodeCue& cue, const std::vector<EpisodeNode>& nodes);

 private:
  static Fact Key(const EpisodeTriple& triple) { return {triple.parent, triple.attribute, triple.value.bits()}; }

  std::set<Fact> now_;
  std::vector<std::set<Fact>> episodes_;
};

}  // namespace soarbox::kernel
