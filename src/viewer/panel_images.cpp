// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panel_images.h"

#include "picture/png_reader.h"
#include "world/asset_store.h"

namespace soarbox::viewer {

Ogre::ResourceHandle PanelImages::Find(const std::string& key) {
  const auto known = known_.find(key);
  if (known != known_.end()) return known->second;
  Ogre::ResourceHandle& handle = known_[key];
  const auto file = world::FindAsset(key);
  if (file == nullptr) return handle;
  picture::PngRead read = picture::ReadPng(*file);
  if (!read.problem.empty()) return handle;
  const auto width = static_cast<unsigned>(read.pixels.width), height = static_cast<unsigned>(read.pixels.height);
  const Ogre::TexturePtr texture = Ogre::TextureManager::getSingleton().createManual(
      "Soarbox/Panel/" + key, kGroup, Ogre::TEX_TYPE_2D, width, height, Ogre::MIP_UNLIMITED, Ogre::PF_BYTE_RGBA,
      Ogre::TU_AUTOMIPMAP);
  texture->getBuffer()->blitFromMemory(Ogre::PixelBox(width, height, 1, Ogre::PF_BYTE_RGBA, read.pixels.rgba.data()));
  return handle = texture->getHandle();
}

}  // namespace soarbox::viewer
