// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/hud.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "viewer/draw_colors.h"
#include "viewer/palette.h"

namespace soarbox::viewer {
namespace {

constexpr float kBarHeight = kStatusBar_px, kCardMargin = 16;
constexpr ImU32 kBarColor = IM_COL32(14, 19, 26, 205), kBarText = IM_COL32(236, 241, 246, 255),
                kBarQuiet = IM_COL32(152, 166, 180, 255), kGo = IM_COL32(96, 208, 132, 255),
                kHold = IM_COL32(247, 190, 82, 255);

/// Writes words one after the other along the bar.
class BarWriter {
 public:
  BarWriter(ImDrawList& out, const PanelHost& host, float x) : out_(out), host_(host), x_(x) {}

  void Word(const std::string& text, ImU32 color, bool bold = false, float gap = 22) {
    ImFont* font = bold ? host_.bold_font() : host_.panel_font();
    out_.AddText(font, font->FontSize, {x_, (kBarHeight - font->FontSize) / 2}, color, text.c_str());
    x_ += font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str()).x + gap;
  }
  void Pair(const char* label, const std::string& value) {
    Word(label, kBarQuiet, false, 6);
    Word(value, kBarText);
  }
  void Skip(float width) { x_ += width; }
  float x() const { return x_; }

 private:
  ImDrawList& out_;
  const PanelHost& host_;
  float x_;
};

std::string Text(const char* format, auto... values) {
  char text[160];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

void Row(const char* label, const std::string& value) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextDisabled("%s", label);
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(value.c_str());
}

/// From red through amber to green.
world::Color HealthBarColor(float share) {
  return share < 0.5f ? world::Color{0.90f, 0.22f + 1.0f * share, 0.18f, 1}
                      : world::Color{0.90f - 1.2f * (share - 0.5f), 0.72f, 0.22f, 1};
}

}  // namespace

void DrawStatusBar(const PanelHost& host, const RunStatus& status, const world::SceneSnapshot& scene,
                   float frames_per_second) {
  ImDrawList& out = *ImGui::GetForegroundDrawList();
  const float width = ImGui::GetIO().DisplaySize.x;
  out.AddRectFilled({0, 0}, {width, kBarHeight}, kBarColor);
  const ImU32 state = status.paused ? kHold : kGo;
  const float middle = kBarHeight / 2;
  if (status.paused) {
    out.AddRectFilled({12, middle - 5}, {15.5f, middle + 5}, state);
    out.AddRectFilled({18.5f, middle - 5}, {22, middle + 5}, state);
  } else {
    out.AddTriangleFilled({12, middle - 6}, {12, middle + 6}, {22, middle}, state);
  }
  BarWriter bar(out, host, 30);
  bar.Word(status.paused ? "Paused" : "Running", state, true);
  const int minutes = static_cast<int>(scene.time_s / 60);
  bar.Pair("time", Text("%d:%05.2f", minutes, scene.time_s - 60.0 * minutes));
  bar.Pair("tick", std::to_string(scene.tick));
  bar.Pair("speed", std::isinf(status.speed) ? "unlimited" : Text("%.4g\xc3\x97", status.speed));
  bar.Pair("agents", std::to_string(scene.agents.size()));
  const auto failed =
      std::count_if(scene.agents.begin(), scene.agents.end(), [](const auto& agent) { return agent.failed; });
  if (failed > 0)
    bar.Word(Text("%d stopped by an error", static_cast<int>(failed)), IM_COL32(255, 120, 104, 255), true);
  if (!status.message.empty()) bar.Word(status.message, kBarQuiet);

  const std::string rate = frames_per_second > 0 ? Text("%.0f fps     ", static_cast<double>(frames_per_second)) : "";
  const std::string right = rate + "H  keys";
  ImFont* font = host.panel_font();
  const float right_width = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, right.c_str()).x;
  BarWriter(out, host, width - right_width - 14).Word(right, kBarQuiet);
}

void DrawKeyHelp(const PanelHost& host) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({size.x / 2, size.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::Begin("##keys", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs);
  ImGui::PushFont(host.bold_font());
  ImGui::TextUnformatted("Keys");
  ImGui::PopFont();
  ImGui::Separator();
  constexpr struct {
    const char* title;
    CommandGroup group;
  } kGroups[] = {{"Run", CommandGroup::kRun},
                 {"Camera", CommandGroup::kCamera},
                 {"Selection", CommandGroup::kSelection},
                 {"Shown over the scene", CommandGroup::kOverlay}};
  constexpr const char* kMouse[][2] = {{"Left click, Tab", "select an agent; with Shift, one more"},
                                       {"Double click", "go there: an agent, or a place"},
                                       {"Left drag", "select those in a box"},
                                       {"Right drag", "look around, or circle"},
                                       {"Middle drag", "move the picture"},
                                       {"Wheel", "zoom to the cursor"},
                                       {"W A S D, Q E", "fly; faster with Shift"}};
  const auto row = [&](std::string_view key, std::string_view meaning) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushFont(host.bold_font());
    ImGui::TextUnformatted(key.data(), key.data() + key.size());
    ImGui::PopFont();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(meaning.data(), meaning.data() + meaning.size());
  };
  if (ImGui::BeginTable("##columns", 2, ImGuiTableFlags_SizingFixedFit)) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    for (const auto& [title, group] : kGroups) {
      if (group == CommandGroup::kSelection) ImGui::TableNextColumn();
      ImGui::TextDisabled("%s", title);
      if (ImGui::BeginTable(title, 2, ImGuiTableFlags_SizingFixedFit)) {
        for (const CommandInfo& info : Commands()) {
          if (info.group == group) row(info.keys, info.title);
        }
        ImGui::EndTable();
      }
      ImGui::Dummy({1, 4});
    }
    ImGui::TextDisabled("Mouse");
    if (ImGui::BeginTable("Mouse", 2, ImGuiTableFlags_SizingFixedFit)) {
      for (const auto& [key, meaning] : kMouse) row(key, meaning);
      ImGui::EndTable();
    }
    ImGui::EndTable();
  }
  ImGui::End();
}

ScreenBox AreaOfCards(float width_px, float height_px) {
  return {kCardMargin, kBarHeight + kCardMargin, width_px - kCardMargin, height_px - kCardMargin};
}

ScreenBox DrawAgentCard(const PanelHost& host, const world::AgentSnapshot& agent, bool followed, Corner corner) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const ScreenBox at = BoxIn(corner, AreaOfCards(size.x, size.y), 0, 0);
  const ImVec2 pivot{at.left < size.x / 2 ? 0.0f : 1.0f, at.top < size.y / 2 ? 0.0f : 1.0f};
  ImGui::SetNextWindowPos({at.left, at.top}, ImGuiCond_Always, pivot);
  ImGui::SetNextWindowSizeConstraints({250, 0}, {420, size.y});
  ImGui::Begin("##agent", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs);
  const ImVec2 cursor = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddCircleFilled({cursor.x + 6, cursor.y + 8}, 6, Packed(AgentColor(agent.kind)), 20);
  ImGui::Dummy({14, 14});
  ImGui::SameLine();
  ImGui::PushFont(host.bold_font());
  ImGui::TextUnformatted(agent.name.empty() ? Text("agent %u", agent.id).c_str() : agent.name.c_str());
  ImGui::PopFont();
  ImGui::SameLine();
  ImGui::TextDisabled("%s", agent.kind.c_str());
  ImGui::Separator();
  if (ImGui::BeginTable("##facts", 2, ImGuiTableFlags_SizingFixedFit)) {
    Row("script", agent.script.empty() ? "none" : agent.script);
    const auto& p = agent.position;
    Row("position",
        Text("%.1f, %.1f, %.1f m", static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)));
    Row("speed", Text("%.2f m/s", static_cast<double>(world::Length({agent.velocity.x, 0, agent.velocity.z}))));
    Row("last command", agent.last_command.empty() ? "none" : agent.last_command);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextDisabled("health");
    ImGui::TableNextColumn();
    const float share = std::clamp(agent.health / 100.0f, 0.0f, 1.0f);
    const world::Color color = HealthBarColor(share);
    ImGui::PushStyleColor(ImGuiCol_PlotHistogram, ImVec4(color.r, color.g, color.b, 1));
    ImGui::ProgressBar(share, {120, 14}, Text("%.0f", static_cast<double>(agent.health)).c_str());
    ImGui::PopStyleColor();
    if (agent.failed)
      Row("state", "its script stopped on an error");
    else if (!agent.alive)
      Row("state", "dead");
    ImGui::EndTable();
  }
  ImGui::TextDisabled(followed ? "C: stop following" : "C: follow");
  const ImVec2 low = ImGui::GetWindowPos(), card = ImGui::GetWindowSize();
  ImGui::End();
  return {low.x, low.y, low.x + card.x, low.y + card.y};
}

}  // namespace soarbox::viewer
