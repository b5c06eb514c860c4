// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <unordered_map>
#include <vector>

#include "kernel/longterm/knowledge.h"
#include "kernel/longterm/link_weights.h"
#include "kernel/longterm/smem_settings.h"

namespace soarbox::kernel {

/// Activation that spreads from the contents of working memory. An object is a source if an identifier in working
/// memory that has elements is an instance of it. Activation flows along augmentations according to their weights, and
/// decreases with each step.
///
/// The reach of a source is each object's share of the source's activation. It depends only on the graph. It is
/// computed when the source appears, and is kept until the source disappears, even if the graph changes. If the graph
/// has not changed when the source returns, the reach is reused. As in Soar 9.6.3, activation spreads when a query has
/// more than one candidate, and only to its candidates: all other objects keep their last value as long as any source
/// reaches them.
///
/// A source of strength x emits x / (1 + x). The minimum for an object is baseline / (p (1 + p)^depth). An object that
/// receives t from all sources gets ln(t) - ln(minimum) added to its activation.
class Spreading {
 public:
  Spreading(const SmemSettings& settings, LinkWeights& weights) : settings_(settings), weights_(weights) {}

  /// Sets the strengths of the current sources, by object. Spread computes the effect.
  void SetSources(const Knowledge& knowledge, const std::map<std::uint32_t, double>& sources);
  /// The effect on an object: `share` is added to the object's own activation, or to `unused` if it was never used.
  struct Gift {
    double share, unused;
  };
  /// Computes the shares of the candidates of a query. `unused`: the current activation of objects that were never
  /// used.
  template <class ForEachCandidate>
  void Spread(double unused, ForEachCandidate&& for_each) {
    std::erase_if(shares_, [&](const auto& share) { return !totals_.contains(share.first); });
    for_each([&](std::uint32_t object) {
      if (const auto total = totals_.find(object); total != totals_.end()) {
        shares_[object] = {std::log(total->second) - std::log(least_), unused};
      }
    });
  }
  /// The graph or its weights changed.
  void Forget() { reaches_.clear(); }
  /// Settings changed.
  void Renew() {
    reaches_.clear();
    active_.clear();
    known_.clear();
  }
  void Clear();
  bool Reaches(std::uint32_t object) const { return shares_.contains(object); }
  /// Returns null if nothing has spread to the object.
  const Gift* GiftTo(std::uint32_t object) const {
    const auto share = shares_.find(object);
    return share == shares_.end() ? nullptr : &share->second;
  }
  /// All objects with a share.
  const std::map<std::uint32_t, Gift>& shares() const { return shares_; }
  /// The number of objects that the sources reach.
  std::size_t size() const { return totals_.size(); }

 private:
  struct Share {
    std::uint32_t object;
    double share;
  };
  using Reach = std::shared_ptr<const std::vector<Share>>;
  Reach ReachOf(const Knowledge& knowledge, std::uint32_t source);

  const SmemSettings& settings_;
  LinkWeights& weights_;
  std::unordered_map<std::uint32_t, Reach> reaches_;  ///< The valid ones, of current and former sources.
  std::map<std::uint32_t, Reach> active_;             ///< Those of the current sources.
  std::map<std::uint32_t, double> known_;
  std::unordered_map<std::uint32_t, double> totals_;
  std::map<std::uint32_t, Gift> shares_;
  double least_ = 0;
};

}  // namespace soarbox::kernel
