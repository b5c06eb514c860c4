// SPDX-License-Identifier: BSD-2-Clause
#include "sim/scenario.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "sim/simulation.h"
#include "world/world.h"

namespace soarbox::sim {
namespace {

namespace fs = std::filesystem;

class ScenarioTest : public testing::Test {
 protected:
  ScenarioTest() : root_(fs::path(testing::TempDir()) / ("scenario-" + std::to_string(getpid()))) {
    Write("scenarios/thesis/Sandbox.lua");
    Write("scenarios/thesis/mixed.lua");
    Write("scenarios/arena/Sandbox.lua");
    Write("media/scripts/GUI.lua");
    fs::create_directories(root_ / "empty");
    data_ = {root_ / "scenarios", root_ / "media"};
  }
  ~ScenarioTest() override { fs::remove_all(root_); }

  void Write(const fs::path& name) {
    fs::create_directories((root_ / name).parent_path());
    std::ofstream(root_ / name) << "-- a script\n";
  }

  fs::path root_;
  DataFolders data_;
};

TEST_F(ScenarioTest, IsFoundByNameByFolderAndByFile) {
  EXPECT_EQ(FindScenario("thesis", data_).value().script, root_ / "scenarios/thesis/Sandbox.lua");
  EXPECT_EQ(FindScenario((root_ / "scenarios/arena").string(), data_).value().name, "arena");
  EXPECT_EQ(FindScenario("thesis/mixed.lua", data_).value().name, "thesis/mixed");
}

TEST_F(ScenarioTest, ThatIsMissingIsToldWithTheNearestName) {
  const auto found = FindScenario("thesys", data_);
  ASSERT_FALSE(found.ok());
  EXPECT_EQ(found.error().hint, "did you mean 'thesis'?");
  EXPECT_EQ(FindScenario("something-else-entirely", data_).error().hint, "there are: arena thesis");
}

TEST_F(ScenarioTest, FolderWithoutAScriptIsToldApartFromNoFolder) {
  const auto found = FindScenario((root_ / "empty").string(), data_);
  ASSERT_FALSE(found.ok());
  EXPECT_EQ(found.error().file, (root_ / "empty").string());
}

TEST_F(ScenarioTest, TheScriptOfAnAgentIsNoWorld) {
  const fs::path walker = root_ / "walker.lua";
  std::ofstream(walker) << "function Agent_Update(agent, milliseconds)\nend\n-- Sandbox_Initialize is elsewhere\n";
  const auto found = FindScenario(walker.string(), data_);
  ASSERT_FALSE(found.ok());
  EXPECT_EQ(found.error().message, "this is the script of an agent, not of a world: it has no Sandbox_Initialize");
  EXPECT_NE(found.error().hint.find("Sandbox.CreateAgent(sandbox, \"walker.lua\")"), std::string::npos);

  std::ofstream(walker, std::ios::app) << "function Sandbox_Initialize(sandbox)\nend\n";
  EXPECT_TRUE(FindScenario(walker.string(), data_).ok());
  std::ofstream(walker) << "require \"World\"\nfunction Agent_Update(agent) end\n";
  EXPECT_TRUE(FindScenario(walker.string(), data_).ok());
}

TEST_F(ScenarioTest, FilesAreFoundInFolderOrderAndWithOtherCapitals) {
  const std::vector<fs::path> folders{root_ / "scenarios/arena", root_ / "scenarios/thesis"};
  EXPECT_EQ(FindInFolders("Sandbox.lua", folders), root_ / "scenarios/arena/Sandbox.lua");
  EXPECT_EQ(FindInFolders("MIXED.LUA", folders), root_ / "scenarios/thesis/mixed.lua");
  EXPECT_TRUE(FindInFolders("absent.lua", folders).empty());
}

TEST_F(ScenarioTest, AgentsOfOneEntryStandApartAlsoWithoutAPosition) {
  std::ofstream(root_ / "many.toml") << "[[agent]]\nname = \"one\"\ncount = 6\nacross = 3\n";
  const auto scenario = FindScenario((root_ / "many.toml").string(), {fs::path(SOARBOX_SOURCE_DIR) / "scenarios",
                                                                      fs::path(SOARBOX_SOURCE_DIR) / "media"});
  ASSERT_TRUE(scenario) << Format(scenario.error());
  SimulationSettings settings;
  settings.soar.threads = 1;
  const auto simulation = Simulation::Create(scenario.value(), settings);
  ASSERT_TRUE(simulation) << Format(simulation.error());
  const world::World& world = (*simulation)->world();
  ASSERT_EQ(world.AgentIds().size(), 6u);
  for (const world::EntityId a : world.AgentIds()) {
    for (const world::EntityId b : world.AgentIds()) {
      if (a == b) continue;
      EXPECT_GT(world::Length(world.FindAgent(a)->Position() - world.FindAgent(b)->Position()), 1);
    }
  }
}

}  // namespace
}  // namespace soarbox::sim
