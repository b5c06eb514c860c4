// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/graph_match.h"

#include <utility>

namespace soarbox::kernel {

bool GraphMatch::AddFact(const EpisodeTriple& triple) {
  const EpisodeFact fact = store_.Find(triple);
  if (fact == kNoEpisodeFact) return false;
  facts_.push_back(fact);
  return true;
}

/// Lowers latest_ to an episode in which all facts are true. Returns false if none beats the best one so far.
bool GraphMatch::Narrow() {
  std::size_t agree = 0, at = 0;
  EpisodeNumber episode = (*allowed_)(latest_);
  while (agree < facts_.size()) {
    if (episode <= best_) return false;
    const EpisodeNumber held = store_.Latest(facts_[at], episode);
    at = at + 1 == facts_.size() ? 0 : at + 1;
    if (held == episode) {
      ++agree;
      continue;
    }
    episode = (*allowed_)(held);
    agree = episode == held ? 1 : 0;
  }
  latest_ = episode;
  return episode > best_;
}

/// Binds the variable and adds the facts that its elements require. Returns false if this is impossible or cannot beat
/// the best assignment.
bool GraphMatch::Bind(std::uint32_t variable, EpisodeNode node, std::uint32_t by_edge) {
  nodes_[variable] = node;
  for (const std::uint32_t index : cue_.EdgesTo(variable)) {
    const EpisodeCue::Edge& edge = cue_.edge(index);
    if (nodes_[edge.from] == kNoEpisodeNode || index == by_edge) continue;
    if (!AddFact({nodes_[edge.from], edge.attribute, EpisodeValue::Node(node)})) return false;
  }
  for (const std::uint32_t index : cue_.EdgesFrom(variable)) {
    const EpisodeCue::Edge& edge = cue_.edge(index);
    if (edge.to == EpisodeCue::kNoVariable) {
      if (!AddFact({node, edge.attribute, EpisodeValue::Constant(edge.value)})) return false;
    } else if (nodes_[edge.to] != kNoEpisodeNode) {
      if (!AddFact({node, edge.attribute, EpisodeValue::Node(nodes_[edge.to])})) return false;
    }
  }
  if (!Narrow()) return false;
  for (const std::uint32_t index : cue_.EdgesFrom(variable)) {
    const std::uint32_t to = cue_.edge(index).to;
    if (to == EpisodeCue::kNoVariable || waiting_[to] != 0) continue;
    waiting_[to] = 1;
    frontier_.push_back(to);
  }
  return true;
}

/// Selects the variable with the fewest candidates and starts to try them.
void GraphMatch::Choose() {
  Try attempt;
  std::size_t fewest = ~std::size_t{0};
  for (std::uint32_t place = 0; place < frontier_.size(); ++place) {
    for (const std::uint32_t index : cue_.EdgesTo(frontier_[place])) {
      const EpisodeCue::Edge& edge = cue_.edge(index);
      if (nodes_[edge.from] == kNoEpisodeNode) continue;
      const std::size_t count = store_.Children(nodes_[edge.from], edge.attribute).size();
      if (count >= fewest) continue;
      fewest = count;
      attempt.variable = frontier_[place];
      attempt.edge = index;
      attempt.frontier_place = place;
    }
  }
  attempt.next = fewest;
  std::swap(frontier_[attempt.frontier_place], frontier_.back());
  frontier_.pop_back();
  attempt.frontier_size = static_cast<std::uint32_t>(frontier_.size());
  attempt.facts = facts_.size();
  attempt.latest = latest_;
  tries_.push_back(attempt);
}

void GraphMatch::Unbind(Try& attempt) {
  if (!attempt.bound) return;
  attempt.bound = false;
  if (--used_[nodes_[attempt.variable]].count == 0) used_.erase(nodes_[attempt.variable]);
  nodes_[attempt.variable] = kNoEpisodeNode;
  while (frontier_.size() > attempt.frontier_size) {
    waiting_[frontier_.back()] = 0;
    frontier_.pop_back();
  }
  facts_.resize(attempt.facts);
  latest_ = attempt.latest;
}

bool GraphMatch::Find(EpisodeNumber first, EpisodeNumber last, const LatestAllowed& allowed) {
  // The newest nodes lead to the latest episode fastest. A second search determines which nodes match in it.
  if (!Search(first, last, allowed, false)) return false;
  const EpisodeNumber found = best_;
  return Search(
      found, found, [](EpisodeNumber episode) { return episode; }, true);
}

bool GraphMatch::Search(EpisodeNumber first, EpisodeNumber last, const LatestAllowed& allowed, bool oldest_first) {
  allowed_ = &allowed;
  best_ = first - 1;
  latest_ = allowed(last);
  const EpisodeNumber ceiling = latest_;
  nodes_.assign(cue_.variable_count(), kNoEpisodeNode);
  waiting_.assign(cue_.variable_count(), 0);
  frontier_.clear();
  facts_.clear();
  tries_.clear();
  used_.clear();
  waiting_[0] = 1;
  bool found = false;
  if (ceiling < first || !Bind(0, 0, ~0u)) return false;
  bool forward = true;
  while (true) {
    if (forward && frontier_.empty()) {
      best_ = latest_;
      best_nodes_ = nodes_;
      found = true;
      if (best_ == ceiling) break;
      forward = false;
    }
    if (forward) {
      Choose();
    } else if (tries_.empty()) {
      break;
    }
    Try& attempt = tries_.back();
    Unbind(attempt);
    forward = false;
    const EpisodeCue::Edge& edge = cue_.edge(attempt.edge);
    const auto candidates = store_.Children(nodes_[edge.from], edge.attribute);
    while (attempt.next > 0 && !forward) {
      --attempt.next;
      const EpisodeFact fact = candidates[oldest_first ? candidates.size() - 1 - attempt.next : attempt.next];
      const EpisodeNode node = store_.triple(fact).value.node();
      const auto [use, is_free] = used_.try_emplace(node, Use{cue_.ObjectOf(attempt.variable), 0});
      if (!is_free && use->second.object != cue_.ObjectOf(attempt.variable)) continue;
      ++use->second.count;
      attempt.bound = true;
      facts_.push_back(fact);
      forward = Bind(attempt.variable, node, attempt.edge);
      if (!forward) Unbind(attempt);
    }
    if (forward) continue;
    // All candidates have been tried: the variable is unbound again.
    frontier_.push_back(attempt.variable);
    std::swap(frontier_[attempt.frontier_place], frontier_.back());
    tries_.pop_back();
  }
  return found;
}

}  // namespace soarbox::kernel
