// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panel_host.h"

#include <cmath>
#include <filesystem>

#include "viewer/markup.h"
#include "viewer/panels/theme.h"

namespace soarbox::viewer {
namespace {

/// Where distributions keep the DejaVu fonts; without them ImGui's own font serves.
std::string FindFont(const char* file_name) {
  for (const char* folder : {"/usr/share/fonts/truetype/dejavu", "/usr/share/fonts/dejavu", "/usr/share/fonts/TTF",
                             "/usr/share/fonts/dejavu-sans-fonts", "/usr/local/share/fonts/dejavu"}) {
    std::error_code ignored;
    const auto path = std::filesystem::path(folder) / file_name;
    if (std::filesystem::exists(path, ignored)) return path.string();
  }
  return {};
}

ImFont* AddFont(const char* file_name, float height_px) {
  // Latin, Greek, general punctuation, arrows, signs of mathematics, geometric shapes, some signs.
  static const ImWchar kRanges[] = {0x0020, 0x017f, 0x0391, 0x03c9, 0x2010, 0x2027, 0x2190, 0x21ff, 0x2200,
                                    0x2265, 0x25a0, 0x25ff, 0x26a0, 0x26a0, 0x2713, 0x2718, 0};
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  if (const std::string path = FindFont(file_name); !path.empty()) {
    if (ImFont* font = atlas.AddFontFromFileTTF(path.c_str(), height_px, nullptr, kRanges)) return font;
  }
  ImFontConfig config;
  config.SizePixels = height_px;
  return atlas.AddFontDefault(&config);
}

}  // namespace

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
  panel_font_ = AddFont("DejaVuSans.ttf", std::round(15 * scale_));
  bold_font_ = AddFont("DejaVuSans-Bold.ttf", std::round(15 * scale_));
  mono_font_ = AddFont("DejaVuSansMono.ttf", std::round(14 * scale_));
  ImGui::GetIO().FontDefault = panel_font_;
}

void PanelHost::SetTextScale(float scale) {
  if (scale == scale_) return;
  scale_ = scale;
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  LoadFonts();
  ApplyTheme(scale_);
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  atlas.GetTexDataAsRGBA32(&pixels, &width, &height);
  // The overlay made its texture once; the letters go into the same one.
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

void PanelHost::BeginFrame(int width, int height, float seconds) {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
  io.DeltaTime = std::max(seconds, 1e-4f);
  ImGui::NewFrame();
}

void PanelHost::EndFrame() {
  ImGui::EndFrame();
}

}  // namespace soarbox::viewer
