// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <unordered_map>
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
class LinkWeights {
 public:
  using Weights = std::map<std::uint32_t, double>;  ///< By object that is linked to.

  explicit LinkWeights(const SmemSettings& settings) : settings_(settings) {}

  /// A link of an object was used, once. Cycles only grow.
  void Use(const Knowledge& knowledge, std::uint32_t object, std::uint32_t linked, std::uint64_t cycle);
  /// The weights of an object's links, once its uses have counted; null if they are equal.
  const Weights* Of(const Knowledge& knowledge, std::uint32_t object);
  /// The links of an object changed: they weigh the same again.
  void Forget(std::uint32_t object) { weights_.erase(object); }
  void Clear() {
    uses_.clear();
    weights_.clear();
  }
  std::size_t MemoryBytes() const;

 private:
  struct Uses {
    std::uint64_t cycle = 0;
    std::uint32_t linked = 0, count = 0;
  };
  void Count(const Knowledge& knowledge, std::uint32_t object, const std::vector<Uses>& uses);

  const SmemSettings& settings_;
  std::unordered_map<std::uint32_t, std::vector<Uses>> uses_;  ///< That wait, by object, oldest first.
  std::unordered_map<std::uint32_t, Weights> weights_;
};

}  // namespace soarbox::kernel
