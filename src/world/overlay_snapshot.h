// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "world/math.h"
#include "world/scene_snapshot.h"

namespace soarbox::world {

/// Which of the expensive parts of an OverlaySnapshot a viewer needs. The other parts are always filled in.
struct OverlayWants {
  bool navigation = false, influence = false, physics = false;
  bool forces = false;
  friend bool operator==(const OverlayWants&, const OverlayWants&) = default;
};

/// What an agent believes about the position of another agent.
struct ContactSnapshot {
  std::uint32_t agent_id = 0;
  Vec3 position;
  Vec3 forward{0, 0, 1};
  double age_s = 0;      ///< Since it was last perceived.
  double memory_s = 15;  ///< After this time, it is forgotten.
  bool visible = false;  ///< It is in view now.
  bool heard = false;    ///< It was perceived by hearing.
  bool alive = true;     ///< As far as the agent knows.
};

/// What an agent perceives, intends and says. Overlays draw it; scenes do not contain it.
struct AgentOverlay {
  std::uint32_t id = 0;
  std::string operator_name;  ///< The operators of its mind, from the top state down. Empty if there is none, or if
                              ///< they are not reported.
  std::string doing;          ///< The running command, "move-to"; empty: none.
  bool has_senses = false;
  float sight_m = 0, view_deg = 360, hearing_m = 0;
  Vec3 eyes;
  std::optional<Vec3> measured;  ///< The position to which it perceives the distance, but not the direction.
  std::vector<Vec3> path;        ///< Remaining corners of its path, in order; empty: no path.
  bool path_is_whole = false;    ///< The path is complete, including corners already passed.
  std::optional<Vec3> goal;      ///< The position that it moves to or aims at.
  std::uint32_t target_id = 0;   ///< The agent that is its target; 0: none.
  std::uint32_t leader_id = 0;   ///< The agent that it follows; 0: none.
  std::vector<ContactSnapshot> contacts;
};

/// A recent shot.
struct ShotSnapshot {
  Vec3 from, to;
  std::uint32_t shooter_id = 0;
  std::uint32_t hit_agent_id = 0;  ///< 0: no agent.
  double age_s = 0;
};

/// A recent message of an agent.
struct SpeechSnapshot {
  std::uint32_t from_id = 0;
  std::uint32_t to_id = 0;  ///< 0: the entire team.
  std::string text;         ///< "contact: target red-1, x 3.5"
  double age_s = 0;
};

/// A force or impulse that a script or a command applied to a body for the last step.
struct PushSnapshot {
  std::uint32_t owner_id = 0;  ///< The agent or object.
  Vec3 position;               ///< Present position of the body's centre.
  Vec3 force_n;                ///< Force during one step. For a change of velocity: the force that would have caused
                               ///< it.
  float mass_kg = 1;
  Vec3 spin_rad_s{};  ///< Change of angular velocity by an angular impulse, as a vector along the axis (right-hand
                      ///< rule).
};

/// A named part of the world that is not an agent.
struct PlaceSnapshot {
  enum class Kind : std::uint8_t { kWaypoint, kRegion, kItem, kThing } kind = Kind::kWaypoint;
  std::string name;
  Vec3 position;  ///< On the ground; for items and things, their top.
};

/// All data for overlays that are not in the scene, at the end of a tick. Recordings do not contain them.
struct OverlaySnapshot {
  std::uint64_t tick = 0;
  std::vector<AgentOverlay> agents;  ///< By ascending id.
  std::vector<ShotSnapshot> shots;
  std::vector<SpeechSnapshot> speech;
  std::vector<PlaceSnapshot> places;  ///< Waypoints, regions, then things and items that have names.
  bool has_navigation = false;        ///< The navigation mesh was requested, exists and is ready.
  bool has_influence = false;         ///< The influence map was requested and exists.
  // The following are only filled in if requested.
  bool has_pushes = false;                  ///< Pushes were requested; the list may still be empty.
  std::vector<PushSnapshot> pushes;         ///< In the order in which they were applied.
  std::vector<LineSnapshot> lines;          ///< Edges of navigation meshes, wireframes of bodies.
  std::vector<TriangleSnapshot> triangles;  ///< Filled areas of navigation meshes and the influence map.
};

}  // namespace soarbox::world
