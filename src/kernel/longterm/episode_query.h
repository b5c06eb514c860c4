// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "kernel/longterm/episode_cue.h"
#include "kernel/longterm/episode_store.h"
#include "kernel/longterm/surface_match.h"

namespace soarbox::kernel {

struct EpisodeQuery {
  EpisodeCue positive, negative;
  EpisodeWindow window;
  bool graph_match = true;
};

struct EpisodeAnswer {
  EpisodeNumber episode = 0;  ///< 0: none.
  double score = 0;
  std::int32_t cardinality = 0;
  bool graph_matched = false;
  std::vector<EpisodeNode> nodes;  ///< If so: by variable of the positive cue.
};

/// The result of a query: the latest episode in which the positive cue matches as a graph and no leaf of the negative
/// cue matches. If there is none, or if graph matching is off, the one with the best surface score.
EpisodeAnswer Answer(const EpisodeStore& store, const EpisodeQuery& query);

/// The successive best episodes of a query that is executed like Soar, one episode at a time from the latest backwards.
std::vector<SurfaceStep> StepsOf(const EpisodeStore& store, const EpisodeQuery& query);

/// Finds the episodes in which a leaf of a negative cue matches.
class NegativeLeaves {
 public:
  NegativeLeaves(const EpisodeStore& store, const EpisodeCue& cue) : store_(store), cue_(cue) {}

  /// The latest episode up to `episode` in which none matches, or 0.
  EpisodeNumber LatestWithout(EpisodeNumber episode);

 private:
  struct Span {
    EpisodeNumber end = 0;
    bool held = false;
  };
  Span& Look(EpisodeNumber episode, EpisodeNumber& start);

  const EpisodeStore& store_;
  const EpisodeCue& cue_;
  std::map<EpisodeNumber, Span> known_;  ///< By start: episodes in which the answer is the same.
};

}  // namespace soarbox::kernel
