// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/icons.h"

#include <numbers>

#include "viewer/panels/layout_audit.h"
#include "viewer/panels/theme.h"
#include "viewer/panels/widgets.h"

namespace soarbox::viewer {
namespace {

/// Draws icons in a square of 12 by 12 units around a centre.
class Sign {
 public:
  Sign(ImVec2 centre, float unit, ImU32 color)
      : out_(*ImGui::GetWindowDrawList()), c_(centre), u_(unit), color_(color) {}

  void Triangle(float x, float y, float half, bool right = true) {
    const float tip = right ? half : -half;
    out_.AddTriangleFilled(At(x - tip, y - half * 1.15f), At(x - tip, y + half * 1.15f), At(x + tip, y), color_);
  }
  void Bar(float x, float half_height, float width = 2) {
    out_.AddRectFilled(At(x - width / 2, -half_height), At(x + width / 2, half_height), color_);
  }
  void Dot(float x, float y, float radius) { out_.AddCircleFilled(At(x, y), radius * u_, color_); }
  void Line(float x1, float y1, float x2, float y2) { out_.AddLine(At(x1, y1), At(x2, y2), color_, 1.6f * u_); }
  void Ring(float from, float to) {
    constexpr float kTurn = 2 * std::numbers::pi_v<float>;
    out_.PathArcTo(c_, 4.4f * u_, from * kTurn, to * kTurn, 20);
    out_.PathStroke(color_, 0, 1.8f * u_);
  }

 private:
  ImVec2 At(float x, float y) const { return {c_.x + x * u_, c_.y + y * u_}; }
  ImDrawList& out_;
  ImVec2 c_;
  float u_;
  ImU32 color_;
};

void Draw(Icon icon, Sign sign) {
  switch (icon) {
    case Icon::kPlay:
      sign.Triangle(0.5f, 0, 4.5f);
      break;
    case Icon::kPause:
      sign.Bar(-2.5f, 4.5f, 3);
      sign.Bar(2.5f, 4.5f, 3);
      break;
    case Icon::kStepTick:
      sign.Bar(-3.5f, 4.5f);
      sign.Triangle(1.5f, 0, 3.8f);
      break;
    case Icon::kStepDecision:
      sign.Dot(-3.5f, 0, 1.8f);
      sign.Triangle(1.8f, 0, 3.4f);
      break;
    case Icon::kStepPhase:
      sign.Dot(-4.5f, 0, 1);
      sign.Dot(-1.6f, 0, 1);
      sign.Triangle(3, 0, 2.6f);
      break;
    case Icon::kReset:
      sign.Ring(-0.15f, 0.62f);
      sign.Triangle(-1.2f, -4.4f, 2.4f, false);
      break;
    case Icon::kNextSeed:
      for (const float x : {-3.0f, 3.0f})
        for (const float y : {-3.0f, 3.0f}) sign.Dot(x, y, 1.3f);
      sign.Dot(0, 0, 1.3f);
      break;
    case Icon::kStepBack:
      sign.Triangle(-0.5f, 0, 4, false);
      break;
    case Icon::kToBegin:
      sign.Bar(-4.5f, 4.5f);
      sign.Triangle(1, 0, 4, false);
      break;
    case Icon::kToEnd:
      sign.Triangle(-1, 0, 4);
      sign.Bar(4.5f, 4.5f);
      break;
    case Icon::kBranch:
      sign.Line(-4, 4, -4, -4);
      sign.Line(-4, 2, 3, -1);
      sign.Dot(-4, -4, 2);
      sign.Dot(-4, 4, 2);
      sign.Dot(3.5f, -1.5f, 2);
      break;
  }
}

}  // namespace

bool IconButton(Icon icon, const char* id, std::string_view word, std::string_view tooltip, bool enabled, bool lit) {
  ImGui::PushID(id);
  ImGui::BeginDisabled(!enabled);
  const float font = ImGui::GetFontSize(), pad = ImGui::GetStyle().FramePadding.x;
  const ImVec2 text = ImGui::CalcTextSize(word.data(), word.data() + word.size());
  const float width = font + 2 * pad + (word.empty() ? 0 : text.x + pad * 0.6f);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  if (lit) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
  const bool clicked = ImGui::Button("##button", {width, ImGui::GetFrameHeight()});
  if (lit) ImGui::PopStyleColor();
  const float middle = corner.y + ImGui::GetFrameHeight() / 2;
  const ImU32 color = theme::Packed(theme::kText, enabled ? 1.0f : 0.35f);
  Draw(icon, Sign({corner.x + pad + font / 2, middle}, font / 13, color));
  if (!word.empty()) {
    PutText(*ImGui::GetWindowDrawList(), {corner.x + 1.6f * pad + font, middle - text.y / 2}, color, word);
  }
  ImGui::EndDisabled();
  if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
    ImGui::BeginTooltip();
    ImGui::TextUnformatted(tooltip.data(), tooltip.data() + tooltip.size());
    ImGui::EndTooltip();
  }
  ImGui::PopID();
  return clicked;
}

}  // namespace soarbox::viewer
