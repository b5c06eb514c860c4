// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace soarbox::kernel {

/// A union-find structure of identities. Identities are in one set if the fields that they belong to must have the same
/// value. A set is literal if a rule mentions its value as a constant. An identity is a key, not an object: the number
/// of a firing and a class of fields of its rule. Used for the analysis of one result.
class IdentityGraph {
 public:
  using Node = std::uint32_t;
  static constexpr Node kNone = 0xFFFFFFFFu;

  struct Key {
    std::uint32_t firing = 0, place = 0;
    friend bool operator==(const Key&, const Key&) = default;
  };

  void Clear();
  Node Of(Key key);
  /// The representative of the node's set.
  Node Root(Node node) const;
  /// Merges two sets. The representative of the larger set is kept; that of `b` if they have the same size.
  void Join(Node a, Node b);
  void Literalize(Node node) { records_[Root(node)].literal = true; }
  bool literal(Node node) const { return records_[Root(node)].literal; }
  const Key& key(Node node) const { return records_[node].key; }
  std::uint32_t size() const { return static_cast<std::uint32_t>(records_.size()); }
  std::uint32_t joins() const { return joins_; }

 private:
  struct Record {
    Key key;
    Node parent = kNone;
    std::uint32_t size = 1;
    bool literal = false;
  };
  std::uint32_t Slot(const Key& key) const;

  mutable std::vector<Record> records_;  ///< Lookups shorten paths, thus mutable.
  std::vector<Node> slots_;              ///< A hash table whose size is a power of two.
  std::uint32_t joins_ = 0;
};

}  // namespace soarbox::kernel
