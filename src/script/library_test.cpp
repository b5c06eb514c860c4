// SPDX-License-Identifier: BSD-2-Clause
#include "script/host_test_support.h"

// Runs the tests of the Lua library (media/scripts) that are written in Lua (tests/lua).

namespace soarbox::script {
namespace {

class LibraryTest : public HostTest, public testing::WithParamInterface<const char*> {
 protected:
  LibraryTest() {
    settings_.script_folders.push_back(std::filesystem::path(SOARBOX_SOURCE_DIR) / "tests" / "lua");
    settings_.sandbox_limits.instructions = 200'000'000;
    Write("Quiet.lua", "");
    StartWith(
        "function Sandbox_Initialize(s)\n"
        "  sandbox = s\n"
        "  Sandbox.CreatePlane(s, 100, 100)\n"
        "  agent = Sandbox.CreateAgent(s, 'Quiet.lua')\n"
        "  other = Sandbox.CreateAgent(s, 'Quiet.lua')\n"
        "end");
  }
};

TEST_P(LibraryTest, Passes) {
  std::string printed = Run(std::string("require '") + GetParam() + "'");
  Ticks(2);
  if (printed.empty()) printed = Run("Finish()");
  EXPECT_TRUE(printed.starts_with("passed ")) << printed;
  EXPECT_NE(printed, "passed 0");
  EXPECT_EQ(Errors(), "");
  for (const Diagnostic& warning : recorder_.warnings) ADD_FAILURE() << Format(warning);
}

INSTANTIATE_TEST_SUITE_P(Lua, LibraryTest,
                         testing::Values("AgentUtilitiesTest", "AnimationStatesTest", "CommunicationsTest",
                                         "DecisionsTest", "EatersRulesTest", "KnowledgeTest", "MapFileTest",
                                         "SandboxUtilitiesTest", "SimpleEatersRulesTest", "SoldierTest",
                                         "TankSoarRulesTest"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace soarbox::script
