// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/longterm/flat_map.h"
#include "kernel/longterm/terms.h"

namespace soarbox::kernel {

/// One augmentation of an object: ^attribute value. `row` counts augmentations in the order in which they were made:
/// of equally active objects the one whose augmentation is youngest answers a query.
struct Edge {
  StoreTerm attribute, value;
  std::uint32_t row = 0;
};

/// An augmentation as an entry of an index.
struct Member {
  std::uint32_t row = 0;
  std::uint32_t object = 0;  ///< Place of the object.
};

/// What semantic memory knows: objects with numbers, and their augmentations; indices from (attribute, value) and from
/// attribute to the objects that have it. How active objects are is known elsewhere (activations.h), so agents may
/// share one Knowledge as long as none of them changes it.
///
/// Invariants: an object has an augmentation once; each augmentation stands in both indices, in the order of rows;
/// an object's place never changes and none is ever removed but by Clear.
class Knowledge {
 public:
  static constexpr std::uint32_t kNowhere = FlatMap::kNone;

  // Objects ---------------------------------------------------------------------------------------------------------

  std::uint32_t object_count() const { return static_cast<std::uint32_t>(objects_.size()); }
  std::uint64_t edge_count() const { return edge_count_; }
  /// The place of an object, or kNowhere.
  std::uint32_t Find(Lti number) const { return by_number_.Find(number); }
  std::uint32_t FindOrAdd(Lti number);
  /// A new object with the lowest number that is free and above those given out before.
  std::uint32_t AddNew();
  Lti NumberAt(std::uint32_t place) const { return objects_[place].number; }
  std::span<const Edge> EdgesAt(std::uint32_t place) const { return objects_[place].edges; }
  bool Has(std::uint32_t place, StoreTerm attribute, StoreTerm value) const;
  bool Has(std::uint32_t place, StoreTerm attribute) const;
  /// False if it is there already.
  bool AddEdge(std::uint32_t place, StoreTerm attribute, StoreTerm value);
  /// False if there is none.
  bool RemoveEdge(std::uint32_t place, StoreTerm attribute, StoreTerm value);
  void RemoveEdges(std::uint32_t place);
  void Clear();
  /// The same once more, for one who wants to change it.
  Knowledge Copy() const;
  /// The number at which the search for a new one begins.
  Lti next_number() const { return next_number_; }
  void set_next_number(Lti number) { next_number_ = number; }

  // Indices ---------------------------------------------------------------------------------------------------------

  /// The index of (attribute, value), or of an attribute with any value if `value` is none; kNowhere if nobody has it.
  std::uint32_t FindList(StoreTerm attribute, StoreTerm value) const {
    return lists_by_key_.Find(Key(attribute, value));
  }
  /// Oldest row first. Of an attribute an object with several values stands here several times.
  std::span<const Member> ListAt(std::uint32_t list) const { return lists_[list]; }
  std::uint32_t list_count() const { return static_cast<std::uint32_t>(lists_.size()); }

  Terms& terms() { return terms_; }
  const Terms& terms() const { return terms_; }

  /// Names given to objects: (@steel ^name x).
  Lti FindAlias(std::string_view name) const;
  void SetAlias(std::string_view name, Lti number) { aliases_.insert_or_assign(std::string(name), number); }
  const std::map<std::string, Lti, std::less<>>& aliases() const { return aliases_; }

  std::size_t MemoryBytes() const;
  /// The first violation of the class's invariants in words, or empty.
  std::string CheckInvariants() const;

 private:
  struct Object {
    Lti number = 0;
    std::vector<Edge> edges;
  };
  static std::uint64_t Key(StoreTerm attribute, StoreTerm value) {
    return (static_cast<std::uint64_t>(attribute.bits()) << 32) | value.bits();
  }
  void Enter(std::uint64_t key, Member member);
  void Leave(std::uint64_t key, std::uint32_t row);

  Terms terms_;
  std::vector<Object> objects_;
  FlatMap by_number_;
  FlatMap lists_by_key_;
  std::vector<std::vector<Member>> lists_;
  std::map<std::string, Lti, std::less<>> aliases_;
  std::uint64_t edge_count_ = 0;
  std::uint32_t next_row_ = 1;
  Lti next_number_ = 1;
};

}  // namespace soarbox::kernel
