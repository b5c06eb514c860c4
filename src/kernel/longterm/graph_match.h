// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

#include "kernel/longterm/episode_cue.h"
#include "kernel/longterm/episode_store.h"

namespace soarbox::kernel {

/// The latest episode in which the whole cue matches as a graph: each variable is a node, and variables of two objects
/// of the cue are two nodes. (Only the cue itself, the top state, may also be another variable's node.)
///
/// It tries assignments over nodes, of which there are as many as there were things at a time, not over episodes. For
/// each, it finds the latest common episode of the facts in their intervals, and drops an assignment as soon as it
/// cannot beat the best so far. If several match in the latest episode, variables get the nodes that came first, as in
/// Soar 9.6.3.
class GraphMatch {
 public:
  /// The latest episode up to the given one that may be returned, or 0.
  using LatestAllowed = std::function<EpisodeNumber(EpisodeNumber)>;

  GraphMatch(const EpisodeStore& store, const EpisodeCue& cue) : store_(store), cue_(cue) {}

  /// True if there is one from `first` to `last`.
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
    std::uint32_t frontier_size = 0;   ///< Before its successors were added.
    std::size_t next = 0;              ///< Candidates before this one are left to try.
    std::size_t facts = 0;             ///< Before the candidate's were added.
    EpisodeNumber latest = 0;          ///< Before the candidate.
    bool bound = false;
  };

  /// Tries the nodes that came last first, or those that came first.
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
  /// A bound node: to variables of which object, and to how many.
  struct Use {
    std::uint32_t object = 0, count = 0;
  };
  std::unordered_map<EpisodeNode, Use> used_;
  std::vector<std::uint32_t> frontier_;  ///< Variables that a bound one leads to.
  std::vector<std::uint8_t> waiting_;    ///< By variable: is in frontier_, or bound.
  std::vector<EpisodeFact> facts_;       ///< All facts that the assignment so far needs.
  std::vector<Try> tries_;
  EpisodeNumber latest_ = 0;  ///< The latest episode in which all of them hold.
  EpisodeNumber best_ = 0;
};

}  // namespace soarbox::kernel
