// SPDX-License-Identifier: BSD-2-Clause
#include "script/host_test_support.h"
#include "script/lua_machine.h"
#include "script/lua_values.h"
#include "script/script_path.h"

namespace soarbox::script {
namespace {

using world::EntityId;

/// Neither prints nor draws random numbers.
class Nothing final : public RandomSource, public PrintSink {
 public:
  double Unit() override { return 0; }
  void Reseed(std::int64_t) override {}
  void OnPrint(std::string_view, std::string_view text) override { printed = text; }
  std::string printed;
};

TEST(AgentLists, AnArrayIsKnownUntilAScriptChangesIt) {
  ScriptPath path(std::vector<std::filesystem::path>{});
  Nothing nothing;
  MachineSetup setup;
  setup.script = "test.lua";
  setup.path = &path;
  setup.random = &nothing;
  setup.print = &nothing;
  LuaMachine machine(std::move(setup));
  std::vector<EntityId> ids;
  for (std::uint32_t number = 1; number <= 100; ++number) ids.push_back(EntityId{number});
  int kept = 0;
  const auto push = [&] {
    const auto error = machine.Protected([&](lua_State* state) {
      machine.agent_lists.Push(state, ids);
      kept = machine.Keep(-1);
    });
    EXPECT_FALSE(error);
  };
  const auto holds = [&] {
    bool result = false;
    const auto error = machine.Protected([&](lua_State* state) {
      LuaMachine::PushKept(state, kept);
      result = machine.agent_lists.Holds(state, 1, ids);
    });
    EXPECT_FALSE(error);
    return result;
  };
  const auto run = [&](std::string_view text) {
    EXPECT_FALSE(machine.RunText("function change(agents) " + std::string(text) + " end", "test.lua"));
    EXPECT_FALSE(machine.CallGlobal("change", [&](lua_State* state) {
      LuaMachine::PushKept(state, kept);
      return 1;
    }));
  };
  ASSERT_FALSE(machine.Protected([](lua_State* state) { InstallValues(state); }));

  push();
  EXPECT_TRUE(holds());
  run("local n = 0 for i, a in ipairs(agents) do if a == agents[i] then n = n + 1 end end\n"
      "print(#agents, n, agents[1] == agents[2], agents[0], agents[101])");
  EXPECT_EQ(nothing.printed, "100\t100\tfalse\tnil\tnil");
  EXPECT_TRUE(holds());
  run("local a = agents[3] agents[3] = agents[4] agents[3] = a collectgarbage()");
  EXPECT_TRUE(holds());
  for (const char* change : {"agents[3] = agents[4]", "table.remove(agents)", "table.remove(agents, 1)",
                             "agents[101] = agents[1]", "agents.name = 1", "agents[50] = nil", "agents[0] = agents[1]",
                             "for i = 101, 500 do agents[i] = agents[1] end"}) {
    push();
    run(change);
    EXPECT_FALSE(holds()) << change;
  }
  push();
  ids.pop_back();
  EXPECT_FALSE(holds());
  push();
  EXPECT_TRUE(holds());
  run("print(#agents)");
  EXPECT_EQ(nothing.printed, "99");
}

TEST_F(HostTest, AForceOfAFlockIsTheSameWithTheListOfAllAgentsAndFollowsItsChanges) {
  Write("A.lua",
        "function Agent_Initialize(a) local i = a:GetId() a:SetPosition(Vector.new(i % 7, 1, math.floor(i / 7))) end");
  StartWith(
      "function Sandbox_Initialize(s) for i = 1, 60 do Sandbox.CreateAgent(s, 'A.lua') end\n"
      "  all = Sandbox.GetAgents(s) me = all[20] end\n"
      "function force(list) return tostring(me:ForceToSeparate(4, 180, list)) end\n"
      "function copy(list) local c = {} for i, a in ipairs(list) do c[i] = a end return c end");
  EXPECT_EQ(Run("print(force(all) == force(), force(copy(all)) == force())"), "true\ttrue");
  for (const char* change : {"table.remove(all, 19)", "all[19] = nil", "all[19] = all[60]", "table.remove(all)"}) {
    Run("all = Sandbox.GetAgents(sandbox) " + std::string(change));
    EXPECT_EQ(Run("print(force(all) == force(copy(all)))"), std::string(change) == "all[19] = nil" ? "false" : "true")
        << change;
  }
  EXPECT_EQ(Run("all = Sandbox.GetAgents(sandbox) table.remove(all, 19) print(force(all) == force())"), "false");
  Run("all = Sandbox.GetAgents(sandbox) Sandbox.RemoveAgent(sandbox, all[19])");
  Tick();
  EXPECT_EQ(Run("print(#all, #Sandbox.GetAgents(sandbox), force(all) == force())"), "60\t59\ttrue");
}

TEST_F(HostTest, AForceOfAFlockTakesTheNameOfATeam) {
  Write("A.lua",
        "function Agent_Initialize(a) local i = a:GetId() a:SetPosition(Vector.new(i % 7, 1, math.floor(i / 7)))\n"
        "  a:SetTeam(i % 3 == 0 and 'wolves' or 'sheep') end");
  StartWith(
      "function Sandbox_Initialize(s) for i = 1, 60 do Sandbox.CreateAgent(s, 'A.lua') end\n"
      "  all = Sandbox.GetAgents(s) me = all[20] end\n"
      "function members(team) local t = {} for _, a in ipairs(all) do\n"
      "  if a:GetTeam() == team then t[#t + 1] = a end end return t end\n"
      "function same(team, d, a) local t, ok = members(team), true\n"
      "  for _, f in ipairs({'ForceToSeparate', 'ForceToCombine', 'ForceToAlign'}) do\n"
      "    local one, other = me[f](me, d, a, team), me[f](me, d, a, t)\n"
      "    ok = ok and one.x == other.x and one.y == other.y and one.z == other.z end return ok end");
  EXPECT_EQ(Run("print(same('sheep', 4, 180), same('wolves', 4, 90), same('sheep', 0, 180), same('wolves', 1e9, 180))"),
            "true\ttrue\ttrue\ttrue");
  EXPECT_EQ(Run("print(me:ForceToCombine(4, 180, 'sheep') == me:ForceToCombine(4, 180))"), "false");
  EXPECT_EQ(Run("print(Vector.Length(me:ForceToCombine(4, 180, 'cats')))"), "0");
  // An agent that changes its team or its place counts at once.
  EXPECT_EQ(Run("for _, a in ipairs(all) do a:SetTeam('cats') end print(same('cats', 4, 180), same('sheep', 4, 180))"),
            "true\ttrue");
  EXPECT_EQ(Run("local before = me:ForceToCombine(4, 180, 'cats') me:SetPosition(Vector.new(0, 1, 0))\n"
                "print(same('cats', 4, 180), before == me:ForceToCombine(4, 180, 'cats'))"),
            "true\tfalse");
  // Also between two equal calls, and if the name of a team without members is used again.
  EXPECT_EQ(Run("local before = me:ForceToCombine(9, 180, 'cats') all[1]:SetTeam('dogs')\n"
                "print(same('cats', 9, 180), same('dogs', 9, 180), before == me:ForceToCombine(9, 180, 'cats'))\n"
                "all[1]:SetTeam('cats') print(same('dogs', 9, 180), before == me:ForceToCombine(9, 180, 'cats'))"),
            "true\ttrue\tfalse|true\ttrue");
  EXPECT_EQ(Run("print(#me:GetNeighbours(9, 'cats') == #me:GetNeighbours(9), #me:GetNeighbours(9, 'dogs'))"),
            "true\t0");
  EXPECT_EQ(Run("print(pcall(me.ForceToCombine, me, 4, 180, 5))"),
            "false\tbad argument #4 to 'Agent.ForceToCombine' (table or name of a team expected, got number)");
}

}  // namespace
}  // namespace soarbox::script
