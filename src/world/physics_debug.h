// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <btBulletDynamicsCommon.h>

#include <vector>

#include "world/scene_snapshot.h"

// For the physics_*.cpp files only.
namespace soarbox::world {

/// Collects Bullet's wireframes and bounding boxes as lines. Skips those of infinite shapes.
class PhysicsLineCollector final : public btIDebugDraw {
 public:
  explicit PhysicsLineCollector(std::vector<LineSnapshot>& lines) : lines_(lines) {}

  void drawLine(const btVector3& from, const btVector3& to, const btVector3& color) override;
  void drawContactPoint(const btVector3&, const btVector3&, btScalar, int, const btVector3&) override {}
  void reportErrorWarning(const char*) override {}
  void draw3dText(const btVector3&, const char*) override {}
  void setDebugMode(int) override {}
  int getDebugMode() const override { return DBG_DrawWireframe | DBG_DrawAabb; }

 private:
  std::vector<LineSnapshot>& lines_;
};

}  // namespace soarbox::world
