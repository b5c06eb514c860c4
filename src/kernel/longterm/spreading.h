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

/// Activation that spreads from the contents of working memory. An object is a source if a working memory identifier
/// with elements is an instance of it. What it gives flows along augmentations, by their weights, and shrinks with each
/// step.
///
/// A source's reach depends on the graph alone: each object's part of what the source gives. It is computed when the
/// source comes, and stays until the source goes, whatever happens to the graph. If the graph has not changed when the
/// source returns, the reach is used again. As in Soar 9.6.3, activation spreads when a query has more than one
/// candidate, and only to its candidates: all others keep what they got last, as long as any source reaches them.
///
/// A source of strength x gives x / (1 + x), and no object gets less than the least, which is baseline / (p (1 +
/// p)^depth). What an object gets from all sources, t, adds ln(t) - ln(least) to its activation.
class Spreading {
 public:
  Spreading(const SmemSettings& settings, LinkWeights& weights) : settings_(settings), weights_(weights) {}

  /// The current sources: how strong each is, by object. Spread computes the effect.
  void SetSources(const Knowledge& knowledge, const std::map<std::uint32_t, double>& sources);
  /// What an object got: it adds `share` to the object's own activation, or to `unused` if it was never used.
  struct Gift {
    double share, unused;
  };
  /// Gives the candidates of a query their shares. `unused`: the current activation of objects that were never used.
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
  /// Null if nothing has spread to it.
  const Gift* GiftTo(std::uint32_t object) const {
    const auto share = shares_.find(object);
    return share == shares_.end() ? nullptr : &share->second;
  }
  /// Whatever has a share, by object.
  const std::map<std::uint32_t, Gift>& shares() const { return shares_; }
  /// How many objects the sources reach.
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
  std::unordered_map<std::uint32_t, Reach> reaches_;  ///< Those still valid, of current and former sources.
  std::map<std::uint32_t, Reach> active_;             ///< Of the current sources.
  std::map<std::uint32_t, double> known_;
  std::unordered_map<std::uint32_t, double> totals_;
  std::map<std::uint32_t, Gift> shares_;
  double least_ = 0;
};

}  // namespace soarbox::kernel
