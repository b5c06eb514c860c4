// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "world/math.h"
#include "world/scene_snapshot.h"

namespace soarbox::world {

/// What a viewer wants to know for its overlays; what costs little is always included.
struct OverlayWants {
  bool navigation = false, influence = false, physics = false;
  bool forces = false;
  friend bool operator==(const OverlayWants&, const OverlayWants&) = default;
};

/// Where an agent believes another one to be.
struct ContactSnapshot {
  std::uint32_t agent_id = 0;
  Vec3 position;
  Vec3 forward{0, 0, 1};
  double age_s = 0;      ///< Since it was last noticed.
  double memory_s = 15;  ///< It is forgotten after this long.
  bool visible = false;  ///< In view now.
  bool heard = false;    ///< Known by hearing.
  bool alive = true;     ///< As far as it knows.
};

/// What an agent perceives, wants and says: what overlays draw and a scene does not show.
struct AgentOverlay {
  std::uint32_t id = 0;
  std::string operator_name;  ///< Of its mind, then of its substates. Empty: none, or not reported.
  std::string doing;          ///< The command under way, "move-to"; empty: none.
  bool has_senses = false;
  float sight_m = 0, view_deg = 360, hearing_m = 0;
  Vec3 eyes;
  std::optional<Vec3> measured;  ///< The place to which it perceives the distance, but not the direction.
  std::vector<Vec3> path;        ///< Corners still to pass, in order; empty: none planned.
  bool path_is_whole = false;    ///< The path is all of it, those already passed included.
  std::optional<Vec3> goal;      ///< The place that it goes to or aims at.
  std::uint32_t target_id = 0;   ///< The agent that it has in mind; 0: none.
  std::uint32_t leader_id = 0;   ///< The agent that it follows; 0: none.
  std::vector<ContactSnapshot> contacts;
};

/// A shot of the last moments.
struct ShotSnapshot {
  Vec3 from, to;
  std::uint32_t shooter_id = 0;
  std::uint32_t hit_agent_id = 0;  ///< 0: no agent.
  double age_s = 0;
};

/// Something that an agent said in the last moments.
struct SpeechSnapshot {
  std::uint32_t from_id = 0;
  std::uint32_t to_id = 0;  ///< 0: the whole team.
  std::string text;         ///< "contact: target red-1, x 3.5"
  double age_s = 0;
};

/// A push that a script or a command of the vocabulary gave a body for the last step.
struct PushSnapshot {
  std::uint32_t owner_id = 0;  ///< The agent or object.
  Vec3 position;               ///< Of the body's middle now.
  Vec3 force_n;                ///< For one step; of a change of velocity the force that would have made it.
  float mass_kg = 1;
  Vec3 spin_rad_s{};  ///< How an angular impulse changed its spin, about the axis by the right-hand rule.
};

/// A named part of the world that is not an agent.
struct PlaceSnapshot {
  enum class Kind : std::uint8_t { kWaypoint, kRegion, kItem, kThing } kind = Kind::kWaypoint;
  std::string name;
  Vec3 position;  ///< On the ground; of items and things the top.
};

/// Everything that overlays need besides the scene, at the end of one tick. Recordings do not hold it.
struct OverlaySnapshot {
  std::uint64_t tick = 0;
  std::vector<AgentOverlay> agents;  ///< In ascending id.
  std::vector<ShotSnapshot> shots;
  std::vector<SpeechSnapshot> speech;
  std::vector<PlaceSnapshot> places;  ///< Waypoints, regions, then things and items that have names.
  bool has_navigation = false;        ///< There is a navigation mesh, it is ready and was wanted.
  bool has_influence = false;         ///< The same of an influence map.
  // Only what was wanted.
  bool has_pushes = false;                  ///< They were wanted; there may have been none.
  std::vector<PushSnapshot> pushes;         ///< In the order in which they were given.
  std::vector<LineSnapshot> lines;          ///< Edges of navigation meshes, wireframes of bodies.
  std::vector<TriangleSnapshot> triangles;  ///< Fills of navigation meshes and the influence map.
};

}  // namespace soarbox::world
