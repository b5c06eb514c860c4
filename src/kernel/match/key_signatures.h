// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace soarbox::kernel {

/// For each memory or negative node, the identifiers that its tokens can join with, as a set of 64 hashes: an element
/// with another identifier joins with none of them. Used for nodes with several tokens that are linked to busy alpha
/// memories (OnlyIds is for those with one token). Empty while no alpha memory is busy.
///
/// Invariant: the set contains the hash of each token's identifier. It may contain more, because a token that leaves
/// does not remove its own.
class KeySignatures {
 public:
  using Set = std::uint64_t;

  static Set Of(std::uint32_t id) { return Set{1} << (id * 0x9E3779B1u >> 26); }

  bool empty() const { return sets_.empty(); }
  /// A token has entered a node, which now has `count` tokens.
  void Add(std::uint32_t node, std::uint32_t id, std::uint32_t count) {
    Set& set = sets_[node];
    set = (count == 1 ? 0 : set) | Of(id);
  }
  /// False if no token of the node waits for the identifier.
  bool MayHave(std::uint32_t node, std::uint32_t id) const { return (sets_[node] & Of(id)) != 0; }
  /// Returns true if the set has more hashes than the node has tokens, so that some of them belong to tokens that have
  /// left. Always false for nodes with so many tokens that computing the set again is not worthwhile.
  bool IsStale(std::uint32_t node, std::uint32_t count) const {
    constexpr std::uint32_t kMost = 32;
    return count <= kMost && static_cast<std::uint32_t>(std::popcount(sets_[node])) > count;
  }
  void Replace(std::uint32_t node, Set set) { sets_[node] = set; }
  /// Adds all hashes. They stay in the set until the node gets a first token again.
  void AddAll(std::uint32_t node) { sets_[node] = kAll; }

  /// Creates the sets for this number of nodes. Each set contains all hashes at first.
  void Begin(std::size_t nodes) { sets_.resize(nodes, kAll); }
  /// The number of nodes is now `nodes`.
  void MakeRoom(std::size_t nodes) {
    if (!sets_.empty() && sets_.size() < nodes) sets_.resize(nodes + nodes / 2, kAll);
  }

 private:
  static constexpr Set kAll = std::numeric_limits<Set>::max();

  std::vector<Set> sets_;
};

}  // namespace soarbox::kernel
