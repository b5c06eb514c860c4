// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/picture_notes.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "sim/agent_words.h"
#include "viewer/draw_colors.h"
#include "viewer/labels.h"
#include "viewer/panels/widgets.h"

namespace soarbox::viewer {

void DrawTooltip(const PanelHost& host, const world::AgentSnapshot& agent, const world::OverlaySnapshot& overlays) {
  const world::AgentOverlay* overlay = OverlayOf(overlays, agent.id);
  char text[64];
  std::vector<std::pair<const char*, std::string>> rows{{"kind", agent.kind}, {"team", agent.team}};
  if (overlay != nullptr && !overlay->operator_name.empty()) rows.emplace_back("operator", overlay->operator_name);
  if (!agent.last_command.empty()) rows.emplace_back("command", agent.last_command);
  std::snprintf(text, sizeof text, "%.0f", static_cast<double>(std::max(agent.health, 0.0f)));
  rows.emplace_back("health", agent.alive ? text : "dead");
  std::snprintf(text, sizeof text, "%.1f m/s",
                static_cast<double>(world::Length(world::Vec3{agent.velocity.x, 0, agent.velocity.z})));
  rows.emplace_back("speed", text);
  if (agent.failed) rows.emplace_back("state", sim::kStoppedByError);
  std::erase_if(rows, [](const auto& row) { return row.second.empty(); });

  ImGui::BeginTooltip();
  ImGui::PushFont(host.bold_font());
  ImGui::TextUnformatted(LabelName(agent).c_str());
  ImGui::PopFont();
  for (const auto& [label, value] : rows) {
    ImGui::TextDisabled("%s", label);
    ImGui::SameLine(6 * ImGui::GetFontSize());
    ImGui::TextUnformatted(value.c_str());
  }
  ImGui::EndTooltip();
}

void DrawSelectionBox(ScreenPoint from, ScreenPoint to) {
  ImDrawList& out = *ImGui::GetForegroundDrawList();
  const ImVec2 low{std::min(from.x, to.x), std::min(from.y, to.y)},
      high{std::max(from.x, to.x), std::max(from.y, to.y)};
  out.AddRectFilled(low, high, IM_COL32(255, 219, 90, 36));
  out.AddRect(low, high, IM_COL32(255, 219, 90, 220), 0, 0, 1.4f);
}

ScreenBox DrawClock(const PanelHost& host, const world::SceneSnapshot& scene) {
  const std::string text = TimeText(scene.time_s);
  ImFont* font = host.panel_font();
  const ImVec2 size = SizeOf(font, text.c_str());
  const float pad = font->FontSize * 0.4f;
  const ScreenBox box{0, 0, size.x + 2 * pad, size.y + pad};
  ImDrawList& out = *ImGui::GetBackgroundDrawList();
  out.AddRectFilled({0, 0}, {box.right, box.bottom}, IM_COL32(12, 17, 24, 205));
  out.AddText(font, font->FontSize, {pad, pad / 2}, IM_COL32(236, 241, 246, 255), text.c_str());
  return box;
}

void DrawNotice(const PanelHost& host, const std::string& text, float opacity) {
  ImDrawList& out = *ImGui::GetForegroundDrawList();
  ImFont* font = host.panel_font();
  const ImVec2 size = SizeOf(font, text.c_str()), screen = ImGui::GetIO().DisplaySize;
  const ImVec2 low{std::round((screen.x - size.x) / 2), std::round(screen.y * 0.86f)};
  const float pad = font->FontSize * 0.6f;
  out.AddRectFilled({low.x - pad, low.y - pad * 0.7f}, {low.x + size.x + pad, low.y + size.y + pad * 0.7f},
                    Faded(IM_COL32(12, 17, 24, 225), opacity), 6);
  out.AddText(font, font->FontSize, low, Faded(IM_COL32(255, 236, 190, 255), opacity), text.c_str());
}

}  // namespace soarbox::viewer
