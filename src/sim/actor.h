// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/bearing.h"
#include "sim/body_kind.h"
#include "sim/contacts.h"
#include "sim/places.h"
#include "vocabulary/command_check.h"
#include "world/message_board.h"
#include "world/weapon.h"
#include "world/world.h"

namespace soarbox::sim {

class Arena;

/// An event that an agent perceived.
struct Happening {
  std::uint32_t number = 0;
  std::uint64_t tick = 0;
  std::string type;  ///< As in the table of percepts: "hit", "collision", "shot-heard".
  std::string by;
  float bearing_deg = 0;
  float damage = 0;
};

/// A thing that an actor carries.
struct CarriedThing {
  std::string name;
  Item item;  ///< Its object is not in the world while it is carried.
};

/// A thing that an actor has seen, as it was when it was last in view.
struct SeenThing {
  std::string name, kind;
  world::Vec3 position;
  float radius_m = 0;
  bool moves = false;
  bool visible = false;
  std::uint64_t seen_tick = 0;
  // For agents whose mind imagines the scene: the thing's orientation, and its bounding box in its own coordinates.
  world::Quat orientation;
  world::Vec3 low, high;
};

/// Maximum distance at which hands reach a thing, between the two surfaces.
inline constexpr float kArmsReach_m = 1.5f;

/// The result or progress of a command, for the mind that gave it.
struct Outcome {
  enum class Status : std::uint8_t { kProgress, kComplete, kError, kInterrupted } status = Status::kComplete;
  std::uint64_t tag = 0;
  std::string command;
  std::string reason, parameter;
  std::string text;        ///< The problem in words for users; empty if there is none.
  std::string brief = {};  ///< As CommandFault::brief.
  float progress = 0;
};

/// A command that a body is executing.
struct Running {
  vocabulary::SaidCommand said;
  const vocabulary::CommandRow* row = nullptr;
  std::uint64_t ticks = 0;  ///< Number of completed steps; 0 in the first step.
  // Data that the command's implementation keeps between steps (conduct.h).
  float start_m = 0, best_m = 0;
  std::uint64_t best_tick = 0, mark_tick = 0;
  int index = 0, count = 0;
  float turn_deg = 0;
  std::optional<world::Vec3> goal = std::nullopt;
  std::vector<world::Vec3> path = {};  ///< Remaining corners of the path to path_goal.
  world::Vec3 path_goal;
  std::uint64_t path_tick = 0;
  int told_tenths = -1;  ///< The last reported progress, in tenths.
  /// The direction for the next step, computed in advance (Arena::Foresee).
  struct FreeWay {
    world::Vec3 wanted;
    float turn_before_deg = 0;
    world::Vec3 direction;
    float turn_deg = 0;
  };
  std::optional<FreeWay> foreseen = std::nullopt;

  const vocabulary::Percept* Get(std::string_view name) const { return vocabulary::FindPercept(said.parameters, name); }
  double Number(std::string_view name, double otherwise) const;
  std::string Word(std::string_view name) const;
};

/// The result of one step of a command.
struct StepResult {
  enum class State : std::uint8_t { kGoing, kDone, kFailed } state = State::kDone;
  std::string_view reason = {};
  float progress = 0;

  static StepResult Going(float progress = 0) { return {State::kGoing, {}, progress}; }
  static StepResult Done() { return {State::kDone, {}, 1}; }
  static StepResult Failed(std::string_view reason) { return {State::kFailed, reason, 0}; }
};

/// The body of an agent without a body script. It executes the commands of the vocabulary.
///
/// Created and owned by the Arena; the physical agent belongs to the world. Deterministic: it draws random numbers only
/// from the agent's own stream.
class Actor {
 public:
  Actor(Arena& arena, world::World& world, world::EntityId id, BodyKind kind, bool is_scripted);

  world::EntityId id() const { return id_; }
  world::Agent& body() { return *body_; }
  const world::Agent& body() const { return *body_; }
  const BodyKind& kind() const { return kind_; }
  Arena& arena() { return arena_; }
  const Arena& arena() const { return arena_; }
  const world::MessageBoard& board() const;
  world::World& world() { return world_; }
  const world::World& world() const { return world_; }
  bool IsAlive() const { return body_->Health() > 0; }

  // Commands.
  /// Starts a command of a mind. An error in the command becomes an outcome. A command for legs, head or hands
  /// interrupts the running command for the same part.
  void Begin(const vocabulary::SaidCommand& command);
  /// Ends a command that the rules have withdrawn, without an outcome.
  void Cancel(std::uint64_t tag);
  /// One tick: weapons, then commands, then legs.
  void Step();
  /// Returns true if the next Step at most sets the velocity and the orientation of the actor's own body. After it, the
  /// other actors still find all bodies at the same places.
  bool OnlyWalks() const;
  /// Computes in advance the most expensive search of the next Step. Reads the world and changes only this actor.
  void Foresee();
  std::vector<Outcome> TakeOutcomes();
  const std::vector<Running>& running() const { return running_; }

  // For the implementations of commands (conduct.h).
  /// Sets the velocity on the ground for this step. Without a call, the body stands still.
  void Walk(world::Vec3 velocity) { wanted_ = velocity; }
  void Look(world::Vec3 direction) { look_ = direction; }
  float speed_mps() const;  ///< Walking speed in the present stance.
  float TopSpeed() const;
  void SetWalkSpeed(float mps) { walk_mps_ = mps; }
  const std::string& stance() const { return stance_; }
  void SetStance(std::string_view stance);
  /// Sets the node of its mesh, which shows its stance.
  void SetLooks(world::NodeId looks);
  float Steadiness() const;
  std::optional<world::Weapon>& weapon() { return weapon_; }
  const std::optional<world::Weapon>& weapon() const { return weapon_; }
  world::EntityId target() const { return target_; }
  void SetTarget(world::EntityId target) { target_ = target; }
  const std::vector<CarriedThing>& carried() const { return carried_; }
  /// Adds a load. If it is wider than the body, the body carries it on its shoulders and becomes as wide.
  void Carry(CarriedThing thing);
  /// Removes the thing of this name from its hands and returns it. Returns nothing if it does not carry the thing.
  std::optional<CarriedThing> LetGo(std::string_view name);
  /// The radius that its body would have without the thing of this name.
  float RadiusWithout(std::string_view name) const;
  /// The believed position of an agent. For friends and agents in view, this is the true position; for others, the
  /// position where they were last perceived. Returns nothing, with a reason, for agents that were never perceived or
  /// are forgotten.
  struct Sighting {
    world::Vec3 position, velocity;
    world::Vec3 forward{0, 0, 1};
    bool certain = false;  ///< It is in view, or a friend.
    bool alive = true;
  };
  std::optional<Sighting> Find(world::EntityId agent, std::string_view& reason) const;
  /// The place that the parameters of the command name.
  struct Place {
    world::Vec3 position;
    world::EntityId entity = world::kNoEntity;
    float radius_m = 0;  ///< Radius of the thing at the place.
  };
  std::optional<Place> FindPlace(const Running& command, std::string_view& reason) const;

  // Knowledge of the surroundings, which the senses update.
  Contacts& contacts() { return contacts_; }
  const Contacts& contacts() const { return contacts_; }
  /// Things that are in view or remembered, by id.
  std::map<world::EntityId, SeenThing>& things() { return things_; }
  const std::map<world::EntityId, SeenThing>& things() const { return things_; }
  std::deque<Happening>& happenings() { return happenings_; }
  const std::deque<Happening>& happenings() const { return happenings_; }
  void Notice(Happening happening);
  std::optional<world::Message>& order() { return order_; }
  const std::optional<world::Message>& order() const { return order_; }
  /// The number of the last message that was checked for orders.
  std::uint32_t& orders_heard() { return orders_heard_; }

  // Status of its movement.
  struct Way {
    std::string status = "none";
    std::string command;
    std::optional<float> remaining_m;
  };
  Way& way() { return way_; }
  const Way& way() const { return way_; }

  void AddTo(world::StateHash& hash) const;

 private:
  void End(const Running& command, Outcome::Status status, std::string_view reason, std::string text = {});
  /// For a command to a place that does not exist: the most similar name, and a list of the places.
  std::string WhichPlaces(const Running& command, std::string_view reason) const;
  void Die();
  void HoldLoad();
  void MoveBody();
  void ShowBearing();

  Arena& arena_;
  world::World& world_;
  world::EntityId id_;
  world::Agent* body_;
  BodyKind kind_;
  std::optional<world::Weapon> weapon_;
  std::vector<Running> running_;
  std::vector<Outcome> outcomes_;
  Contacts contacts_;
  std::deque<Happening> happenings_;
  std::uint32_t happened_ = 0;
  std::optional<world::Message> order_;
  std::uint32_t orders_heard_ = 0;
  Way way_;
  std::optional<world::Vec3> wanted_, look_;
  Bearing bearing_;
  float walk_mps_;
  std::string stance_ = "standing";
  world::EntityId target_ = world::kNoEntity;
  std::vector<CarriedThing> carried_;
  world::NodeId load_ = world::NodeId::kNone;  ///< Node of the widest load, if that is wider than the body.
  float own_radius_m_ = 0;                     ///< Radius without a load.
  std::map<world::EntityId, SeenThing> things_;
  bool is_scripted_;  ///< A script moves the body; the actor only perceives.
  bool dead_ = false;
};

}  // namespace soarbox::sim
