// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace soarbox::kernel {

/// For each alpha memory, its joins that feed sparse memories, so that a leaving element need not search all nodes of
/// the memory for them. AlphaState::sparse is their number.
class SparseFeeders {
 public:
  const std::vector<std::uint32_t>& Of(std::uint32_t alpha) const { return joins_[alpha]; }
  void Add(std::uint32_t alpha, std::uint32_t join) {
    if (joins_.size() <= alpha) joins_.resize(alpha + 1u);
    joins_[alpha].push_back(join);
  }
  void Remove(std::uint32_t alpha, std::uint32_t join) { std::erase(joins_[alpha], join); }

 private:
  std::vector<std::vector<std::uint32_t>> joins_;  ///< By alpha memory.
};

}  // namespace soarbox::kernel
