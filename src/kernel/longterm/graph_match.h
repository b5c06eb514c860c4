// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

#include "kernel/longterm/episode_cue.h"
#include "kernel/longterm/episode_store.h"

namespace soarbox::kernel {

/// Finds the latest episode in which the entire cue matches as a graph. Each variable is assigned a node. Variables of
/// two objects of the cue are assigned different nodes. (Only the cue itself, the top state, may share its node with
/// another variable.)
///
/// The search is over assignments of nodes. Their number depends on the number of simultaneous objects, not on that of
/// episodes. For each assignment, it intersects the intervals of the facts to find the latest common episode. It drops
/// an assignment as soon as it cannot beat the best one. If several assignments match in the latest episode, variables
/// get the oldest nodes, as in Soar 9.6.3.
class GraphMatch {
 public:
  /// The latest allowed episode up to the given one, or 0.
  using LatestAllowed = std::function<EpisodeNumber(EpisodeNumber)>;

  GraphMatch(const EpisodeStore& store, const EpisodeCue& cue) : store_(store), cue_(cue) {}

  /// Searches the episodes from `first` to `last`. Returns true if one matches.
  bool Find(EpisodeNumber first, EpisodeNumber last, const LatestAllowed& allowed);
  EpisodeNumber episode() const { return best_; }
  /// By variable: its node in the match.
  const std::vector<EpisodeNode>& nodes() const { return best_nodes_; }

 private:
  /// The state of a variable during the search.
  struct Try {
    std::uint32_t variable = 0;
    std::uint32_t edge = 0;            ///< The edge by which its candidates were found.
    std::uint32_t frontier_place = 0;  ///< The variable's place in the frontier.
    std::uint32_t frontier_size = 0;   ///< The size of the frontier before its successors were added.
    std::size_t next = 0;              ///< The index of the next candidate, counted down: those before it are untried.
    std::size_t facts = 0;             ///< The number of facts before those of the candidate were added.
    EpisodeNumber latest = 0;          ///< The value of latest_ before the candidate was assigned.
    bool bound = false;
  };

  /// Tries the newest nodes first, or, if `oldest_first`, the oldest.
  bool Search(EpisodeNumber first, EpisodeNumber last, const LatestAllowed& allowed, bool oldest_first);
  bool Bind(std::uint32_t variable, EpisodeNode node, std::uint32_t by_edge);
  bool AddFact(const EpisodeTriple& triple);
  bool Narrow();
  void Choose();
  void Unbind(Try& attempt);

  const EpisodeStore& store_;
  const EpisodeCue& cue_;
  const LatestAllowed* allowed_ = nullptr;
  std::vector<EpisodeNode> nodes_, best_nodes_;
  /// For a bound node: the object of its variables, and their number.
  struct Use {
    std::uint32_t object = 0, count = 0;
  };
  std::unordered_map<EpisodeNode, Use> used_;
  std::vector<std::uint32_t> frontier_;  ///< Unbound variables to which a bound one is linked.
  std::vector<std::uint8_t> waiting_;    ///< By variable: it is in frontier_, or bound.
  std::vector<EpisodeFact> facts_;       ///< All facts that the current assignment requires.
  std::vector<Try> tries_;
  EpisodeNumber latest_ = 0;  ///< The latest episode in which all these facts are true.
  EpisodeNumber best_ = 0;
};

}  // namespace soarbox::kernel
