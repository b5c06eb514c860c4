// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/scaled_scene.h"

#include <cstdint>
#include <utility>

namespace soarbox::viewer {

constexpr const char* kTexture = "Soarbox/ScaledScene";

ScaledScene::ScaledScene(Ogre::Root& root, Ogre::Camera& scene, Materials& materials, unsigned samples)
    : root_(root), scene_(scene), materials_(materials), samples_(samples), shown_(root.createSceneManager()) {
  camera_ = shown_->createCamera(kTexture);
  shown_->getRootSceneNode()->attachObject(camera_);
}

ScaledScene::~ScaledScene() {
  Drop();
  if (square_) square_->detachFromParent();
  square_.reset();
  root_.destroySceneManager(shown_);
}

void ScaledScene::Drop() {
  if (target_ != nullptr) target_->removeAllViewports();
  target_ = nullptr;
  if (texture_) Ogre::TextureManager::getSingleton().remove(texture_);
  texture_.reset();
}

void ScaledScene::SetSize(int width, int height) {
  if (width == width_ && height == height_) return;
  width_ = width;
  height_ = height;
  is_drawn_ = false;
  Drop();
  texture_ = Ogre::TextureManager::getSingleton().createManual(
      kTexture, kGroup, Ogre::TEX_TYPE_2D, static_cast<unsigned>(width), static_cast<unsigned>(height), 0,
      Ogre::PF_BYTE_RGB, Ogre::TU_RENDERTARGET, nullptr, false, samples_);
  target_ = texture_->getBuffer()->getRenderTarget();
  target_->setAutoUpdated(false);
  Ogre::Viewport* view = target_->addViewport(&scene_);
  view->setBackgroundColour(Ogre::ColourValue(0.6f, 0.7f, 0.8f));
  view->setOverlaysEnabled(false);
  if (!square_) {
    material_ = materials_.Enlarged();
    square_ = std::make_unique<Ogre::Rectangle2D>(true);
    square_->setCorners(-1, 1, 1, -1);
    square_->setBoundingBox(Ogre::AxisAlignedBox::BOX_INFINITE);
    square_->setMaterial(material_);
    shown_->getRootSceneNode()->attachObject(square_.get());
  }
  material_->getTechnique(0)->getPass(0)->getTextureUnitState(0)->setTexture(texture_);
}

void ScaledScene::Draw(bool has_changed) {
  if (is_drawn_ && !has_changed) return;
  is_drawn_ = true;
  target_->update();
}

}  // namespace soarbox::viewer
