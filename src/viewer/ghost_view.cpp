// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/ghost_view.h"

#include <algorithm>
#include <cmath>

#include "viewer/mesh_library.h"
#include "viewer/scene_view.h"
#include "viewer/viewer.h"

namespace soarbox::viewer {
namespace {

// The figure is built for a body of this size and scaled to others.
constexpr float kRadius_m = 0.4f, kHeight_m = 1.8f;

}  // namespace

GhostView::GhostView(Ogre::SceneManager& scene, Materials& materials) : scene_(scene), materials_(materials) {
  mesh_ = UploadMesh("Soarbox/Ghost", AgentMesh(kRadius_m, kHeight_m, AgentDetail::kMiddle));
}

GhostView::~GhostView() {
  // Ogre's scene must not refer to our objects when the engine ends it.
  for (const auto& [key, batch] : batches_) batch->detachFromParent();
}

void GhostView::Update(const std::vector<Ghost>& ghosts, const SceneView& bodies, BoneTexture& bones) {
  for (auto& [key, batch] : batches_) batch->Begin();
  std::size_t plain = 0;
  for (const Ghost& ghost : ghosts) {
    if (ghost.is_name_only || !world::IsFinite(ghost.position)) continue;
    // Opacity is quantised, so that fading does not create a material per frame.
    const int step = std::clamp(static_cast<int>(std::lround(ghost.opacity * 10)), 1, 10);
    world::Color color = ghost.color;
    color.a = static_cast<float>(step) / 10;
    const world::Vec3 ahead = world::Normalized(world::Vec3{ghost.forward.x, 0, ghost.forward.z});
    const float heading = std::atan2(ahead.x, ahead.z);
    if (const auto figure = bodies.FigureOf(ghost.agent_id)) {
      const Ogre::MaterialPtr& material = materials_.Ghost(color, Placing::kBones);
      std::unique_ptr<InstanceBatch>& batch = batches_[{figure->look, material->getName()}];
      if (!batch) {
        batch = std::make_unique<InstanceBatch>(scene_, library_.For(figure->look, BodyDetail::kMiddle), 1);
        batch->setMaterial(material);
        batch->setCastShadows(false);
        batch->setRenderQueueGroup(Ogre::RENDER_QUEUE_7);
        scene_.getRootSceneNode()->createChildSceneNode()->attachObject(batch.get());
        batch->Begin();
      }
      PosedBody body = *figure->body;
      body.place.at = {ghost.position - world::Vec3{0, ghost.height_m / 2, 0}, world::Turn({0, 1, 0}, heading)};
      AddBody(*batch, body, color, bones.Add(body, figure->look), InstanceBatch::Shown::kInPicture);
      continue;
    }
    const Ogre::MaterialPtr& material = materials_.Ghost(color, Placing::kOne);
    if (plain == figures_.size()) figures_.push_back(MakeFigure());
    Figure& figure = figures_[plain++];
    if (figure.material != material->getName()) {
      figure.material = material->getName();
      figure.entity->setMaterial(material);
    }
    figure.node->setVisible(true);
    figure.node->setPosition(ToOgre(ghost.position));
    figure.node->setOrientation(Ogre::Quaternion(Ogre::Radian(heading), Ogre::Vector3::UNIT_Y));
    figure.node->setScale(ghost.radius_m / kRadius_m, ghost.height_m / kHeight_m, ghost.radius_m / kRadius_m);
  }
  for (; plain < figures_.size(); ++plain) figures_[plain].node->setVisible(false);
  for (auto& [key, batch] : batches_) batch->End();
}

GhostView::Figure GhostView::MakeFigure() {
  Figure figure;
  figure.node = scene_.getRootSceneNode()->createChildSceneNode();
  figure.entity = scene_.createEntity(mesh_);
  figure.entity->setCastShadows(false);
  figure.entity->setRenderQueueGroup(Ogre::RENDER_QUEUE_7);
  figure.node->attachObject(figure.entity);
  return figure;
}

}  // namespace soarbox::viewer
