// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/naive_episodes_test_support.h"

#include <algorithm>
#include <set>

namespace soarbox::kernel {
namespace {

using Facts = std::set<NaiveEpisodes::Fact>;

std::set<EpisodeNode> NodesOf(const Facts& episode) {
  std::set<EpisodeNode> nodes = {0};
  for (const auto& [parent, attribute, value] : episode) {
    nodes.insert(parent);
    if (EpisodeValue::FromBits(value).IsNode()) nodes.insert(EpisodeValue::FromBits(value).node());
  }
  return nodes;
}

bool Linked(const Facts& episode, EpisodeNode from, EpisodeTerm attribute, EpisodeNode to) {
  return episode.contains({from, attribute, EpisodeValue::Node(to).bits()});
}

/// Whether a variable may be assigned to a node, judged by single leaves.
bool MayBe(const Facts& episode, const std::set<EpisodeNode>& nodes, const EpisodeCue& cue, std::uint32_t variable,
           EpisodeNode node) {
  if (variable == 0) return node == 0;
  const auto edges = cue.EdgesTo(variable);
  return std::all_of(edges.begin(), edges.end(), [&](std::uint32_t index) {
    const EpisodeCue::Edge& edge = cue.edge(index);
    return std::any_of(nodes.begin(), nodes.end(), [&](EpisodeNode from) {
      return Linked(episode, from, edge.attribute, node) && MayBe(episode, nodes, cue, edge.from, from);
    });
  });
}

/// The edges of a cue that are leaves and are true in an episode.
std::vector<const EpisodeCue::Edge*> HeldLeaves(const Facts& episode, const EpisodeCue& cue) {
  std::vector<const EpisodeCue::Edge*> held;
  const std::set<EpisodeNode> nodes = NodesOf(episode);
  for (const EpisodeCue::Edge& edge : cue.edges()) {
    if (!edge.leaf) continue;
    const bool holds = std::any_of(nodes.begin(), nodes.end(), [&](EpisodeNode from) {
      if (!MayBe(episode, nodes, cue, edge.from, from)) return false;
      if (edge.to == EpisodeCue::kNoVariable) {
        return episode.contains({from, edge.attribute, EpisodeValue::Constant(edge.value).bits()});
      }
      return std::any_of(nodes.begin(), nodes.end(),
                         [&](EpisodeNode to) { return Linked(episode, from, edge.attribute, to); });
    });
    if (holds) held.push_back(&edge);
  }
  return held;
}

bool Assign(const Facts& episode, const std::set<EpisodeNode>& nodes, const EpisodeCue& cue,
            std::vector<EpisodeNode>& chosen) {
  if (chosen.size() == cue.variable_count()) return NaiveEpisodes::IsMatch(episode, cue, chosen);
  for (const EpisodeNode node : nodes) {
    bool taken = false;
    for (std::uint32_t other = 1; other < chosen.size(); ++other) {
      const bool same = cue.ObjectOf(other) == cue.ObjectOf(static_cast<std::uint32_t>(chosen.size()));
      taken = taken || (chosen[other] == node && !same);
    }
    if (taken) continue;
    chosen.push_back(node);
    if (Assign(episode, nodes, cue, chosen)) return true;
    chosen.pop_back();
  }
  return false;
}

}  // namespace

bool NaiveEpisodes::IsMatch(const std::set<Fact>& episode, const EpisodeCue& cue,
                            const std::vector<EpisodeNode>& nodes) {
  return std::all_of(cue.edges().begin(), cue.edges().end(), [&](const EpisodeCue::Edge& edge) {
    const EpisodeValue value =
        edge.to == EpisodeCue::kNoVariable ? EpisodeValue::Constant(edge.value) : EpisodeValue::Node(nodes[edge.to]);
    return episode.contains({nodes[edge.from], edge.attribute, value.bits()});
  });
}

EpisodeAnswer NaiveEpisodes::Answer(const EpisodeQuery& query) const {
  EpisodeAnswer best;
  bool leaf_seen = false;
  for (EpisodeNumber number = query.window.last; number >= query.window.first && number != 0; --number) {
    const Facts& episode = Episode(number);
    const auto positive = HeldLeaves(episode, query.positive);
    const auto negative = HeldLeaves(episode, query.negative);
    leaf_seen = leaf_seen || !positive.empty() || !negative.empty();
    const auto& prohibited = query.window.prohibited;
    if (!leaf_seen || std::find(prohibited.begin(), prohibited.end(), number) != prohibited.end()) continue;
    EpisodeAnswer here;
    here.episode = number;
    for (const EpisodeCue::Edge* edge : positive) here.score += edge->weight;
    for (const EpisodeCue::Edge* edge : negative) here.score -= edge->weight;
    here.cardinality = static_cast<std::int32_t>(positive.size()) - static_cast<std::int32_t>(negative.size());
    const bool perfect = here.cardinality == static_cast<std::int32_t>(query.positive.leaf_count());
    if (query.graph_match && perfect && query.positive.leaf_count() > 0 &&
        (best.episode == 0 || here.score >= best.score)) {
      here.nodes = {0};
      here.graph_matched = Assign(episode, NodesOf(episode), query.positive, here.nodes);
      if (here.graph_matched) return here;
    }
    if (best.episode == 0 || here.score > best.score) best = here;
  }
  return best;
}

}  // namespace soarbox::kernel
