// SPDX-License-Identifier: BSD-2-Clause
#include "world/physics_ways.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>

#include "world/entity_ids.h"
#include "world/limits.h"

namespace soarbox::world {
namespace {

/// The group as a bit. Several groups can share a bit.
std::uint64_t GroupOf(std::size_t n) {
  return 1ull << (n % 64);
}

bool IsAny(const void* mask) {
  std::uint64_t halves[2];
  std::memcpy(halves, mask, sizeof(halves));
  return (halves[0] | halves[1]) != 0;
}

}  // namespace

struct LevelWays::Way {
  btScalar x, z;  ///< The direction.
  btScalar length_m;
  bool is_unit;
  btScalar sides[3];
};

bool LevelWays::Segment::Enters(const BoxedBody& each) const {
  return probe.Meets(each.box, 1) && EntryOf(*each.body, from, to).has_value();
}

LevelWays::LevelWays(const Walker& walker, float reach_m)
    : walker_(walker), reach_m_(reach_m), slack_m_(SlackAbout(ToBullet(walker.place), reach_m)) {
  constexpr std::size_t kUsual = 48;
  bodies_.reserve(kUsual);
  circles_.reserve(kUsual / kLanes);
  low_ = ToBullet(LimitPosition(walker.place - Vec3{reach_m, 0, reach_m}));
  high_ = ToBullet(LimitPosition(walker.place + Vec3{reach_m, 0, reach_m}));
}

bool LevelWays::IsOwn(const btCollisionObject& body) const {
  const int owner = body.getUserIndex();
  return owner == static_cast<int>(Number(walker_.self)) || owner == static_cast<int>(Number(walker_.through));
}

/// Whether the body is a plane that no path comes near, such as the ground.
bool LevelWays::IsPlaneAfar(const BoxedBody& each) const {
  constexpr btScalar kLarge_m = 1e6f;
  if (each.radius < kLarge_m) return false;
  const std::optional<WorldPlane> plane = PlaneOf(*each.body);
  return plane && std::abs(plane->HeightOf(ToBullet(walker_.place))) >
                      2 * reach_m_ * (std::abs(plane->normal.x()) + std::abs(plane->normal.z())) + slack_m_;
}

LevelWays::Circle LevelWays::CircleOf(const BoxedBody& each) const {
  const bool is_beside = walker_.place.y > each.low + slack_m_ && walker_.place.y < each.high - slack_m_;
  return {each.x - walker_.place.x, each.z - walker_.place.z, each.radius + slack_m_,
          is_beside ? std::max(each.radius - slack_m_, btScalar{0}) : btScalar{0}};
}

bool LevelWays::StandsIn(const BoxedBody& each) const {
  const Circle circle = CircleOf(each);
  const btScalar off_m = std::sqrt(circle.x * circle.x + circle.z * circle.z);
  return off_m < circle.inner && off_m + circle.outer < walker_.half_width_m;
}

void LevelWays::Consider(const BoxedBody& each) {
  if (IsPlaneAfar(each)) return;
  if (IsOwn(*each.body)) {
    if (!StandsIn(each)) own_.push_back(each);
    return;
  }
  const Circle circle = CircleOf(each);
  const btScalar farthest = reach_m_ + circle.outer;
  if (circle.x * circle.x + circle.z * circle.z > farthest * farthest) return;
  const std::size_t lane = bodies_.size() % kLanes;
  bodies_.push_back(each);
  if (lane == 0) circles_.emplace_back();
  Circles& four = circles_.back();
  four.x[lane] = circle.x;
  four.z[lane] = circle.z;
  four.outer[lane] = circle.outer;
  four.inner[lane] = circle.inner;
}

bool LevelWays::IsNear(const Circle& circle, const Way& way) const {
  const btScalar along = circle.x * way.x + circle.z * way.z, beside = circle.x * way.z - circle.z * way.x;
  return !way.is_unit || (std::abs(beside) <= circle.outer + walker_.half_width_m && along >= -circle.outer &&
                          along <= circle.outer + way.length_m);
}

/// Whether one of the segments certainly enters a body. If not, sets `groups` to the groups of four with bodies that
/// may be entered.
bool LevelWays::IsBlockedForCertain(const Way& way, std::uint64_t& groups) const {
  groups = 0;
  for (std::size_t n = 0; n < circles_.size(); ++n) {
    // Positions of the circles' centres along and beside the path.
    const Circles& four = circles_[n];
    const Four along = four.x * way.x + four.z * way.z, beside = four.x * way.z - four.z * way.x;
    const Four reach = four.outer + walker_.half_width_m, past = along - way.length_m;
    const Mask near = (beside <= reach) & (beside >= -reach) & (along >= -four.outer) & (past <= four.outer);
    if (!IsAny(&near)) continue;
    groups |= GroupOf(n);
    const Four inner = four.inner * four.inner, outer = four.outer * four.outer;
    const Mask before_end = past <= four.inner - four.outer;
    Mask enters{};
    for (const btScalar side : way.sides) {
      const Four off = beside - side, off_2 = off * off;
      enters |= (off_2 < inner) & (off_2 + along * along > outer) & (before_end | (off_2 + past * past < inner));
    }
    enters &= along > 0;
    if (IsAny(&enters)) return true;
  }
  return false;
}

/// Calls visit for each body of the groups that one of the segments may enter. If visit returns false, stops and
/// returns false.
template <class Visit>
bool LevelWays::VisitNear(const Way& way, std::uint64_t groups, const Visit& visit) const {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const std::size_t n = i / kLanes, lane = i % kLanes;
    if ((groups & GroupOf(n)) == 0) continue;
    const Circles& four = circles_[n];
    if (IsNear({four.x[lane], four.z[lane], four.outer[lane], 0}, way) && !visit(bodies_[i])) return false;
  }
  return true;
}

bool LevelWays::IsOpen(Vec3 direction, float length_m) const {
  constexpr float kUnit = 1e-5f;
  const btScalar half_m = walker_.half_width_m;
  const Way way{
      direction.x, direction.z, length_m, std::abs(LengthSquared(direction) - 1) < kUnit, {0, half_m, -half_m}};
  const bool may_meet_own =
      std::ranges::any_of(own_, [&](const BoxedBody& each) { return IsNear(CircleOf(each), way); });
  std::uint64_t groups = ~0ull;
  if (!may_meet_own && way.is_unit) {
    if (IsBlockedForCertain(way, groups)) return false;
    if (groups == 0) return true;
  }
  const Vec3 across{direction.z, 0, -direction.x};
  for (const btScalar side : way.sides) {
    const Vec3 from = walker_.place + across * side;
    const Vec3 begin = LimitPosition(from), end = LimitPosition(from + direction * length_m);
    if (begin == end) continue;
    const Segment segment{ToBullet(begin), ToBullet(end), Probe(ToBullet(begin), ToBullet(end))};
    if (may_meet_own ? !IsOwnFirst(way, segment)
                     : !VisitNear(way, groups, [&](const BoxedBody& each) { return !segment.Enters(each); }))
      return false;
  }
  return true;
}

/// Whether the segment enters no body, or first one of the walker's own bodies.
bool LevelWays::IsOwnFirst(const Way& way, const Segment& segment) const {
  FirstHit first;
  btScalar share = 1;
  const auto take = [&](const BoxedBody& each) {
    if (segment.probe.Meets(each.box, share)) TakeIfFirst(*each.body, segment.from, segment.to, first, share);
    return true;
  };
  VisitNear(way, ~0ull, take);
  for (const BoxedBody& each : own_) take(each);
  return first.body == nullptr || IsOwn(*first.body);
}

}  // namespace soarbox::world
