// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels.h"

#include <algorithm>
#include <cstdio>

#include "viewer/palette.h"

namespace soarbox::viewer {
namespace {

constexpr float kBarHeight = 26;
constexpr ImU32 kBarColor = IM_COL32(14, 19, 26, 205), kText = IM_COL32(236, 241, 246, 255),
                kQuiet = IM_COL32(152, 166, 180, 255), kGo = IM_COL32(96, 208, 132, 255),
                kHold = IM_COL32(247, 190, 82, 255);

ImU32 Packed(world::Color c, float alpha = 1) {
  return ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, c.a * alpha});
}

/// Writes one word after the other along the bar.
class BarWriter {
 public:
  BarWriter(ImDrawList& out, const PanelHost& host, float x) : out_(out), host_(host), x_(x) {}

  void Word(const std::string& text, ImU32 color, bool bold = false, float gap = 22) {
    ImFont* font = bold ? host_.bold_font() : host_.panel_font();
    out_.AddText(font, font->FontSize, {x_, (kBarHeight - font->FontSize) / 2}, color, text.c_str());
    x_ += font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str()).x + gap;
  }
  void Pair(const char* label, const std::string& value) {
    Word(label, kQuiet, false, 6);
    Word(value, kText);
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
world::Color HealthColor(float share) {
  return share < 0.5f ? world::Color{0.90f, 0.22f + 1.0f * share, 0.18f, 1}
                      : world::Color{0.90f - 1.2f * (share - 0.5f), 0.72f, 0.22f, 1};
}

std::string LabelText(const world::AgentSnapshot& agent) {
  const std::string name = agent.name.empty() ? Text("agent %u", agent.id) : agent.name.substr(0, 60);
  return agent.failed ? name + "  (stopped)" : name;
}

/// Text with a dark rim, legible on any ground.
void RimmedText(ImDrawList& out, ImFont* font, ImVec2 at, ImU32 color, const char* text, float alpha) {
  const ImU32 rim = IM_COL32(8, 12, 18, static_cast<int>(190 * alpha));
  for (const ImVec2 shift : {ImVec2{-1, 0}, ImVec2{1, 0}, ImVec2{0, -1}, ImVec2{0, 1}}) {
    out.AddText(font, font->FontSize, {at.x + shift.x, at.y + shift.y}, rim, text);
  }
  out.AddText(font, font->FontSize, at, color, text);
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
  bar.Pair("speed", Text("%.4g\xc3\x97", status.speed));
  bar.Pair("agents", std::to_string(scene.agents.size()));
  const auto failed =
      std::count_if(scene.agents.begin(), scene.agents.end(), [](const auto& agent) { return agent.failed; });
  if (failed > 0)
    bar.Word(Text("%d stopped by an error", static_cast<int>(failed)), IM_COL32(255, 120, 104, 255), true);
  if (!status.message.empty()) bar.Word(status.message, kQuiet);

  const std::string rate = frames_per_second > 0 ? Text("%.0f fps     ", static_cast<double>(frames_per_second)) : "";
  const std::string right = rate + "H  keys";
  ImFont* font = host.panel_font();
  const float right_width = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, right.c_str()).x;
  BarWriter(out, host, width - right_width - 14).Word(right, kQuiet);
}

void DrawKeyHelp(const PanelHost& host) {
  struct Key {
    const char* key;
    const char* meaning;
  };
  constexpr Key kKeys[] = {{"W A S D", "move"},
                           {"Q E", "down, up"},
                           {"Shift", "move faster"},
                           {"Right mouse button", "look around"},
                           {"Mouse wheel", "flying speed"},
                           {"Left click", "select an agent"},
                           {"C", "follow the selected agent"},
                           {nullptr, nullptr},
                           {"P", "pause, go on"},
                           {"N", "single step"},
                           {"+  -", "faster, slower"},
                           {nullptr, nullptr},
                           {"L", "names of agents"},
                           {"H", "this list"},
                           {"Esc", "quit"},
                           {nullptr, nullptr},
                           {"Space, F1 to F7, ...", "as the scenario says"}};
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({size.x / 2, size.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::Begin("##keys", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs);
  ImGui::PushFont(host.bold_font());
  ImGui::TextUnformatted("Keys");
  ImGui::PopFont();
  ImGui::Separator();
  if (ImGui::BeginTable("##table", 2, ImGuiTableFlags_SizingFixedFit)) {
    for (const Key& key : kKeys) {
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      if (key.key == nullptr) {
        ImGui::Dummy({1, 3});
        continue;
      }
      ImGui::PushFont(host.bold_font());
      ImGui::TextUnformatted(key.key);
      ImGui::PopFont();
      ImGui::TableNextColumn();
      ImGui::Text("  %s", key.meaning);
    }
    ImGui::EndTable();
  }
  ImGui::End();
}

void DrawAgentCard(const PanelHost& host, const world::AgentSnapshot& agent, bool followed) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({16, size.y - 16}, ImGuiCond_Always, {0, 1});
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
    const world::Color color = HealthColor(share);
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
  ImGui::End();
}

void DrawAgentLabels(const PanelHost& host, const std::vector<world::AgentSnapshot>& agents,
                     const world::CameraSnapshot& camera, const Projection& projection, std::uint32_t selected) {
  constexpr std::size_t kMostLabels = 60;
  constexpr float kFadeFrom_m = 50, kGone_m = 90;
  struct Label {
    float distance;
    const world::AgentSnapshot* agent;
    std::string text;
    ImFont* font;
    ImVec2 corner, end;
  };
  std::vector<Label> candidates;
  for (const auto& agent : agents) {
    const float distance = world::Distance(agent.position, camera.position);
    if (!(distance < kGone_m) && agent.id != selected) continue;
    const auto at = projection.Project(agent.position + world::Vec3{0, agent.height_m / 2 + 0.28f, 0});
    if (!at || at->x < -100 || at->x > ImGui::GetIO().DisplaySize.x + 100) continue;
    Label label{agent.id == selected ? 0 : distance, &agent, LabelText(agent), nullptr, {}, {}};
    label.font = agent.id == selected ? host.bold_font() : host.panel_font();
    const ImVec2 size = label.font->CalcTextSizeA(label.font->FontSize, FLT_MAX, 0, label.text.c_str());
    label.corner = {std::round(at->x - size.x / 2), std::round(at->y - size.y)};
    label.end = {label.corner.x + size.x, label.corner.y + size.y};
    candidates.push_back(std::move(label));
  }
  // Near ones first: a label gives way to nearer ones. Equal distances keep the agents' order.
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Label& a, const Label& b) { return a.distance < b.distance; });
  std::vector<const Label*> shown;
  for (const Label& label : candidates) {
    const bool covered = std::any_of(shown.begin(), shown.end(), [&](const Label* near) {
      return label.corner.x < near->end.x && near->corner.x < label.end.x && label.corner.y + 3 < near->end.y &&
             near->corner.y + 3 < label.end.y;
    });
    if (!covered) shown.push_back(&label);
    if (shown.size() == kMostLabels) break;
  }

  ImDrawList& out = *ImGui::GetBackgroundDrawList();
  for (const Label* label : shown) {
    const world::AgentSnapshot& agent = *label->agent;
    const float alpha = std::clamp((kGone_m - label->distance) / (kGone_m - kFadeFrom_m), 0.0f, 1.0f);
    const int opacity = static_cast<int>(255 * alpha);
    const ImU32 color = agent.failed ? IM_COL32(255, 130, 112, opacity) : IM_COL32(255, 255, 255, opacity);
    RimmedText(out, label->font, label->corner, color, label->text.c_str(), alpha);
    if (agent.health > 99.5f || !agent.alive) continue;
    const float middle = (label->corner.x + label->end.x) / 2, half = 20, y = label->end.y + 2;
    const float share = std::clamp(agent.health / 100.0f, 0.0f, 1.0f);
    out.AddRectFilled({middle - half - 1, y - 1}, {middle + half + 1, y + 5},
                      IM_COL32(8, 12, 18, static_cast<int>(190 * alpha)));
    out.AddRectFilled({middle - half, y}, {middle - half + 2 * half * share, y + 4}, Packed(HealthColor(share), alpha));
  }
}

}  // namespace soarbox::viewer
