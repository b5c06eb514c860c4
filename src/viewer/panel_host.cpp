// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panel_host.h"

#include <cmath>
#include <iostream>

#include "viewer/markup.h"
#include "viewer/panels/draw_limit.h"
#include "viewer/panels/panel_fonts.h"
#include "viewer/panels/theme.h"

namespace soarbox::viewer {
PanelHost::PanelHost(Materials& materials) : overlay_(new Ogre::ImGuiOverlay()) {
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.ConfigFlags |= ImGuiConfigFlags_NoMouseCursorChange;
  LoadFonts();
  ApplyTheme(scale_);
  Ogre::OverlayManager::getSingleton().addOverlay(overlay_);
  overlay_->setZOrder(300);
  overlay_->show();
  materials.AdoptPanelMaterial(Ogre::MaterialManager::getSingleton().getByName("ImGui/material", Ogre::RGN_INTERNAL));
}

PanelHost::~PanelHost() {
  Ogre::OverlayManager::getSingleton().destroy(overlay_);
}

void PanelHost::LoadFonts() {
  using world::UiFont;
  for (const UiFont font : {UiFont::kSmall, UiFont::kMedium, UiFont::kLarge}) {
    script_fonts_[static_cast<std::size_t>(font)] = AddFont("DejaVuSans.ttf", LineHeight(font));
  }
  for (const UiFont font : {UiFont::kSmallMono, UiFont::kMediumMono, UiFont::kLargeMono}) {
    script_fonts_[static_cast<std::size_t>(font)] = AddFont("DejaVuSansMono.ttf", LineHeight(font));
  }
  const PanelFonts fonts = AddPanelFonts(scale_);
  panel_font_ = fonts.plain;
  bold_font_ = fonts.bold;
  mono_font_ = fonts.mono;
  ImGui::GetIO().FontDefault = panel_font_;
}

void PanelHost::SetTextScale(float scale) {
  if (scale == scale_) return;
  scale_ = scale;
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  LoadFonts();
  ApplyTheme(scale_, light_);
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  atlas.GetTexDataAsRGBA32(&pixels, &width, &height);
  // The overlay created its texture once; the letters go into that texture.
  const Ogre::MaterialPtr material =
      Ogre::MaterialManager::getSingleton().getByName("ImGui/material", Ogre::RGN_INTERNAL);
  const Ogre::TexturePtr texture = material->getTechnique(0)->getPass(0)->getTextureUnitState(0)->_getTexturePtr();
  texture->freeInternalResources();
  texture->setWidth(static_cast<unsigned>(width));
  texture->setHeight(static_cast<unsigned>(height));
  texture->createInternalResources();
  texture->getBuffer()->blitFromMemory(
      Ogre::PixelBox(static_cast<unsigned>(width), static_cast<unsigned>(height), 1, Ogre::PF_BYTE_RGBA, pixels));
}

void PanelHost::SetLight(bool light) {
  if (light == light_) return;
  light_ = light;
  ApplyTheme(scale_, light_);
}

void PanelHost::BeginFrame(int width, int height, float seconds) {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
  io.DeltaTime = std::max(seconds, 1e-4f);
  ImGui::NewFrame();
}

void PanelHost::EndFrame() {
  ImGui::EndFrame();
  for (const std::string& name : CutOverfullWindows())
    if (told_cut_.insert(name).second)
      std::cerr << "soarbox: warning: " << name << " contains too much to be drawn completely\n";
}

}  // namespace soarbox::viewer
