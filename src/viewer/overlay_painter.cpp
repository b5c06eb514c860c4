// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/overlay_painter.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "sim/foreign_kind.h"
#include "viewer/half_turn.h"
#include "viewer/interpolate.h"
#include "viewer/palette.h"

namespace soarbox::viewer {
namespace {

using world::AgentOverlay;
using world::AgentSnapshot;
using world::Color;
using world::Vec3;

constexpr float kTrailStep_m = 0.3f;
constexpr std::size_t kMostTrailPoints = 160;
constexpr int kMostPushesShown = 12;  ///< Maximum number of pushes shown per body; all of them count in the sum.
constexpr double kTracer_s = 0.7, kHitMark_s = 1.8;
constexpr Color kSight{1.0f, 0.93f, 0.55f, 1}, kHearing{0.55f, 0.85f, 1.0f, 1}, kVelocity{0.35f, 0.90f, 1.0f, 1},
    kForce{1.0f, 0.45f, 0.85f, 1}, kTracer{1.0f, 0.85f, 0.35f, 1}, kHit{1.0f, 0.22f, 0.12f, 1},
    kMiss{0.92f, 0.90f, 0.85f, 1}, kUnknown{0.60f, 0.62f, 0.66f, 0.8f};

Color Faded(Color color, float alpha) {
  color.a *= std::clamp(alpha, 0.0f, 1.0f);
  return color;
}

/// Lines need brighter colours than cloth.
Color Bright(Color color) {
  for (float* channel : {&color.r, &color.g, &color.b}) *channel = 0.30f + 0.70f * *channel;
  return color;
}

Color ColorOf(const AgentSnapshot& agent) {
  return Bright(agent.team.empty() ? AgentColor(agent.kind) : TeamColor(agent.team));
}

Vec3 FeetOf(const AgentSnapshot& agent) {
  return agent.position - Vec3{0, agent.height_m / 2, 0};
}

/// Draws lines, arrows and circles into a frame's marks.
class Pen {
 public:
  explicit Pen(OverlayMarks& marks) : marks_(marks) {}

  void Line(Vec3 from, Vec3 to, Color color) {
    if (world::IsFinite(from) && world::IsFinite(to)) marks_.lines.push_back({from, to, color});
  }
  void Dashes(Vec3 from, Vec3 to, Color color, float dash_m = 0.5f) {
    const float length = world::Distance(from, to);
    if (!(length < 1000)) return;
    const Vec3 along = world::Normalized(to - from);
    for (float at = 0; at < length; at += 2 * dash_m)
      Line(from + along * at, from + along * std::min(at + dash_m, length), color);
  }
  void Circle(Vec3 centre, float radius, Color color, bool dashed = false) {
    constexpr int kPieces = 48;
    for (int i = 0; i < kPieces; i += dashed ? 2 : 1)
      Line(OnCircle(centre, radius, Turn(i, kPieces)), OnCircle(centre, radius, Turn(i + 1, kPieces)), color);
  }
  void Arrow(Vec3 from, Vec3 to, Color color) {
    Line(from, to, color);
    const Vec3 along = world::Normalized(to - from);
    const Vec3 across = world::Normalized(Cross(along, Vec3{0, 1, 0}));
    const float head = std::min(0.35f, 0.4f * world::Distance(from, to));
    Line(to, to - along * head + across * (0.5f * head), color);
    Line(to, to - along * head - across * (0.5f * head), color);
  }
  void Cross3(Vec3 at, float size, Color color) {
    Line(at - Vec3{size, 0, 0}, at + Vec3{size, 0, 0}, color);
    Line(at - Vec3{0, size, 0}, at + Vec3{0, size, 0}, color);
    Line(at - Vec3{0, 0, size}, at + Vec3{0, 0, size}, color);
  }
  void Star(Vec3 at, float size, Color color) {
    for (const Vec3 arm : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{0.6f, 0.6f, 0.5f}, Vec3{-0.6f, 0.6f, 0.5f},
                           Vec3{0.6f, 0.6f, -0.5f}, Vec3{-0.6f, 0.6f, -0.5f}})
      Line(at - arm * size, at + arm * size, color);
  }
  /// A sector of a disc around a heading, filled if `fill` is visible.
  void Sector(Vec3 centre, float radius, float heading, float half_angle, Color edge, Color fill) {
    const int pieces = std::max(6, static_cast<int>(48 * half_angle / kPi));
    const bool is_whole = half_angle > 0.999f * kPi;
    Vec3 before = OnCircle(centre, radius, heading - half_angle);
    if (!is_whole) Line(centre, before, edge);
    for (int i = 1; i <= pieces; ++i) {
      const float angle = heading - half_angle + 2 * half_angle * static_cast<float>(i) / static_cast<float>(pieces);
      const Vec3 next = OnCircle(centre, radius, angle);
      Line(before, next, edge);
      if (fill.a > 0) marks_.triangles.push_back({centre, before, next, fill});
      before = next;
    }
    if (!is_whole) Line(before, centre, edge);
  }

 private:
  static float Turn(int i, int pieces) { return 2 * kPi * static_cast<float>(i) / static_cast<float>(pieces); }
  static Vec3 OnCircle(Vec3 centre, float radius, float heading) {
    return centre + Vec3{radius * std::sin(heading), 0, radius * std::cos(heading)};
  }

  OverlayMarks& marks_;
};

const AgentSnapshot* Find(const OverlayScene& scene, std::uint32_t id) {
  const auto at = std::find_if(scene.agents.begin(), scene.agents.end(), [id](const auto& a) { return a.id == id; });
  return at != scene.agents.end() ? &*at : nullptr;
}

bool IsSelected(const OverlayScene& scene, std::uint32_t id) {
  return std::find(scene.selection.begin(), scene.selection.end(), id) != scene.selection.end();
}

void PaintSenses(const AgentSnapshot& agent, const AgentOverlay& overlay, bool is_filled, Pen& pen) {
  if (!agent.alive) return;
  const Vec3 ground = FeetOf(agent) + Vec3{0, 0.09f, 0};
  if (overlay.measured) {
    // The agent knows the distance but not the direction: anywhere on the circle.
    const Vec3 place{overlay.measured->x, ground.y, overlay.measured->z};
    const float away = world::Distance(ground, place);
    if (away < 500) pen.Circle(ground, away, Faded(kSight, is_filled ? 0.8f : 0.4f), true);
    pen.Dashes(ground, place, Faded(kSight, is_filled ? 0.9f : 0.5f), 0.4f);
    pen.Circle(place, 0.3f, Faded(kSight, 0.9f));
  }
  if (!overlay.has_senses) return;
  const float heading = std::atan2(agent.forward.x, agent.forward.z);
  if (overlay.sight_m > 0) {
    const float half = overlay.view_deg / 2 * kPi / 180;
    pen.Sector(ground, overlay.sight_m, heading, half, Faded(kSight, is_filled ? 0.9f : 0.45f),
               Faded(kSight, is_filled ? 0.13f : 0));
  }
  if (overlay.hearing_m > 0) pen.Circle(ground, overlay.hearing_m, Faded(kHearing, is_filled ? 0.9f : 0.4f), true);
}

void PaintPath(const AgentSnapshot& agent, const AgentOverlay& overlay, Pen& pen) {
  if (overlay.path.empty() || !agent.alive) return;
  const Color color = ColorOf(agent);
  const auto lifted = [](Vec3 p) { return p + Vec3{0, 0.18f, 0}; };
  Vec3 before = lifted(FeetOf(agent));
  bool is_first = true;
  for (const Vec3 corner : overlay.path) {
    const Vec3 next = lifted(corner);
    if (is_first && overlay.path_is_whole) {
      before = next;  // The path includes passed corners: no line from the body.
    } else if (&corner == &overlay.path.back()) {
      pen.Arrow(before, next, color);
    } else {
      pen.Line(before, next, color);
    }
    pen.Circle(next, 0.14f, Faded(color, 0.8f));
    before = next;
    is_first = false;
  }
  if (!overlay.path_is_whole) pen.Circle(before, 0.45f, color);
}

void PaintTargets(const OverlayScene& scene, const AgentSnapshot& agent, const AgentOverlay& overlay, Pen& pen) {
  if (!agent.alive) return;
  const Color color = ColorOf(agent);
  if (const AgentSnapshot* target = Find(scene, overlay.target_id)) {
    pen.Arrow(agent.position + Vec3{0, 0.3f, 0}, target->position + Vec3{0, 0.3f, 0}, Faded(kHit, 0.85f));
    pen.Circle(target->position, target->radius_m * 1.9f, kHit);
  }
  if (const AgentSnapshot* leader = Find(scene, overlay.leader_id))
    pen.Dashes(agent.position, leader->position, Faded(color, 0.8f), 0.35f);
  if (overlay.goal) {
    const Vec3 goal{overlay.goal->x, FeetOf(agent).y + 0.12f, overlay.goal->z};
    if (overlay.path.empty()) pen.Dashes(FeetOf(agent) + Vec3{0, 0.12f, 0}, goal, Faded(color, 0.7f));
    pen.Circle(goal, 0.35f, color);
    pen.Line(goal, goal + Vec3{0, 1.6f, 0}, color);
    // A small flag that is visible from far away.
    pen.Line(goal + Vec3{0, 1.6f, 0}, goal + Vec3{0.5f, 1.4f, 0}, color);
    pen.Line(goal + Vec3{0.5f, 1.4f, 0}, goal + Vec3{0, 1.2f, 0}, color);
  }
}

void PaintShots(const OverlayScene& scene, Pen& pen) {
  for (const world::ShotSnapshot& shot : scene.overlays.shots) {
    if (shot.age_s < kTracer_s)
      pen.Line(shot.from, shot.to, Faded(kTracer, 1 - static_cast<float>(shot.age_s / kTracer_s)));
    if (shot.age_s >= kHitMark_s) continue;
    const float left = 1 - static_cast<float>(shot.age_s / kHitMark_s);
    if (shot.hit_agent_id == scene.inside && scene.inside != 0) continue;  // It would be in front of the camera.
    if (shot.hit_agent_id != 0)
      pen.Star(shot.to, 0.32f, Faded(kHit, 0.3f + left));
    else
      pen.Cross3(shot.to, 0.18f, Faded(kMiss, left));
  }
}

/// The other agents as one agent believes them to be, with a thread to their true positions.
void PaintBelief(const OverlayScene& scene, OverlayMarks& marks, Pen& pen) {
  constexpr float kSame_m = 0.4f;
  const AgentSnapshot* self = scene.selection.empty() ? nullptr : Find(scene, scene.selection.front());
  const auto own = std::find_if(scene.overlays.agents.begin(), scene.overlays.agents.end(),
                                [&](const AgentOverlay& a) { return self != nullptr && a.id == self->id; });
  if (self == nullptr || own == scene.overlays.agents.end() || !own->has_senses) return;
  for (const AgentSnapshot& other : scene.agents) {
    if (other.id == self->id) continue;
    const auto contact = std::find_if(own->contacts.begin(), own->contacts.end(),
                                      [&](const world::ContactSnapshot& c) { return c.agent_id == other.id; });
    const Vec3 feet = FeetOf(other) + Vec3{0, 0.07f, 0};
    if (contact == own->contacts.end()) {
      pen.Circle(feet, 0.6f, kUnknown, true);  // The agent knows nothing about this one.
      continue;
    }
    const auto confidence =
        contact->visible ? 1.0f : static_cast<float>(std::clamp(1 - contact->age_s / contact->memory_s, 0.0, 1.0));
    const Color color = ColorOf(other);
    if (world::Distance(contact->position, other.position) < kSame_m) {
      pen.Circle(feet, 0.6f, Faded(color, 0.35f + 0.65f * confidence), !contact->visible);
      continue;  // The belief is right: no ghost is needed.
    }
    char name[96];
    const char* how = contact->heard ? "heard " : "";
    if (contact->visible)
      std::snprintf(name, sizeof name, "%.40s", other.name.c_str());
    else
      std::snprintf(name, sizeof name, "%.40s \xc2\xb7 %s%.1f s ago", other.name.c_str(), how, contact->age_s);
    Ghost ghost;
    ghost.name = name;
    ghost.agent_id = other.id;
    if (!contact->alive) ghost.name += " \xc2\xb7 dead";
    ghost.position = contact->position;
    ghost.forward = contact->forward;
    ghost.color = color;
    ghost.opacity = 0.25f + 0.65f * confidence;
    ghost.radius_m = other.radius_m;
    ghost.height_m = other.height_m;
    marks.ghosts.push_back(std::move(ghost));
  }
}

}  // namespace

void PaintGhostThreads(const std::vector<Ghost>& ghosts, const std::vector<AgentSnapshot>& agents,
                       OverlayMarks& marks) {
  Pen pen(marks);
  for (const Ghost& ghost : ghosts) {
    if (ghost.is_name_only || !world::IsFinite(ghost.position)) continue;
    const Color color = Faded(Bright(ghost.color), 0.4f + ghost.opacity);
    pen.Circle(ghost.position - Vec3{0, ghost.height_m / 2 - 0.07f, 0}, 0.55f, color);
    const auto agent =
        std::find_if(agents.begin(), agents.end(), [&](const AgentSnapshot& a) { return a.id == ghost.agent_id; });
    if (ghost.agent_id == 0 || agent == agents.end() || !world::IsFinite(agent->position)) continue;
    pen.Dashes(ghost.position, agent->position, color, 0.25f);
  }
}

void OverlayPainter::Note(const world::SceneSnapshot& newest) {
  if (newest.tick == tick_ && newest.time_s == time_s_) return;
  // An earlier tick or another run: the trails are not valid.
  if (newest.tick < tick_ || newest.tick > tick_ + 300) courses_.clear();
  const auto seconds = static_cast<float>(newest.time_s - time_s_);
  tick_ = newest.tick;
  time_s_ = newest.time_s;
  for (const AgentSnapshot& agent : newest.agents) {
    if (!world::IsFinite(agent.position) || !world::IsFinite(agent.velocity)) continue;
    Course& course = courses_[agent.id];
    if (course.seen != 0 && seconds > 0) course.acceleration = (agent.velocity - course.velocity) / seconds;
    course.velocity = agent.velocity;
    course.seen = tick_ + 1;
    const Vec3 feet = FeetOf(agent);
    if (course.points.empty() || world::Distance(course.points.back(), feet) >= kTrailStep_m)
      course.points.push_back(feet);
    if (course.points.size() > kMostTrailPoints) course.points.pop_front();
  }
  std::erase_if(courses_, [this](const auto& entry) { return entry.second.seen != tick_ + 1; });
}

void OverlayPainter::PaintTrails(const OverlayScene& scene, OverlayMarks& marks) const {
  Pen pen(marks);
  const Vec3 lift{0, 0.06f, 0};
  for (const AgentSnapshot& agent : scene.agents) {
    const auto found = courses_.find(agent.id);
    if (found == courses_.end()) continue;
    const std::deque<Vec3>& points = found->second.points;
    const Color color = ColorOf(agent);
    for (std::size_t i = 1; i <= points.size(); ++i) {
      const Vec3 from = points[i - 1], to = i < points.size() ? points[i] : FeetOf(agent);
      if (world::Distance(from, to) > kJump_m) continue;  // The agent was placed there.
      const float age = static_cast<float>(points.size() - i) / static_cast<float>(kMostTrailPoints);
      pen.Line(from + lift, to + lift, Faded(color, 0.95f * (1 - age)));
    }
  }
}

namespace {

/// An arrow around the axis of an angular push; a turn per second is a full circle.
void PaintSpin(Vec3 centre, Vec3 spin_rad_s, Color color, Pen& pen) {
  const float strength = world::Length(spin_rad_s);
  if (!(strength > 0.05f) || !world::IsFinite(centre)) return;
  constexpr int kPieces = 28;
  constexpr float kRadius_m = 0.9f;
  const Vec3 axis = spin_rad_s / strength;
  const Vec3 aside = std::abs(axis.y) < 0.9f ? Vec3{0, 1, 0} : Vec3{1, 0, 0};
  const Vec3 a = world::Normalized(Cross(axis, aside)), b = Cross(axis, a);
  const float whole = std::clamp(strength, 0.35f, 1.85f * kPi);
  const auto at = [&](int i) {
    const float angle = whole * static_cast<float>(i) / kPieces;
    return centre + (a * std::cos(angle) + b * std::sin(angle)) * kRadius_m;
  };
  for (int i = 0; i + 1 < kPieces; ++i) pen.Line(at(i), at(i + 1), color);
  const Vec3 tip = at(kPieces), along = world::Normalized(tip - at(kPieces - 1)), out = world::Normalized(tip - centre);
  pen.Line(at(kPieces - 1), tip, color);
  pen.Line(tip, tip - along * 0.28f + out * 0.14f, color);
  pen.Line(tip, tip - along * 0.28f - out * 0.14f, color);
}

}  // namespace

void OverlayPainter::PaintForces(const OverlayScene& scene, OverlayMarks& marks) const {
  Pen pen(marks);
  // An acceleration of 10 m/s² is two metres long. The length is limited, because collisions and impulses would fill
  // the picture.
  const auto arrow = [&pen](Vec3 from, Vec3 acceleration, Color color) {
    Vec3 push = acceleration * 0.2f;
    if (const float length = world::Length(push); length > 4) push = push * (4 / length);
    if (world::Length(push) > 0.04f) pen.Arrow(from, from + push, color);
  };
  const Vec3 lift{0, 0.15f, 0};
  for (const AgentSnapshot& agent : scene.agents) {
    const auto found = courses_.find(agent.id);
    if (found == courses_.end() || !agent.alive) continue;
    const Vec3 from = agent.position + Vec3{0, 0.1f, 0};
    const Vec3 velocity{agent.velocity.x, 0, agent.velocity.z};
    if (world::Length(velocity) > 0.05f) pen.Arrow(from, from + velocity * 0.6f, kVelocity);
    if (scene.overlays.has_pushes) continue;
    // If the applied forces are not known, shows the resulting acceleration.
    const Vec3 acceleration = found->second.acceleration;
    arrow(from + lift, {acceleration.x, 0, acceleration.z}, kForce);
  }
  // Each push that a script or a command gave a body. If there are several, the bright arrow is their sum.
  struct Sum {
    Vec3 from, acceleration;
    int count = 0;
  };
  std::map<std::uint32_t, Sum> sums;
  for (const world::PushSnapshot& push : scene.overlays.pushes) {
    if (!(push.mass_kg > 0)) continue;
    const AgentSnapshot* agent = Find(scene, push.owner_id);
    if (push.spin_rad_s != Vec3{}) {
      PaintSpin(agent != nullptr ? agent->position : push.position, push.spin_rad_s, kForce, pen);
      continue;
    }
    Sum& sum = sums[push.owner_id];
    sum.from = (agent != nullptr ? agent->position + Vec3{0, 0.1f, 0} : push.position) + lift;
    sum.acceleration += push.force_n / push.mass_kg;
    if (++sum.count <= kMostPushesShown) arrow(sum.from, push.force_n / push.mass_kg, Faded(kForce, 0.45f));
  }
  for (const auto& [owner, sum] : sums) arrow(sum.from, sum.acceleration, kForce);
}

void OverlayPainter::Paint(const OverlayScene& scene, OverlayMarks& marks) const {
  const auto is_on = [&](ViewerCommand command) { return scene.on[static_cast<std::size_t>(command)]; };
  Pen pen(marks);
  if (is_on(ViewerCommand::kTrails)) PaintTrails(scene, marks);
  if (is_on(ViewerCommand::kForces)) PaintForces(scene, marks);
  // A dashed ring around agents that another simulation moves.
  for (const AgentSnapshot& agent : scene.agents) {
    if (!is_on(ViewerCommand::kLabels) || agent.kind != sim::kForeignKind || !agent.alive ||
        !world::IsFinite(agent.position))
      continue;
    const Color color = agent.team.empty() ? AgentColor(agent.kind) : TeamColor(agent.team);
    pen.Circle(agent.position - Vec3{0, agent.height_m / 2 - 0.06f, 0}, agent.radius_m * 2, color, true);
  }
  for (const AgentOverlay& overlay : scene.overlays.agents) {
    const AgentSnapshot* agent = Find(scene, overlay.id);
    if (agent == nullptr || !world::IsFinite(agent->position)) continue;
    const bool is_selected = IsSelected(scene, overlay.id);
    if (is_on(ViewerCommand::kSenses) && (is_selected || scene.selection.empty()))
      PaintSenses(*agent, overlay, is_selected, pen);
    if (is_on(ViewerCommand::kPaths)) PaintPath(*agent, overlay, pen);
    if (is_on(ViewerCommand::kTargets)) PaintTargets(scene, *agent, overlay, pen);
  }
  if (is_on(ViewerCommand::kShots)) PaintShots(scene, pen);
  if (is_on(ViewerCommand::kBelief)) PaintBelief(scene, marks, pen);
  // These data are only there if they were requested.
  const auto& more = scene.overlays;
  marks.lines.insert(marks.lines.end(), more.lines.begin(), more.lines.end());
  marks.triangles.insert(marks.triangles.end(), more.triangles.begin(), more.triangles.end());
}

}  // namespace soarbox::viewer
