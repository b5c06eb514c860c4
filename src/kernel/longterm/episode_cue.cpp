// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/episode_cue.h"

#include <algorithm>

namespace soarbox::kernel {
namespace {

enum class CueStage : std::uint8_t { kUnknown, kOnTheWay, kDone, kLeftOut };

/// The state of reading an object's elements.
struct CueVisit {
  std::uint32_t object = 0;
  std::uint32_t next = 0;     ///< The index of the next element.
  std::uint32_t through = 0;  ///< The edge that refers to this object.
  bool has_edges = false;
  bool left_out = false;  ///< One of its elements was omitted.
};

}  // namespace

EpisodeCue::EpisodeCue(std::span<const EpisodeCueElement> elements, std::uint32_t objects) {
  std::vector<std::vector<std::uint32_t>> of_object(objects);
  for (std::uint32_t n = 0; n < elements.size(); ++n) of_object[elements[n].object].push_back(n);
  std::vector<CueStage> stage(objects, CueStage::kUnknown);
  std::vector<std::uint32_t> variable_of(objects, kNoVariable);
  // At first, edges refer to objects, because the variables are not known yet.
  std::vector<bool> dropped;
  const auto add = [&](const EpisodeCueElement& element, std::uint32_t to, bool leaf) {
    edges_.push_back({element.object, to, element.attribute, element.value_is_object ? 0 : element.value, leaf,
                      leaf ? element.weight : 0});
    dropped.push_back(false);
    return static_cast<std::uint32_t>(edges_.size() - 1);
  };
  std::vector<CueVisit> way;
  way.push_back({});
  stage[0] = CueStage::kOnTheWay;
  while (!way.empty()) {
    CueVisit& visit = way.back();
    if (visit.next == of_object[visit.object].size()) {
      const bool nothing = visit.left_out && !visit.has_edges && way.size() > 1;
      stage[visit.object] = nothing ? CueStage::kLeftOut : CueStage::kDone;
      const std::uint32_t through = visit.through;
      way.pop_back();
      if (way.empty()) break;
      if (nothing) {
        dropped[through] = true;
        way.back().left_out = true;
      } else {
        way.back().has_edges = true;
      }
      continue;
    }
    const EpisodeCueElement& element = elements[of_object[visit.object][visit.next++]];
    if (!element.value_is_object) {
      add(element, kNoVariable, true);
      visit.has_edges = true;
      continue;
    }
    const bool leaf = of_object[element.value].empty();
    switch (stage[element.value]) {
      case CueStage::kOnTheWay:
      case CueStage::kLeftOut:
        visit.left_out = true;
        break;
      case CueStage::kDone:
        add(element, element.value, leaf);
        visit.has_edges = true;
        break;
      case CueStage::kUnknown:
        stage[element.value] = CueStage::kOnTheWay;
        way.push_back({element.value, 0, add(element, element.value, leaf), false, false});
        break;
    }
  }
  // Removes the omitted edges and numbers the others in order of first visit.
  std::size_t kept = 0;
  object_of_.push_back(0);
  variable_of[0] = 0;
  for (std::size_t n = 0; n < edges_.size(); ++n) {
    Edge edge = edges_[n];
    if (dropped[n] || stage[edge.from] == CueStage::kLeftOut) continue;
    if (edge.to != kNoVariable) {
      // For an object without elements, each link is a separate leaf.
      if (edge.leaf || variable_of[edge.to] == kNoVariable) {
        variable_of[edge.to] = variable_count();
        object_of_.push_back(edge.to);
      }
      edge.to = variable_of[edge.to];
    }
    edges_[kept++] = edge;
  }
  edges_.resize(kept);
  for (Edge& edge : edges_) {
    edge.from = variable_of[edge.from];
    if (!edge.leaf) continue;
    ++leaf_count_;
    leaf_weight_ += edge.weight;
    all_weigh_ = all_weigh_ && edge.weight > 0;
  }
  MakeLists();
  OrderVariables();
}

void EpisodeCue::MakeLists() {
  const auto make = [&](Lists& lists, auto variable_of) {
    lists.begins.assign(variable_count() + 1, 0);
    for (const Edge& edge : edges_) {
      if (const std::uint32_t v = variable_of(edge); v != kNoVariable) ++lists.begins[v + 1];
    }
    for (std::uint32_t v = 0; v < variable_count(); ++v) lists.begins[v + 1] += lists.begins[v];
    lists.edges.resize(lists.begins.back());
    std::vector<std::uint32_t> at(lists.begins.begin(), lists.begins.end() - 1);
    for (std::uint32_t n = 0; n < edges_.size(); ++n) {
      if (const std::uint32_t v = variable_of(edges_[n]); v != kNoVariable) lists.edges[at[v]++] = n;
    }
  };
  make(from_, [](const Edge& edge) { return edge.from; });
  make(to_, [](const Edge& edge) { return edge.to; });
}

void EpisodeCue::OrderVariables() {
  std::vector<std::uint32_t> waits(variable_count());
  for (std::uint32_t v = 0; v < variable_count(); ++v) waits[v] = static_cast<std::uint32_t>(EdgesTo(v).size());
  top_down_.push_back(0);
  for (std::size_t n = 0; n < top_down_.size(); ++n) {
    for (const std::uint32_t index : EdgesFrom(top_down_[n])) {
      const std::uint32_t to = edges_[index].to;
      if (to != kNoVariable && --waits[to] == 0) top_down_.push_back(to);
    }
  }
}

EpisodeNumber EpisodeWindow::Latest(EpisodeNumber episode, EpisodeNumber least) const {
  episode = std::min(episode, last);
  auto at = std::upper_bound(prohibited.begin(), prohibited.end(), episode);
  while (at != prohibited.begin() && *std::prev(at) == episode) {
    --at;
    --episode;
    while (at != prohibited.begin() && *std::prev(at) > episode) --at;  // It may be in the list twice.
  }
  return episode >= least ? episode : 0;
}

}  // namespace soarbox::kernel
