// SPDX-License-Identifier: BSD-2-Clause
#include "world/physics_dynamics.h"

namespace soarbox::world {
namespace {

/// Whether the body keeps its rotation in this step and needs no continuous collision detection.
bool OnlyMoves(const btRigidBody& body, btScalar step_s) {
  return body.getAngularFactor().isZero() && body.getAngularVelocity().isZero() &&
         body.getLinearVelocity().length2() * step_s * step_s <= body.getCcdSquareMotionThreshold();
}

btVector3 NextPlace(const btRigidBody& body, btScalar step_s) {
  return body.getWorldTransform().getOrigin() + body.getLinearVelocity() * step_s;
}

}  // namespace

void DynamicsWorld::predictUnconstraintMotion(btScalar step_s) {
  for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
    btRigidBody& body = *m_nonStaticRigidBodies[i];
    if (body.isStaticOrKinematicObject()) continue;
    if (body.getLinearDamping() != 0 || body.getAngularDamping() != 0) body.applyDamping(step_s);
    if (OnlyMoves(body, step_s)) {
      body.getInterpolationWorldTransform().setBasis(body.getWorldTransform().getBasis());
      body.getInterpolationWorldTransform().setOrigin(NextPlace(body, step_s));
    } else {
      body.predictIntegratedTransform(step_s, body.getInterpolationWorldTransform());
    }
  }
}

void DynamicsWorld::createPredictiveContacts(btScalar step_s) {
  releasePredictiveContacts();
  others_.resize(0);
  for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
    btRigidBody& body = *m_nonStaticRigidBodies[i];
    body.setHitFraction(1);
    if (body.isActive() && !OnlyMoves(body, step_s)) others_.push_back(&body);
  }
  if (others_.size() > 0) createPredictiveContactsInternal(&others_[0], others_.size(), step_s);
}

void DynamicsWorld::integrateTransforms(btScalar step_s) {
  others_.resize(0);
  for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
    btRigidBody& body = *m_nonStaticRigidBodies[i];
    body.setHitFraction(1);
    if (!body.isActive() || body.isStaticOrKinematicObject()) continue;
    if (!OnlyMoves(body, step_s)) {
      others_.push_back(&body);
      continue;
    }
    body.getWorldTransform().setOrigin(NextPlace(body, step_s));
    body.setInterpolationWorldTransform(body.getWorldTransform());
    body.setInterpolationLinearVelocity(body.getLinearVelocity());
    body.setInterpolationAngularVelocity(body.getAngularVelocity());
  }
  if (others_.size() > 0) integrateTransformsInternal(&others_[0], others_.size(), step_s);
}

}  // namespace soarbox::world
