// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/picture_notes.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "viewer/draw_colors.h"
#include "viewer/labels.h"

namespace soarbox::viewer {

void DrawTooltip(const PanelHost& host, const world::AgentSnapshot& agent, const world::OverlaySnapshot& overlays,
                 ScreenPoint cursor) {
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
  if (agent.failed) rows.emplace_back("state", "stopped by an error");
  std::erase_if(rows, [](const auto& row) { return row.second.empty(); });

  ImFont *bold = host.bold_font(), *plain = host.panel_font();
  const float line = plain->FontSize * 1.2f, pad = plain->FontSize * 0.6f;
  float labels = 0, values = 0;
  for (const auto& [label, value] : rows) {
    labels = std::max(labels, SizeOf(plain, label).x);
    values = std::max(values, SizeOf(plain, value.c_str()).x);
  }
  const std::string name = LabelName(agent);
  const float width = std::max(SizeOf(bold, name.c_str()).x, labels + pad + values) + 2 * pad;
  const float height = line * static_cast<float>(rows.size() + 1) + 2 * pad;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const ImVec2 low{std::clamp(cursor.x + 16, 4.0f, std::max(4.0f, screen.x - width - 4)),
                   std::clamp(cursor.y + 18, 4.0f, std::max(4.0f, screen.y - height - 4))};
  ImDrawList& out = *ImGui::GetForegroundDrawList();
  out.AddRectFilled(low, {low.x + width, low.y + height}, IM_COL32(12, 17, 24, 236), 5);
  out.AddRect(low, {low.x + width, low.y + height}, IM_COL32(255, 255, 255, 40), 5);
  float y = low.y + pad;
  out.AddText(bold, bold->FontSize, {low.x + pad, y}, IM_COL32(255, 255, 255, 255), name.c_str());
  for (const auto& [label, value] : rows) {
    y += line;
    out.AddText(plain, plain->FontSize, {low.x + pad, y}, IM_COL32(152, 166, 180, 255), label);
    out.AddText(plain, plain->FontSize, {low.x + 2 * pad + labels, y}, IM_COL32(236, 241, 246, 255), value.c_str());
  }
}

void DrawSelectionBox(ScreenPoint from, ScreenPoint to) {
  ImDrawList& out = *ImGui::GetForegroundDrawList();
  const ImVec2 low{std::min(from.x, to.x), std::min(from.y, to.y)},
      high{std::max(from.x, to.x), std::max(from.y, to.y)};
  out.AddRectFilled(low, high, IM_COL32(255, 219, 90, 36));
  out.AddRect(low, high, IM_COL32(255, 219, 90, 220), 0, 0, 1.4f);
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
