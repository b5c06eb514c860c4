// SPDX-License-Identifier: BSD-2-Clause
#include "world/physics_dispatch.h"

#include <algorithm>

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

}  // namespace

void PairDispatcher::dispatchAllCollisionPairs(btOverlappingPairCache* pairs, const btDispatcherInfo& info,
                                               btDispatcher*) {
  known_.clear();
  others_.clear();
  btBroadphasePairArray& all = pairs->getOverlappingPairArray();
  for (int i = 0; i < all.size(); ++i) (IsAlone(all[i]) ? known_ : others_).push_back(&all[i]);
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
