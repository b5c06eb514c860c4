// SPDX-License-Identifier: BSD-2-Clause
#include "world/physics_sight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "world/physics_crowd.h"

namespace soarbox::world {
namespace {

/// A segment as bounding boxes are tested against it. Four numbers at a time: the fourth is no coordinate.
class Probe {
 public:
  Probe(const btVector3& from, const btVector3& to) {
    constexpr btScalar kLarge = 1e18f;
    const btVector3 along = to - from;
    for (int axis = 0; axis < 3; ++axis) inverse_[axis] = along[axis] != 0 ? 1 / along[axis] : kLarge;
    for (int axis = 0; axis < 3; ++axis) from_[axis] = from[axis];
  }

  /// Whether the segment up to this share meets the box.
  bool Meets(const btDbvtVolume& box, btScalar share) const {
    const Four a = (Load(box.Mins()) - from_) * inverse_, b = (Load(box.Maxs()) - from_) * inverse_;
    const Four enter = a < b ? a : b, leave = a < b ? b : a;
    return std::max(std::max(enter[0], enter[1]), std::max(enter[2], btScalar{0})) <=
           std::min(std::min(leave[0], leave[1]), std::min(leave[2], share));
  }

 private:
  using Four [[gnu::vector_size(16)]] = btScalar;
  static Four Load(const btVector3& vector) {
    static_assert(sizeof(Four) == sizeof(btVector3));
    Four loaded;
    std::memcpy(&loaded, &vector, sizeof(loaded));  // Not aligned.
    return loaded;
  }

  Four from_{}, inverse_{};
};

/// Calls visit(box, body) for each body below a node whose bounding box `meets` accepts, like those of all nodes above
/// it. Ends when visit answers false; returns whether it never did.
template <class Meets, class Visit>
bool VisitTree(const btDbvtNode* root, const Meets& meets, const Visit& visit) {
  std::array<const btDbvtNode*, 64> waiting;
  std::size_t count = 0;
  for (const btDbvtNode* node = root; node != nullptr; node = count > 0 ? waiting[--count] : nullptr) {
    if (!meets(node->volume)) continue;
    if (node->isleaf()) {
      const auto* proxy = static_cast<const btBroadphaseProxy*>(node->data);
      if (!visit(node->volume, *static_cast<const btCollisionObject*>(proxy->m_clientObject))) return false;
      continue;
    }
    for (const btDbvtNode* child : {node->childs[0], node->childs[1]}) {
      if (count < waiting.size()) {
        waiting[count++] = child;
      } else if (!VisitTree(child, meets, visit)) {
        return false;  // A tree this deep is rare: it continues on a list of its own.
      }
    }
  }
  return true;
}

template <class Meets, class Visit>
bool VisitTrees(const CrowdBroadphase& bodies, const Meets& meets, const Visit& visit) {
  for (const btDbvt* tree : bodies.Trees())
    if (tree->m_root != nullptr && !VisitTree(tree->m_root, meets, visit)) return false;
  return true;
}

/// Each body whose bounding box the segment meets up to `share`, which visit may lessen.
template <class Visit>
bool VisitBodies(const CrowdBroadphase& bodies, const btVector3& from, const btVector3& to, btScalar& share,
                 const Visit& visit) {
  const Probe probe(from, to);
  return VisitTrees(
      bodies, [&](const btDbvtVolume& box) { return probe.Meets(box, share); },
      [&](const btDbvtVolume&, const btCollisionObject& body) { return visit(body); });
}

/// Takes the body for the first hit if it is entered no later; of several at one point the one of the smallest owner.
void TakeIfFirst(const btCollisionObject& body, const btVector3& from, const btVector3& to, FirstHit& first,
                 btScalar& share) {
  const auto entry = EntryOf(body, from, to);
  if (!entry || entry->fraction > share) return;
  const bool ties = first.body != nullptr && entry->fraction == share;
  if (ties && body.getUserIndex() >= first.body->getUserIndex()) return;
  first = {&body, *entry};
  share = entry->fraction;
}

/// Whether the segment enters the body before `share` of it.
bool IsEnteredBefore(const btCollisionObject& body, const btVector3& from, const btVector3& to, btScalar share) {
  const auto entry = EntryOf(body, from, to);
  return entry && entry->fraction < share;
}

/// What a body fills, seen from above.
struct Circle {
  btScalar x, z, radius;
};

Circle CircleAround(const btCollisionObject& body, const btDbvtVolume& box) {
  const btTransform& place = body.getWorldTransform();
  const bool stands = place.getBasis()[1][1] == 1;
  if (stands && body.getCollisionShape()->getShapeType() == CAPSULE_SHAPE_PROXYTYPE) {
    const auto& capsule = static_cast<const btCapsuleShape&>(*body.getCollisionShape());
    return {place.getOrigin().x(), place.getOrigin().z(), capsule.getRadius()};
  }
  const btVector3 center = box.Center(), half = box.Extents();
  return {center.x(), center.z(), std::sqrt(half.x() * half.x() + half.z() * half.z())};
}

/// The part of the segment in front of the target's surface; all of it if there is none.
btScalar ShareInFrontOf(const btCollisionObject* target, const btVector3& from, const btVector3& to) {
  if (target == nullptr) return 1;
  // What stands behind the target's surface, or leans into it, hides nothing.
  const auto surface = EntryOf(*target, from, to);
  return surface ? surface->fraction : 1;
}

}  // namespace

FirstHit FindFirstHit(const CrowdBroadphase& bodies, const btVector3& from, const btVector3& to) {
  FirstHit first;
  btScalar share = 1;
  VisitBodies(bodies, from, to, share, [&](const btCollisionObject& body) {
    TakeIfFirst(body, from, to, first, share);
    return true;
  });
  return first;
}

NearBodies::NearBodies(const CrowdBroadphase& bodies, const btVector3& low, const btVector3& high) {
  constexpr std::size_t kUsual = 48;
  bodies_.reserve(kUsual);
  const btDbvtVolume wanted = btDbvtVolume::FromMM(low, high);
  VisitTrees(
      bodies, [&](const btDbvtVolume& box) { return Intersect(box, wanted); },
      [&](const btDbvtVolume& box, const btCollisionObject& body) {
        bodies_.push_back({box, &body});
        return true;
      });
  circles_.resize((bodies_.size() + kLanes - 1) / kLanes);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Circle circle = CircleAround(*bodies_[i].body, bodies_[i].box);
    // More than what rounding can take away.
    constexpr btScalar kSlack_m = 0.02f, kSlack = 4e-6f;
    const btScalar far = std::abs(circle.x) + std::abs(circle.z) + (high - low).x() + circle.radius;
    Circles& circles = circles_[i / kLanes];
    circles.x[i % kLanes] = circle.x;
    circles.z[i % kLanes] = circle.z;
    circles.radius[i % kLanes] = circle.radius + kSlack_m + kSlack * far;
  }
}

/// Calls visit for each body that the segment may enter, until it answers false; returns whether it never did.
template <class Visit>
bool NearBodies::VisitNear(const btVector3& from, const btVector3& to, const Visit& visit) const {
  const btScalar dx = to.x() - from.x(), dz = to.z() - from.z();
  const btScalar length = std::sqrt(dx * dx + dz * dz);
  for (std::size_t n = 0; n < circles_.size(); ++n) {
    const Circles& four = circles_[n];
    // How far its centre is beside the segment and along it, and its radius, all times the segment's length.
    const Four x = four.x - from.x(), z = four.z - from.z();
    const Four beside = x * dz - z * dx, along = x * dx + z * dz, radius = four.radius * length;
    const auto near =
        (beside <= radius) & (beside >= -radius) & (along >= -radius) & (along <= radius + length * length);
    std::uint64_t halves[2];
    static_assert(sizeof(halves) == sizeof(near));
    std::memcpy(halves, &near, sizeof(halves));
    if ((halves[0] | halves[1]) == 0) continue;
    for (std::size_t lane = 0; lane < kLanes && n * kLanes + lane < bodies_.size(); ++lane)
      if (near[lane] != 0 && !visit(bodies_[n * kLanes + lane])) return false;
  }
  return true;
}

FirstHit NearBodies::FindFirst(const btVector3& from, const btVector3& to) const {
  FirstHit first;
  btScalar share = 1;
  const Probe probe(from, to);
  VisitNear(from, to, [&](const Boxed& each) {
    if (probe.Meets(each.box, share)) TakeIfFirst(*each.body, from, to, first, share);
    return true;
  });
  return first;
}

bool NearBodies::IsOpen(const btVector3& from, const btVector3& to, int owner, int other) const {
  const Probe probe(from, to);
  const auto is_of_these = [&](const Boxed& each) {
    const int its = each.body->getUserIndex();
    return its == owner || its == other;
  };
  const auto enters = [&](const Boxed& each) {
    return probe.Meets(each.box, 1) && EntryOf(*each.body, from, to).has_value();
  };
  if (VisitNear(from, to, [&](const Boxed& each) { return is_of_these(each) || !enters(each); })) return true;
  // Something is in the way, unless one of these stands in front of it.
  if (VisitNear(from, to, [&](const Boxed& each) { return !is_of_these(each) || !enters(each); })) return false;
  const int first = FindFirst(from, to).body->getUserIndex();
  return first == owner || first == other;
}

bool IsClear(const CrowdBroadphase& bodies, const btVector3& from, const btVector3& to, const btCollisionObject* viewer,
             const btCollisionObject* target) {
  btScalar share = ShareInFrontOf(target, from, to);
  return VisitBodies(bodies, from, to, share, [&](const btCollisionObject& body) {
    return &body == viewer || &body == target || !IsEnteredBefore(body, from, to, share);
  });
}

bool NearBodies::IsClear(const btVector3& from, const btVector3& to, const btCollisionObject* viewer,
                         const btCollisionObject* target) const {
  const btScalar share = ShareInFrontOf(target, from, to);
  const Probe probe(from, to);
  return VisitNear(from, to, [&](const Boxed& each) {
    return each.body == viewer || each.body == target || !probe.Meets(each.box, share) ||
           !IsEnteredBefore(*each.body, from, to, share);
  });
}

}  // namespace soarbox::world
