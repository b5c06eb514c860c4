// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <cmath>
#include <map>

#include "script/api_table.h"
#include "script/host_test_support.h"

// Checks what the API does with values that it does not accept: tries each function of its table.

namespace soarbox::script {
namespace {

constexpr const char* kRangesWorld = R"(
function Sandbox_Initialize(s)
  sandbox = s
  local floor = Sandbox.CreateBox(s, 30, 1, 30)
  Core.SetMass(floor, 0)
  agent = Sandbox.CreateAgent(s, "Quiet.lua")
  other = Sandbox.CreateAgent(s, "Quiet.lua")
  object = Sandbox.CreateBox(s, 1, 1, 1)
  node = Core.CreateBox(s, 1, 1, 1)
  light = Core.CreatePointLight(s, Vector.new(0, 5, 0))
  effect = Core.CreateParticle(s, "Bullet")
  line = Core.CreateLine(s, Vector.new(), Vector.new(1))
  ui = Sandbox.CreateUIComponent(s, 1)
  panel = Sandbox.CreateUIComponent3d(s, Vector.new(0, 2, 0))
  mesh = Core.CreateMesh(s, "models/soarbox/soldier.mesh")
  animation = Animation.GetAnimation(mesh, "stand_run_forward_aim")
  Sandbox.CreateNavigationMesh(s, "default", {MinimumRegionArea = 10})
  Sandbox.CreateInfluenceMap(s, "default", {CellWidth = 2, CellHeight = 1})
end
)";

/// Lua code of a valid argument.
std::string RightValue(const ApiFunction& function, const ApiArgument& argument) {
  static const std::map<std::string_view, std::string> kByName{
      {"Agent.SetLeader leader", "other"},
      {"UI.SetWorldPosition ui", "panel"},
      {"UI.SetWorldRotation ui", "panel"},
      {"UI.SetGradientColor direction", "'north_south'"},
      {"Animation.AttachToBone bone", "'b_Head1'"},
      {"Sandbox.CreateSkyBox material", "'ThickCloudsWaterSkyBox'"},
      {"Core.SetLineStartEnd line", "line"},
      {"Sandbox.PlaySound file", "'bell.wav'"},
      {"Animation.Play name", "'stand_run_forward_aim'"},
  };
  const std::string whole = std::string(function.name) + " " + std::string(argument.name);
  if (const auto own = kByName.find(whole); own != kByName.end()) return own->second;
  switch (argument.type) {
    case ApiType::kSandbox:
      return "sandbox";
    case ApiType::kAgent:
      return argument.name == "other" ? "other" : "agent";
    case ApiType::kObject:
      return "object";
    case ApiType::kUi:
      return "ui";
    case ApiType::kMesh:
      return "mesh";
    case ApiType::kAnimation:
      return "animation";
    case ApiType::kVector:
      return "Vector.new(0, 0, 1)";
    case ApiType::kNumber:
      return "1";
    case ApiType::kString:
      return "'default'";
    case ApiType::kTable:
    case ApiType::kAgents:
      return "{}";
    case ApiType::kNode:
    case ApiType::kPlaced:
    case ApiType::kScene:
    case ApiType::kThing:
      return argument.name == "light" || argument.name == "effect" || argument.name == "mesh"
                 ? std::string(argument.name)
                 : "node";
    default:
      return "nil";
  }
}

/// The call with `value` as one argument; optional arguments after it are left out.
std::string CallWith(const ApiFunction& function, std::size_t index, const std::string& value) {
  std::string text;
  const auto arguments = ParseArguments(function.arguments);
  const bool has_alpha = arguments.back().name == "alpha";
  for (std::size_t i = 0; i < arguments.size() && (i <= index || !arguments[i].optional || has_alpha); ++i)
    text += (i == 0 ? "" : ", ") + (i == index ? value : RightValue(function, arguments[i]));
  return std::string(function.name) + "(" + text + ")";
}

std::string InVector(const ApiArgument& argument, const std::string& number) {
  return argument.type == ApiType::kVector ? "Vector.new(0, " + number + ", 0)" : number;
}

class ArgumentRangeTest : public HostTest {
 protected:
  ArgumentRangeTest() {
    Write("Quiet.lua", "");
    Write("bell.wav", ShortWav());
    StartWith(kRangesWorld);
  }

  /// The error or the warnings of a call.
  std::string Told(const std::string& call) {
    recorder_.warnings.clear();
    // Each call has its own line, because each place is warned about once.
    const std::string error = Run(std::string(++line_, '\n') + call);
    if (error.starts_with("error: ")) return error;
    std::string told;
    for (const Diagnostic& warning : recorder_.warnings) {
      EXPECT_EQ(warning.line, static_cast<int>(line_) + 1) << call;
      told += warning.message + "|";
    }
    return told;
  }
  std::size_t line_ = 0;
};

TEST_F(ArgumentRangeTest, NoNumberThatIsNotFiniteIsTakenWithoutAWord) {
  for (const ApiGroup& group : ApiGroups()) {
    if (group.name == "Vector") continue;  // These functions only calculate.
    for (const ApiFunction& function : group.functions) {
      const auto arguments = ParseArguments(function.arguments);
      for (std::size_t i = 0; i < arguments.size(); ++i) {
        if (arguments[i].type != ApiType::kNumber && arguments[i].type != ApiType::kVector) continue;
        const std::string call = CallWith(function, i, InVector(arguments[i], "0 / 0"));
        EXPECT_NE(Told(call), "") << call;
      }
    }
    StartWith(kRangesWorld);
  }
}

TEST_F(ArgumentRangeTest, WhatIsBeyondARangeIsToldWithWhatIsTakenInstead) {
  int tried = 0;
  for (const ApiGroup& group : ApiGroups()) {
    for (const ApiFunction& function : group.functions) {
      const auto arguments = ParseArguments(function.arguments);
      for (std::size_t i = 0; i < arguments.size(); ++i) {
        if (arguments[i].range.empty()) continue;
        for (const bool is_low : {true, false}) {
          const double end = is_low ? arguments[i].low : arguments[i].high;
          if (!std::isfinite(end)) continue;
          const std::string beyond = std::to_string(is_low ? end - std::abs(end) - 1 : end + std::abs(end) + 1);
          const std::string call = CallWith(function, i, InVector(arguments[i], beyond));
          char taken[40];
          std::snprintf(taken, sizeof taken, ": %g", end);
          const std::string told = Told(call);
          EXPECT_NE(told.find(taken), std::string::npos) << call << ": " << told;
          EXPECT_NE(told.find("is used"), std::string::npos) << call << ": " << told;
          EXPECT_NE(told.find(arguments[i].name), std::string::npos) << call << ": " << told;
          ++tried;
        }
      }
    }
    StartWith(kRangesWorld);
  }
  EXPECT_GT(tried, 100);
}

TEST_F(ArgumentRangeTest, RightValuesAreTakenWithoutAWord) {
  for (const ApiGroup& group : ApiGroups()) {
    for (const ApiFunction& function : group.functions) {
      const auto arguments = ParseArguments(function.arguments);
      for (std::size_t i = 0; i < arguments.size(); ++i) {
        if (arguments[i].range.empty()) continue;
        const double middle =
            std::clamp(arguments[i].name == "height" ? 4.0 : 0.5, arguments[i].low, arguments[i].high);
        const std::string call = CallWith(function, i, InVector(arguments[i], std::to_string(middle)));
        const std::string told = Told(call);
        // Other arguments are not valid for this kind of call.
        EXPECT_EQ(told.find("is used"), std::string::npos) << call << ": " << told;
      }
    }
    StartWith(kRangesWorld);
  }
}

TEST_F(ArgumentRangeTest, ABodyHasTheSizeThatIsToldInstead) {
  EXPECT_EQ(Told("node = Core.CreateBox(agent, -1, 1, 1)"), "argument 2, the width, is -1: 0 m is used|");
  EXPECT_EQ(Told("Sandbox.CreatePhysicsSphere(sandbox, -3)"), "argument 2, the radius, is -3: 0.001 m is used|");
  EXPECT_EQ(Told("ball = Sandbox.CreateCapsule(sandbox, 1 / 0, 0 / 0)"),
            "argument 2, the height, is inf: 100000 m is used|argument 3, the radius, is nan: 0.001 m is used|");
  EXPECT_EQ(Told("agent:SetHeight(-1)"), "argument 2, the height, is -1: 0 m is used|");
  EXPECT_EQ(Run("print(agent:GetHeight())"), "0");
  EXPECT_EQ(Told("Core.SetMass(object, -5)"), "argument 2, the mass, is -5: 0 kg is used|");
  EXPECT_EQ(Run("print(Core.GetMass(object))"), "0");
  EXPECT_EQ(Told("Core.CreateCapsule(agent, 1, 1)"),
            "the height is less than the two radii of the caps: their sum is used|");
}

TEST_F(ArgumentRangeTest, AVectorThatIsReplacedStaysAsItIsForItsOwner) {
  EXPECT_EQ(Told("far = Vector.new(0, 2e6, 0) agent:SetPosition(far)"),
            "argument 2, the position, has a component that is 2e+06: 1e+06 m is used|");
  EXPECT_EQ(Run("print(agent:GetPosition().y, far.y)"), "1000000\t2000000");
}

TEST_F(ArgumentRangeTest, APlaceIsToldOnceWhateverItsValues) {
  EXPECT_EQ(Told("for i = 1, 50 do Core.SetMass(object, -i) end"), "argument 2, the mass, is -1: 0 kg is used|");
}

TEST_F(ArgumentRangeTest, VectorsTellOfWhatTheyCannotReckonWith) {
  EXPECT_EQ(Told("v = Vector.new(1) + nil"), "a vector + nil gives nil: put a vector or a number on the right|");
  EXPECT_EQ(Told("v = Vector.new(1) * 'a'"), "a vector * string gives nil: put a vector or a number on the right|");
  EXPECT_EQ(Told("v = {} - Vector.new(1)"), "table - a vector gives nil: put a vector or a number on the right|");
  EXPECT_EQ(Told("v = 2 / Vector.new(1)"), "a number / a vector gives nil: put the vector on the left|");
  EXPECT_EQ(Told("v = Vector.new(1, 2)"),
            "Vector.new takes nothing, a vector, a number or three numbers: this gives nil|");
  EXPECT_EQ(Told("v = Vector.Length(agent)"), "argument 1 is not a vector but AgentType: the call is ignored|");
  EXPECT_EQ(Told("v = Vector.new() v.w = 3"), "a vector has x, y and z: the field 'w' is not set|");
  EXPECT_EQ(Told("v = Vector.new() v[1] = 3"), "a vector has x, y and z: the field 'number' is not set|");
  EXPECT_EQ(Told("v = Vector.new() v.x = 'a'"), "error: the field 'x' of a vector is a number, not string");
  EXPECT_EQ(Told("v = Vector.new() v.y = '2'"), "");
}

TEST_F(ArgumentRangeTest, ANewVectorTakesWhatCountsAsANumber) {
  EXPECT_EQ(Run("print(Vector.new(1, 0, -2) == Vector.new('1', '0', '-2'))"), "true");
  EXPECT_EQ(Run("print(Vector.new(0) == Vector.new(), Vector.new('3') == Vector.new(3, 3, 3))"), "true\ttrue");
  EXPECT_EQ(Run("print(Vector.new(1, 2, nil), Vector.new(1, 2, 'x'), Vector.new(nil), Vector.new({}, 2, 3))"),
            "nil\tnil\tnil\tnil");
  EXPECT_EQ(Run("local v = Vector.new(0 / 0, 1 / 0, 1) print(v.x ~= v.x, v.y == 1 / 0)"), "true\ttrue");
}

TEST_F(ArgumentRangeTest, NilStandsForAnOptionalArgument) {
  EXPECT_EQ(Told("agent:ForceToAvoidAgents(nil)"), "");
  EXPECT_EQ(Told("Sandbox.PlaySound(sandbox, 'bell.wav', nil, nil)"), "");
  EXPECT_EQ(Told("Sandbox.CreateSkyBox(sandbox, 'ThickCloudsWaterSkyBox', nil)"), "");
  EXPECT_EQ(Told("Core.CreateBox(node, 1, 1, 1, nil, nil)"), "");
}

TEST_F(ArgumentRangeTest, AnAgentDoesNotFollowItself) {
  EXPECT_EQ(Told("agent:SetLeader(agent)"),
            "error: bad argument #1 to 'Agent.SetLeader' (an agent cannot be its own leader)");
  EXPECT_EQ(Run("print(agent:GetLeader())"), "");
  EXPECT_EQ(Told("force = agent:ForceToPursue(agent)"), "the agent chases or flees itself: there is no force|");
}

TEST_F(ArgumentRangeTest, CallsThatChangeNothingSaySo) {
  EXPECT_EQ(Told("agent:SetSpeed(3)"), "the agent has a body, which SetVelocity and forces move: the call is ignored|");
  EXPECT_EQ(Told("agent:SetMass(-1)"), "the mass is below 0 kg: the body counts as fixed, as with 0 kg|");
  EXPECT_EQ(Told("agent:SetPath({Vector.new(), 'x', Vector.new(0 / 0)})"), "point 2 is string: it is left out|");
  EXPECT_EQ(Told("Core.SetAxis(object, Vector.new(1), Vector.new(0, 1, 0), Vector.new(0, 0, 1))"),
            "the axes are not perpendicular, of length 1 and right-handed: a similar rotation is used|");
  EXPECT_EQ(Told("Core.CreateDirectionalLight(sandbox, Vector.new())"),
            "the light has no direction: it shines straight down|");
  EXPECT_EQ(Told("UI.SetWorldPosition(ui, Vector.new())"),
            "this panel is on the screen; Sandbox.CreateUIComponent3d makes one in the world: the call is ignored|");
  EXPECT_EQ(Told("Sandbox.SetMarkupColor(sandbox, 10, 1, 1, 1)"),
            "the index of a markup colour is a number from 0 to 9|");
  EXPECT_EQ(Told("Sandbox.AddEvent(sandbox, 'Noise', {f = print, n = node})").size(),
            std::string("the event's field 'f' is function, which an event cannot contain|"
                        "the event's field 'n' is scene node, which an event cannot contain|")
                .size());
  EXPECT_EQ(Told("Sandbox.AddEvent(sandbox, 'Noise', 7)"), "the event is not a table: it is sent without fields|");
  EXPECT_EQ(Told("Sandbox.DrawInfluenceMap(sandbox, 0, {1, 0, 0}, {0, 0, 0, 1}, {0, 0, 0, 1})"),
            "a colour is a table of four numbers, red, green, blue and alpha: other values count as 0|");
}

}  // namespace
}  // namespace soarbox::script
