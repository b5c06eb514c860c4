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

/// How much of the activation that an object passes on goes to each object that it links to (spreading-edge-updating):
/// equal parts at first, and more along the links that working memory uses.
///
/// Uses wait until spreading reaches the object. Then they count, one decision cycle after the other: each use of a
/// link adds (1 - weight) (1 - factor) to it; the other links, except in the first of these cycles, keep factor^uses of
/// their weight; and the weights are scaled to sum to 1 again.
///
/// Weights belong to the knowledge, as links do: they stay when spreading is switched off, and files keep them. Waiting
/// uses are not kept.
class LinkWeights {
 public:
  using Weights = std::map<std::uint32_t, double>;  ///< By linked object.

  explicit LinkWeights(const SmemSettings& settings) : settings_(settings) {}

  /// Notes one use of a link of an object. Cycles only grow.
  void Use(const Knowledge& knowledge, std::uint32_t object, std::uint32_t linked, std::uint64_t cycle);
  /// The weights of an object's links, after its waiting uses have counted; null if they are equal.
  const Weights* Of(const Knowledge& knowledge, std::uint32_t object);
  /// The weights without waiting uses; null if they are equal.
  const Weights* Known(std::uint32_t object) const {
    const auto known = weights_.find(object);
    return known == weights_.end() ? nullptr : &known->second;
  }
  /// The same for each link, including links without a stored weight.
  Weights Effective(const Knowledge& knowledge, std::uint32_t object) const;
  static Weights Equal(const Knowledge& knowledge, std::uint32_t object);
  /// Sets the weights of an object's links. False, and no change, unless it has exactly these links.
  bool Set(const Knowledge& knowledge, std::uint32_t object, Weights weights);
  /// The links of an object changed: their weights become equal again.
  void Forget(std::uint32_t object) { weights_.erase(object); }
  void ForgetUses() { uses_.clear(); }
  void Clear() {
    uses_.clear();
    weights_.clear();
    changed_.clear();
  }
  /// Replaces everything by what was loaded from a file.
  void TakeOver(LinkWeights& loaded) {
    weights_ = std::move(loaded.weights_);
    uses_.clear();
    changed_.clear();
  }
  bool empty() const { return weights_.empty(); }
  /// Whether changes are noted for TakeChanged.
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
  std::unordered_map<std::uint32_t, std::vector<Uses>> uses_;  ///< Waiting uses by object, oldest first.
  std::unordered_map<std::uint32_t, Weights> weights_;
  bool notes_changes_ = false;
  std::vector<std::uint32_t> changed_;
};

}  // namespace soarbox::kernel
