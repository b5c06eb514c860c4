// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "kernel/longterm/episode_cue.h"
#include "kernel/longterm/episode_store.h"

namespace soarbox::kernel {

/// How well an episode matches a cue, counted by leaves.
struct SurfaceScore {
  EpisodeNumber episode = 0;  ///< 0: no leaf matched in any episode.
  double score = 0;
  std::int32_t cardinality = 0;  ///< Positive leaves that matched minus negative leaves that matched.
};

/// An episode with a higher score than all later ones, or with the same score and a graph match.
struct SurfaceStep {
  EpisodeNumber episode = 0;
  bool is_perfect = false;  ///< All positive leaves match, and no negative one does.
  bool ends_search = false;
};

/// Finds the episode with the best score; the latest one if there are several. A leaf counts once per episode, and only
/// if the entire path to it matches. A variable may be matched by any node in the right position, even by several.
///
/// Walks the interval ends of the facts that the cue can reach, latest first. Stops as soon as the leaves that were
/// true in earlier episodes cannot beat the best score.
class SurfaceMatch {
 public:
  /// Called for each episode in which all positive leaves match and no negative one does, but not if a later episode
  /// scored more. Return true to end the search with this episode.
  using OnPerfect = std::function<bool(EpisodeNumber)>;

  SurfaceMatch(const EpisodeStore& store, const EpisodeCue& positive, const EpisodeCue& negative)
      : store_(store), positive_(positive), negative_(negative) {}

  /// `on_perfect` may be empty. `steps`, if given, receives the successive best episodes.
  SurfaceScore Find(const EpisodeWindow& window, const OnPerfect& on_perfect,
                    std::vector<SurfaceStep>* steps = nullptr);

 private:
  /// A variable matched by a node. It is held if each edge to the variable has a fact that is true and comes from a
  /// held cell.
  struct Cell {
    std::uint32_t variable = 0;  ///< Variables of the negative cue follow those of the positive one.
    EpisodeNode node = 0;
    std::uint32_t needed = 0, have = 0;
    std::vector<std::uint32_t> pairs;  ///< The pairs that start at it.
    bool held() const { return have == needed; }
  };
  /// An edge of a cue matched by a fact.
  struct Pair {
    std::uint32_t leaf = 0;  ///< Index in leaves_, or none.
    EpisodeFact fact = 0;
    std::uint32_t cell = 0;     ///< The cell at which it starts.
    std::uint32_t arrival = 0;  ///< Index in arrivals_, or none.
    bool holds = false;
  };
  /// An edge of a cue that leads to a cell: the number of its pairs that support the cell.
  struct Arrival {
    std::uint32_t cell = 0, count = 0;
  };
  struct Leaf {
    double weight = 0;           ///< Below 0 for negative leaves.
    std::int32_t step = 1;       ///< Added to the cardinality if it matches.
    std::uint32_t count = 0;     ///< Number of pairs that are true and reachable.
    std::uint32_t possible = 0;  ///< Number of pairs that are true in the current or an earlier episode.
  };
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;

  const EpisodeCue& CueOf(std::uint32_t variable) const {
    return variable < positive_.variable_count() ? positive_ : negative_;
  }
  std::uint32_t CellOf(std::uint32_t variable, EpisodeNode node);
  void Expand(const EpisodeCue& cue, std::uint32_t first_variable, std::int32_t sign);
  void AddPair(std::uint32_t cell, std::uint32_t edge_key, const EpisodeCue::Edge& edge, EpisodeFact fact,
               std::uint32_t leaf, std::uint32_t first_variable);
  void Schedule(std::uint32_t pair, EpisodeNumber episode);
  void Toggle(std::uint32_t pair);
  void Count(std::uint32_t pair, bool up);
  void Add();

  const EpisodeStore& store_;
  const EpisodeCue& positive_;
  const EpisodeCue& negative_;
  std::vector<Cell> cells_;
  std::vector<Pair> pairs_;
  std::vector<Arrival> arrivals_;
  std::vector<Leaf> leaves_;
  std::unordered_map<std::uint64_t, std::uint32_t> cell_of_, arrival_of_;
  std::vector<std::pair<EpisodeNumber, std::uint32_t>> heap_;  ///< The next change of each pair, going backwards.
  std::vector<std::pair<std::uint32_t, bool>> work_;
  double score_ = 0, possible_ = 0;
  std::int32_t cardinality_ = 0;
  bool leaf_seen_ = false;
  bool changed_ = false;  ///< A leaf has changed since the weights were summed up.
};

}  // namespace soarbox::kernel
