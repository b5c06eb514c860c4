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

/// The distribution of an object's outgoing activation over its links (spreading-edge-updating): equal at first, and
/// more along links that working memory uses.
///
/// Uses are buffered until spreading reaches the object. Then they are applied, one decision cycle after the other.
/// Each use of a link adds (1 - weight) (1 - factor) to its weight. The other links, except in the first of these
/// cycles, are multiplied by factor^uses. Then the weights are scaled so that their sum is 1.
///
/// Weights are part of the knowledge, like links: they are kept when spreading is disabled, and are written to files.
/// Buffered uses are not.
class LinkWeights {
 public:
  using Weights = std::map<std::uint32_t, double>;  ///< By linked object.

  explicit LinkWeights(const SmemSettings& settings) : settings_(settings) {}

  /// Adds one use of a link of an object. Cycles must not decrease.
  void Use(const Knowledge& knowledge, std::uint32_t object, std::uint32_t linked, std::uint64_t cycle);
  /// The weights of an object's links, after applying its buffered uses; null if they are equal.
  const Weights* Of(const Knowledge& knowledge, std::uint32_t object);
  /// The weights without buffered uses; null if they are equal.
  const Weights* Known(std::uint32_t object) const {
    const auto known = weights_.find(object);
    return known == weights_.end() ? nullptr : &known->second;
  }
  /// The weight of each link, including links without a stored weight.
  Weights Effective(const Knowledge& knowledge, std::uint32_t object) const;
  static Weights Equal(const Knowledge& knowledge, std::uint32_t object);
  /// Sets the weights of an object's links. Returns false, and changes nothing, unless the object has exactly these
  /// links.
  bool Set(const Knowledge& knowledge, std::uint32_t object, Weights weights);
  /// The links of an object changed: resets their weights to equal ones.
  void Forget(std::uint32_t object) { weights_.erase(object); }
  void ForgetUses() { uses_.clear(); }
  void Clear() {
    uses_.clear();
    weights_.clear();
    changed_.clear();
  }
  /// Replaces everything by weights that were loaded from a file.
  void TakeOver(LinkWeights& loaded) {
    weights_ = std::move(loaded.weights_);
    uses_.clear();
    changed_.clear();
  }
  bool empty() const { return weights_.empty(); }
  /// Whether changes are recorded for TakeChanged.
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
