// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

#include "kernel/longterm/knowledge.h"
#include "kernel/longterm/smem_settings.h"

namespace soarbox::kernel {

/// How much of the activation that an object passes on goes to each object that it is linked to
/// (spreading-edge-updating): equal parts at first, and more along the links that working memory uses.
///
/// Uses wait until spreading looks at the object. Then those of one decision cycle after the other count: each use of a
/// link adds (1 - weight) (1 - factor) to it; the other links, but in the first of these cycles, keep factor^uses of
/// theirs; and the weights are made to sum to 1 again.
///
/// Weights belong to what is known, as links do: they stay when spreading is switched off, and files keep them. Uses
/// that wait do not.
class LinkWeights {
 public:
  using Weights = std::map<std::uint32_t, double>;  ///< By object that is linked to.

  explicit LinkWeights(const SmemSettings& settings) : settings_(settings) {}

  /// A link of an object was used, once. Cycles only grow.
  void Use(const Knowledge& knowledge, std::uint32_t object, std::uint32_t linked, std::uint64_t cycle);
  /// The weights of an object's links, once its uses have counted; null if they are equal.
  const Weights* Of(const Knowledge& knowledge, std::uint32_t object);
  /// The weights without what waits; null if they are equal.
  const Weights* Known(std::uint32_t object) const {
    const auto known = weights_.find(object);
    return known == weights_.end() ? nullptr : &known->second;
  }
  /// The same for each link, whether it is known or not.
  Weights Effective(const Knowledge& knowledge, std::uint32_t object) const;
  static Weights Equal(const Knowledge& knowledge, std::uint32_t object);
  /// Gives the links of an object their weights. False, and nothing happens, unless it has these links and no others.
  bool Set(const Knowledge& knowledge, std::uint32_t object, Weights weights);
  /// The links of an object changed: they weigh the same again.
  void Forget(std::uint32_t object) { weights_.erase(object); }
  void ForgetUses() { uses_.clear(); }
  void Clear() {
    uses_.clear();
    weights_.clear();
    changed_.clear();
  }
  /// Takes over what a file holds.
  void TakeOver(LinkWeights& loaded) {
    weights_ = std::move(loaded.weights_);
    uses_.clear();
    changed_.clear();
  }
  bool empty() const { return weights_.empty(); }
  /// Whether somebody will ask for TakeChanged.
  void NoteChanges(bool on) {
    notes_changes_ = on;
    changed_.clear();
  }
  /// Objects whose weights changed since the last call, in order.
  std::vector<std::uint32_t> TakeChanged() { return std::exchange(changed_, {}); }

 private:
  struct Uses {
    std::uint64_t cycle = 0;
    std::uint32_t linked = 0, count = 0;
  };
  void Count(const Knowledge& knowledge, std::uint32_t object, const std::vector<Uses>& uses);

  const SmemSettings& settings_;
  std::unordered_map<std::uint32_t, std::vector<Uses>> uses_;  ///< That wait, by object, oldest first.
  std::unordered_map<std::uint32_t, Weights> weights_;
  bool notes_changes_ = false;
  std::vector<std::uint32_t> changed_;
};

}  // namespace soarbox::kernel
