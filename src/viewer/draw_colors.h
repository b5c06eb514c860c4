// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <imgui.h>

#include "world/scene_snapshot.h"

namespace soarbox::viewer {

inline ImU32 Packed(world::Color c, float alpha = 1) {
  return ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, c.a * alpha});
}

inline ImU32 Faded(ImU32 color, float alpha) {
  const auto opacity = static_cast<ImU32>(static_cast<float>(color >> IM_COL32_A_SHIFT) * alpha);
  return (color & ~IM_COL32_A_MASK) | (opacity << IM_COL32_A_SHIFT);
}

inline ImVec2 SizeOf(const ImFont* font, const char* text, float wrap_px = 0) {
  return font->CalcTextSizeA(font->FontSize, 3.4e38f, wrap_px, text);
}

}  // namespace soarbox::viewer
