// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

#include "kernel/longterm/episode_cue.h"
#include "kernel/longterm/episode_store.h"

namespace soarbox::kernel {

/// The latest episode in which the whole cue holds as a graph: each variable is a node, and variables of two
/// objects of the cue are two nodes. (Only the cue itself, the top state, may be another variable's node as well.)
///
/// Assignments are tried over nodes, of which there are as many as there were things at a time, not over episodes. For
/// each, the latest common episode of its facts is found in their intervals; an assignment that cannot beat the best so
/// far is given up as soon as that shows. Where several hold in the latest episode, variables get the nodes that came
/// first, as in Soar 9.6.3.
class GraphMatch {
 public:
  /// The latest episode up to the one given, of those that may be returned, or 0.
  using LatestAllowed = std::function<EpisodeNumber(EpisodeNumber)>;

  GraphMatch(const EpisodeStore& store, const EpisodeCue& cue) : store_(store), cue_(cue) {}

  /// True if there is one from `first` to `last`.
  bool Find(EpisodeNumber first, EpisodeNumber last, const LatestAllowed& allowed);
  EpisodeNumber episode() const { return best_; }
  /// By variable: its node in the match.
  const std::vector<EpisodeNode>& nodes() const { return best_nodes_; }

 private:
  /// A variable that is being tried.
  struct Try {
    std::uint32_t variable = 0;
    std::uint32_t edge = 0;            ///< By which its candidates were found.
    std::uint32_t frontier_place = 0;  ///< Where the variable stood.
    std::uint32_t frontier_size = 0;   ///< Before its successors were added.
    std::size_t next = 0;              ///< Candidates left: those before this one.
    std::size_t facts = 0;             ///< Before the candidate's were added.
    EpisodeNumber latest = 0;          ///< Before the candidate.
    bool bound = false;
  };

  /// Tries nodes that came last first, or those that came first.
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
  /// Nodes that are bound: to variables of which object, and to how many.
  struct Use {
    std::uint32_t object = 0, count = 0;
  };
  std::unordered_map<EpisodeNode, Use> used_;
  std::vector<std::uint32_t> frontier_;  ///< Variables that a bound one leads to.
  std::vector<std::uint8_t> waiting_;    ///< By variable: is in frontier_, or bound.
  std::vector<EpisodeFact> facts_;       ///< All that the assignment so far needs.
  std::vector<Try> tries_;
  EpisodeNumber latest_ = 0;  ///< The latest episode in which all of them hold.
  EpisodeNumber best_ = 0;
};

}  // namespace soarbox::kernel
