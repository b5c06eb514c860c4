// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/spreading.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace soarbox::kernel {

const std::vector<Spreading::Share>& Spreading::ReachOf(const Knowledge& knowledge, std::uint32_t source) {
  const auto [place, added] = reaches_.try_emplace(source);
  if (!added) return place->second;
  // Best first: paths in the order of what is left of the activation; equal ones by number.
  struct Path {
    double share;
    std::uint32_t object;
    std::uint64_t depth;
    std::vector<std::uint32_t> visited;
  };
  const auto later = [&](const Path& a, const Path& b) {
    if (a.share != b.share) return a.share < b.share;
    return knowledge.NumberAt(a.object) > knowledge.NumberAt(b.object);
  };
  std::priority_queue<Path, std::vector<Path>, decltype(later)> open(later);
  open.push({1.0, source, 0, {source}});
  std::map<std::uint32_t, double> sums;
  std::uint64_t paths = 0;
  while (!open.empty() && paths < settings_.spreading_limit) {
    const Path path = open.top();
    open.pop();
    if (path.depth > 0) {
      sums[path.object] += path.share;
      ++paths;
    }
    if (path.depth >= settings_.spreading_depth_limit) continue;
    std::uint64_t fan = 0;
    for (const Edge& edge : knowledge.EdgesAt(path.object)) fan += edge.value.IsObject() ? 1 : 0;
    for (const Edge& edge : knowledge.EdgesAt(path.object)) {
      if (!edge.value.IsObject()) continue;
      const std::uint32_t next = edge.value.index();
      const double share = path.share * settings_.spreading_continue_probability / static_cast<double>(fan);
      if (share < settings_.spreading_baseline) continue;
      if (settings_.spreading_loop_avoidance && std::ranges::find(path.visited, next) != path.visited.end()) continue;
      Path further{share, next, path.depth + 1, {}};
      if (settings_.spreading_loop_avoidance) {
        further.visited = path.visited;
        further.visited.push_back(next);
      }
      open.push(std::move(further));
    }
  }
  for (const auto& [object, share] : sums) place->second.push_back({object, share});
  return place->second;
}

void Spreading::SetSources(const Knowledge& knowledge, const std::map<std::uint32_t, double>& sources) {
  if (sources == known_ && !known_.empty()) return;
  known_ = sources;
  totals_.clear();
  recipients_.clear();
  double weights = 0;
  for (const auto& [source, weight] : sources) weights += settings_.spreading_wma_source ? weight : 1.0;
  for (const auto& [source, weight] : sources) {
    const double part = (settings_.spreading_wma_source ? weight : 1.0) / weights;
    for (const Share& share : ReachOf(knowledge, source)) totals_[share.object] += share.share * part;
  }
  for (const auto& [object, total] : totals_) recipients_.push_back(object);
  std::ranges::sort(recipients_);
  double sum = 0, power = 1;
  for (std::uint64_t k = 0; k < settings_.spreading_depth_limit; ++k) {
    power *= settings_.spreading_continue_probability;
    sum += power;
  }
  offset_ = std::log(settings_.spreading_baseline / sum);
}

double Spreading::ShareOf(std::uint32_t object) const {
  const auto total = totals_.find(object);
  return total == totals_.end() ? 0 : std::log(total->second) - offset_;
}

void Spreading::Clear() {
  reaches_.clear();
  known_.clear();
  totals_.clear();
  recipients_.clear();
}

}  // namespace soarbox::kernel
