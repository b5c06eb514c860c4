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

/// One augmentation of an object: ^attribute value. `row` counts augmentations in order of creation: among equally
/// active objects, the one with the youngest augmentation answers a query.
struct Edge {
  StoreTerm attribute, value;
  std::uint32_t row = 0;
};

/// An augmentation with the rank of its attribute in the order in which the store met them.
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

/// The members of an index, in the order of rows: those of shared knowledge that this agent has not removed, and its
/// own.
class MemberList {
 public:
  /// How many there are.
  std::size_t size() const { return inherited_.size() + own_.size() - hidden_count_; }
  bool empty() const { return size() == 0; }
  /// The slots of the list, some of which may be hidden: those are no longer members.
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
/// attribute to the objects that have it. The activation of objects is elsewhere (activations.h), so agents may share
/// one Knowledge as long as none of them changes it.
///
/// To change shared knowledge, put a layer over it: a Knowledge of its own that begins equal and holds only the
/// differences: added objects, copies of changed ones, and the new members of each index. It costs what was changed,
/// not what is known. The base of a layer is complete knowledge, never another layer.
///
/// Invariants: an object has an augmentation once; each augmentation is in both indices, in the order of rows; an
/// object's place never changes, and only Clear removes objects. What a layer adds has greater places and rows than
/// everything in its base.
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
  /// A new object with the lowest free number above those given out before.
  std::uint32_t AddNew();
  /// Moves the search for the next new number past the taken ones, once for everyone who will share this.
  void SkipTakenNumbers();
  Lti NumberAt(std::uint32_t place) const {
    return place >= first_place_ ? objects_[place - first_place_].number : base_->objects_[place].number;
  }
  std::span<const Edge> EdgesAt(std::uint32_t place) const {
    return place >= first_place_ ? objects_[place - first_place_].edges : InheritedEdgesAt(place);
  }
  /// The order in which an object's augmentations are shown and retrieved: by attribute; for one attribute, first the
  /// objects by number, then the constants. Attributes and constants are in the order in which the store met them.
  std::vector<Edge> OrderedEdgesAt(std::uint32_t place) const;
  /// The same, writing to `edges` and replacing its contents.
  void OrderEdgesAt(std::uint32_t place, std::vector<RankedEdge>& edges) const;
  bool Has(std::uint32_t place, StoreTerm attribute, StoreTerm value) const;
  bool Has(std::uint32_t place, StoreTerm attribute) const;
  /// False if it exists already.
  bool AddEdge(std::uint32_t place, StoreTerm attribute, StoreTerm value);
  /// False if it does not exist.
  bool RemoveEdge(std::uint32_t place, StoreTerm attribute, StoreTerm value);
  void Clear();
  /// The number at which the search for a new one begins.
  Lti next_number() const { return next_number_; }
  void set_next_number(Lti number) { next_number_ = number; }

  // Indices ---------------------------------------------------------------------------------------------------------

  /// The index of (attribute, value), or of an attribute with any value if `value` is none; kNowhere if nobody ever had
  /// it. Valid until something changes.
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

  /// The object with this name: (@steel ^name x).
  Lti FindAlias(std::string_view name) const;
  void SetAlias(std::string_view name, Lti number) { aliases_.insert_or_assign(std::string(name), number); }
  std::map<std::string, Lti, std::less<>> Aliases() const;

  /// Without the base.
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
  /// For changes: copies an object of the base first.
  std::vector<Edge>& OwnEdgesAt(std::uint32_t place);
  std::uint32_t OwnList(std::uint64_t key);
  void Enter(std::uint64_t key, Member member);
  void Leave(std::uint64_t key, std::uint32_t row);
  /// Whether a member of the base's lists is not one here.
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
