// SPDX-License-Identifier: BSD-2-Clause
#include <string>
#include <utility>

#include "picture/png.h"
#include "script/host_test_support.h"
#include "world/asset_store.h"

// Buttons, bars and images of panels, and files that scripts use.

namespace soarbox::script {
namespace {

using world::EntityId;

constexpr const char* kPanelWorld = R"(
function Sandbox_Initialize(s)
  sandbox = s
  ui = Sandbox.CreateUIComponent(s, 1)
  presses = 0
  UI.SetButton(ui, "go", function(sandbox, panel) presses = presses + 1; print(panel == ui) end)
end
)";

class PanelPartsTest : public HostTest {
 protected:
  PanelPartsTest() {
    Write("badge.png", picture::PngOf(picture::Image(4, 2, {1, 0, 0, 1})));
    StartWith(kPanelWorld);
  }
};

TEST_F(PanelPartsTest, APressCallsTheFunctionOfAButtonThatIsShown) {
  EXPECT_TRUE(host_->PressButton("go"));
  EXPECT_EQ(Printed(), "true");
  Run("UI.SetVisible(ui, false)");
  EXPECT_TRUE(host_->PressButton("go"));
  EXPECT_EQ(Run("print(presses)"), "1");
  Run("UI.SetVisible(ui, true); UI.RemoveButton(ui)");
  EXPECT_FALSE(host_->PressButton("go"));
  EXPECT_EQ(Run("print(UI.GetButton(ui))"), "nil");
}

TEST_F(PanelPartsTest, ARemovedPanelIsNoButtonAnyMore) {
  Run("child = UI.CreateChild(ui) UI.SetButton(child, 'in', function() UI.Remove(ui) end)");
  EXPECT_TRUE(host_->PressButton("in")) << "it removes itself with its parent";
  EXPECT_FALSE(host_->PressButton("in"));
  EXPECT_FALSE(host_->PressButton("go"));
  EXPECT_EQ(Errors(), "");
}

TEST_F(PanelPartsTest, AFunctionThatFailsIsReportedAndTheWorldGoesOn) {
  Run("UI.SetButton(ui, 'go', function() error('no') end)");
  EXPECT_TRUE(host_->PressButton("go"));
  host_->TellTroubles();
  EXPECT_NE(Errors().find("no"), std::string::npos) << Errors();
  Tick();
}

TEST_F(PanelPartsTest, AButtonMayReplaceItsOwnFunctionWhileItRuns) {
  Run("UI.SetButton(ui, 'go', function(s, ui) UI.SetButton(ui, 'stop', function() print('stopped') end) end)");
  EXPECT_TRUE(host_->PressButton("go"));
  EXPECT_FALSE(host_->PressButton("go"));
  EXPECT_TRUE(host_->PressButton("stop"));
  EXPECT_EQ(Printed(), "stopped");
  EXPECT_EQ(Errors(), "");
}

TEST_F(PanelPartsTest, PanelsShowTheirPartsInTheScene) {
  EXPECT_EQ(Run("UI.SetBar(ui, 0.25, 1, 0, 0); UI.SetImage(ui, 'badge.png'); print(UI.GetBar(ui))"), "0.25");
  const world::UiSnapshot panel = std::as_const(*world_).Snapshot().ui.at(0);
  EXPECT_EQ(panel.button, "go");
  EXPECT_TRUE(panel.has_bar);
  EXPECT_FLOAT_EQ(panel.bar, 0.25f);
  EXPECT_FLOAT_EQ(panel.bar_color.r, 1);
  EXPECT_EQ(world::AssetName(panel.material), "badge.png");
  ASSERT_NE(world::FindAsset(panel.material), nullptr);
  EXPECT_TRUE(world::FindAsset(panel.material)->starts_with("\x89PNG"));
  EXPECT_EQ(Run("UI.RemoveBar(ui); UI.RemoveImage(ui); print(UI.GetBar(ui))"), "nil");
  EXPECT_EQ(std::as_const(*world_).Snapshot().ui.at(0).material, "");
}

TEST_F(PanelPartsTest, FilesStayInsideTheWorldsFolders) {
  EXPECT_NE(Run("UI.SetImage(ui, '/etc/passwd')").find("named relative to the scenario's folder"), std::string::npos);
  EXPECT_NE(Run("UI.SetImage(ui, 'a/../../b.png')").find("named relative to the scenario's folder"), std::string::npos);
  EXPECT_NE(Run("UI.SetImage(ui, 'bagde.png')").find("did you mean \"badge.png\"?"), std::string::npos);
  EXPECT_NE(Run("UI.SetImage(ui, 'Sandbox.lua')").find("Sandbox.lua: this is not a PNG file"), std::string::npos);
}

TEST_F(HostTest, TheRoverCollectsCrystalsByItselfAndByGamepad) {
  settings_.script_folders.insert(settings_.script_folders.begin(),
                                  std::filesystem::path(SOARBOX_SOURCE_DIR) / "scenarios" / "rover");
  Start();
  ASSERT_EQ(Errors(), "");
  ASSERT_EQ(world_->AgentIds().size(), 1u);
  const EntityId rover = world_->AgentIds()[0];
  Ticks(5);
  EXPECT_LT(world_->FindAgent(rover)->Speed(), 0.01f) << "it waits for its button";
  EXPECT_TRUE(host_->PressButton("start"));
  bool has_rung = false;
  for (int tick = 0; tick < 600; ++tick) {
    Tick();
    for (const world::SoundSnapshot& sound : std::as_const(*world_).Snapshot().sounds)
      has_rung |= world::AssetName(sound.file) == "chime.wav" && sound.in_world;
  }
  EXPECT_TRUE(has_rung) << "it has found a crystal";
  const world::SceneSnapshot scene = std::as_const(*world_).Snapshot();
  EXPECT_GT(std::stoi(scene.ui[2].text), 1) << "crystals";
  int models = 0;
  for (const world::DrawableSnapshot& drawable : scene.drawables)
    models += !world::AssetName(drawable.mesh.value()).empty();
  EXPECT_EQ(models, 10);

  EXPECT_TRUE(host_->PressButton("autopilot"));
  InputEvent stick;
  stick.source = InputEvent::Source::kGamepad;
  stick.pad = 1;
  stick.axis = "left_y";
  stick.value = 1;
  host_->HandleInput(stick);
  Ticks(60);
  const world::Agent* agent = world_->FindAgent(rover);
  EXPECT_LT(Dot(agent->Velocity(), agent->Forward()), -3) << "the stick is pulled back: it reverses";
  EXPECT_EQ(Errors(), "");
}

}  // namespace
}  // namespace soarbox::script
