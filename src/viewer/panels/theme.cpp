// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/theme.h"

namespace soarbox::viewer {
namespace {

ImVec4 Faded(ImVec4 color, float alpha) {
  color.w = alpha;
  return color;
}

void UseDark() {
  using namespace theme;
  kText = {0.91f, 0.93f, 0.95f, 1};
  kQuiet = {0.61f, 0.67f, 0.73f, 1};
  kGround = {0.075f, 0.095f, 0.122f, 1};
  kRaised = {0.115f, 0.143f, 0.180f, 1};
  kField = {0.045f, 0.060f, 0.080f, 1};
  kEdge = {0.20f, 0.24f, 0.29f, 1};
  kAccent = {0.34f, 0.71f, 0.91f, 1};
  kGood = {0.18f, 0.75f, 0.56f, 1};
  kWarn = {0.95f, 0.68f, 0.13f, 1};
  kBad = {0.97f, 0.49f, 0.29f, 1};
  kNumber = {0.94f, 0.89f, 0.26f, 1};
  kVariable = {0.86f, 0.58f, 0.74f, 1};
}

/// The same hues, dark enough for a white background.
void UseLight() {
  using namespace theme;
  kText = {0.09f, 0.11f, 0.14f, 1};
  kQuiet = {0.34f, 0.39f, 0.45f, 1};
  kGround = {0.955f, 0.962f, 0.970f, 1};
  kRaised = {0.890f, 0.905f, 0.922f, 1};
  kField = {1.0f, 1.0f, 1.0f, 1};
  kEdge = {0.72f, 0.75f, 0.79f, 1};
  kAccent = {0.00f, 0.36f, 0.62f, 1};
  kGood = {0.00f, 0.42f, 0.31f, 1};
  kWarn = {0.60f, 0.36f, 0.00f, 1};
  kBad = {0.72f, 0.22f, 0.00f, 1};
  kNumber = {0.45f, 0.38f, 0.00f, 1};
  kVariable = {0.56f, 0.22f, 0.42f, 1};
}

}  // namespace

void ApplyTheme(float scale, bool light) {
  using namespace theme;
  light ? UseLight() : UseDark();
  ImGuiStyle style;
  light ? ImGui::StyleColorsLight(&style) : ImGui::StyleColorsDark(&style);
  style.WindowRounding = 0;
  style.ChildRounding = 4;
  style.FrameRounding = 4;
  style.PopupRounding = 5;
  style.GrabRounding = 4;
  style.ScrollbarRounding = 6;
  style.ScrollbarSize = 12;
  style.WindowBorderSize = 1;
  style.PopupBorderSize = 1;
  style.FrameBorderSize = 1;
  style.WindowPadding = {8, 7};
  style.FramePadding = {7, 4};
  style.ItemSpacing = {7, 5};
  style.ItemInnerSpacing = {5, 4};
  style.CellPadding = {5, 3};
  style.IndentSpacing = 16;

  ImVec4* c = style.Colors;
  c[ImGuiCol_Text] = kText;
  c[ImGuiCol_TextDisabled] = kQuiet;
  c[ImGuiCol_WindowBg] = kGround;
  c[ImGuiCol_ChildBg] = {0, 0, 0, 0};
  c[ImGuiCol_PopupBg] = Faded(kRaised, 0.98f);
  c[ImGuiCol_MenuBarBg] = kRaised;
  c[ImGuiCol_Border] = kEdge;
  c[ImGuiCol_FrameBg] = kField;
  const auto either = [light](ImVec4 on_dark, ImVec4 on_light) { return light ? on_light : on_dark; };
  c[ImGuiCol_FrameBgHovered] = either({0.10f, 0.14f, 0.18f, 1}, {0.95f, 0.97f, 1.0f, 1});
  c[ImGuiCol_FrameBgActive] = either({0.12f, 0.17f, 0.22f, 1}, {0.91f, 0.95f, 1.0f, 1});
  c[ImGuiCol_Button] = either({0.16f, 0.20f, 0.25f, 1}, {0.83f, 0.86f, 0.89f, 1});
  c[ImGuiCol_ButtonHovered] = either({0.20f, 0.29f, 0.37f, 1}, {0.75f, 0.83f, 0.91f, 1});
  c[ImGuiCol_ButtonActive] = either({0.18f, 0.38f, 0.52f, 1}, {0.60f, 0.76f, 0.90f, 1});
  c[ImGuiCol_Header] = Faded(kAccent, 0.24f);
  c[ImGuiCol_HeaderHovered] = Faded(kAccent, 0.16f);
  c[ImGuiCol_HeaderActive] = Faded(kAccent, 0.34f);
  c[ImGuiCol_CheckMark] = kAccent;
  c[ImGuiCol_SliderGrab] = Faded(kAccent, 0.65f);
  c[ImGuiCol_SliderGrabActive] = kText;
  c[ImGuiCol_Separator] = kEdge;
  c[ImGuiCol_SeparatorHovered] = kAccent;
  c[ImGuiCol_SeparatorActive] = kAccent;
  c[ImGuiCol_TableHeaderBg] = kRaised;
  c[ImGuiCol_TableBorderLight] = Faded(kEdge, 0.5f);
  c[ImGuiCol_TableBorderStrong] = kEdge;
  c[ImGuiCol_TableRowBgAlt] = either({1, 1, 1, 0.022f}, {0, 0, 0, 0.03f});
  c[ImGuiCol_ScrollbarBg] = either({0, 0, 0, 0.15f}, {0, 0, 0, 0.06f});
  c[ImGuiCol_ScrollbarGrab] = either({0.27f, 0.32f, 0.38f, 1}, {0.66f, 0.70f, 0.75f, 1});
  c[ImGuiCol_TextSelectedBg] = Faded(kAccent, 0.40f);
  c[ImGuiCol_PlotLines] = kAccent;
  c[ImGuiCol_ModalWindowDimBg] = {0, 0, 0, 0.45f};
  style.ScaleAllSizes(scale);
  ImGui::GetStyle() = style;
}

}  // namespace soarbox::viewer
