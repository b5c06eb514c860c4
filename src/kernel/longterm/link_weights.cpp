// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/link_weights.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace soarbox::kernel {

namespace {
/// Maximum number of buffered uses per object, so that objects that spreading never reaches do not exhaust the memory.
constexpr std::size_t kMostWaiting = 4096;
}  // namespace

void LinkWeights::Use(const Knowledge& knowledge, std::uint32_t object, std::uint32_t linked, std::uint64_t cycle) {
  std::vector<Uses>& uses = uses_[object];
  for (std::size_t n = uses.size(); n-- > 0 && uses[n].cycle == cycle;) {
    if (uses[n].linked != linked) continue;
    ++uses[n].count;
    return;
  }
  if (uses.size() == kMostWaiting) Count(knowledge, object, std::exchange(uses, {}));
  uses.push_back({cycle, linked, 1});
}

const LinkWeights::Weights* LinkWeights::Of(const Knowledge& knowledge, std::uint32_t object) {
  if (const auto waiting = uses_.find(object); waiting != uses_.end()) {
    const std::vector<Uses> uses = std::move(waiting->second);
    uses_.erase(waiting);
    Count(knowledge, object, uses);
  }
  return Known(object);
}

LinkWeights::Weights LinkWeights::Equal(const Knowledge& knowledge, std::uint32_t object) {
  Weights links;
  double fan = 0;
  for (const Edge& edge : knowledge.EdgesAt(object)) {
    if (!edge.value.IsObject()) continue;
    links[edge.value.index()] = 0;
    ++fan;
  }
  for (auto& [linked, weight] : links) weight = 1 / fan;
  return links;
}

LinkWeights::Weights LinkWeights::Effective(const Knowledge& knowledge, std::uint32_t object) const {
  const Weights* const known = Known(object);
  return known == nullptr ? Equal(knowledge, object) : *known;
}

bool LinkWeights::Set(const Knowledge& knowledge, std::uint32_t object, Weights weights) {
  const Weights links = Equal(knowledge, object);
  if (links.empty() ||
      !std::ranges::equal(links, weights, {}, &Weights::value_type::first, &Weights::value_type::first)) {
    return false;
  }
  weights_[object] = std::move(weights);
  if (notes_changes_) changed_.push_back(object);
  return true;
}

void LinkWeights::Count(const Knowledge& knowledge, std::uint32_t object, const std::vector<Uses>& uses) {
  Weights links = Effective(knowledge, object);
  const double factor = settings_.spreading_edge_update_factor;
  // (A link that exists only in working memory also gets a share while these uses are applied.)
  Weights weights = links;
  for (std::size_t n = 0; n < uses.size();) {
    const std::uint64_t cycle = uses[n].cycle;
    const bool is_first = n == 0;
    Weights gains;
    std::uint64_t count = 0;
    for (; n < uses.size() && uses[n].cycle == cycle; ++n) {
      double& gain = gains[uses[n].linked];
      for (std::uint32_t use = 0; use < uses[n].count; ++use) gain += (1 - weights[uses[n].linked]) * (1 - factor);
      count += uses[n].count;
    }
    double sum = 0;
    for (auto& [linked, weight] : weights) {
      if (const auto gain = gains.find(linked); gain != gains.end()) {
        weight += gain->second;
      } else if (!is_first) {
        weight *= std::pow(factor, static_cast<double>(count));
      }
      sum += weight;
    }
    if (!(sum > 0)) continue;
    for (auto& [linked, weight] : weights) weight /= sum;
  }
  if (links.empty()) return;
  for (auto& [linked, weight] : links) weight = weights[linked];
  weights_[object] = std::move(links);
  if (notes_changes_) changed_.push_back(object);
}

}  // namespace soarbox::kernel
