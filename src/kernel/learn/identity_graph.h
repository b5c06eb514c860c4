// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace soarbox::kernel {

/// Which places of the rules behind a result have the same value of necessity, and which have a value that some rule
/// names literally. An identity is a name, not an object: the number of a firing and a class of fields of its rule.
/// Lives for the analysis of one result.
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
  /// The node that stands for the whole set.
  Node Root(Node node) const;
  /// The name of the larger set stays; that of `b` if they are equally large.
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

  mutable std::vector<Record> records_;  ///< Paths are shortened by looking.
  std::vector<Node> slots_;              ///< By hash; a power of two.
  std::uint32_t joins_ = 0;
};

}  // namespace soarbox::kernel
