// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstddef>

#include "world/physics_crowd.h"
#include "world/physics_field.h"

// Where bodies are looked for, for the physics_*.cpp files only. Reading changes nothing, so that several threads may
// do it at a time.
namespace soarbox::world {

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

/// The broad phase's trees, and the field while it is known.
struct AllBodies {
  const CrowdBroadphase& trees;
  const BodyField& field;

  /// Whether the field finds what is on a segment, as fast as it can be; else the trees do.
  bool AreInField(const btVector3& from, const btVector3& to) const {
    return field.is_known() && (to - from).length2() < BodyField::kLongest_m * BodyField::kLongest_m;
  }
};

/// Calls visit(const BoxedBody&) for each body whose box touches this one.
template <class Visit>
void VisitTouching(const AllBodies& bodies, const btVector3& low, const btVector3& high, const Visit& visit) {
  const btDbvtVolume wanted = btDbvtVolume::FromMM(low, high);
  if (bodies.field.is_known()) {
    return bodies.field.VisitBox(low, high, [&](const BoxedBody& each) {
      if (Intersect(each.box, wanted)) visit(each);
    });
  }
  VisitTrees(
      bodies.trees, [&](const btDbvtVolume& box) { return Intersect(box, wanted); },
      [&](const btDbvtVolume& box, const btCollisionObject& body) {
        visit(SeenFromAbove(body, box));
        return true;
      });
}

}  // namespace soarbox::world
