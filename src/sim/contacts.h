// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "world/entity_ids.h"
#include "world/math.h"

namespace soarbox::sim {

/// What an actor knows about another agent.
struct Contact {
  world::EntityId agent = world::kNoEntity;
  enum class Source : std::uint8_t { kSight, kHearing, kMemory } source = Source::kSight;
  bool visible = false;
  std::uint64_t noticed_tick = 0;
  world::Vec3 position;  ///< With the noise of the senses.
  world::Vec3 velocity;
  world::Vec3 forward{0, 0, 1};
  bool alive = true;
};

/// The contacts of an actor, sorted by id. A sorted vector, because every actor reads its contacts in each tick.
/// Inserting and erasing invalidate iterators and references.
class Contacts {
 public:
  using Entry = std::pair<world::EntityId, Contact>;
  using iterator = std::vector<Entry>::iterator;
  using const_iterator = std::vector<Entry>::const_iterator;

  iterator begin() { return entries_.begin(); }
  iterator end() { return entries_.end(); }
  const_iterator begin() const { return entries_.begin(); }
  const_iterator end() const { return entries_.end(); }
  std::size_t size() const { return entries_.size(); }

  iterator find(world::EntityId id) {
    const iterator at = Place(id);
    return at != end() && at->first == id ? at : end();
  }
  const_iterator find(world::EntityId id) const { return const_cast<Contacts*>(this)->find(id); }
  /// Inserts a contact if there is none.
  Contact& operator[](world::EntityId id) {
    const iterator at = Place(id);
    return at != end() && at->first == id ? at->second : entries_.insert(at, {id, Contact{}})->second;
  }
  // Access by index.
  Entry& At(std::size_t place) { return entries_[place]; }
  /// `place`: the index at which the id must be inserted.
  Entry& Insert(std::size_t place, world::EntityId id) {
    Contact contact;
    contact.agent = id;
    return *entries_.insert(entries_.begin() + static_cast<std::ptrdiff_t>(place), {id, contact});
  }
  void Erase(std::size_t place) { entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(place)); }

 private:
  iterator Place(world::EntityId id) {
    return std::lower_bound(entries_.begin(), entries_.end(), id,
                            [](const Entry& entry, world::EntityId wanted) { return entry.first < wanted; });
  }

  std::vector<Entry> entries_;
};

}  // namespace soarbox::sim
