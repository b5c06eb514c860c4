// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/spreading.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace soarbox::kernel {

Spreading::Reach Spreading::ReachOf(const Knowledge& knowledge, std::uint32_t source) {
  Reach& known = reaches_[source];
  if (known != nullptr) return known;
  // Best first: paths sorted by their remaining activation; equal ones by number.
  struct Step {
    std::uint32_t object;
    double weight;  ///< Of the augmentation of this step: equal steps must have equal weights, too.
    bool operator==(const Step&) const = default;
  };
  struct Path {
    double share;
    std::uint32_t object;
    std::uint64_t depth;
    std::vector<Step> visited;
  };
  const auto later = [&](const Path& a, const Path& b) {
    if (a.share != b.share) return a.share < b.share;
    return knowledge.NumberAt(a.object) > knowledge.NumberAt(b.object);
  };
  std::priority_queue<Path, std::vector<Path>, decltype(later)> open(later);
  open.push({1.0, source, 0, {{source, 1.0}}});
  std::map<std::uint32_t, double> sums;
  std::uint64_t paths = 0;
  const double continues = settings_.spreading_continue_probability, least = settings_.spreading_baseline;
  while (!open.empty() && paths < settings_.spreading_limit) {
    const Path path = open.top();
    open.pop();
    const LinkWeights::Weights* const weights = weights_.Of(knowledge, path.object);
    std::uint64_t fan = 0;
    for (const Edge& edge : knowledge.EdgesAt(path.object)) fan += edge.value.IsObject() ? 1 : 0;
    const double passed_on = path.share * continues;
    if (fan == 0 || passed_on <= least) continue;
    for (const Edge& edge : knowledge.EdgesAt(path.object)) {
      if (!edge.value.IsObject() || paths >= settings_.spreading_limit) continue;
      const std::uint32_t next = edge.value.index();
      const double weight = weights == nullptr ? 1 / static_cast<double>(fan) : weights->find(next)->second;
      const bool is_left_out = settings_.spreading_loop_avoidance
                                   ? std::ranges::find(path.visited, Step{next, weight}) != path.visited.end()
                                   : weight < least;
      if (is_left_out) continue;
      const double share = passed_on * weight;
      sums[next] += share;
      ++paths;
      if (path.depth + 1 >= settings_.spreading_depth_limit || continues * share <= least) continue;
      Path further{share, next, path.depth + 1, {}};
      if (settings_.spreading_loop_avoidance) {
        further.visited = path.visited;
        further.visited.push_back({next, weight});
      }
      open.push(std::move(further));
    }
  }
  auto made = std::make_shared<std::vector<Share>>();
  for (const auto& [object, share] : sums) made->push_back({object, share});
  known = std::move(made);
  return known;
}

void Spreading::SetSources(const Knowledge& knowledge, const std::map<std::uint32_t, double>& sources) {
  if (sources == known_ && !known_.empty()) return;
  known_ = sources;
  totals_.clear();
  std::erase_if(active_, [&](const auto& source) { return !sources.contains(source.first); });
  const double continues = settings_.spreading_continue_probability;
  least_ = settings_.spreading_baseline /
           (continues * std::pow(1 + continues, static_cast<double>(settings_.spreading_depth_limit)));
  for (const auto& [source, strength] : sources) {
    Reach& active = active_[source];
    if (active == nullptr) active = ReachOf(knowledge, source);
    const std::vector<Share>& reach = *active;
    double whole = 0;
    for (const Share& share : reach) whole += share.share;
    const double odds = strength / (1 + strength);
    for (const Share& share : reach) totals_[share.object] += std::max(odds * share.share / whole, least_);
  }
}

void Spreading::Clear() {
  Renew();
  totals_.clear();
  shares_.clear();
}

}  // namespace soarbox::kernel
