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

/// Something that happened to an actor.
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
  Item item;  ///< Its object is gone from the world.
};

/// A thing that an actor has seen, as it was when it was last in view.
struct SeenThing {
  std::string name, kind;
  world::Vec3 position;
  float radius_m = 0;
  bool moves = false;
  bool visible = false;
  std::uint64_t seen_tick = 0;
  // For agents that sense a scene: how it is turned, and the box around it in its own frame.
  world::Quat orientation;
  world::Vec3 low, high;
};

/// How far hands reach, from skin to skin.
inline constexpr float kArmsReach_m = 1.5f;

/// How a command went, for the mind that gave it.
struct Outcome {
  enum class Status : std::uint8_t { kProgress, kComplete, kError, kInterrupted } status = Status::kComplete;
  std::uint64_t tag = 0;
  std::string command;
  std::string reason, parameter;
  std::string text;  ///< What is wrong, for people; empty if nothing is.
  float progress = 0;
};

/// A command that a body is carrying out.
struct Running {
  vocabulary::SaidCommand said;
  const vocabulary::CommandRow* row = nullptr;
  std::uint64_t ticks = 0;  ///< Steps done so far; 0 in the first.
  // What the conducts keep between steps.
  float start_m = 0, best_m = 0;
  std::uint64_t best_tick = 0, mark_tick = 0;
  int index = 0, count = 0;
  float turn_deg = 0;
  std::optional<world::Vec3> goal = std::nullopt;
  std::vector<world::Vec3> path = {};  ///< Corners still to pass, with the goal that they lead to.
  world::Vec3 path_goal;
  std::uint64_t path_tick = 0;
  int told_tenths = -1;  ///< Progress reported last.
  /// The way that its next step will look for, found in advance (Arena::Foresee).
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

/// What one step of a command came to.
struct StepResult {
  enum class State : std::uint8_t { kGoing, kDone, kFailed } state = State::kDone;
  std::string_view reason = {};
  float progress = 0;

  static StepResult Going(float progress = 0) { return {State::kGoing, {}, progress}; }
  static StepResult Done() { return {State::kDone, {}, 1}; }
  static StepResult Failed(std::string_view reason) { return {State::kFailed, reason, 0}; }
};

/// The body of an agent that needs no script: it carries out the commands of the vocabulary.
///
/// Made by the Arena, which owns it; the physical agent is the world's. Deterministic: draws from the agent's own
/// random stream only.
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
  /// Takes a command that a mind has given; a mistake in it becomes an outcome. Interrupts others that hold the same
  /// part.
  void Begin(const vocabulary::SaidCommand& command);
  /// The rules have withdrawn the command: the body gives it up without an outcome.
  void Cancel(std::uint64_t tag);
  /// One tick: weapons, commands, legs.
  void Step();
  /// Whether others meet the same bodies at the same places during the next Step: it walks and turns at most.
  bool OnlyWalks() const;
  /// Finds what takes the next Step longest to look for. Reads the world and changes only this.
  void Foresee();
  std::vector<Outcome> TakeOutcomes();
  const std::vector<Running>& running() const { return running_; }

  // For the conducts.
  /// The ground velocity wanted in this step; the legs see to it. The body stands if nobody wants any.
  void Walk(world::Vec3 velocity) { wanted_ = velocity; }
  void Look(world::Vec3 direction) { look_ = direction; }
  float speed_mps() const;  ///< Of walking, with the stance taken into account.
  float TopSpeed() const;
  void SetWalkSpeed(float mps) { walk_mps_ = mps; }
  const std::string& stance() const { return stance_; }
  void SetStance(std::string_view stance);
  /// The node of its mesh, which shows how it holds itself.
  void SetLooks(world::NodeId looks);
  float Steadiness() const;
  std::optional<world::Weapon>& weapon() { return weapon_; }
  const std::optional<world::Weapon>& weapon() const { return weapon_; }
  world::EntityId target() const { return target_; }
  void SetTarget(world::EntityId target) { target_ = target; }
  const std::vector<CarriedThing>& carried() const { return carried_; }
  /// A load that is wider than the body rests on its shoulders and makes the body as wide.
  void Carry(CarriedThing thing);
  /// Takes the thing of this name out of its hands. Nothing if it carries no such thing.
  std::optional<CarriedThing> LetGo(std::string_view name);
  /// The radius that its body would have without the thing of this name.
  float RadiusWithout(std::string_view name) const;
  /// Where it supposes an agent to be: friends and agents in view where they are, others where it last noticed them.
  /// Nothing, with a reason, for agents that it never noticed or has forgotten.
  struct Sighting {
    world::Vec3 position, velocity;
    world::Vec3 forward{0, 0, 1};
    bool certain = false;  ///< In view, or a friend.
    bool alive = true;
  };
  std::optional<Sighting> Find(world::EntityId agent, std::string_view& reason) const;
  /// The place that the command's parameters name.
  struct Place {
    world::Vec3 position;
    world::EntityId entity = world::kNoEntity;
    float radius_m = 0;  ///< Of the thing that is there.
  };
  std::optional<Place> FindPlace(const Running& command, std::string_view& reason) const;

  // Knowledge; the senses keep it.
  Contacts& contacts() { return contacts_; }
  const Contacts& contacts() const { return contacts_; }
  /// Things in view or remembered, by their number in the world.
  std::map<world::EntityId, SeenThing>& things() { return things_; }
  const std::map<world::EntityId, SeenThing>& things() const { return things_; }
  std::deque<Happening>& happenings() { return happenings_; }
  const std::deque<Happening>& happenings() const { return happenings_; }
  void Notice(Happening happening);
  std::optional<world::Message>& order() { return order_; }
  const std::optional<world::Message>& order() const { return order_; }
  /// The number of the last message that was checked for an order.
  std::uint32_t& orders_heard() { return orders_heard_; }

  // How its movement goes.
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
  /// For a command to a place that does not exist: which place was most likely meant, and which places there are.
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
  world::NodeId load_ = world::NodeId::kNone;  ///< Of the widest thing that it carries, if that is wider than the body.
  float own_radius_m_ = 0;                     ///< Without the load.
  std::map<world::EntityId, SeenThing> things_;
  bool is_scripted_;  ///< A script moves the body; this one only perceives.
  bool dead_ = false;
};

}  // namespace soarbox::sim
