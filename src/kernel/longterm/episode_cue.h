// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/longterm/episode_store.h"

namespace soarbox::kernel {

/// An element of a cue as the agent wrote it. Object 0 is the cue itself, which represents the top state of the
/// episode.
struct EpisodeCueElement {
  std::uint32_t object = 0;
  EpisodeTerm attribute = kUnknownEpisodeTerm;
  bool value_is_object = false;
  std::uint32_t value = 0;  ///< The number of an object, or a term.
  double weight = 1;
};

/// A cue as an acyclic graph: variables, and attributes that link them to each other and to constants. An element is
/// omitted if it leads back to an object on the path from the cue, or only to such elements. Variable 0 is the top
/// state. An object without elements becomes a separate variable for each link to it: two links to such an object may
/// match two nodes.
class EpisodeCue {
 public:
  static constexpr std::uint32_t kNoVariable = 0xFFFFFFFF;

  struct Edge {
    std::uint32_t from = 0;          ///< A variable.
    std::uint32_t to = kNoVariable;  ///< A variable, or none if `value` is a constant.
    EpisodeTerm attribute = 0;
    EpisodeTerm value = 0;
    bool leaf = false;  ///< It counts in scores: its value is a constant or an object without elements.
    double weight = 0;
  };

  EpisodeCue() = default;
  /// `elements` belong to `objects` objects, and are in the order of the agent's working memory.
  EpisodeCue(std::span<const EpisodeCueElement> elements, std::uint32_t objects);

  std::uint32_t variable_count() const { return static_cast<std::uint32_t>(object_of_.size()); }
  const std::vector<Edge>& edges() const { return edges_; }
  const Edge& edge(std::uint32_t index) const { return edges_[index]; }
  /// Indices of the edges that leave a variable, or lead to one.
  std::span<const std::uint32_t> EdgesFrom(std::uint32_t variable) const { return from_.Of(variable); }
  std::span<const std::uint32_t> EdgesTo(std::uint32_t variable) const { return to_.Of(variable); }
  /// The agent's object that a variable represents.
  std::uint32_t ObjectOf(std::uint32_t variable) const { return object_of_[variable]; }
  /// Variables in an order in which each comes after those that lead to it.
  std::span<const std::uint32_t> TopDown() const { return top_down_; }
  std::uint32_t leaf_count() const { return leaf_count_; }
  double leaf_weight() const { return leaf_weight_; }
  /// True if all leaves have a weight above 0.
  bool all_weigh() const { return all_weigh_; }

 private:
  /// Lists of edges by variable.
  struct Lists {
    std::vector<std::uint32_t> begins, edges;
    std::span<const std::uint32_t> Of(std::uint32_t variable) const {
      return {edges.data() + begins[variable], begins[variable + 1] - begins[variable]};
    }
  };
  void MakeLists();
  void OrderVariables();

  std::vector<Edge> edges_;
  std::vector<std::uint32_t> object_of_, top_down_;
  Lists from_, to_;
  std::uint32_t leaf_count_ = 0;
  double leaf_weight_ = 0;
  bool all_weigh_ = true;
};

/// Which episodes a query may return.
struct EpisodeWindow {
  EpisodeNumber first = 1, last = 0;      ///< Both included.
  std::vector<EpisodeNumber> prohibited;  ///< Sorted.

  /// The latest allowed episode up to `episode`; 0 if there is none.
  EpisodeNumber Latest(EpisodeNumber episode) const { return Latest(episode, first); }
  /// Same, with `least` as the first allowed episode.
  EpisodeNumber Latest(EpisodeNumber episode, EpisodeNumber least) const;
  /// Whether the first episode is prohibited. If so, a search backwards that skips prohibited episodes may leave the
  /// window and, as in Soar 9.6.3, return an episode before it.
  bool is_open() const { return std::binary_search(prohibited.begin(), prohibited.end(), first); }
};

}  // namespace soarbox::kernel
