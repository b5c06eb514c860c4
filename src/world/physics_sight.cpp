// SPDX-License-Identifier: BSD-2-Clause
#include "world/physics_sight.h"

#include <algorithm>
#include <array>
#include <cmath>
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

FirstHit FindFirstHit(const std::vector<BoxedBody>& bodies, const btVector3& from, const btVector3& to) {
  FirstHit first;
  btScalar share = 1;
  const Probe probe(from, to);
  for (const BoxedBody& each : bodies) {
    if (probe.Meets(each.box, share)) TakeIfFirst(*each.body, from, to, first, share);
  }
  return first;
}

void FindInBox(const CrowdBroadphase& bodies, const btVector3& low, const btVector3& high,
               std::vector<BoxedBody>& found) {
  const btDbvtVolume wanted = btDbvtVolume::FromMM(low, high);
  VisitTrees(
      bodies, [&](const btDbvtVolume& box) { return Intersect(box, wanted); },
      [&](const btDbvtVolume& box, const btCollisionObject& body) {
        found.push_back({box, &body});
        return true;
      });
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
