// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstddef>

#include "world/physics_crowd.h"
#include "world/physics_field.h"

// Searches in the trees of bodies; for the physics_*.cpp files only. They change nothing, so several threads may search
// at a time.
namespace soarbox::world {

/// Calls visit(box, body) for each body in the tree if `meets` accepts its bounding box and the boxes of all its
/// ancestors. If visit returns false, stops and returns false.
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
        return false;  // Deep trees are rare; this part continues with a new stack.
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

/// All bodies: the trees of the broadphase, and the grid while it is known.
struct AllBodies {
  const CrowdBroadphase& trees;
  const BodyField& field;

  /// Whether the grid can answer a query along this segment efficiently; otherwise the trees are searched.
  bool AreInField(const btVector3& from, const btVector3& to) const {
    return field.is_known() && (to - from).length2() < BodyField::kLongest_m * BodyField::kLongest_m;
  }
};

/// Calls visit(const BoxedBody&) for each body whose box overlaps this box.
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
