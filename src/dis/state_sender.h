// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "dis/dis_settings.h"
#include "dis/earth.h"
#include "dis/pdu.h"
#include "world/entity_ids.h"

namespace soarbox::sim {
class Actor;
class Simulation;
}  // namespace soarbox::sim
namespace soarbox::world {
class Agent;
}

namespace soarbox::dis {

/// Converts seconds of an exercise to the timestamp of a PDU, relative to an arbitrary start.
std::uint32_t RelativeTimestamp(double seconds);

/// Creates the PDUs about our agents. A state is sent when an entity leaves its extrapolated path, when its appearance
/// changes, and at intervals. Shots, collisions and messages are sent when they occur.
class StateSender {
 public:
  explicit StateSender(const Settings& settings) : settings_(settings), frame_(settings.anchor) {}

  /// Call it after each tick. `now_s`: real time from any starting point.
  std::vector<Pdu> AfterTick(const sim::Simulation& simulation, double now_s);
  /// Call it while the run is paused. Reports that all entities stand still and still exist.
  std::vector<Pdu> WhileStill(const sim::Simulation& simulation, double now_s);
  /// Reports that all entities leave.
  std::vector<Pdu> Leave();
  /// The name of the agent with this number; empty if there is none.
  std::string NameOf(std::uint16_t entity) const;

 private:
  struct Entity {
    std::uint16_t number = 0;
    std::string name;
    EntityState sent;
    double sent_at_s = -1e9;   ///< Real time.
    double sent_at_sim_s = 0;  ///< Simulated time.
    Vector sent_position;      ///< In local coordinates.
    Vector sent_velocity;
    float sent_heading_deg = 0;
  };
  bool IsOurs(const sim::Simulation& simulation, world::EntityId id) const;
  Entity& EntityOf(const world::Agent& agent);
  /// All zero if `id` is not an agent.
  EntityId IdOf(const sim::Simulation& simulation, world::EntityId id) const;
  EntityState StateOf(const sim::Simulation& simulation, const world::Agent& agent, bool is_still);
  bool MustBeTold(const Entity& entity, const EntityState& now, const world::Agent& agent, double now_s,
                  double sim_s) const;
  void AddStates(const sim::Simulation& simulation, double now_s, bool is_still, std::vector<Pdu>& pdus);
  void AddShots(const sim::Simulation& simulation, std::vector<Pdu>& pdus);
  void AddCollisions(const sim::Simulation& simulation, std::vector<Pdu>& pdus);
  void AddMessages(const sim::Simulation& simulation, std::vector<Pdu>& pdus);

  const Settings& settings_;
  LocalFrame frame_;
  std::map<world::EntityId, Entity> entities_;
  std::uint16_t events_ = 0;
  std::uint32_t last_message_ = 0;
};

}  // namespace soarbox::dis
