// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <unordered_map>
#include <vector>

#include "kernel/longterm/knowledge.h"
#include "kernel/longterm/link_weights.h"
#include "kernel/longterm/smem_settings.h"

namespace soarbox::kernel {

/// Activation that spreads from what is in working memory: an object that a working memory identifier is an instance
/// of, and that identifier has elements, is a source. What it gives flows along augmentations, by their weights, and
/// grows less with each step.
///
/// A source's reach depends on the graph alone and is kept until the graph changes: an object's part of all that the
/// source gives. A source of strength x gives x / (1 + x), and no object less than the least, which is
/// baseline / (p (1 + p)^depth). What an object gets of all sources, t, adds ln(t) - ln(least) to its activation.
class Spreading {
 public:
  Spreading(const SmemSettings& settings, LinkWeights& weights) : settings_(settings), weights_(weights) {}

  /// The sources of now: how strong each is, by object. Order does not matter.
  void SetSources(const Knowledge& knowledge, const std::map<std::uint32_t, double>& sources);
  /// The graph or its weights changed.
  void Forget() {
    reaches_.clear();
    known_.clear();
  }
  void Clear();
  bool Reaches(std::uint32_t object) const { return totals_.contains(object); }
  double ShareOf(std::uint32_t object) const;
  /// Whatever gets a share, in ascending order.
  std::span<const std::uint32_t> Recipients() const { return recipients_; }
  std::size_t size() const { return recipients_.size(); }

 private:
  struct Share {
    std::uint32_t object;
    double share;
  };
  const std::vector<Share>& ReachOf(const Knowledge& knowledge, std::uint32_t source);

  const SmemSettings& settings_;
  LinkWeights& weights_;
  std::unordered_map<std::uint32_t, std::vector<Share>> reaches_;
  std::map<std::uint32_t, double> known_;
  std::unordered_map<std::uint32_t, double> totals_;
  std::vector<std::uint32_t> recipients_;
  double least_ = 0;
};

}  // namespace soarbox::kernel
