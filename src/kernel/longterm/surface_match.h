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

/// How well an episode agrees with a cue leaf by leaf.
struct SurfaceScore {
  EpisodeNumber episode = 0;  ///< 0: no leaf held in any.
  double score = 0;
  std::int32_t cardinality = 0;  ///< Positive leaves that held less negative ones that did.
};

/// An episode that scored more than all later ones, or the same and holds the cue as a graph.
struct SurfaceStep {
  EpisodeNumber episode = 0;
  bool is_perfect = false;  ///< All positive leaves hold, no negative one does.
  bool ends_search = false;
};

/// The episode whose score is best, the latest of these. A leaf counts once in an episode, and only if all that leads
/// to it holds; a variable stands for any node there, and for several at a time.
///
/// Walks the ends of intervals of the facts that the cue can reach, latest first; ends as soon as leaves that were true
/// still earlier cannot beat the best.
class SurfaceMatch {
 public:
  /// Told of each episode in which all positive leaves hold and no negative one, as long as no later one scored more:
  /// true ends the search with it.
  using OnPerfect = std::function<bool(EpisodeNumber)>;

  SurfaceMatch(const EpisodeStore& store, const EpisodeCue& positive, const EpisodeCue& negative)
      : store_(store), positive_(positive), negative_(negative) {}

  /// `on_perfect` may be empty. `steps`, if there, gets what was the best on the way.
  SurfaceScore Find(const EpisodeWindow& window, const OnPerfect& on_perfect,
                    std::vector<SurfaceStep>* steps = nullptr);

 private:
  /// A variable as a node: held when each edge to the variable has a fact that holds and comes from a held cell.
  struct Cell {
    std::uint32_t variable = 0;  ///< Those of the negative cue after those of the positive one.
    EpisodeNode node = 0;
    std::uint32_t needed = 0, have = 0;
    std::vector<std::uint32_t> pairs;  ///< That leave it.
    bool held() const { return have == needed; }
  };
  /// An edge of a cue as a fact.
  struct Pair {
    std::uint32_t leaf = 0;  ///< Index into leaves_, or none.
    EpisodeFact fact = 0;
    std::uint32_t cell = 0;     ///< That it leaves.
    std::uint32_t arrival = 0;  ///< Index into arrivals_, or none.
    bool holds = false;
  };
  /// An edge of a cue that leads to a cell: how many pairs of it speak for the cell.
  struct Arrival {
    std::uint32_t cell = 0, count = 0;
  };
  struct Leaf {
    double weight = 0;           ///< Negative leaves: less than nothing.
    std::int32_t step = 1;       ///< What it adds to the cardinality.
    std::uint32_t count = 0;     ///< Pairs that hold and are reached.
    std::uint32_t possible = 0;  ///< Pairs that hold at or before the present episode.
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
  std::vector<std::pair<EpisodeNumber, std::uint32_t>> heap_;  ///< When which pair changes, going back.
  std::vector<std::pair<std::uint32_t, bool>> work_;
  double score_ = 0, possible_ = 0;
  std::int32_t cardinality_ = 0;
  bool leaf_seen_ = false;
  bool changed_ = false;  ///< A leaf, since the weights were added up.
};

}  // namespace soarbox::kernel
