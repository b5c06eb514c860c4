// SPDX-License-Identifier: BSD-2-Clause
#include "world/physics_dispatch.h"

#include <BulletCollision/CollisionDispatch/btConvexConvexAlgorithm.h>

#include <algorithm>
#include <cmath>

namespace soarbox::world {
namespace {

int ShapeOf(const btBroadphaseProxy& proxy) {
  return static_cast<const btCollisionObject*>(proxy.m_clientObject)->getCollisionShape()->getShapeType();
}

/// Whether updating the contacts of a pair changes only its own manifold.
bool IsAlone(const btBroadphasePair& pair) {
  if (pair.m_algorithm == nullptr) return false;
  const int one = ShapeOf(*pair.m_pProxy0), other = ShapeOf(*pair.m_pProxy1);
  return (one == CAPSULE_SHAPE_PROXYTYPE && (other == CAPSULE_SHAPE_PROXYTYPE || other == STATIC_PLANE_PROXYTYPE)) ||
         (one == STATIC_PLANE_PROXYTYPE && other == CAPSULE_SHAPE_PROXYTYPE);
}

/// Whether the distance between the two is certainly larger than `least_m`.
bool AreFarther(const btCollisionObject& capsule_body, const btCollisionObject& box_body, btScalar least_m) {
  const auto& capsule = static_cast<const btCapsuleShape&>(*capsule_body.getCollisionShape());
  const auto& box = static_cast<const btBoxShape&>(*box_body.getCollisionShape());
  const btTransform &place = capsule_body.getWorldTransform(), &frame = box_body.getWorldTransform();
  // The capsule's axis in the coordinates of the box.
  const btVector3 apart = place.getOrigin() - frame.getOrigin();
  const btVector3 middle = apart * frame.getBasis();
  const btVector3 end = place.getBasis().getColumn(capsule.getUpAxis()) * capsule.getHalfHeight() * frame.getBasis();
  const btVector3 half = box.getHalfExtentsWithMargin();
  btScalar gap_2 = 0, size = 0;
  for (int i = 0; i < 3; ++i) {
    const btScalar gap = std::abs(middle[i]) - std::abs(end[i]) - half[i];
    if (gap > 0) gap_2 += gap * gap;
    size += std::abs(apart[i]) + half[i];
  }
  // An upper bound of the rounding errors, here and in Bullet.
  constexpr btScalar kLeast_m = 1e-5f, kShare = 5e-7f;
  const btScalar enough = capsule.getRadius() + least_m + kLeast_m + kShare * size;
  return gap_2 > enough * enough;
}

/// Whether updating the pair would change nothing: a capsule and a box that have no contacts and are too far apart to
/// get one. Bullet's general algorithm for convex shapes takes 9,000 instructions to find that out.
bool StaysApart(const btBroadphasePair& pair) {
  if (pair.m_algorithm == nullptr) return false;
  const auto& one = *static_cast<const btCollisionObject*>(pair.m_pProxy0->m_clientObject);
  const auto& other = *static_cast<const btCollisionObject*>(pair.m_pProxy1->m_clientObject);
  const int kind = one.getCollisionShape()->getShapeType(), kind_of_other = other.getCollisionShape()->getShapeType();
  const bool is_swapped = kind == BOX_SHAPE_PROXYTYPE && kind_of_other == CAPSULE_SHAPE_PROXYTYPE;
  if (!is_swapped && (kind != CAPSULE_SHAPE_PROXYTYPE || kind_of_other != BOX_SHAPE_PROXYTYPE)) return false;
  const btPersistentManifold* contacts = static_cast<btConvexConvexAlgorithm*>(pair.m_algorithm)->getManifold();
  if (contacts == nullptr || contacts->getNumContacts() > 0) return false;
  return AreFarther(is_swapped ? other : one, is_swapped ? one : other, contacts->getContactBreakingThreshold());
}

}  // namespace

void PairDispatcher::dispatchAllCollisionPairs(btOverlappingPairCache* pairs, const btDispatcherInfo& info,
                                               btDispatcher*) {
  known_.clear();
  others_.clear();
  btBroadphasePairArray& all = pairs->getOverlappingPairArray();
  for (int i = 0; i < all.size(); ++i) {
    if (!StaysApart(all[i])) (IsAlone(all[i]) ? known_ : others_).push_back(&all[i]);
  }
  // The last ones first, as in Bullet.
  std::sort(others_.begin(), others_.end(), [](const btBroadphasePair* a, const btBroadphasePair* b) {
    const int a_0 = a->m_pProxy0->m_uniqueId, b_0 = b->m_pProxy0->m_uniqueId;
    return a_0 != b_0 ? a_0 > b_0 : a->m_pProxy1->m_uniqueId > b->m_pProxy1->m_uniqueId;
  });
  for (btBroadphasePair* pair : others_) getNearCallback()(*pair, *this, info);
  constexpr std::size_t kWorthThread = 64;
  static const Workers none;
  WorkInPieces(workers_ != nullptr ? *workers_ : none, known_.size(), kWorthThread,
               [&](std::size_t begin, std::size_t end) {
                 for (std::size_t i = begin; i < end; ++i) getNearCallback()(*known_[i], *this, info);
               });
}

}  // namespace soarbox::world
