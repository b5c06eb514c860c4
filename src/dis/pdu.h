// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace soarbox::dis {

// The protocol data units (PDUs) of IEEE 1278.1 that Soarbox sends and understands, as values. All lengths are in
// metres, angles in radians, speeds in m/s. Coordinates are geocentric: from the centre of the earth, x towards 0
// degrees of longitude on the equator, z towards the north pole.

struct Vector {
  double x = 0, y = 0, z = 0;
  friend bool operator==(const Vector&, const Vector&) = default;
};

/// Identifies an entity in the entire exercise. All zero: none.
struct EntityId {
  std::uint16_t site = 0, application = 0, entity = 0;
  friend auto operator<=>(const EntityId&, const EntityId&) = default;
  bool IsNobody() const { return *this == EntityId{}; }
};

/// What something is: kind (1 platform, 2 munition, 3 life form), domain (1 land), country, and finer numbers.
struct EntityType {
  std::uint8_t kind = 0, domain = 0;
  std::uint16_t country = 0;
  std::uint8_t category = 0, subcategory = 0, specific = 0, extra = 0;
  friend auto operator<=>(const EntityType&, const EntityType&) = default;
};

/// Psi turns about z, then theta about y, then phi about x: from geocentric axes to those of a body (x forward, y
/// right, z down).
struct Euler {
  double psi = 0, theta = 0, phi = 0;
};

enum class PduType : std::uint8_t {
  kEntityState = 1,
  kFire = 2,
  kDetonation = 3,
  kCollision = 4,
  kCreateEntity = 11,
  kRemoveEntity = 12,
  kStartResume = 13,
  kStopFreeze = 14,
  kAcknowledge = 15,
  kComment = 22,
};

/// Bits of an appearance that Soarbox uses.
namespace appearance {
inline constexpr std::uint32_t kDamageShift = 3, kDamageMask = 3;      ///< 0 none to 3 destroyed or dead; all kinds.
inline constexpr std::uint32_t kPostureShift = 16, kPostureMask = 15;  ///< Of a life form.
inline constexpr std::uint32_t kFrozen = 1u << 21, kDeactivated = 1u << 23;
inline constexpr std::uint32_t kWeaponShift = 24, kWeaponMask = 3;  ///< Of a life form: 3 ready to fire.
enum Posture : std::uint32_t { kStanding = 1, kWalking = 2, kRunning = 3, kKneeling = 4, kProne = 5, kCrouching = 12 };
}  // namespace appearance

/// How receivers extrapolate the motion of an entity between two states.
enum class DeadReckoning : std::uint8_t {
  kOther = 0,
  kStatic = 1,
  kFpw = 2,  ///< Fixed orientation, constant velocity.
  kRpw = 3,  ///< With rotation.
  kRvw = 4,  ///< With rotation and acceleration.
  kFvw = 5,  ///< With acceleration.
};

struct EntityState {
  EntityId id;
  std::uint8_t force = 0;  ///< 0 other, 1 friendly, 2 opposing, 3 neutral.
  EntityType type, alternative;
  Vector velocity, position;
  Euler orientation;
  std::uint32_t appearance = 0;
  DeadReckoning algorithm = DeadReckoning::kFpw;
  Vector acceleration;
  Vector turn;          ///< rad/s about the body's axes.
  std::string marking;  ///< At most 11 characters of ASCII.
  std::uint32_t capabilities = 0;
};

/// The number of an event, which links a shot to its hit.
struct EventId {
  std::uint16_t site = 0, application = 0, number = 0;
};

struct Burst {
  EntityType munition;
  std::uint16_t warhead = 0, fuse = 0, quantity = 1, rate = 0;
};

struct Fire {
  EntityId shooter, target, munition;
  EventId event;
  std::uint32_t mission = 0;
  Vector position;
  Burst burst;
  Vector velocity;
  float range_m = 0;
};

enum class DetonationResult : std::uint8_t { kOther = 0, kEntityImpact = 1, kGroundImpact = 3, kNone = 5 };

struct Detonation {
  EntityId shooter, target, munition;
  EventId event;
  Vector velocity, position;
  Burst burst;
  Vector position_in_target;  ///< In the target's axes; zero if there is none.
  std::uint8_t result = 0;    ///< A DetonationResult, or another value of the standard.
};

struct Collision {
  EntityId issuer, other;
  EventId event;
  std::uint8_t type = 0;  ///< 0 inelastic, 1 elastic.
  Vector velocity;
  float mass_kg = 0;
  Vector position_in_issuer;
};

/// Text from one entity to another, or to all.
struct Comment {
  EntityId from, to;
  std::vector<std::string> texts;
};

/// An order of an exercise's manager, or the answer to one.
struct Management {
  PduType type = PduType::kAcknowledge;
  EntityId from, to;
  std::uint32_t request = 0;
  std::uint16_t flag = 0;   ///< Acknowledge: which order is acknowledged (1 create, 2 remove, 3 start, 4 stop).
  bool is_able = true;      ///< Acknowledge: the order is obeyed.
  std::uint8_t reason = 0;  ///< Stop/Freeze.
};

using Body = std::variant<EntityState, Fire, Detonation, Collision, Comment, Management>;

struct Pdu {
  std::uint8_t version = 7;  ///< Of the protocol: 6 (1278.1a) or 7 (1278.1-2012).
  std::uint8_t exercise = 1;
  std::uint32_t timestamp = 0;  ///< In 1/2^31 hours since the full hour, shifted by one; lowest bit: absolute time.
  Body body;
};

/// "1:2:3"
std::string ToText(const EntityId& id);
/// "3.1.225.1.0.0.0"
std::string ToText(const EntityType& type);

}  // namespace soarbox::dis
