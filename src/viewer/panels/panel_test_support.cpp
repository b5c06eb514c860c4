// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/panel_test_support.h"

#include <gmock/gmock.h>

#include "viewer/panels/draw_limit.h"
#include "viewer/panels/layout_audit.h"
#include "viewer/panels/text_capture.h"
#include "viewer/panels/theme.h"

namespace soarbox::viewer {
PanelStage::PanelStage() {
  context_ = ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
}
PanelStage::~PanelStage() {
  ImGui::DestroyContext(context_);
}

void PanelStage::SetSize(int new_width, int new_height, int new_percent) {
  width = new_width;
  height = new_height;
  percent = new_percent;
  const float scale = static_cast<float>(percent) / 100;
  ImGui::GetIO().DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
  ImGui::GetIO().DeltaTime = 1.0f / 30;
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  fonts_ = AddPanelFonts(scale);
  ImGui::GetIO().FontDefault = fonts_.plain;
  ApplyTheme(scale);
  unsigned char* pixels = nullptr;
  int pixels_wide = 0, pixels_high = 0;
  atlas.GetTexDataAsRGBA32(&pixels, &pixels_wide, &pixels_high);
}

void PanelStage::Draw(const Layout& arranged, const std::function<void(Workspace&)>& in_the_last) {
  Workspace workspace(arranged);
  workspace.layout.SetText(percent);
  world::SceneSnapshot scene = simulation->Snapshot();
  scene.ui = script_ui;
  const RunStatus status;
  ++contents.revision;  // Tests change contents directly.
  std::uint32_t selected = 0;
  for (const world::AgentSnapshot& agent : scene.agents)
    if (agent.name == contents.agent) selected = agent.id;
  constexpr int kFrames = 3;  // Tables and windows have their sizes after the first frame.
  for (int i = 0; i < kFrames; ++i) {
    std::vector<workbench::Request> requests;
    std::vector<ViewerCommand> commands;
    if (i + 1 == kFrames && in_the_last) in_the_last(workspace);
    ImGui::NewFrame();
    PanelFrame frame{contents,         scene,    status,   fonts_,   static_cast<float>(percent) / 100,
                     workspace.layout, selected, requests, commands, [](ViewerCommand) { return false; }};
    workspace.Draw(frame, width, height, 60);
    ImGui::EndFrame();
    overfull = CutOverfullWindows();  // As in the window; without this ImGui would end the program.
    ImGui::Render();
  }
  cover = workspace.cover();
  shown.clear();
  for (const ShownText& text : CaptureText(*ImGui::GetDrawData(), *ImGui::GetIO().Fonts)) shown += text.text + "\n";
  complaints = AuditLayout(*ImGui::GetIO().Fonts);
}

void PanelStage::Draw(workbench::PanelId panel,
                      const std::function<void(Workspace&, workbench::PanelId)>& in_the_last) {
  Layout layout = DefaultLayout();
  layout.Show(panel);
  Draw(layout, [&](Workspace& workspace) {
    if (in_the_last) in_the_last(workspace, panel);
  });
}

std::string PanelStage::Copy(workbench::PanelId panel) {
  ImGui::SetClipboardText("");
  Draw(panel, [](Workspace& workspace, workbench::PanelId opened) {
    workspace.Open(opened);
    workspace.CopyPanel();
  });
  return ImGui::GetClipboardText();
}

void Panels::ExpectShown(workbench::PanelId panel, const std::vector<const char*>& texts) {
  stage->Draw(panel);
  for (const char* text : texts) EXPECT_THAT(stage->shown, testing::HasSubstr(text)) << InfoOf(panel).word;
}

}  // namespace soarbox::viewer
