// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/longterm/flat_map.h"
#include "kernel/longterm/store_term.h"

namespace soarbox::kernel {

/// One augmentation of an object: ^attribute value. `row` is a running number of augmentations: among objects with
/// equal activation, the one with the newest augmentation is the result of a query.
struct Edge {
  StoreTerm attribute, value;
  std::uint32_t row = 0;
};

/// An augmentation with the rank of its attribute, in order of first use in the store.
struct RankedEdge {
  std::uint32_t rank = 0;
  Edge edge;
};

/// An augmentation as an entry of an index.
struct Member {
  std::uint32_t row = 0;
  std::uint32_t object = 0;  ///< Place of the object.
};

class Knowledge;

/// The members of an index, sorted by row: those of shared knowledge that this agent has not removed, and its own.
class MemberList {
 public:
  /// The number of members.
  std::size_t size() const { return inherited_.size() + own_.size() - hidden_count_; }
  bool empty() const { return size() == 0; }
  /// The number of slots of the list. Some may be hidden: they are no longer members.
  std::size_t slots() const { return inherited_.size() + own_.size(); }
  const Member& At(std::size_t slot) const {
    return slot < inherited_.size() ? inherited_[slot] : own_[slot - inherited_.size()];
  }
  bool IsHidden(std::size_t slot) const;
  /// The first slot whose row is at least `row`, or slots().
  std::size_t FirstNotBefore(std::uint32_t row) const;
  template <class Function>
  void ForEach(const Function& function) const {
    for (std::size_t slot = 0; slot < slots(); ++slot) {
      if (!IsHidden(slot)) function(At(slot));
    }
  }

 private:
  friend class Knowledge;
  MemberList(std::span<const Member> inherited, std::span<const Member> own, std::size_t hidden, const Knowledge& owner)
      : inherited_(inherited), own_(own), hidden_count_(hidden), owner_(owner) {}
  std::span<const Member> inherited_, own_;
  std::size_t hidden_count_;
  const Knowledge& owner_;
};

/// The contents of semantic memory: objects with numbers, and their augmentations; indices from (attribute, value) and
/// from attribute to objects. The activation of objects is stored elsewhere (activations.h), so that agents may share a
/// Knowledge as long as none of them changes it.
///
/// Shared knowledge is changed by a layer over it: a Knowledge that starts equal and stores only the differences: added
/// objects, copies of changed ones, and new members of indices. Its cost depends on the changes, not on the total size.
/// The base of a layer is complete knowledge, never another layer.
///
/// Invariants: an object has each augmentation once. Each augmentation is in both indices, which are sorted by row. An
/// object's place never changes; only Clear removes objects. Places and rows of a layer are greater than all those of
/// its base.
class Knowledge {
 public:
  static constexpr std::uint32_t kNowhere = FlatMap::kNone;

  Knowledge() = default;
  /// A layer over `base`, which must not change from now on.
  explicit Knowledge(std::shared_ptr<const Knowledge> base);

  bool is_layer() const { return base_ != nullptr; }

  // Objects ---------------------------------------------------------------------------------------------------------

  std::uint32_t object_count() const { return first_place_ + static_cast<std::uint32_t>(objects_.size()); }
  std::uint64_t edge_count() const { return edge_count_; }
  /// The place of an object, or kNowhere.
  std::uint32_t Find(Lti number) const {
    const std::uint32_t own = by_number_.Find(number);
    return own != kNowhere || base_ == nullptr ? own : base_->by_number_.Find(number);
  }
  std::uint32_t FindOrAdd(Lti number);
  /// Adds an object with the lowest free number above those assigned before.
  std::uint32_t AddNew();
  /// Moves the search for the next free number past the used ones, once for all agents that will share this.
  void SkipTakenNumbers();
  Lti NumberAt(std::uint32_t place) const {
    return place >= first_place_ ? objects_[place - first_place_].number : base_->objects_[place].number;
  }
  std::span<const Edge> EdgesAt(std::uint32_t place) const {
    return place >= first_place_ ? objects_[place - first_place_].edges : InheritedEdgesAt(place);
  }
  /// The order in which augmentations are shown and retrieved: sorted by attribute; within one attribute, first objects
  /// by number, then constants. Attributes and constants are in order of their first use in the store.
  std::vector<Edge> OrderedEdgesAt(std::uint32_t place) const;
  /// Like OrderedEdgesAt, but replaces the contents of `edges`.
  void OrderEdgesAt(std::uint32_t place, std::vector<RankedEdge>& edges) const;
  bool Has(std::uint32_t place, StoreTerm attribute, StoreTerm value) const;
  bool Has(std::uint32_t place, StoreTerm attribute) const;
  /// Returns false if it exists already.
  bool AddEdge(std::uint32_t place, StoreTerm attribute, StoreTerm value);
  /// Returns false if it does not exist.
  bool RemoveEdge(std::uint32_t place, StoreTerm attribute, StoreTerm value);
  void Clear();
  /// The number at which the search for a free one begins.
  Lti next_number() const { return next_number_; }
  void set_next_number(Lti number) { next_number_ = number; }

  // Indices ---------------------------------------------------------------------------------------------------------

  /// The index of (attribute, value), or of an attribute with any value if `value` is none; kNowhere if it was never
  /// used. Valid until the next change.
  std::uint32_t FindList(StoreTerm attribute, StoreTerm value) const {
    const std::uint64_t key = Key(attribute, value);
    const std::uint32_t own = lists_by_key_.Find(key);
    if (own != kNowhere || base_ == nullptr) return own;
    const std::uint32_t inherited = base_->lists_by_key_.Find(key);
    return inherited == kNowhere ? kNowhere : inherited | kInherited;
  }
  /// Oldest row first. An object with several values of the attribute appears several times in the attribute's list.
  MemberList ListAt(std::uint32_t list) const;

  Terms& terms() { return terms_; }
  const Terms& terms() const { return terms_; }

  /// The number of the object with this alias, as in (@steel ^name x); 0 if there is none.
  Lti FindAlias(std::string_view name) const;
  void SetAlias(std::string_view name, Lti number) { aliases_.insert_or_assign(std::string(name), number); }
  std::map<std::string, Lti, std::less<>> Aliases() const;

  /// Without the base.
  std::size_t MemoryBytes() const;
  /// Returns a description of the first violated invariant, or an empty text.
  std::string CheckInvariants() const;

 private:
  friend class MemberList;
  static constexpr std::uint32_t kInherited = 0x80000000u;  ///< For a list that only the base has.

  struct Object {
    Lti number = 0;
    std::vector<Edge> edges;
  };
  /// For a list of a layer: the base's list that it continues, or kNowhere, and the number of its hidden members.
  struct Continued {
    std::uint32_t list = kNowhere;
    std::uint32_t hidden = 0;
  };
  static std::uint64_t Key(StoreTerm attribute, StoreTerm value) {
    return (static_cast<std::uint64_t>(attribute.bits()) << 32) | value.bits();
  }
  std::span<const Edge> InheritedEdgesAt(std::uint32_t place) const;
  /// For changes: copies an object of the base first.
  std::vector<Edge>& OwnEdgesAt(std::uint32_t place);
  std::uint32_t OwnList(std::uint64_t key);
  void Enter(std::uint64_t key, Member member);
  void Leave(std::uint64_t key, std::uint32_t row);
  /// Whether a member of a list of the base was removed here.
  bool Hides(const Member& member) const;

  std::shared_ptr<const Knowledge> base_;
  Terms terms_;
  std::uint32_t first_place_ = 0;  ///< The place of the first object in objects_; smaller places belong to the base.
  std::uint32_t first_row_ = 1;
  std::vector<Object> objects_;
  FlatMap by_number_;
  FlatMap lists_by_key_;
  std::vector<std::vector<Member>> lists_;
  std::vector<Continued> continued_;  ///< For a layer: parallel to lists_.
  FlatMap changed_;                   ///< For a layer: 1 + place of an object of the base -> index in changed_edges_.
  std::vector<std::vector<Edge>> changed_edges_;
  std::map<std::string, Lti, std::less<>> aliases_;
  std::uint64_t edge_count_ = 0;
  std::uint32_t next_row_ = 1;
  Lti next_number_ = 1;
};

inline bool MemberList::IsHidden(std::size_t slot) const {
  return hidden_count_ != 0 && slot < inherited_.size() && owner_.Hides(inherited_[slot]);
}

}  // namespace soarbox::kernel
