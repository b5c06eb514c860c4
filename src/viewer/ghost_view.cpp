// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/ghost_view.h"

#include <cmath>

#include "viewer/mesh_library.h"
#include "viewer/viewer.h"

namespace soarbox::viewer {
namespace {

// The figure is made for a body of this size and scaled to others.
constexpr float kRadius_m = 0.4f, kHeight_m = 1.8f;

}  // namespace

GhostView::GhostView(Ogre::SceneManager& scene, Materials& materials) : scene_(scene), materials_(materials) {
  mesh_ = UploadMesh("Soarbox/Ghost", AgentMesh(kRadius_m, kHeight_m, AgentDetail::kMiddle));
}

void GhostView::Update(const std::vector<Ghost>& ghosts) {
  while (figures_.size() < ghosts.size()) {
    Figure figure;
    figure.node = scene_.getRootSceneNode()->createChildSceneNode();
    figure.entity = scene_.createEntity(mesh_);
    figure.entity->setCastShadows(false);
    figure.entity->setRenderQueueGroup(Ogre::RENDER_QUEUE_7);
    figure.node->attachObject(figure.entity);
    figures_.push_back(std::move(figure));
  }
  for (std::size_t i = 0; i < figures_.size(); ++i) {
    const bool is_shown = i < ghosts.size() && world::IsFinite(ghosts[i].position);
    figures_[i].node->setVisible(is_shown);
    if (!is_shown) continue;
    const Ghost& ghost = ghosts[i];
    // Opacities come in steps, so that fading does not make a material per frame.
    const int step = std::clamp(static_cast<int>(std::lround(ghost.opacity * 10)), 1, 10);
    world::Color color = ghost.color;
    color.a = static_cast<float>(step) / 10;
    const Ogre::MaterialPtr& material = materials_.Ghost(color);
    if (figures_[i].material != material->getName()) {
      figures_[i].material = material->getName();
      figures_[i].entity->setMaterial(material);
    }
    const world::Vec3 ahead = world::Normalized(world::Vec3{ghost.forward.x, 0, ghost.forward.z});
    figures_[i].node->setPosition(ToOgre(ghost.position));
    figures_[i].node->setOrientation(
        Ogre::Quaternion(Ogre::Radian(std::atan2(ahead.x, ahead.z)), Ogre::Vector3::UNIT_Y));
    figures_[i].node->setScale(ghost.radius_m / kRadius_m, ghost.height_m / kHeight_m, ghost.radius_m / kRadius_m);
  }
}

}  // namespace soarbox::viewer
