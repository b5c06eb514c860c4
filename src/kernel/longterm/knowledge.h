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
#include "kernel/longterm/terms.h"

namespace soarbox::kernel {

/// One augmentation of an object: ^attribute value. `row` counts augmentations in the order in which they were made:
/// of equally active objects the one whose augmentation is youngest answers a query.
struct Edge {
  StoreTerm attribute, value;
  std::uint32_t row = 0;
};

/// An augmentation with the place of its attribute in the order in which the store met them.
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

/// The members of an index, in the order of rows: those of shared knowledge, less those that this agent took away, and
/// those of its own.
class MemberList {
 public:
  /// How many there are.
  std::size_t size() const { return inherited_.size() + own_.size() - hidden_count_; }
  bool empty() const { return size() == 0; }
  /// The places of the list, of which some may be hidden: they are no members any more.
  std::size_t slots() const { return inherited_.size() + own_.size(); }
  const Member& At(std::size_t slot) const {
    return slot < inherited_.size() ? inherited_[slot] : own_[slot - inherited_.size()];
  }
  bool IsHidden(std::size_t slot) const;
  /// The first slot whose row is not below `row`, or slots().
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

/// What semantic memory knows: objects with numbers, and their augmentations; indices from (attribute, value) and from
/// attribute to the objects that have it. How active objects are is known elsewhere (activations.h), so agents may
/// share one Knowledge as long as none of them changes it.
///
/// Who wants to change shared knowledge puts a layer over it, a Knowledge of its own that begins equal and holds only
/// what differs: objects that were added, copies of those that were changed, and of each index the members that came.
/// It costs what was changed, not what is known. A layer stands on whole knowledge, never on another layer.
///
/// Invariants: an object has an augmentation once; each augmentation stands in both indices, in the order of rows;
/// an object's place never changes and none is ever removed but by Clear. What a layer adds has greater places and
/// rows than all that it stands on.
class Knowledge {
 public:
  static constexpr std::uint32_t kNowhere = FlatMap::kNone;

  Knowledge() = default;
  /// A layer over `base`, which never changes from now on.
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
  /// A new object with the lowest number that is free and above those given out before.
  std::uint32_t AddNew();
  /// Moves the search for the next new number behind those that are taken, once for all who will share this.
  void SkipTakenNumbers();
  Lti NumberAt(std::uint32_t place) const {
    return place >= first_place_ ? objects_[place - first_place_].number : base_->objects_[place].number;
  }
  std::span<const Edge> EdgesAt(std::uint32_t place) const {
    return place >= first_place_ ? objects_[place - first_place_].edges : InheritedEdgesAt(place);
  }
  /// The order in which an object's augmentations are shown and retrieved: by attribute, and of one attribute first
  /// the objects by number, then the constants; attributes and constants in the order in which the store met them.
  std::vector<Edge> OrderedEdgesAt(std::uint32_t place) const;
  /// The same, in `edges` instead of what is there.
  void OrderEdgesAt(std::uint32_t place, std::vector<RankedEdge>& edges) const;
  bool Has(std::uint32_t place, StoreTerm attribute, StoreTerm value) const;
  bool Has(std::uint32_t place, StoreTerm attribute) const;
  /// False if it is there already.
  bool AddEdge(std::uint32_t place, StoreTerm attribute, StoreTerm value);
  /// False if there is none.
  bool RemoveEdge(std::uint32_t place, StoreTerm attribute, StoreTerm value);
  void Clear();
  /// The number at which the search for a new one begins.
  Lti next_number() const { return next_number_; }
  void set_next_number(Lti number) { next_number_ = number; }

  // Indices ---------------------------------------------------------------------------------------------------------

  /// The index of (attribute, value), or of an attribute with any value if `value` is none; kNowhere if nobody ever had
  /// it. It holds until something changes.
  std::uint32_t FindList(StoreTerm attribute, StoreTerm value) const {
    const std::uint64_t key = Key(attribute, value);
    const std::uint32_t own = lists_by_key_.Find(key);
    if (own != kNowhere || base_ == nullptr) return own;
    const std::uint32_t inherited = base_->lists_by_key_.Find(key);
    return inherited == kNowhere ? kNowhere : inherited | kInherited;
  }
  /// Oldest row first. Of an attribute an object with several values stands here several times.
  MemberList ListAt(std::uint32_t list) const;

  Terms& terms() { return terms_; }
  const Terms& terms() const { return terms_; }

  /// Names given to objects: (@steel ^name x).
  Lti FindAlias(std::string_view name) const;
  void SetAlias(std::string_view name, Lti number) { aliases_.insert_or_assign(std::string(name), number); }
  std::map<std::string, Lti, std::less<>> Aliases() const;

  /// Without what it stands on.
  std::size_t MemoryBytes() const;
  /// The first violation of the class's invariants in words, or empty.
  std::string CheckInvariants() const;

 private:
  friend class MemberList;
  static constexpr std::uint32_t kInherited = 0x80000000u;  ///< Of a list that only the base has.

  struct Object {
    Lti number = 0;
    std::vector<Edge> edges;
  };
  /// Of a list of a layer: the list of the base that it continues, or kNowhere, and how many of that are hidden.
  struct Continued {
    std::uint32_t list = kNowhere;
    std::uint32_t hidden = 0;
  };
  static std::uint64_t Key(StoreTerm attribute, StoreTerm value) {
    return (static_cast<std::uint64_t>(attribute.bits()) << 32) | value.bits();
  }
  std::span<const Edge> InheritedEdgesAt(std::uint32_t place) const;
  /// To be changed: of an object of the base, a copy.
  std::vector<Edge>& OwnEdgesAt(std::uint32_t place);
  std::uint32_t OwnList(std::uint64_t key);
  void Enter(std::uint64_t key, Member member);
  void Leave(std::uint64_t key, std::uint32_t row);
  /// Whether a member of the base's lists is none here.
  bool Hides(const Member& member) const;

  std::shared_ptr<const Knowledge> base_;
  Terms terms_;
  std::uint32_t first_place_ = 0;  ///< Of objects_; those before are the base's.
  std::uint32_t first_row_ = 1;
  std::vector<Object> objects_;
  FlatMap by_number_;
  FlatMap lists_by_key_;
  std::vector<std::vector<Member>> lists_;
  std::vector<Continued> continued_;  ///< Of a layer: for each of lists_.
  FlatMap changed_;                   ///< Of a layer: place + 1 of an object of the base -> changed_edges_.
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
