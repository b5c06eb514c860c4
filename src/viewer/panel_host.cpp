// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panel_host.h"

#include <filesystem>

#include "viewer/markup.h"

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
  // Latin, general punctuation, arrows and geometric shapes.
  static const ImWchar kRanges[] = {0x0020, 0x017f, 0x2010, 0x2027, 0x2190, 0x21ff, 0x25a0, 0x25ff, 0};
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  if (const std::string path = FindFont(file_name); !path.empty()) {
    if (ImFont* font = atlas.AddFontFromFileTTF(path.c_str(), height_px, nullptr, kRanges)) return font;
  }
  ImFontConfig config;
  config.SizePixels = height_px;
  return atlas.AddFontDefault(&config);
}

void SetStyle() {
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 6;
  style.WindowBorderSize = 1;
  style.WindowPadding = {12, 10};
  style.ItemSpacing = {8, 5};
  style.Colors[ImGuiCol_WindowBg] = {0.055f, 0.075f, 0.10f, 0.86f};
  style.Colors[ImGuiCol_Border] = {1, 1, 1, 0.10f};
  style.Colors[ImGuiCol_Text] = {0.93f, 0.95f, 0.97f, 1};
  style.Colors[ImGuiCol_TextDisabled] = {0.58f, 0.64f, 0.70f, 1};
}

}  // namespace

PanelHost::PanelHost(Materials& materials) : overlay_(new Ogre::ImGuiOverlay()) {
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.ConfigFlags |= ImGuiConfigFlags_NoMouseCursorChange;
  LoadFonts();
  SetStyle();
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
  panel_font_ = AddFont("DejaVuSans.ttf", 15);
  bold_font_ = AddFont("DejaVuSans-Bold.ttf", 15);
  ImGui::GetIO().FontDefault = panel_font_;
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
