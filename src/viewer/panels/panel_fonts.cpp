// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/panel_fonts.h"

#include <cmath>
#include <filesystem>
#include <string>
#include <system_error>

namespace soarbox::viewer {
namespace {

/// Folders in which distributions have the DejaVu fonts. If there are none, ImGui's own font is used.
std::string FindFont(const char* file_name) {
  for (const char* folder : {"/usr/share/fonts/truetype/dejavu", "/usr/share/fonts/dejavu", "/usr/share/fonts/TTF",
                             "/usr/share/fonts/dejavu-sans-fonts", "/usr/local/share/fonts/dejavu"}) {
    std::error_code ignored;
    const auto path = std::filesystem::path(folder) / file_name;
    if (std::filesystem::exists(path, ignored)) return path.string();
  }
  return {};
}

}  // namespace

ImFont* AddFont(const char* file_name, float height_px) {
  // Latin, Greek, general punctuation, arrows, mathematical operators, geometric shapes, some symbols.
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

PanelFonts AddPanelFonts(float scale) {
  return {AddFont("DejaVuSans.ttf", std::round(15 * scale)), AddFont("DejaVuSans-Bold.ttf", std::round(15 * scale)),
          AddFont("DejaVuSansMono.ttf", std::round(14 * scale))};
}

}  // namespace soarbox::viewer
