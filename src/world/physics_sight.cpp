// SPDX-License-Identifier: BSD-2-Clause
#include "world/physics_sight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "world/limits.h"

namespace soarbox::world {
namespace {

/// Calls visit for each body whose bounding box the segment intersects up to `share`, which visit may reduce. Stops
/// when visit returns false.
template <class Visit>
bool VisitBodies(const AllBodies& bodies, const btVector3& from, const btVector3& to, btScalar& share,
                 const Visit& visit) {
  const Probe probe(from, to);
  if (bodies.AreInField(from, to)) {
    return bodies.field.VisitAlong(
        from, to, [&](const BoxedBody& each) { return !probe.Meets(each.box, share) || visit(*each.body); });
  }
  return VisitTrees(
      bodies.trees, [&](const btDbvtVolume& box) { return probe.Meets(box, share); },
      [&](const btDbvtVolume&, const btCollisionObject& body) { return visit(body); });
}

/// Whether the segment enters the body before the fraction `share`.
bool IsEnteredBefore(const btCollisionObject& body, const btVector3& from, const btVector3& to, btScalar share) {
  const auto entry = EntryOf(body, from, to);
  return entry && entry->fraction < share;
}

/// The borders of a view, seen from above.
class Edges {
 public:
  explicit Edges(const View& view) {
    constexpr float kSlack_deg = 0.5f;
    const float angle = (view.angle_deg / 2 + kSlack_deg) * std::numbers::pi_v<float> / 180;
    const float length = std::sqrt(view.forward.x * view.forward.x + view.forward.z * view.forward.z);
    constexpr float kLeast = 1e-3f;
    if (!(length > kLeast) || !(angle < std::numbers::pi_v<float>)) return;
    const float x = view.forward.x / length, z = view.forward.z / length;
    const float sine = std::sin(angle), cosine = std::cos(angle);
    // Unit vectors into the view from its left and its right border.
    left_x_ = sine * x - cosine * z;
    left_z_ = sine * z + cosine * x;
    right_x_ = sine * x + cosine * z;
    right_z_ = sine * z - cosine * x;
    is_wide_ = cosine < 0;
    is_open_ = false;
  }

  /// Whether a circle at this position relative to the viewer is outside the view.
  bool AreBeside(btScalar x, btScalar z, btScalar radius) const {
    const bool left = x * left_x_ + z * left_z_ < -radius, right = x * right_x_ + z * right_z_ < -radius;
    return !is_open_ && (is_wide_ ? left && right : left || right);
  }

 private:
  btScalar left_x_ = 0, left_z_ = 0, right_x_ = 0, right_z_ = 0;
  bool is_wide_ = false, is_open_ = true;
};

/// The part of the segment before the target's surface; the entire segment if there is no target.
btScalar ShareInFrontOf(const btCollisionObject* target, const btVector3& from, const btVector3& to) {
  if (target == nullptr) return 1;
  // Bodies behind the target's surface, or that overlap it, hide nothing.
  const auto surface = EntryOf(*target, from, to);
  return surface ? surface->fraction : 1;
}

/// An upper bound of the horizontal extent of the target around that point.
btScalar ReachOf(const btCollisionObject* target, const btVector3& place) {
  if (target == nullptr) return 0;
  const btCollisionShape& shape = *target->getCollisionShape();
  btVector3 middle = target->getWorldTransform().getOrigin();
  btScalar radius = 0;
  if (shape.getShapeType() == CAPSULE_SHAPE_PROXYTYPE && Stands(*target)) {
    radius = static_cast<const btCapsuleShape&>(shape).getRadius();
  } else {
    shape.getBoundingSphere(middle, radius);
    middle = target->getWorldTransform() * middle;
  }
  const btVector3 off = middle - place;
  return radius + std::sqrt(off.x() * off.x() + off.z() * off.z());
}

}  // namespace

FirstHit FindFirstHit(const AllBodies& bodies, const btVector3& from, const btVector3& to) {
  FirstHit first;
  btScalar share = 1;
  VisitBodies(bodies, from, to, share, [&](const btCollisionObject& body) {
    TakeIfFirst(body, from, to, first, share);
    return true;
  });
  return first;
}

bool EntersNothing(const AllBodies& bodies, const btVector3& from, const btVector3& to) {
  if (!bodies.AreInField(from, to)) return FindFirstHit(bodies, from, to).body == nullptr;
  // Seen from above, most bodies near a short segment are beside it.
  const btVector3 along = to - from;
  const btScalar length = std::sqrt(along.x() * along.x() + along.z() * along.z());
  const btScalar slack_m = SlackAbout(from, length);
  const Probe probe(from, to);
  return bodies.field.VisitAlong(from, to, [&](const BoxedBody& each) {
    const btScalar beside = (each.x - from.x()) * along.z() - (each.z - from.z()) * along.x();
    return std::abs(beside) > (each.radius + slack_m) * length || !probe.Meets(each.box, 1) ||
           !EntryOf(*each.body, from, to);
  });
}

NearBodies::NearBodies(const AllBodies& bodies, const View& view)
    : slack_m_(SlackAbout(ToBullet(view.place), view.range_m)) {
  constexpr std::size_t kUsual = 48;
  bodies_.reserve(kUsual);
  constexpr float kBeyond_m = 0.1f, kHigh_m = 1e6f;
  const Vec3 reach{view.range_m + kBeyond_m, kHigh_m, view.range_m + kBeyond_m};
  const btVector3 low = ToBullet(LimitPosition(view.place - reach)), high = ToBullet(LimitPosition(view.place + reach));
  const Edges edges(view);
  VisitTouching(bodies, low, high, [&](const BoxedBody& each) {
    const btScalar x = each.x - view.place.x, z = each.z - view.place.z, radius = each.radius + slack_m_;
    const btScalar reach = view.range_m + kBeyond_m + radius;
    if (x * x + z * z > reach * reach || edges.AreBeside(x, z, radius)) return;
    if (const std::optional<WorldPlane> plane = PlaneOf(*each.body)) {
      planes_.push_back({each, *plane});
      return;
    }
    bodies_.push_back(each);
    bodies_.back().x = x;
    bodies_.back().z = z;
  });
  directions_.Reset(bodies_.size());
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    directions_.Add(i, bodies_[i].x, bodies_[i].z, bodies_[i].radius + slack_m_);
}

/// A line of sight to two points, one above the other, seen from above.
struct NearBodies::Line {
  Line(const btVector3& from, const btVector3& to, const btVector3& other)
      : start(from),
        x(to.x() - from.x()),
        z(to.z() - from.z()),
        length(std::sqrt(x * x + z * z)),
        eyes(from.y()),
        rise{to.y() - from.y(), other.y() - from.y()} {}

  /// Whether one of the two lines may cross the plane.
  bool MayCross(const WorldPlane& plane, btScalar slack_m) const {
    const btScalar above = plane.HeightOf(start);
    const btScalar level = above + plane.normal.x() * x + plane.normal.z() * z;
    const btScalar one = level + plane.normal.y() * rise[0], other = level + plane.normal.y() * rise[1];
    return std::min({above, one, other}) < slack_m && std::max({above, one, other}) > -slack_m;
  }

  btVector3 start;
  btScalar x, z, length, eyes;
  btScalar rise[2];
};

/// Calls visit for each body that the line may enter, with the positions of its centre along and beside the line, both
/// multiplied by the line's length. If visit returns false, stops and returns false.
template <class Visit>
bool NearBodies::VisitNear(const Line& line, const Visit& visit) const {
  for (const Plane& plane : planes_)
    if (line.MayCross(plane.plane, slack_m_) && !visit(plane.body, 0, 0)) return false;
  const btScalar length_2 = line.length * line.length;
  return directions_.VisitAlong(line.x, line.z, [&](std::size_t i) {
    const BoxedBody& each = bodies_[i];
    const btScalar along = each.x * line.x + each.z * line.z, beside = each.x * line.z - each.z * line.x;
    const btScalar radius = (each.radius + slack_m_) * line.length;
    const bool near = std::abs(beside) <= radius && along >= -radius && along <= radius + length_2;
    return !near || visit(each, along, beside);
  });
}

/// Whether a body certainly hides everything beyond the fraction `before`: the line passes through it at the point
/// nearest to its axis.
bool NearBodies::HidesForCertain(const BoxedBody& each, const Line& line, btScalar rise, btScalar before,
                                 btScalar along, btScalar beside) const {
  const btScalar length_2 = line.length * line.length;
  if (!each.IsPillar() || !(along > 0) || !(along < before * length_2)) return false;
  const btScalar radius = each.radius - slack_m_, off = beside / line.length, share = along / length_2;
  const btScalar height = line.eyes + rise * share;
  const btScalar past = std::max({each.low - height, height - each.high, btScalar{0}});
  // The eyes are outside the body.
  const btScalar away = along / line.length, outer = each.radius + slack_m_;
  return radius > 0 && off * off + past * past < radius * radius && off * off + away * away > outer * outer;
}

/// Whether the point is certainly inside the body, so that no segment from there enters it.
bool NearBodies::IsInside(const BoxedBody& each, const btVector3& point) const {
  const btScalar radius = each.radius - slack_m_;
  const btScalar past = std::max({each.low - point.y(), point.y() - each.high, btScalar{0}});
  return each.IsPillar() && radius > 0 && each.x * each.x + each.z * each.z + past * past < radius * radius;
}

bool IsClear(const AllBodies& bodies, const btVector3& from, const btVector3& to, const btCollisionObject* viewer,
             const btCollisionObject* target) {
  btScalar share = ShareInFrontOf(target, from, to);
  return VisitBodies(bodies, from, to, share, [&](const btCollisionObject& body) {
    return &body == viewer || &body == target || !IsEnteredBefore(body, from, to, share);
  });
}

FirstHit NearBodies::FindFirst(const btVector3& from, const btVector3& to) const {
  FirstHit first;
  btScalar share = 1;
  const Probe probe(from, to);
  VisitNear(Line(from, to, to), [&](const BoxedBody& each, btScalar, btScalar) {
    if (probe.Meets(each.box, share)) TakeIfFirst(*each.body, from, to, first, share);
    return true;
  });
  return first;
}

bool NearBodies::MeetsNoOther(const btVector3& from, const btVector3& to, int viewer, int target) const {
  struct Other {
    const BoxedBody* body;
    btScalar along, beside;
  };
  std::array<Other, 32> others;
  std::array<const BoxedBody*, 4> own;
  std::size_t count = 0, own_count = 0;
  const Line line(from, to, to);
  // The line enters the target only after this fraction.
  btScalar before = 1;
  bool is_inside_own = true;
  const bool are_all = VisitNear(line, [&](const BoxedBody& each, btScalar along, btScalar beside) {
    const int owner = each.body->getUserIndex();
    if (owner != viewer && owner != target) {
      others[count++] = {&each, along, beside};
      return count < others.size();
    }
    own[own_count++] = &each;
    if (owner == viewer) {
      is_inside_own = is_inside_own && IsInside(each, from);
    } else {
      const btScalar x = each.x - line.x, z = each.z - line.z;
      before = std::min(before, 1 - (each.radius + slack_m_ + std::sqrt(x * x + z * z)) / line.length);
    }
    return own_count < own.size();
  });
  if (!are_all) {
    const FirstHit first = FindFirst(from, to);
    return first.body == nullptr || first.body->getUserIndex() == viewer || first.body->getUserIndex() == target;
  }
  // Usually no other body is near the segment, or one of them certainly hides the target.
  for (std::size_t i = 0; i < count && is_inside_own; ++i)
    if (HidesForCertain(*others[i].body, line, line.rise[0], before, others[i].along, others[i].beside)) return false;
  FirstHit first;
  btScalar share = 1;
  const Probe probe(from, to);
  const auto take = [&](const BoxedBody& each) {
    if (probe.Meets(each.box, share)) TakeIfFirst(*each.body, from, to, first, share);
  };
  for (std::size_t i = 0; i < count; ++i) take(*others[i].body);
  if (first.body == nullptr) return true;
  const btCollisionObject* const other = first.body;
  for (std::size_t i = 0; i < own_count; ++i) take(*own[i]);
  return first.body != other;
}

bool NearBodies::IsClearToEither(const btVector3& from, const btVector3& to, const btVector3& other,
                                 const btCollisionObject* viewer, const btCollisionObject* target) const {
  const Line line(from, to, other);
  // The line enters the target only after this fraction.
  const btScalar before = line.length > 0 ? 1 - (ReachOf(target, to) + slack_m_) / line.length : 0;
  // Usually the result is certain. Other bodies that may be between are tested like any segment.
  std::array<const BoxedBody*, 32> between;
  std::size_t count = 0;
  bool is_hidden[2] = {};
  VisitNear(line, [&](const BoxedBody& each, btScalar along, btScalar beside) {
    if (each.body == viewer || each.body == target) return true;
    between[count++] = &each;
    for (int n : {0, 1})
      is_hidden[n] = is_hidden[n] || HidesForCertain(each, line, line.rise[n], before, along, beside);
    return count < between.size() && !(is_hidden[0] && is_hidden[1]);
  });
  if (count == 0) return true;
  for (int n : {0, 1}) {
    if (is_hidden[n]) continue;
    const btVector3& end = n == 0 ? to : other;
    const btScalar share = ShareInFrontOf(target, from, end);
    const Probe probe(from, end);
    const auto hides = [&](const BoxedBody& each) {
      return probe.Meets(each.box, share) && IsEnteredBefore(*each.body, from, end, share);
    };
    if (std::any_of(between.begin(), between.begin() + count, [&](const BoxedBody* each) { return hides(*each); }))
      continue;
    if (count < between.size() || VisitNear(line, [&](const BoxedBody& each, btScalar, btScalar) {
          return each.body == viewer || each.body == target || !hides(each);
        }))
      return true;
  }
  return false;
}

}  // namespace soarbox::world
