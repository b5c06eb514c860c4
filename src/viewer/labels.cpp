// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/labels.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "viewer/palette.h"

namespace soarbox::viewer {
namespace {

constexpr std::size_t kMostLabels = 80;
constexpr float kFadeFrom_m = 95, kGone_m = 120;
constexpr float kTop_px = 30;  // Below the bar at the top.
constexpr ImU32 kPaper = IM_COL32(12, 17, 24, 188);

ImU32 Packed(world::Color c, float alpha = 1) {
  return ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, c.a * alpha});
}

ImU32 Faded(ImU32 color, float alpha) {
  const auto opacity = static_cast<ImU32>(static_cast<float>(color >> IM_COL32_A_SHIFT) * alpha);
  return (color & ~IM_COL32_A_MASK) | (opacity << IM_COL32_A_SHIFT);
}

/// From red through amber to green; the length of the bar says the same to those who do not tell them apart.
world::Color HealthColor(float share) {
  return share < 0.5f ? world::Color{0.92f, 0.25f + 0.9f * share, 0.08f, 1}
                      : world::Color{0.92f - 1.6f * (share - 0.5f), 0.70f, 0.08f + 0.8f * (share - 0.5f), 1};
}

std::string NameOf(const world::AgentSnapshot& agent) {
  return agent.name.empty() ? "agent " + std::to_string(agent.id) : agent.name.substr(0, 40);
}

/// What an agent is about in a word or two.
std::string StateOf(const world::AgentSnapshot& agent, const world::AgentOverlay* overlay) {
  if (agent.failed) return "stopped by an error";
  if (!agent.alive) return "dead";
  std::string mind = overlay != nullptr ? overlay->operator_name : std::string();
  const std::string body = overlay != nullptr && !overlay->doing.empty() ? overlay->doing : agent.last_command;
  if (mind.size() > 24) mind = mind.substr(0, 23) + "\xe2\x80\xa6";
  if (mind.empty()) return body.substr(0, 30);
  if (body.empty() || body == mind) return mind;
  return mind + " \xc2\xb7 " + body.substr(0, 24);
}

struct Label {
  const world::AgentSnapshot* agent = nullptr;
  float rank = 0;  ///< Smaller ones keep their place.
  bool is_selected = false;
  std::string name, state;
  ImVec2 at;  ///< The middle of its lower edge.
  ImVec2 low, high;
  float alpha = 1;
};

ImVec2 TextSize(const ImFont* font, const std::string& text) {
  return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str());
}

/// Sizes of a label's parts for the fonts of the window.
struct Metrics {
  ImFont *name, *state;
  float pad, swatch, bar;

  explicit Metrics(const PanelHost& host)
      : name(host.bold_font()),
        state(host.panel_font()),
        pad(name->FontSize * 0.27f),
        swatch(name->FontSize * 0.30f),
        bar(std::max(3.0f, name->FontSize * 0.25f)) {}

  void Lay(Label& label) const {
    const ImVec2 n = TextSize(name, label.name);
    const ImVec2 s = label.state.empty() ? ImVec2{0, 0} : TextSize(state, label.state);
    const float width = std::max(n.x, s.x) + 3 * pad + swatch;
    const float height = n.y + s.y + bar + 2 * pad;
    label.low = {std::round(label.at.x - width / 2), std::round(label.at.y - height)};
    label.high = {label.low.x + width, label.low.y + height};
  }
};

bool Overlap(const Label& a, const ScreenBox& b) {
  return a.low.x < b.right + 2 && b.left < a.high.x + 2 && a.low.y < b.bottom + 2 && b.top < a.high.y + 2;
}

/// Finds room for a label beside those that have theirs; false if there is none.
bool FindRoom(Label& label, const std::vector<ScreenBox>& taken, const Metrics& metrics, float top) {
  // Above its agent if that can be, else higher, else to the sides; in widths and heights of the label.
  const ImVec2 kPlaces[] = {{0, 0},         {0, 0.6f},    {0.6f, 0.3f},  {-0.6f, 0.3f}, {0, 1.2f},    {1.1f, -0.4f},
                            {-1.1f, -0.4f}, {0.7f, 1.2f}, {-0.7f, 1.2f}, {0, 1.8f},     {1.2f, 0.8f}, {-1.2f, 0.8f},
                            {0, 2.6f},      {1.3f, 1.8f}, {-1.3f, 1.8f}, {0, 3.6f}};
  const auto covers = [&](const ScreenBox& other) { return Overlap(label, other); };
  for (const bool is_short : {false, true}) {
    if (is_short && label.state.empty()) break;
    if (is_short) label.state.clear();
    for (const ImVec2 place : kPlaces) {
      metrics.Lay(label);
      const ImVec2 size{label.high.x - label.low.x, label.high.y - label.low.y};
      const float y = std::max(label.low.y - place.y * size.y, top);
      label.low = {std::round(label.low.x + place.x * size.x), std::round(y)};
      label.high = {label.low.x + size.x, label.low.y + size.y};
      if (std::none_of(taken.begin(), taken.end(), covers)) return true;
    }
  }
  return label.is_selected;
}

void Paint(const Label& label, const Metrics& metrics) {
  ImDrawList& out = *ImGui::GetBackgroundDrawList();
  const world::AgentSnapshot& agent = *label.agent;
  const float alpha = label.alpha;
  // A label that moved away keeps a thread to its agent.
  const ImVec2 near{std::clamp(label.at.x, label.low.x + 3, label.high.x - 3),
                    std::clamp(label.at.y, label.low.y + 3, label.high.y)};
  if (std::abs(near.x - label.at.x) + std::abs(near.y - label.at.y) > 5)
    out.AddLine(near, label.at, Faded(IM_COL32(255, 255, 255, 170), alpha), 1.2f);
  const world::Color team = agent.team.empty() ? AgentColor(agent.kind) : TeamColor(agent.team);
  out.AddRectFilled(label.low, label.high, Faded(kPaper, alpha), 4);
  out.AddRectFilled(label.low, {label.low.x + metrics.swatch, label.high.y}, Packed(team, alpha), 4,
                    ImDrawFlags_RoundCornersLeft);
  if (label.is_selected) out.AddRect(label.low, label.high, Faded(IM_COL32(255, 219, 90, 255), alpha), 4, 0, 1.6f);
  const float left = label.low.x + metrics.swatch + metrics.pad;
  float y = label.low.y + metrics.pad * 0.6f;
  const ImU32 ink = agent.failed ? IM_COL32(255, 150, 132, 255) : IM_COL32(255, 255, 255, 255);
  out.AddText(metrics.name, metrics.name->FontSize, {left, y}, Faded(ink, alpha), label.name.c_str());
  y += metrics.name->FontSize;
  if (!label.state.empty()) {
    const ImU32 quiet = agent.failed ? ink : IM_COL32(188, 204, 220, 255);
    out.AddText(metrics.state, metrics.state->FontSize, {left, y}, Faded(quiet, alpha), label.state.c_str());
    y += metrics.state->FontSize;
  }
  if (!agent.alive) return;
  const float share = std::clamp(agent.health / 100.0f, 0.0f, 1.0f);
  const float top = label.high.y - metrics.pad * 0.7f - metrics.bar, right = label.high.x - metrics.pad;
  out.AddRectFilled({left, top}, {right, top + metrics.bar}, Faded(IM_COL32(60, 70, 82, 255), alpha), 1);
  out.AddRectFilled({left, top}, {left + (right - left) * share, top + metrics.bar}, Packed(HealthColor(share), alpha),
                    1);
}

}  // namespace

const world::AgentOverlay* OverlayOf(const world::OverlaySnapshot& overlays, std::uint32_t agent_id) {
  const auto at = std::lower_bound(overlays.agents.begin(), overlays.agents.end(), agent_id,
                                   [](const world::AgentOverlay& a, std::uint32_t id) { return a.id < id; });
  return at != overlays.agents.end() && at->id == agent_id ? &*at : nullptr;
}

void DrawAgentLabels(const PanelHost& host, const LabelScene& scene, const world::CameraSnapshot& camera,
                     const Projection& projection, std::vector<ScreenBox>& taken) {
  const Metrics metrics(host);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  std::vector<Label> candidates;
  for (const auto& agent : scene.agents) {
    if (agent.id == scene.hidden) continue;
    const bool is_selected =
        std::find(scene.selection.begin(), scene.selection.end(), agent.id) != scene.selection.end();
    const bool stands_out = is_selected || agent.id == scene.hovered;
    const float distance = world::Distance(agent.position, camera.position);
    // From high above, as on a map, distance says little.
    const float gone_m = std::max(kGone_m, 2.2f * camera.position.y), fade_m = gone_m * kFadeFrom_m / kGone_m;
    if (!(distance < gone_m) && !stands_out) continue;
    const auto at = projection.Project(agent.position + world::Vec3{0, agent.height_m / 2 + 0.22f, 0});
    if (!at || at->x < -20 || at->x > screen.x + 20 || at->y < 0 || at->y > screen.y + 40) continue;
    Label label;
    label.agent = &agent;
    label.is_selected = stands_out;
    label.rank = stands_out ? 0 : distance + (agent.alive ? 0 : 1000);
    label.name = NameOf(agent);
    label.state = StateOf(agent, OverlayOf(scene.overlays, agent.id));
    label.at = {at->x, at->y};
    label.alpha = stands_out ? 1 : std::clamp((gone_m - distance) / (gone_m - fade_m), 0.0f, 1.0f);
    if (!agent.alive) label.alpha *= 0.6f;
    candidates.push_back(std::move(label));
  }
  // Near ones first. Equal distances keep the agents' order.
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Label& a, const Label& b) { return a.rank < b.rank; });
  std::vector<Label> shown;
  for (Label& label : candidates) {
    if (shown.size() == kMostLabels) break;
    if (!FindRoom(label, taken, metrics, kTop_px)) continue;
    taken.push_back({label.low.x, label.low.y, label.high.x, label.high.y});
    shown.push_back(std::move(label));
  }
  for (auto label = shown.rbegin(); label != shown.rend(); ++label) Paint(*label, metrics);
}

void DrawSpeech(const PanelHost& host, const LabelScene& scene, const Projection& projection,
                std::vector<ScreenBox>& taken) {
  constexpr double kShown_s = 3.5, kFades_s = 0.6;
  constexpr float kWidest_px = 230;
  ImDrawList& out = *ImGui::GetBackgroundDrawList();
  ImFont* font = host.panel_font();
  const float pad = font->FontSize * 0.45f;
  // The newest thing that each agent said.
  std::unordered_map<std::uint32_t, const world::SpeechSnapshot*> last;
  for (const world::SpeechSnapshot& speech : scene.overlays.speech) {
    if (speech.age_s < kShown_s) last[speech.from_id] = &speech;
  }
  for (const auto& agent : scene.agents) {
    const auto found = last.find(agent.id);
    if (found == last.end() || agent.id == scene.hidden) continue;
    const auto head = projection.Project(agent.position + world::Vec3{0, agent.height_m * 0.42f, 0});
    if (!head) continue;
    const world::SpeechSnapshot& speech = *found->second;
    std::string text = speech.text.substr(0, 160);
    for (const auto& other : scene.agents) {
      if (other.id == speech.to_id) text = "to " + other.name + ": " + text;
    }
    const float alpha = static_cast<float>(std::clamp((kShown_s - speech.age_s) / kFades_s, 0.0, 1.0));
    const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, kWidest_px, text.c_str());
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    // To the right of the head, or to the left where there is no room; below bubbles that are there already.
    bool is_left = head->x + 24 + size.x + 2 * pad > screen.x;
    ScreenBox box;
    box.left = is_left ? head->x - 24 - size.x - 2 * pad : head->x + 24;
    box.top = std::max(kTop_px, head->y - size.y / 2 - pad - 6);
    for (const ScreenBox& other : taken) {
      const bool meets = box.left < other.right && other.left < box.left + size.x + 2 * pad &&
                         box.top < other.bottom + 3 && other.top < box.top + size.y + 2 * pad + 3;
      if (meets) box.top = other.bottom + 4;
    }
    box.right = box.left + size.x + 2 * pad;
    box.bottom = box.top + size.y + 2 * pad;
    taken.push_back(box);
    const ImU32 paper = Faded(IM_COL32(250, 249, 242, 238), alpha);
    const float x = is_left ? box.right : box.left, y = std::clamp(head->y, box.top + 6, box.bottom - 6);
    out.AddTriangleFilled({x, y - 5}, {x, y + 5}, {head->x + (is_left ? -7.0f : 7.0f), head->y}, paper);
    out.AddRectFilled({box.left, box.top}, {box.right, box.bottom}, paper, 7);
    out.AddText(font, font->FontSize, {box.left + pad, box.top + pad}, Faded(IM_COL32(24, 30, 38, 255), alpha),
                text.c_str(), nullptr, kWidest_px);
  }
}

void DrawGhostLabels(const PanelHost& host, const std::vector<Ghost>& ghosts, const Projection& projection,
                     const std::vector<ScreenBox>& taken) {
  ImDrawList& out = *ImGui::GetBackgroundDrawList();
  ImFont* font = host.panel_font();
  std::vector<ScreenBox> occupied = taken;
  for (const Ghost& ghost : ghosts) {
    if (ghost.name.empty()) continue;
    const auto head = projection.Project(ghost.position + world::Vec3{0, ghost.height_m / 2 + 0.15f, 0});
    const auto feet = projection.Project(ghost.position - world::Vec3{0, ghost.height_m / 2, 0});
    if (!head || !feet) continue;
    const ImVec2 size = TextSize(font, ghost.name);
    ScreenBox box;
    box.left = std::round(head->x - size.x / 2) - 4;
    box.right = box.left + size.x + 8;
    const auto place = [&](float top) {
      box.top = std::round(top);
      box.bottom = box.top + size.y + 2;
      return std::none_of(occupied.begin(), occupied.end(), [&](const ScreenBox& other) {
        return box.left < other.right && other.left < box.right && box.top < other.bottom && other.top < box.bottom;
      });
    };
    // Above the figure, else below its feet, else further down.
    const float line = size.y + 4;
    if (!place(head->y - line) && !place(feet->y + 3) && !place(feet->y + 3 + line) && !place(feet->y + 3 + 2 * line) &&
        !place(head->y - 2 * line))
      continue;
    occupied.push_back(box);
    out.AddRectFilled({box.left, box.top}, {box.right, box.bottom}, IM_COL32(12, 17, 24, 150), 3);
    world::Color ink = ghost.color;
    for (float* channel : {&ink.r, &ink.g, &ink.b}) *channel = 0.45f + 0.55f * *channel;
    ink.a = std::clamp(0.5f + ghost.opacity, 0.0f, 1.0f);
    out.AddText(font, font->FontSize, {box.left + 4, box.top + 1}, Packed(ink), ghost.name.c_str());
  }
}

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
    labels = std::max(labels, TextSize(plain, label).x);
    values = std::max(values, TextSize(plain, value).x);
  }
  const std::string name = NameOf(agent);
  const float width = std::max(TextSize(bold, name).x, labels + pad + values) + 2 * pad;
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
  const ImVec2 size = TextSize(font, text), screen = ImGui::GetIO().DisplaySize;
  const ImVec2 low{std::round((screen.x - size.x) / 2), std::round(screen.y * 0.86f)};
  const float pad = font->FontSize * 0.6f;
  out.AddRectFilled({low.x - pad, low.y - pad * 0.7f}, {low.x + size.x + pad, low.y + size.y + pad * 0.7f},
                    Faded(IM_COL32(12, 17, 24, 225), opacity), 6);
  out.AddText(font, font->FontSize, low, Faded(IM_COL32(255, 236, 190, 255), opacity), text.c_str());
}

}  // namespace soarbox::viewer
