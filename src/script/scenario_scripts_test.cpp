// SPDX-License-Identifier: BSD-2-Clause
#include "script/host_test_support.h"

// Entire scenarios: the thesis' world in the dialect of its scripts with minds that always give the same command, and
// agents that only scripts control, with our Lua library.

namespace soarbox::script {
namespace {

using world::EntityId;
using world::Vec3;

class ThesisScriptsTest : public HostTest {
 protected:
  void SetUp() override {
    settings_.script_folders.insert(settings_.script_folders.begin() + 1, {SOARBOX_SOURCE_DIR "/tests/thesis/scripts",
                                                                           SOARBOX_SOURCE_DIR "/scenarios/thesis"});
    commands_ = {{"seeking", "sametarget"}, {"follower", "follow"}, {"waypoint", "samewaypoint"}};
  }
};

TEST_F(ThesisScriptsTest, RunForThreeHundredTicks) {
  Start();
  ASSERT_TRUE(loaded_);
  ASSERT_EQ(world_->AgentIds().size(), 6u);
  EXPECT_EQ(minds_.made.size(), 5u);
  Ticks(300);
  EXPECT_EQ(Errors(), "");
  EXPECT_TRUE(recorder_.warnings.empty()) << recorder_.warnings[0].message;
  const Vec3 leader = world_->FindAgent(EntityId{2})->Position();
  EXPECT_GT(Length(leader), 10.0f) << "the leader runs";
  const world::Agent* waypoint = world_->FindAgent(EntityId{7});
  EXPECT_LT(Distance(waypoint->Position(), {50, 0.8f, 0}), 8.0f) << "the waypoint agent keeps to its first target";
  for (std::uint32_t id = 3; id <= 6; ++id) {
    EXPECT_EQ(world_->FindAgent(EntityId{id})->Leader(), EntityId{2});
    EXPECT_NEAR(world_->FindAgent(EntityId{id})->Position().y, 0.8f, 0.05f);
  }
}

TEST_F(ThesisScriptsTest, FollowCommandsAndAnswerKeys) {
  Start();
  ASSERT_TRUE(loaded_);
  commands_["waypoint"] = "nextwaypoint";
  Tick();
  EXPECT_EQ(world_->FindAgent(EntityId{7})->Target(), (Vec3{0, 0, 0}));
  Tick();
  EXPECT_EQ(world_->FindAgent(EntityId{7})->Target(), (Vec3{20, 0, 0}));

  host_->HandleInput(KeyEvent("f7_key", true));
  EXPECT_TRUE(world_->draw_physics());
  host_->HandleInput(KeyEvent("space_key", true));
  ASSERT_EQ(world_->ObjectIds().size(), 2u);
  Tick();
  EXPECT_NEAR(Length(world_->FindObject(world_->ObjectIds()[1])->Velocity()), 33.3f, 1.0f);

  const auto visible = [&] {
    std::vector<bool> flags;
    for (const world::UiSnapshot& ui : world_->Snapshot().ui) flags.push_back(ui.visible);
    return flags;
  };
  EXPECT_EQ(visible(), (std::vector<bool>{false, false, true}));
  for (const char* key : {"f2_key", "f5_key", "f6_key"}) host_->HandleInput(KeyEvent(key, true));
  Tick();
  EXPECT_EQ(visible(), (std::vector<bool>{true, true, false}));
  EXPECT_NE(world_->Snapshot().ui[0].text.find("position"), std::string::npos);
  EXPECT_NE(world_->Snapshot().ui[1].text.find("steps"), std::string::npos);
  EXPECT_EQ(Errors(), "");
}

TEST_F(ThesisScriptsTest, AreTheSameForOneSeedAndDifferForTwo) {
  std::uint64_t hashes[3];
  for (int run = 0; run < 3; ++run) {
    Start("Sandbox.lua", run < 2 ? 7 : 8);
    Ticks(100);
    hashes[run] = world_->Hash();
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_NE(hashes[0], hashes[2]);
}

TEST_F(HostTest, AShowroomOfAllPiecesComesToRestOnTheGround) {
  StartWith(
      "require 'SandboxUtilities' require 'GUI'\n"
      "function Sandbox_Initialize(s)\n"
      "  GUI_CreateUI(s) SandboxUtilities_CreateLights(s)\n"
      "  Core.SetMaterial(Sandbox.CreatePlane(s, 200, 200), 'Ground2')\n"
      "  local x = 0\n"
      "  for name in pairs(SandboxUtilities.Objects) do\n"
      "    assert(SandboxUtilities_CreateObject(s, name, Vector.new(x, 0, 0))) x = x + 5\n"
      "  end\n"
      "  print(SandboxUtilities_CreateObject(s, 'modular_nothing'))\n"
      "end\n"
      "function Sandbox_HandleEvent(s, e) GUI_HandleEvent(s, e)\n"
      "  if e.key == 'space_key' and e.pressed then SandboxUtilities_ShootBox(s) SandboxUtilities_ShootBullet(s) end "
      "end");
  ASSERT_EQ(Errors(), "");
  EXPECT_EQ(Printed(), "nil");
  EXPECT_EQ(world_->ObjectIds().size(), 35u);
  Ticks(150);
  for (const EntityId id : world_->ObjectIds())
    EXPECT_LT(Length(world_->FindObject(id)->Velocity()), 0.5f) << Number(id);
  host_->HandleInput(KeyEvent("space_key", true));
  EXPECT_EQ(world_->ObjectIds().size(), 37u);
  Ticks(60);
  EXPECT_EQ(world_->ObjectIds().size(), 36u) << "the bullet went with its first hit";
  EXPECT_EQ(Errors(), "");
}

TEST_F(HostTest, OnTheCommonNobodyCreepsAndNobodySpins) {
  settings_.script_folders.insert(settings_.script_folders.begin(),
                                  std::filesystem::path(SOARBOX_SOURCE_DIR) / "scenarios" / "movement");
  Start();
  ASSERT_EQ(world_->AgentIds().size(), 20u);
  const EntityId courier = world_->AgentIds()[0], dog = world_->AgentIds()[1];
  EXPECT_EQ(world_->FindAgent(world_->AgentIds()[19])->PathPoints().size(), 17u) << "a lap is closed";
  float nearest = 1000, fastest = 0, run = 0;
  Vec3 before = world_->FindAgent(courier)->Position();
  for (int tick = 0; tick < 1200; ++tick) {
    Tick();
    const Vec3 here = world_->FindAgent(courier)->Position();
    run += Distance(here, std::exchange(before, here));
    nearest = std::min(nearest, Distance(here, world_->FindAgent(dog)->Position()));
    for (const EntityId id : world_->AgentIds()) fastest = std::max(fastest, world_->FindAgent(id)->Speed());
  }
  EXPECT_LT(nearest, 1.5f) << "the dog catches the courier";
  EXPECT_GT(run, 140) << "which runs on all the same";
  EXPECT_LT(fastest, 8.5f);
  EXPECT_EQ(Errors(), "");
}

}  // namespace
}  // namespace soarbox::script
