// SPDX-License-Identifier: BSD-2-Clause
#include "script/script_debugger.h"

#include "script/host_test_support.h"
#include "script/script_profiler.h"

namespace soarbox::script {
namespace {

using world::EntityId;

constexpr std::string_view kAgent = R"(local speed = 3
Memory = {place = "north", {1, 2}}
local function Twice(n)
  local result = n * 2
  return result
end
function Agent_Update(agent, ms)
  local sum = 0
  for i = 1, 3 do
    sum = sum + Twice(i) + speed
  end
  total = sum
end
)";

class ScriptDebuggerTest : public HostTest {
 protected:
  /// Runs one agent with the script above. `at_pause` is called at each pause and returns how to continue.
  void Debug(std::string_view agent, std::vector<ScriptBreakpoint> marks) {
    Write("A.lua", agent);
    const ObserveNewHosts observed(&debugger_);
    StartWith("function Sandbox_Initialize(s) Sandbox.CreateAgent(s, 'A.lua') end");
    debugger_.SetBreakpoints(folder_ / "A.lua", std::move(marks));
  }
  ~ScriptDebuggerTest() override { host_.reset(); }

  std::string Where() {
    std::string text = View().reason();
    for (const ScriptFrame& frame : View().Frames()) text += " " + frame.function + ":" + std::to_string(frame.line);
    return text;
  }
  std::string Shown(const std::vector<ScriptVariable>& variables) {
    std::string text;
    for (const ScriptVariable& one : variables) text += (text.empty() ? "" : ", ") + one.name + "=" + one.value;
    return text;
  }
  std::string Value(std::string_view expression) {
    const Result<ScriptVariable> value = View().Evaluate(0, expression);
    return value ? value->value : "error: " + value.error().message;
  }

  std::vector<std::string> places_;
  std::vector<ScriptStep> steps_;  ///< How to continue after each pause; kGo at the end.
  std::function<void()> look_ = [] {};
  ScriptView& View() { return debugger_.view(); }

  ScriptDebugger debugger_{[this] {
    places_.push_back(Where());
    look_();
    debugger_.SetStep(places_.size() <= steps_.size() ? steps_[places_.size() - 1] : ScriptStep::kGo);
  }};
};

TEST_F(ScriptDebuggerTest, PausesAtALineEachTimeItIsExecuted) {
  Debug(kAgent, {{10, ""}});
  host_->UpdateAgent(EntityId{1});
  EXPECT_EQ(places_, std::vector<std::string>(3, "breakpoint Agent_Update:10"));
  EXPECT_EQ(Run("print(total)", EntityId{1}), "21");
}

TEST_F(ScriptDebuggerTest, ACondition) {
  Debug(kAgent, {{10, "i == 2 and speed > 1"}});
  look_ = [&] { EXPECT_EQ(Value("i"), "2"); };
  host_->UpdateAgent(EntityId{1});
  EXPECT_EQ(places_.size(), 1u);
}

TEST_F(ScriptDebuggerTest, StepsOverIntoAndOut) {
  Debug(kAgent, {{10, "i == 1"}});
  using enum ScriptStep;
  steps_ = {kInto, kOver, kOut, kOver, kOver, kOver, kOut};
  host_->UpdateAgent(EntityId{1});
  EXPECT_EQ(places_, (std::vector<std::string>{"breakpoint Agent_Update:10", "step Twice:4 Agent_Update:10",
                                               "step Twice:5 Agent_Update:10", "step Agent_Update:10",
                                               "step Agent_Update:9", "step Agent_Update:10", "step Agent_Update:9"}));
  // Out of the outermost function: stops in the next call.
  host_->UpdateAgent(EntityId{1});
  EXPECT_EQ(places_.at(7), "step Agent_Update:8");
}

TEST_F(ScriptDebuggerTest, ShowsVariablesAndFields) {
  Debug(kAgent, {{10, "i == 2"}});
  look_ = [&] {
    EXPECT_EQ(Shown(View().Locals(0)), "agent=" + Value("agent") + ", ms=33, sum=5, i=2");
    EXPECT_EQ(Shown(View().Upvalues(0)), "Twice=function A.lua:3, speed=3");
    const std::vector<ScriptVariable> globals = View().Globals(1);
    EXPECT_EQ(Shown(globals), "Memory={{...}, place = \"north\"}");
    ASSERT_EQ(globals.size(), 1u);
    const std::vector<ScriptVariable> fields = View().Fields(globals[0].reference);
    EXPECT_EQ(Shown(fields), "[1]={1, 2}, place=\"north\"");
    EXPECT_EQ(Shown(View().Fields(fields[0].reference)), "[1]=1, [2]=2");
  };
  host_->UpdateAgent(EntityId{1});
  EXPECT_EQ(places_.size(), 1u);
  const Result<ScriptVariable> later = View().EvaluateGlobal(1, "Memory.place .. '!'");
  ASSERT_TRUE(later.ok());
  EXPECT_EQ(later->value, "\"north!\"");
}

TEST_F(ScriptDebuggerTest, EvaluatesExpressionsWithoutRunningScripts) {
  Debug(
      "local half = 0.5\nPoint = setmetatable({x = 1}, {__index = {y = 2}})\n"
      "function Agent_Update(agent)\n  local t = {a = {b = {'deep'}}}\n  local text = 'abc'\n  return t, text, "
      "half\nend",
      {{6, ""}});
  look_ = [&] {
    EXPECT_EQ(Value("t.a.b[1]"), "\"deep\"");
    EXPECT_EQ(Value("#text + half * 2 ^ 3 % 3"), "4");
    EXPECT_EQ(Value("not nil == true and -half or 7"), "-0.5");
    EXPECT_EQ(Value("Point.x + Point.y"), "3");
    EXPECT_EQ(Value("'a' .. 1 .. \"b\" == 'a1b'"), "true");
    EXPECT_EQ(Value("t.c and t.c.d.e"), "nil");
    EXPECT_EQ(Value("math.max(1, 4, 3)"), "4");
    EXPECT_EQ(Value("agent:GetId()"), "1");
    EXPECT_EQ(Value("(agent:GetPosition() - agent:GetPosition()).x"), "0");
    EXPECT_EQ(Value("0x10 >= 16"), "true");
    EXPECT_EQ(Value("text < 'b'"), "true");
    EXPECT_EQ(Value("t.c.d"), "error: a nil value has no fields: d is asked for");
    EXPECT_TRUE(Value("Agent_Update(agent)").starts_with("error: Agent_Update is a function of a script"));
    EXPECT_TRUE(Value("pcall(Agent_Update)").starts_with("error: pcall might call a function of a script"));
    EXPECT_EQ(Value("1 +"), "error: the expression ends too early");
    EXPECT_EQ(Value("half = 2"), "error: what is written after the expression: = 2");
    EXPECT_EQ(Value("function() end"), "error: functions cannot be written here");
    EXPECT_TRUE(Value("string.rep('x', 1e9)").starts_with("error: "));
    EXPECT_EQ(Value(std::string(500, '(')), "error: the expression is too deep");
  };
  host_->UpdateAgent(EntityId{1});
  EXPECT_EQ(places_.size(), 1u);
  EXPECT_EQ(Errors(), "");
}

TEST_F(ScriptDebuggerTest, PausesAtErrorsThatNobodyCatches) {
  Debug("function Agent_Update(agent)\n  local n = nil\n  pcall(error, 'caught')\n  print(n.x)\nend", {});
  debugger_.SetStopAtErrors(true);
  look_ = [&] { EXPECT_EQ(View().error(), "A.lua:4: attempt to index local 'n' (a nil value)"); };
  Tick();
  EXPECT_EQ(places_, std::vector<std::string>{"error Agent_Update:4"});
}

TEST_F(ScriptDebuggerTest, StepsOverACoroutine) {
  Debug(
      "local co = coroutine.wrap(function()\n  while true do\n    coroutine.yield(1)\n  end\nend)\n"
      "function Agent_Update()\n  local a = co()\n  local b = co()\n  return a + b\nend",
      {{7, ""}});
  using enum ScriptStep;
  steps_ = {kOver, kInto, kOver, kOver, kOver};
  host_->UpdateAgent(EntityId{1});
  ASSERT_GE(places_.size(), 3u);
  EXPECT_EQ(places_[1], "step Agent_Update:8");
  EXPECT_TRUE(places_[2].starts_with("step the function at line 1:")) << places_[2];
}

TEST_F(ScriptDebuggerTest, LimitsCountAsWithoutIt) {
  constexpr std::string_view kEndless = "function Agent_Update()\n  while true do\n    x = 1\n  end\nend";
  const auto error_with = [&](std::vector<ScriptBreakpoint> marks) {
    Debug(kEndless, std::move(marks));
    Tick();
    return Errors();
  };
  const std::string without = error_with({});
  EXPECT_NE(without.find("endless loop"), std::string::npos);
  int pauses = 0;
  look_ = [&] { EXPECT_EQ(Value("x"), ++pauses == 1 ? "nil" : "1"); };
  EXPECT_EQ(error_with({{3, "not x or x == 2"}}), without);
  EXPECT_EQ(pauses, 1);
}

TEST_F(ScriptDebuggerTest, ChangesNothingThatAScriptDoes) {
  const auto hash_with = [&](std::vector<ScriptBreakpoint> marks) {
    Debug(
        "function Agent_Update(a)\n  local list = {}\n  for i = 1, 50 do\n    list[i] = {i, math.random()}\n  end\n"
        "  a:SetPosition(Vector.new(list[7][2], 0, list[50][2]))\nend",
        std::move(marks));
    look_ = [&] {
      View().Locals(0);
      Value("list[1]");
    };
    Ticks(20);
    return world_->Hash();
  };
  const std::uint64_t without = hash_with({});
  EXPECT_EQ(hash_with({{4, "i % 10 == 0"}}), without);
  EXPECT_GT(places_.size(), 50u);
}

TEST(LinesOfScript, AreThoseOfAllFunctions) {
  EXPECT_EQ(LinesOfScript("local a = 1\n\n-- no\nlocal function f()\n  return a\nend\nf()\n"),
            (std::vector<int>{1, 5, 6, 7}));
  EXPECT_TRUE(LinesOfScript("not Lua").empty());
}

TEST_F(ScriptDebuggerTest, TheScriptOfARemovedAgentIsNoLongerListed) {
  Debug(kAgent, {{8, ""}});
  steps_ = {ScriptStep::kOver, ScriptStep::kGo};
  Tick();
  ASSERT_EQ(View().Machines().size(), 2u);
  int memory = 0;
  for (const ScriptVariable& global : View().Globals(1))
    if (global.name == "Memory") memory = global.reference;
  EXPECT_EQ(View().Fields(memory).size(), 2u);
  world_->RemoveAgent(EntityId{1});
  const std::size_t pauses = places_.size();
  Ticks(2);
  EXPECT_EQ(View().Machines().size(), 1u);
  EXPECT_TRUE(View().Fields(memory).empty());
  EXPECT_EQ(places_.size(), pauses);
}

TEST_F(ScriptDebuggerTest, TheProfilerCountsCalls) {
  Write("A.lua", kAgent);
  ScriptProfiler profiler;
  const ObserveNewHosts observed(&profiler);
  StartWith("function Sandbox_Initialize(s) Sandbox.CreateAgent(s, 'A.lua') end");
  Ticks(4);
  std::vector<ScriptProfiler::Row> rows = profiler.Rows();
  std::erase_if(rows, [](const ScriptProfiler::Row& row) { return row.place == "A.lua:0" || row.place[0] != 'A'; });
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].function + " " + rows[0].place + " " + std::to_string(rows[0].calls), "Agent_Update A.lua:7 4");
  EXPECT_EQ(rows[1].function + " " + rows[1].place + " " + std::to_string(rows[1].calls), "Twice A.lua:3 12");
  EXPECT_GE(rows[0].total_s, rows[1].total_s);
  EXPECT_NE(profiler.Table(4, 1).find("functions of scripts, for each of 4 ticks"), std::string::npos);
  host_.reset();
}

}  // namespace
}  // namespace soarbox::script
