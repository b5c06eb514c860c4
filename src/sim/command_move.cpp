// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/arena.h"
#include "sim/conduct.h"
#include "sim/directions.h"

namespace soarbox::sim {
namespace {

using world::Vec3;

constexpr float kBlockedAfter_s = 4;
constexpr float kProgress_m = 0.25f;
constexpr float kFarEnough_m = 20;
constexpr float kRayHeight_m = 0.4f;

float StepOf(const Actor& actor) {
  return actor.world().settings().step_s;
}

constexpr float kHalfWidth = 1.1f;  // In multiples of the radius.

Vec3 FootOf(const world::Agent& body) {
  Vec3 foot = body.Position();
  foot.y += kRayHeight_m - body.Height() / 2;
  return foot;
}

/// The free paths of a body up to this distance, in all directions.
world::WaysAround WaysOf(const Actor& actor, float ahead_m, world::EntityId through) {
  const world::Agent& body = actor.body();
  constexpr float kSlack_m = 0.01f;
  return actor.world().Ways({FootOf(body), body.Radius() * kHalfWidth, body.id(), through},
                            ahead_m + (1 + kHalfWidth) * body.Radius() + kSlack_m);
}

/// Whether there may be a path for a body on the ground. A body on top of something may jump down.
bool MayReach(Actor& actor, const WalkOrder& order) {
  constexpr float kOnGround_m = 0.5f;
  // The mesh keeps half a metre away from walls; people can go nearer.
  constexpr float kSlack_m = 0.75f;
  Vec3 foot = actor.body().Position();
  foot.y -= actor.body().Height() / 2;
  return foot.y > kOnGround_m || actor.arena().MayReach(foot, order.goal, order.within_m + kSlack_m);
}

/// The point to walk to next: the next corner of the path on the navigation mesh, or the goal itself. Returns nothing
/// if there is no path.
std::optional<Vec3> NextCorner(Actor& actor, Running& command, const WalkOrder& order) {
  const Vec3 goal = order.goal;
  constexpr float kPassed_m = 0.5f;
  constexpr float kSameGoal_m = 1;
  constexpr float kAgain_s = 3;
  const Vec3 here = actor.body().Position();
  const std::uint64_t tick = actor.world().tick();
  const bool is_old = static_cast<float>(tick - command.path_tick) * StepOf(actor) > kAgain_s;
  if (command.path_tick == 0 || is_old || FlatDistance(command.path_goal, goal) > kSameGoal_m) {
    command.path = actor.arena().FindWay(here, goal);
    command.path_goal = goal;
    command.path_tick = tick;
    if (command.path.empty() && !MayReach(actor, order)) return std::nullopt;
  }
  while (!command.path.empty() && FlatDistance(here, command.path.front()) < kPassed_m)
    command.path.erase(command.path.begin());
  // The last corner is the goal, which may have moved since.
  return command.path.size() > 1 ? command.path.front() : goal;
}

/// Walks to the command's place and stops there, at a distance of at most `within_m` unless the command has another
/// value.
StepResult GoTo(Actor& actor, Running& command, double within_m, float speed_mps) {
  std::string_view reason;
  const auto place = actor.FindPlace(command, reason);
  if (!place) return StepResult::Failed(reason);
  WalkOrder order;
  order.goal = place->position;
  order.within_m = static_cast<float>(command.Number("within", within_m)) + place->radius_m;
  if (place->radius_m > 0) order.within_m += actor.body().Radius();
  order.speed_mps = speed_mps;
  order.through = place->entity;
  if (command.Get("away-from") != nullptr) {
    order.shun = actor.arena().FindAgentNamed(command.Word("away-from"));
    order.shun_m = static_cast<float>(command.Number("gap", 6));
    if (order.shun == world::kNoEntity) return StepResult::Failed("no-such-agent");
    if (order.shun == actor.id()) return StepResult::Failed("itself");
  }
  return WalkTo(actor, command, order);
}

StepResult MoveTo(Actor& actor, Running& command) {
  return GoTo(actor, command, 0.75, actor.speed_mps());
}

/// A direction that keeps away from another agent: past it on the side that is nearer to the goal, or away from it if
/// it is too near.
Vec3 KeptAway(Actor& actor, Running& command, const WalkOrder& order, Vec3 wanted) {
  std::string_view unknown;
  const auto seen = actor.Find(order.shun, unknown);
  if (!seen) return wanted;  // Its position is not known.
  const Vec3 from = Flat(actor.body().Position() - seen->position);
  const float range_m = world::Length(from);
  constexpr float kHeed_m = 3;  // Additional distance at which the path begins to bend.
  if (range_m > order.shun_m + kHeed_m || range_m < 0.01f) {
    command.index = 0;
    return wanted;
  }
  const Vec3 off = from * (1 / range_m);
  const float towards = -world::Dot(wanted, off);
  if (towards <= 0 && range_m >= order.shun_m) return wanted;  // It moves away from the other agent anyway.
  const Vec3 left{off.z, 0, -off.x};
  // Stays on the side on which it has begun to pass.
  if (command.index == 0) command.index = world::Dot(wanted, left) >= 0 ? 1 : -1;
  const float push = std::clamp((order.shun_m + kHeed_m - range_m) / kHeed_m, 0.0f, 2.0f) - 1;
  return world::Normalized(left * static_cast<float>(command.index) + off * push);
}

StepResult Arrive(Actor& actor, Running& command) {
  return GoTo(actor, command, 0.3, actor.TopSpeed());
}

StepResult Seek(Actor& actor, Running& command) {
  std::string_view reason;
  const auto place = actor.FindPlace(command, reason);
  if (!place) return StepResult::Failed(reason);
  WalkOrder order;
  order.goal = place->position;
  order.within_m = static_cast<float>(command.Number("within", 1)) + place->radius_m;
  order.speed_mps = actor.TopSpeed();
  order.slow_down = order.stands = false;
  order.through = place->entity;
  return WalkTo(actor, command, order);
}

StepResult Flee(Actor& actor, Running& command) {
  std::string_view reason;
  auto place = actor.FindPlace(command, reason);
  if (!place && command.goal && (reason == "lost" || reason == "never-noticed")) place = Actor::Place{*command.goal};
  if (!place) return StepResult::Failed(reason);
  command.goal = place->position;
  const float until_m = static_cast<float>(command.Number("until", kFarEnough_m));
  const float now_m = FlatDistance(actor.body().Position(), place->position);
  actor.way().remaining_m = std::max(0.0f, until_m - now_m);
  if (now_m >= until_m) return StepResult::Done();
  Vec3 away = world::Normalized(Flat(actor.body().Position() - place->position));
  if (away == Vec3{}) away = Flat(actor.body().Forward());
  actor.Walk(FreeDirection(actor, away, 3, world::kNoEntity, command.turn_deg) * actor.TopSpeed());
  return StepResult::Going(now_m / until_m);
}

constexpr std::string_view kWander = "wander";
constexpr float kWanderAhead_m = 3;

/// A heading that drifts randomly; draws from the agent's own stream.
float Drift(const Actor& actor, const Running& command, world::RandomStream& random) {
  const float heading = command.ticks == 0 ? HeadingOf(actor.body().Forward()) : command.best_m;
  return WrapDegrees(heading + (random.Unit() - 0.5f) * 12);
}

/// Uses the direction that was computed in advance, or computes it now.
Vec3 FreeWander(const Actor& actor, Running& command, Vec3 wanted) {
  const auto known = std::exchange(command.foreseen, std::nullopt);
  if (known && known->wanted == wanted && known->turn_before_deg == command.turn_deg) {
    command.turn_deg = known->turn_deg;
    return known->direction;
  }
  return FreeDirection(actor, wanted, kWanderAhead_m, world::kNoEntity, command.turn_deg);
}

StepResult Wander(Actor& actor, Running& command) {
  const double seconds = command.Number("seconds", 0);
  const double passed = static_cast<double>(command.ticks) * static_cast<double>(StepOf(actor));
  if (seconds > 0 && passed >= seconds) return StepResult::Done();
  command.best_m = Drift(actor, command, actor.body().random());
  const Vec3 free = FreeWander(actor, command, AlongHeading(command.best_m));
  const float heading = HeadingOf(free);
  if (std::abs(WrapDegrees(heading - command.best_m)) > 1) command.best_m = heading;
  actor.Walk(free * actor.speed_mps());
  return StepResult::Going(seconds > 0 ? static_cast<float>(passed / seconds) : 0);
}

StepResult Patrol(Actor& actor, Running& command) {
  const auto& waypoints = actor.arena().places().waypoints;
  if (waypoints.empty()) return StepResult::Failed("no-waypoints");
  const int count = static_cast<int>(waypoints.size());
  if (command.ticks == 0) {
    const Vec3 here = actor.body().Position();
    const auto nearest =
        std::min_element(waypoints.begin(), waypoints.end(), [&](const Waypoint& a, const Waypoint& b) {
          return FlatDistance(a.position, here) < FlatDistance(b.position, here);
        });
    const double from = command.Number("from", 0);
    command.index = from >= 1 ? (static_cast<int>(from) - 1) % count : static_cast<int>(nearest - waypoints.begin());
    command.count = 0;
  }
  WalkOrder order;
  order.goal = waypoints[static_cast<std::size_t>(command.index)].position;
  order.within_m = 1;
  order.speed_mps = actor.speed_mps();
  order.slow_down = order.stands = false;
  const StepResult leg = WalkTo(actor, command, order);
  if (leg.state == StepResult::State::kFailed) return leg;
  const double rounds = command.Number("rounds", 0);
  if (leg.state == StepResult::State::kDone) {
    command.index = (command.index + 1) % count;
    command.best_tick = 0;  // The next part of the path is measured separately.
    ++command.count;
    if (rounds > 0 && command.count >= static_cast<int>(rounds) * count) return StepResult::Done();
  }
  return StepResult::Going(rounds > 0 ? static_cast<float>(command.count / (rounds * count)) : 0);
}

StepResult Stop(Actor&, Running&) {
  return StepResult::Done();
}

constexpr Conduct kMoveConducts[] = {
    {"move-to", MoveTo}, {"arrive", Arrive}, {"seek", Seek}, {"flee", Flee},
    {kWander, Wander},   {"patrol", Patrol}, {"stop", Stop},
};

}  // namespace

std::span<const Conduct> MovingConducts() {
  return kMoveConducts;
}

bool IsWalk(std::string_view command) {
  return std::ranges::any_of(kMoveConducts, [&](const Conduct& conduct) { return conduct.command == command; });
}

void ForeseeWander(Actor& actor, Running& command) {
  if (command.said.name != kWander) return;
  world::RandomStream random = actor.body().random();
  Running::FreeWay way;
  way.wanted = AlongHeading(Drift(actor, command, random));
  way.turn_before_deg = way.turn_deg = command.turn_deg;
  way.direction = FreeDirection(actor, way.wanted, kWanderAhead_m, world::kNoEntity, way.turn_deg);
  command.foreseen = way;
}

Vec3 FreeDirection(const Actor& actor, Vec3 wanted, float ahead_m, world::EntityId through, float& turn_deg) {
  const world::WaysAround ways = WaysOf(actor, ahead_m, through);
  const auto is_free = [&](Vec3 direction, float so_far_m) {
    return ways.IsOpen(direction, so_far_m + actor.body().Radius());
  };
  if (is_free(wanted, ahead_m)) {
    turn_deg = 0;
    return wanted;
  }
  const float heading = HeadingOf(wanted);
  const float side = turn_deg < 0 ? -1.0f : 1.0f;
  for (const float reach_m : {ahead_m, std::min(ahead_m, 0.8f)}) {
    // Once it passes an obstacle on one side, it stays on that side as long as that is open.
    for (const float sign : {side, -side}) {
      for (float turn = 15; turn <= 135; turn += 15) {
        const Vec3 tried = AlongHeading(heading + sign * turn);
        if (!is_free(tried, reach_m)) continue;
        const bool decided = turn_deg != 0;
        if (!decided && sign == side) {
          // If no side was chosen yet, uses the smaller turn of both sides.
          for (float other = 15; other < turn; other += 15) {
            const Vec3 mirrored = AlongHeading(heading - sign * other);
            if (!is_free(mirrored, reach_m)) continue;
            turn_deg = -sign * other;
            return mirrored;
          }
        }
        turn_deg = sign * turn;
        return tried;
      }
    }
  }
  return wanted;
}

StepResult WalkTo(Actor& actor, Running& command, const WalkOrder& order) {
  const Vec3 here = actor.body().Position();
  const float left_m = FlatDistance(here, order.goal);
  const std::uint64_t tick = actor.world().tick();
  actor.way().remaining_m = std::max(0.0f, left_m - order.within_m);
  if (command.best_tick == 0) {
    command.start_m = std::max(left_m, 0.01f);
    command.best_m = left_m;
    command.best_tick = command.mark_tick = tick;
  }
  if (left_m < command.best_m - kProgress_m) {
    command.best_m = left_m;
    command.mark_tick = tick;
  }
  const float speed = world::Length(Flat(actor.body().Velocity()));
  if (left_m <= order.within_m) {
    if (!order.stands || speed < 0.3f) return StepResult::Done();
    return StepResult::Going(1 - left_m / command.start_m);
  }
  // Walking around a long obstacle is progress, too. A body is blocked only if it hardly moves, or has circled for a
  // long time.
  const float stuck_s = static_cast<float>(tick - command.mark_tick) * StepOf(actor);
  if ((stuck_s > kBlockedAfter_s && speed < 0.3f) || stuck_s > 6 * kBlockedAfter_s)
    return StepResult::Failed("blocked");

  const std::optional<Vec3> next = NextCorner(actor, command, order);
  if (!next) return StepResult::Failed("no-way");
  Vec3 wanted = world::Normalized(Flat(*next - here));
  if (order.shun != world::kNoEntity) wanted = KeptAway(actor, command, order, wanted);
  const float ahead_m = std::min(FlatDistance(here, *next), 1.2f + 0.5f * order.speed_mps);
  float pace = order.speed_mps;
  if (order.slow_down) pace = std::min(pace, std::max(0.4f, 1.6f * (left_m - order.within_m * 0.5f)));
  actor.Walk(FreeDirection(actor, wanted, ahead_m, order.through, command.turn_deg) * pace);
  return StepResult::Going(1 - left_m / command.start_m);
}

ConductStep FindConduct(std::string_view command) {
  for (const auto& family :
       {MovingConducts(), FollowingConducts(), FightingConducts(), CarryingConducts(), OtherConducts()})
    for (const Conduct& conduct : family)
      if (conduct.command == command) return conduct.step;
  return nullptr;
}

}  // namespace soarbox::sim
