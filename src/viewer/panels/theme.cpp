// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/theme.h"

namespace soarbox::viewer {
namespace {

ImVec4 Faded(ImVec4 color, float alpha) {
  color.w = alpha;
  return color;
}

}  // namespace

void ApplyTheme(float scale) {
  using namespace theme;
  ImGuiStyle style;
  ImGui::StyleColorsDark(&style);
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
  c[ImGuiCol_FrameBgHovered] = {0.10f, 0.14f, 0.18f, 1};
  c[ImGuiCol_FrameBgActive] = {0.12f, 0.17f, 0.22f, 1};
  c[ImGuiCol_Button] = {0.16f, 0.20f, 0.25f, 1};
  c[ImGuiCol_ButtonHovered] = {0.20f, 0.29f, 0.37f, 1};
  c[ImGuiCol_ButtonActive] = {0.18f, 0.38f, 0.52f, 1};
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
  c[ImGuiCol_TableRowBgAlt] = {1, 1, 1, 0.022f};
  c[ImGuiCol_ScrollbarBg] = {0, 0, 0, 0.15f};
  c[ImGuiCol_ScrollbarGrab] = {0.27f, 0.32f, 0.38f, 1};
  c[ImGuiCol_TextSelectedBg] = Faded(kAccent, 0.40f);
  c[ImGuiCol_PlotLines] = kAccent;
  c[ImGuiCol_ModalWindowDimBg] = {0, 0, 0, 0.45f};
  style.ScaleAllSizes(scale);
  ImGui::GetStyle() = style;
}

}  // namespace soarbox::viewer
