// SPDX-License-Identifier: BSD-2-Clause
#include "world/physics_sight.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "world/physics_crowd.h"

namespace soarbox::world {
namespace {

/// A segment as bounding boxes are tested against it.
class Probe {
 public:
  Probe(const btVector3& from, const btVector3& to) : from_(from) {
    constexpr btScalar kLarge = 1e18f;
    const btVector3 along = to - from;
    for (int axis = 0; axis < 3; ++axis) inverse_[axis] = along[axis] != 0 ? 1 / along[axis] : kLarge;
  }

  /// Whether the segment up to this share meets the box.
  bool Meets(const btDbvtVolume& box, btScalar share) const {
    btScalar first = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const btScalar a = (box.Mins()[axis] - from_[axis]) * inverse_[axis];
      const btScalar b = (box.Maxs()[axis] - from_[axis]) * inverse_[axis];
      first = std::max(first, std::min(a, b));
      share = std::min(share, std::max(a, b));
    }
    return first <= share;
  }

 private:
  btVector3 from_, inverse_{0, 0, 0};
};

/// Calls visit(body) for each body whose bounding box the segment meets up to `share`, which visit may lessen. Ends
/// when visit answers false; returns whether it never did.
template <class Visit>
bool VisitTree(const btDbvtNode* root, const Probe& probe, btScalar& share, const Visit& visit) {
  std::array<const btDbvtNode*, 64> waiting;
  std::size_t count = 0;
  for (const btDbvtNode* node = root; node != nullptr; node = count > 0 ? waiting[--count] : nullptr) {
    if (!probe.Meets(node->volume, share)) continue;
    if (node->isleaf()) {
      const auto* proxy = static_cast<const btBroadphaseProxy*>(node->data);
      if (!visit(*static_cast<const btCollisionObject*>(proxy->m_clientObject))) return false;
      continue;
    }
    for (const btDbvtNode* child : {node->childs[0], node->childs[1]}) {
      if (count < waiting.size()) {
        waiting[count++] = child;
      } else if (!VisitTree(child, probe, share, visit)) {
        return false;  // A tree this deep is rare: it continues on a list of its own.
      }
    }
  }
  return true;
}

template <class Visit>
bool VisitBodies(const CrowdBroadphase& bodies, const btVector3& from, const btVector3& to, btScalar& share,
                 const Visit& visit) {
  const Probe probe(from, to);
  for (const btDbvt* tree : bodies.Trees())
    if (tree->m_root != nullptr && !VisitTree(tree->m_root, probe, share, visit)) return false;
  return true;
}

}  // namespace

FirstHit FindFirstHit(const CrowdBroadphase& bodies, const btVector3& from, const btVector3& to) {
  FirstHit first;
  btScalar share = 1;
  VisitBodies(bodies, from, to, share, [&](const btCollisionObject& body) {
    const auto entry = EntryOf(body, from, to);
    if (!entry || entry->fraction > share) return true;
    const bool ties = first.body != nullptr && entry->fraction == share;
    if (ties && body.getUserIndex() >= first.body->getUserIndex()) return true;
    first = {&body, *entry};
    share = entry->fraction;
    return true;
  });
  return first;
}

bool IsClear(const CrowdBroadphase& bodies, const btVector3& from, const btVector3& to, const btCollisionObject* viewer,
             const btCollisionObject* target) {
  btScalar share = 1;
  if (target != nullptr) {
    // What stands behind the target's surface, or leans into it, hides nothing.
    if (const auto surface = EntryOf(*target, from, to)) share = surface->fraction;
  }
  const btScalar limit = share;
  return VisitBodies(bodies, from, to, share, [&](const btCollisionObject& body) {
    if (&body == viewer || &body == target) return true;
    const auto entry = EntryOf(body, from, to);
    return !entry || entry->fraction >= limit;
  });
}

}  // namespace soarbox::world
