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

/// The data that the actors of a world share: places, messages, noises, and the actors themselves.
///
/// In each tick, the minds first read the senses (senses.h) and begin commands. Step() then updates all actors in the
/// order of creation. HearCollisions() is called after the step of the physics. Owned by the simulation.
class Arena {
 public:
  using Report = std::function<void(RunEvent)>;

  Arena(world::World& world, Report report);

  /// Gives an agent a body of this kind, with its appearance. If a script controls the body, the actor provides only
  /// the senses of the kind and executes no commands.
  Actor& Add(world::EntityId agent, const BodyKind& kind, bool is_scripted = false);
  /// Removes the actor of an agent that the world has removed, with the things that it carries. Reports that it left.
  void Remove(world::EntityId agent);
  /// Null for agents that were not added.
  Actor* Find(world::EntityId agent);
  const Actor* Find(world::EntityId agent) const { return const_cast<Arena*>(this)->Find(agent); }
  std::span<const std::unique_ptr<Actor>> actors() const { return actors_; }
  /// The id of an agent by its name; kNoEntity if there is none.
  world::EntityId FindAgentNamed(std::string_view name) const;
  /// The id of a thing by its name; kNoEntity if there is none.
  world::EntityId FindObjectNamed(std::string_view name) const;
  /// The thing's name in the scenario, or its kind and number.
  std::string NameOfObject(world::EntityId object) const;

  /// Puts a carried thing on the ground, under its name. Returns false if the world accepts no more objects.
  bool PutDown(const CarriedThing& thing, world::Vec3 ground);

  /// Builds a navigation mesh of the present world. Commands to move follow its paths from now on.
  void BuildWays();
  /// The corners of a path, without its start. Empty if there is no mesh or no path.
  std::vector<world::Vec3> FindWay(world::Vec3 from, world::Vec3 to);
  /// False if the mesh shows that no path leads to within `within_m` of the place. True if that is not certain, for
  /// example because a thing has been removed since the mesh was built.
  bool MayReach(world::Vec3 from, world::Vec3 to, float within_m);

  /// Computes searches of the coming Step in advance, on several threads. It covers the actors before the first one
  /// that does more than walk (Actor::OnlyWalks). The actors only read the world, so the result does not depend on the
  /// order or the number of threads.
  void Foresee(const world::Workers& workers);
  void Step();
  /// Converts the collisions of the last physics step to happenings of the agents that took part.
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
    std::deque<PastShot> shots;  ///< Recent shots, oldest first. Each shot removes those of more than 2 s before.
    /// By agent. An agent that is missing is alive, or a script reduced its health to 0.
    std::map<world::EntityId, Death> deaths;
  };
  /// Recent events, for observers.
  const Past& past() const { return past_; }
  /// An order of the user: "advance waypoint gate" is converted to ^action advance ^waypoint gate.
  void Order(world::EntityId agent, const std::string& order);
  void Tell(world::EntityId agent, std::string_view news, std::string text, std::optional<Speech> speech = {});

  /// The ground on which agents walk. It is not listed as a thing.
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
  std::vector<std::unique_ptr<Actor>> actors_;  ///< In the order of creation, that is, by ascending id.
  world::EntityId ground_ = world::kNoEntity;
  bool has_ways_ = false;
  std::vector<world::EntityId> things_of_ways_;  ///< The things that existed when the mesh was built, by ascending id.
  std::set<std::pair<world::EntityId, world::EntityId>> touching_;
  Past past_;
};

}  // namespace soarbox::sim
