// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/surface_match.h"

#include <algorithm>

namespace soarbox::kernel {

// Collecting the reachable facts --------------------------------------------------------------------------------------

std::uint32_t SurfaceMatch::CellOf(std::uint32_t variable, EpisodeNode node) {
  const auto [found, is_new] =
      cell_of_.try_emplace(std::uint64_t{variable} << 32 | node, static_cast<std::uint32_t>(cells_.size()));
  if (is_new) {
    Cell cell;
    cell.variable = variable;
    cell.node = node;
    const bool negative = variable >= positive_.variable_count();
    const std::uint32_t own = negative ? variable - positive_.variable_count() : variable;
    cell.needed = static_cast<std::uint32_t>(CueOf(variable).EdgesTo(own).size());
    cells_.push_back(cell);
  }
  return found->second;
}

void SurfaceMatch::AddPair(std::uint32_t cell, std::uint32_t edge_key, const EpisodeCue::Edge& edge, EpisodeFact fact,
                           std::uint32_t leaf, std::uint32_t first_variable) {
  Pair pair;
  pair.leaf = leaf;
  pair.fact = fact;
  pair.cell = cell;
  pair.arrival = kNone;
  if (edge.to != EpisodeCue::kNoVariable) {
    const EpisodeNode node = store_.triple(fact).value.node();
    const std::uint32_t to = CellOf(first_variable + edge.to, node);
    const auto [found, is_new] =
        arrival_of_.try_emplace(std::uint64_t{edge_key} << 32 | node, static_cast<std::uint32_t>(arrivals_.size()));
    if (is_new) arrivals_.push_back({to, 0});
    pair.arrival = found->second;
  }
  cells_[cell].pairs.push_back(static_cast<std::uint32_t>(pairs_.size()));
  pairs_.push_back(pair);
}

void SurfaceMatch::Expand(const EpisodeCue& cue, std::uint32_t first_variable, std::int32_t sign) {
  if (cue.variable_count() == 0) return;
  const std::uint32_t first_edge = first_variable == 0 ? 0 : static_cast<std::uint32_t>(positive_.edges().size());
  std::vector<std::uint32_t> leaf_of(cue.edges().size(), kNone);
  for (std::size_t n = 0; n < cue.edges().size(); ++n) {
    if (!cue.edges()[n].leaf) continue;
    leaf_of[n] = static_cast<std::uint32_t>(leaves_.size());
    leaves_.push_back({sign * cue.edges()[n].weight, sign, 0, 0});
  }
  std::size_t next = cells_.size();
  CellOf(first_variable, 0);
  for (; next < cells_.size(); ++next) {
    const std::uint32_t cell = static_cast<std::uint32_t>(next);
    const EpisodeNode node = cells_[next].node;
    for (const std::uint32_t index : cue.EdgesFrom(cells_[next].variable - first_variable)) {
      const EpisodeCue::Edge& edge = cue.edge(index);
      const std::uint32_t key = first_edge + index;
      if (edge.to != EpisodeCue::kNoVariable) {
        for (const EpisodeFact fact : store_.Children(node, edge.attribute)) {
          AddPair(cell, key, edge, fact, leaf_of[index], first_variable);
        }
        continue;
      }
      const EpisodeFact fact = store_.Find({node, edge.attribute, EpisodeValue::Constant(edge.value)});
      if (fact != kNoEpisodeFact) AddPair(cell, key, edge, fact, leaf_of[index], first_variable);
    }
  }
}

// Searching backwards -------------------------------------------------------------------------------------------------

void SurfaceMatch::Schedule(std::uint32_t pair, EpisodeNumber episode) {
  heap_.emplace_back(episode, pair);
  std::push_heap(heap_.begin(), heap_.end());
}

/// A pair starts or stops to support a leaf or a cell.
void SurfaceMatch::Count(std::uint32_t pair, bool up) {
  work_.emplace_back(pair, up);
  while (!work_.empty()) {
    const auto [at, more] = work_.back();
    work_.pop_back();
    const Pair& p = pairs_[at];
    if (p.leaf != kNone) {
      Leaf& leaf = leaves_[p.leaf];
      leaf_seen_ = true;
      if (more ? leaf.count++ == 0 : --leaf.count == 0) {
        cardinality_ += more ? leaf.step : -leaf.step;
        changed_ = true;
      }
    }
    if (p.arrival == kNone) continue;
    Arrival& arrival = arrivals_[p.arrival];
    if (more ? arrival.count++ != 0 : --arrival.count != 0) continue;
    Cell& cell = cells_[arrival.cell];
    const bool before = cell.held();
    cell.have = more ? cell.have + 1 : cell.have - 1;
    if (cell.held() == before) continue;
    for (const std::uint32_t out : cell.pairs) {
      if (pairs_[out].holds) work_.emplace_back(out, more);
    }
  }
}

void SurfaceMatch::Toggle(std::uint32_t at) {
  Pair& pair = pairs_[at];
  pair.holds = !pair.holds;
  if (cells_[pair.cell].held()) Count(at, pair.holds);
}

/// Sums up the weights again, always in the same order, because incremental sums would accumulate rounding errors.
void SurfaceMatch::Add() {
  score_ = possible_ = 0;
  for (const Leaf& leaf : leaves_) {
    if (leaf.count != 0) score_ += leaf.weight;
    if (leaf.possible != 0 && leaf.weight > 0) possible_ += leaf.weight;
  }
  changed_ = false;
}

SurfaceScore SurfaceMatch::Find(const EpisodeWindow& window, const OnPerfect& on_perfect,
                                std::vector<SurfaceStep>* steps) {
  SurfaceScore best;
  if (window.last < window.first) return best;
  const EpisodeNumber least = window.is_open() ? 1 : window.first;
  Expand(positive_, 0, 1);
  Expand(negative_, positive_.variable_count(), -1);
  for (std::uint32_t pair = 0; pair < pairs_.size(); ++pair) {
    const EpisodeNumber held = store_.Latest(pairs_[pair].fact, window.last);
    if (held < least) continue;
    Schedule(pair, held);
    if (pairs_[pair].leaf != kNone) ++leaves_[pairs_[pair].leaf].possible;
  }
  Add();
  // A negative leaf with a negative weight would increase the score, so with such weights the search goes to the end.
  const bool bounded = negative_.all_weigh() && positive_.all_weigh();
  const std::int32_t perfect = static_cast<std::int32_t>(positive_.leaf_count());
  const auto exhausted = [&](const Pair& pair) {
    if (pair.leaf == kNone) return;
    if (--leaves_[pair.leaf].possible == 0) changed_ = true;
  };
  while (!heap_.empty()) {
    const EpisodeNumber episode = heap_.front().first;
    while (!heap_.empty() && heap_.front().first == episode) {
      const std::uint32_t at = heap_.front().second;
      std::pop_heap(heap_.begin(), heap_.end());
      heap_.pop_back();
      Pair& pair = pairs_[at];
      Toggle(at);
      if (pair.holds) {
        // Going backwards, the pair ends before its interval begins.
        Schedule(at, store_.SameSince(pair.fact, episode) - 1);
      } else if (const EpisodeNumber earlier = episode == 0 ? 0 : store_.Latest(pair.fact, episode); earlier >= least) {
        Schedule(at, earlier);
      } else {
        exhausted(pair);
      }
    }
    if (episode < window.first) break;
    if (changed_) Add();
    const EpisodeNumber until = heap_.empty() ? window.first : std::max(least, heap_.front().first + 1);
    const EpisodeNumber candidate = window.Latest(episode, least);
    if (!leaf_seen_ || candidate < until) continue;
    const bool is_perfect = cardinality_ == perfect && perfect > 0;
    if (is_perfect && on_perfect && (best.episode == 0 || score_ >= best.score) && on_perfect(candidate)) {
      if (steps != nullptr) steps->push_back({candidate, true, true});
      return {candidate, score_, cardinality_};
    }
    if (best.episode == 0 || score_ > best.score) {
      best = {candidate, score_, cardinality_};
      if (steps != nullptr) steps->push_back({candidate, is_perfect, is_perfect && !on_perfect});
    }
    if (bounded && !on_perfect && best.score >= possible_) break;
  }
  return best;
}

}  // namespace soarbox::kernel
