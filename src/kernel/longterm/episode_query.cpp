// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/episode_query.h"

#include <algorithm>
#include <iterator>

#include "kernel/longterm/graph_match.h"

namespace soarbox::kernel {

// Negative leaves -----------------------------------------------------------------------------------------------------

NegativeLeaves::Span& NegativeLeaves::Look(EpisodeNumber episode, EpisodeNumber& start) {
  if (const auto after = known_.upper_bound(episode); after != known_.begin()) {
    const auto before = std::prev(after);
    if (before->second.end >= episode) {
      start = before->first;
      return before->second;
    }
  }
  start = 1;
  bool held = false;
  std::vector<std::vector<EpisodeNode>> nodes(cue_.variable_count());
  nodes[0].push_back(0);
  const auto holds = [&](EpisodeFact fact) {
    start = std::max(start, store_.SameSince(fact, episode));
    return store_.Holds(fact, episode);
  };
  for (const std::uint32_t variable : cue_.TopDown()) {
    std::vector<EpisodeNode>& own = nodes[variable];
    bool is_first = true;
    for (const std::uint32_t index : cue_.EdgesTo(variable)) {
      const EpisodeCue::Edge& edge = cue_.edge(index);
      std::vector<EpisodeNode> reached;
      for (const EpisodeNode from : nodes[edge.from]) {
        for (const EpisodeFact fact : store_.Children(from, edge.attribute)) {
          if (holds(fact)) reached.push_back(store_.triple(fact).value.node());
        }
      }
      held = held || (edge.leaf && !reached.empty());
      std::sort(reached.begin(), reached.end());
      reached.erase(std::unique(reached.begin(), reached.end()), reached.end());
      if (is_first) {
        own.swap(reached);
      } else {
        std::vector<EpisodeNode> both;
        std::set_intersection(own.begin(), own.end(), reached.begin(), reached.end(), std::back_inserter(both));
        own.swap(both);
      }
      is_first = false;
    }
    for (const std::uint32_t index : cue_.EdgesFrom(variable)) {
      const EpisodeCue::Edge& edge = cue_.edge(index);
      if (edge.to != EpisodeCue::kNoVariable) continue;
      for (const EpisodeNode node : own) {
        const EpisodeFact fact = store_.Find({node, edge.attribute, EpisodeValue::Constant(edge.value)});
        if (fact != kNoEpisodeFact && holds(fact)) held = true;
      }
    }
  }
  return known_[start] = {episode, held};
}

EpisodeNumber NegativeLeaves::LatestWithout(EpisodeNumber episode) {
  while (episode != 0) {
    EpisodeNumber start = 0;
    if (!Look(episode, start).held) break;
    episode = start - 1;
  }
  return episode;
}

// Queries -------------------------------------------------------------------------------------------------------------

namespace {

bool CanBeAnswered(const EpisodeQuery& query) {
  return query.window.first <= query.window.last && query.positive.variable_count() != 0;
}

bool WantsGraph(const EpisodeQuery& query) {
  return query.graph_match && query.positive.leaf_count() > 0;
}

SurfaceMatch::OnPerfect GraphAt(GraphMatch& matcher) {
  return [&](EpisodeNumber at) { return matcher.Find(at, at, [](EpisodeNumber episode) { return episode; }); };
}

}  // namespace

EpisodeAnswer Answer(const EpisodeStore& store, const EpisodeQuery& query) {
  EpisodeAnswer answer;
  const EpisodeWindow& window = query.window;
  if (!CanBeAnswered(query)) return answer;
  const bool graph = WantsGraph(query);
  const bool graph_first = graph && query.positive.all_weigh() && query.negative.all_weigh() && !window.is_open();
  GraphMatch matcher(store, query.positive);
  if (graph_first) {
    NegativeLeaves negative(store, query.negative);
    const bool has_negative = query.negative.leaf_count() > 0;
    const auto allowed = [&](EpisodeNumber episode) {
      episode = window.Latest(episode);
      while (has_negative && episode != 0) {
        const EpisodeNumber without = negative.LatestWithout(episode);
        if (without == episode) break;
        episode = window.Latest(without);
      }
      return episode;
    };
    if (matcher.Find(window.first, window.last, allowed)) {
      answer.episode = matcher.episode();
      answer.score = query.positive.leaf_weight();
      answer.cardinality = static_cast<std::int32_t>(query.positive.leaf_count());
      answer.graph_matched = true;
      answer.nodes = matcher.nodes();
      return answer;
    }
  }
  SurfaceMatch::OnPerfect on_perfect;
  if (graph && !graph_first) on_perfect = GraphAt(matcher);
  const SurfaceScore best = SurfaceMatch(store, query.positive, query.negative).Find(window, on_perfect);
  answer.episode = best.episode;
  answer.score = best.score;
  answer.cardinality = best.cardinality;
  if (on_perfect && best.episode != 0 && matcher.episode() == best.episode) {
    answer.graph_matched = true;
    answer.nodes = matcher.nodes();
  }
  return answer;
}

std::vector<SurfaceStep> StepsOf(const EpisodeStore& store, const EpisodeQuery& query) {
  std::vector<SurfaceStep> steps;
  if (!CanBeAnswered(query)) return steps;
  GraphMatch matcher(store, query.positive);
  SurfaceMatch::OnPerfect on_perfect;
  if (WantsGraph(query)) on_perfect = GraphAt(matcher);
  SurfaceMatch(store, query.positive, query.negative).Find(query.window, on_perfect, &steps);
  return steps;
}

}  // namespace soarbox::kernel
