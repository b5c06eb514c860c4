// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "sim/actor.h"
#include "sim/directions.h"

namespace soarbox::sim {

/// Selects the contacts that an actor's senses report: all, or only the nearest friends and the nearest enemies
/// (SenseSettings::most). At equal distances, the lower id comes first.
class Attention {
 public:
  explicit Attention(const Actor& actor) : actor_(actor) {
    const auto most = static_cast<std::size_t>(actor.kind().senses.most);
    if (most == 0 || actor.contacts().size() <= most) return;
    for (const bool is_friend : {false, true}) {
      std::vector<Place> places;
      places.reserve(actor.contacts().size());
      for (const auto& [id, contact] : actor.contacts())
        if (IsFriend(id) == is_friend) places.push_back(PlaceOf(id, contact));
      if (places.size() <= most) continue;
      std::nth_element(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(most - 1), places.end());
      (is_friend ? farthest_friend_ : farthest_enemy_) = places[most - 1];
    }
  }
  bool Reaches(world::EntityId id, const Contact& contact) const {
    if (!farthest_friend_ && !farthest_enemy_) return true;
    const std::optional<Place>& farthest = IsFriend(id) ? farthest_friend_ : farthest_enemy_;
    return !farthest || PlaceOf(id, contact) <= *farthest;
  }

 private:
  using Place = std::pair<float, std::uint32_t>;
  Place PlaceOf(world::EntityId id, const Contact& contact) const {
    return {world::LengthSquared(Flat(contact.position - actor_.body().Position())), Number(id)};
  }
  bool IsFriend(world::EntityId id) const { return actor_.world().FindAgent(id)->Team() == actor_.body().Team(); }

  const Actor& actor_;
  std::optional<Place> farthest_friend_, farthest_enemy_;
};

}  // namespace soarbox::sim
