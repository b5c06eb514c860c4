// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/actor.h"
#include "sim/places.h"
#include "sim/run_event.h"
#include "world/message_board.h"

namespace soarbox::sim {

/// What the actors of a world share: places, messages, noises, and the actors themselves.
///
/// One tick: the minds read the senses (senses.h), commands begin, then Step() lets every actor act in creation order;
/// HearCollisions() follows the world's own step. Owned by the simulation.
class Arena {
 public:
  using Report = std::function<void(RunEvent)>;

  Arena(world::World& world, Report report);

  /// Gives an agent of the world a body of this kind, with its looks. An agent whose body is a script gets only the
  /// senses of the kind: it carries out no commands.
  Actor& Add(world::EntityId agent, const BodyKind& kind, bool is_scripted = false);
  /// Removes an agent that has gone from the world, with what it carries, and reports that it leaves.
  void Remove(world::EntityId agent);
  /// Null for agents that were not added.
  Actor* Find(world::EntityId agent);
  const Actor* Find(world::EntityId agent) const { return const_cast<Arena*>(this)->Find(agent); }
  std::span<const std::unique_ptr<Actor>> actors() const { return actors_; }
  /// Any agent of the world, by name; kNoEntity if there is none.
  world::EntityId FindAgentNamed(std::string_view name) const;
  /// A thing by its name; kNoEntity if there is none.
  world::EntityId FindObjectNamed(std::string_view name) const;
  /// Its name in the scenario, or its kind and number.
  std::string NameOfObject(world::EntityId object) const;

  /// Puts a carried thing on the ground at that place, under its name. False if the world takes no more.
  bool PutDown(const CarriedThing& thing, world::Vec3 ground);

  /// Makes a navigation mesh of what is there now; commands to move then follow it.
  void BuildWays();
  /// The corners of the way, without its start; empty if there is no mesh or no way.
  std::vector<world::Vec3> FindWay(world::Vec3 from, world::Vec3 to);
  /// False if the mesh shows that no way leads to within this distance of the place; true where it cannot tell, for
  /// example after a thing has gone that was there when the mesh was made.
  bool MayReach(world::Vec3 from, world::Vec3 to, float within_m);

  /// Before Step: actors find what they will look for, as long as nobody who acts before them does more than walk. They
  /// only read the world, so neither their order nor the number of threads matters.
  void Foresee(const world::Workers& workers);
  void Step();
  /// Makes the collisions of the world's last step happenings of those who took part.
  void HearCollisions();
  void OnShot(const world::Shot& shot);
  struct PastShot {
    world::Shot shot;
    std::uint64_t tick = 0;
  };
  /// How an agent died: "shot by rival".
  struct Death {
    std::string how;
    double time_s = 0;
  };
  struct Past {
    std::deque<PastShot> shots;  ///< Of the last two seconds, oldest first.
    /// By agent. Who is not among them did not die, or a script took its health.
    std::map<world::EntityId, Death> deaths;
  };
  /// What happened, for whoever watches or asks.
  const Past& past() const { return past_; }
  /// An order of the user: "advance waypoint gate" becomes ^action advance ^waypoint gate.
  void Order(world::EntityId agent, const std::string& order);
  void Tell(world::EntityId agent, std::string_view news, std::string text);

  /// The slab that carries the ways; nobody would call it a thing.
  world::EntityId ground() const { return ground_; }
  Places& places() { return places_; }
  const Places& places() const { return places_; }
  world::MessageBoard& board() { return board_; }
  const world::MessageBoard& board() const { return board_; }
  world::World& world() { return world_; }
  const world::World& world() const { return world_; }

  void AddTo(world::StateHash& hash) const;

 private:
  void GiveLooks(Actor& actor);

  world::World& world_;
  Report report_;
  Places places_;
  world::MessageBoard board_;
  std::vector<std::unique_ptr<Actor>> actors_;  ///< In creation order, thus in ascending id.
  world::EntityId ground_ = world::kNoEntity;
  bool has_ways_ = false;
  std::vector<world::EntityId> things_of_ways_;  ///< What was there when the mesh was made, in ascending id.
  std::set<std::pair<world::EntityId, world::EntityId>> touching_;
  Past past_;
};

}  // namespace soarbox::sim
