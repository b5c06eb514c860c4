// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "world/entity_ids.h"
#include "world/math.h"

namespace soarbox::sim {

struct Waypoint {
  std::string name;
  world::Vec3 position;
};

/// An area on the ground: a disc, or an axis-aligned rectangle if half_x_m is greater than 0.
struct Region {
  std::string name;
  world::Vec3 center;
  float radius_m = 0;
  float half_x_m = 0, half_z_m = 0;

  bool Contains(world::Vec3 point) const {
    const world::Vec3 offset = point - center;
    if (half_x_m > 0) return std::abs(offset.x) <= half_x_m && std::abs(offset.z) <= half_z_m;
    return offset.x * offset.x + offset.z * offset.z <= radius_m * radius_m;
  }
};

/// A thing that agents can pick up.
struct Item {
  world::EntityId object;
  std::string gives;  ///< "ammunition", "health" or empty: a thing that can only be carried.
  float amount = 0;
  // Its appearance, for when it is put down again.
  std::string shape = "box", material;
  world::Vec3 size{0.4f, 0.4f, 0.4f};
  float mass_kg = 0;

  float HalfWidth_m() const { return std::max(size.x, size.z) / 2; }
};

/// The named places and things of a world, in the order of the scenario.
struct Places {
  std::vector<Waypoint> waypoints;
  std::vector<Region> regions;
  std::map<world::EntityId, std::string> object_names;
  std::map<world::EntityId, Item> items;

  const Waypoint* FindWaypoint(std::string_view name) const {
    const auto at = std::find_if(waypoints.begin(), waypoints.end(), [&](const Waypoint& w) { return w.name == name; });
    return at == waypoints.end() ? nullptr : &*at;
  }
  const Region* FindRegion(std::string_view name) const {
    const auto at = std::find_if(regions.begin(), regions.end(), [&](const Region& r) { return r.name == name; });
    return at == regions.end() ? nullptr : &*at;
  }
};

}  // namespace soarbox::sim
