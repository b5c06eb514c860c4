// SPDX-License-Identifier: BSD-2-Clause
#include <lua.hpp>
#include <optional>

#include "script/api_call.h"
#include "script/argument_check.h"
#include "script/script_asset.h"
#include "world/rotation.h"

// Sandbox: camera, light, sky, sounds, time, screen, user interface.

namespace soarbox::script {
namespace {

using world::Camera;
using world::Vec3;
using world::World;
using enum WrongCount;

void CreateSkyBox(World& world, std::string_view material, std::optional<Vec3> rotation) {
  world.scene().SetSky(material, rotation.value_or(Vec3{}));
}

void SetAmbientLight(World& world, Vec3 color) {
  world.scene().SetAmbient(color);
}

/// (sandbox, file [, volume [, position]])
int PlaySound(lua_State* state) {
  int index = 3;
  const float volume = ReadParameter<std::optional<float>>(state, index).value_or(1);
  const auto position = ReadParameter<std::optional<Vec3>>(state, index);
  ContextOf(state).world.PlaySound(SoundArgument(state, 2), volume, position);
  return 0;
}

double GetTimeInSeconds(const World& world) {
  return static_cast<double>(world.time_millis()) / 1000.0;
}

/// Scripts get nominal times in microseconds: measured times differ from run to run, and a script could act on them.
/// The window shows the measured ones.
double NominalStep_us(const World& world) {
  return static_cast<double>(world.settings().step_s) * 1e6;
}
double GetSimulationTime(const World&) {
  return 0;
}

Handle CreateUIComponent(lua_State* state, World& world, double layer) {
  if (!(layer >= 0 && layer < 16)) ArgumentError(state, 2, "a layer is a number from 0 to 15");
  ChargeForCreation(state, Made::kPanel);
  return {ValueKind::kUi, Number(world.ui().Create(static_cast<int>(layer)))};
}
Handle CreateUIComponent3d(lua_State* state, World& world, Vec3 position) {
  ChargeForCreation(state, Made::kPanel);
  return {ValueKind::kUi, Number(world.ui().CreateInWorld(position))};
}

/// Returns -1 after a warning.
int ColorIndex(lua_State* state) {
  const double index = luaL_checknumber(state, 2);
  if (index >= 0 && index < 10) return static_cast<int>(index);
  WarnAtCaller(state, "the index of a markup colour is a number from 0 to 9");
  return -1;
}

/// (sandbox, index, r, g, b [, a]); the alpha is used only if there are exactly six arguments.
int SetMarkupColor(lua_State* state) {
  const float alpha = lua_gettop(state) == 6 ? CheckFloat(state, 6) : 1;
  const world::Color color{CheckFloat(state, 3), CheckFloat(state, 4), CheckFloat(state, 5), alpha};
  ContextOf(state).world.ui().SetMarkupColor(ColorIndex(state), color);
  return 0;
}
/// Two results, as in the original sandbox: the index and the colour as a table.
int GetMarkupColor(lua_State* state) {
  const world::Color color = ContextOf(state).world.ui().MarkupColor(ColorIndex(state));
  lua_pushvalue(state, 2);
  lua_createtable(state, 0, 4);
  const std::pair<const char*, float> channels[] = {
      {"red", color.r}, {"green", color.g}, {"blue", color.b}, {"alpha", color.a}};
  for (const auto& [name, value] : channels) {
    lua_pushnumber(state, value);
    lua_setfield(state, -2, name);
  }
  return 2;
}

constexpr ApiFunction kSandboxViewFunctions[] = {
    {"Sandbox.CreateSkyBox", kCall<CreateSkyBox>, kIgnored,
     "sandbox: Sandbox, material: string, rotation: Vector [deg] = none", "",
     "Creates a sky around the world, which replaces the previous one.",
     R"(Sandbox.CreateSkyBox(sandbox, "ThickCloudsWaterSkyBox", Vector.new(0, 180, 0)))"},
    {"Sandbox.CreateUIComponent", kCall<CreateUIComponent>, kError, "sandbox: Sandbox, layer: number", "UI",
     "A panel of 100 by 100 pixels at the top left of the window. Layers go from 0 to 15, with 15 on top.",
     R"(local panel = Sandbox.CreateUIComponent(sandbox, 1)
UI.SetText(panel, "hello"))"},
    {"Sandbox.CreateUIComponent3d", kCall<CreateUIComponent3d>, kError, "sandbox: Sandbox, position: Vector [m]", "UI",
     "A panel in the world, with 0.005 m per pixel.",
     R"(local sign = Sandbox.CreateUIComponent3d(sandbox, Vector.new(0, 2, 0))
UI.SetText(sign, "exit"))"},
    {"Sandbox.GetCameraForward", kCall<&Camera::Forward>, kIgnored, "sandbox: Sandbox", "Vector",
     "The direction in which the camera looks, with length 1.",
     R"(print(Sandbox.GetCameraForward(sandbox).z < 0)  --> true)"},
    {"Sandbox.GetCameraLeft", kCall<&Camera::Left>, kIgnored, "sandbox: Sandbox", "Vector",
     "The direction to the camera's left, with length 1.", R"(print(Sandbox.GetCameraLeft(sandbox).x < 0)  --> true)"},
    {"Sandbox.GetCameraOrientation", kCall<&Camera::RotationVector>, kIgnored, "sandbox: Sandbox", "Vector [deg]",
     "The camera's rotation.", R"(Sandbox.SetCameraOrientation(sandbox, Sandbox.GetCameraOrientation(sandbox)))"},
    {"Sandbox.GetCameraPosition", kCall<&Camera::Position>, kIgnored, "sandbox: Sandbox", "Vector [m]",
     "The camera's position.",
     R"(Sandbox.SetCameraPosition(sandbox, Vector.new(0, 5, -10))
print(Sandbox.GetCameraPosition(sandbox).y)  --> 5)"},
    {"Sandbox.GetCameraUp", kCall<&Camera::Up>, kIgnored, "sandbox: Sandbox", "Vector",
     "The camera's up direction, with length 1.", R"(print(Sandbox.GetCameraUp(sandbox).y > 0)  --> true)"},
    {"Sandbox.GetDrawPhysicsWorld", kCall<&World::draw_physics>, kIgnored, "sandbox: Sandbox", "boolean",
     "Whether the bodies are drawn as wires.", R"(print(Sandbox.GetDrawPhysicsWorld(sandbox))  --> false)"},
    {"Sandbox.GetMarkupColor", GetMarkupColor, kIgnored, "sandbox: Sandbox, index: number", "number, table",
     "The index and the colour of a code %0 to %9 in markup texts: {red, green, blue, alpha} by name.",
     R"(local _, color = Sandbox.GetMarkupColor(sandbox, 0)
print(color.red)  --> 1)"},
    {"Sandbox.GetRenderTime", kCall<NominalStep_us>, kError, "sandbox: Sandbox", "number [us]",
     "The time between the last two frames of the window.", R"(print(Sandbox.GetRenderTime(sandbox) > 0)  --> true)"},
    {"Sandbox.GetScreenHeight", kCall<&World::screen_height>, kError, "sandbox: Sandbox", "number [px]",
     "The height of the window; 800 without a window.", R"(print(Sandbox.GetScreenHeight(sandbox))  --> 800)"},
    {"Sandbox.GetScreenWidth", kCall<&World::screen_width>, kError, "sandbox: Sandbox", "number [px]",
     "The width of the window; 1280 without a window.", R"(print(Sandbox.GetScreenWidth(sandbox))  --> 1280)"},
    {"Sandbox.GetSimulationTime", kCall<GetSimulationTime>, kError, "sandbox: Sandbox", "number [us]",
     "The real time that the last step took.", R"(print(Sandbox.GetSimulationTime(sandbox) >= 0)  --> true)"},
    {"Sandbox.GetTimeInMillis", kCall<&World::time_millis>, kIgnored, "sandbox: Sandbox", "number [ms]",
     "The scripts' clock: 33 for each step.",
     R"(local now = Sandbox.GetTimeInMillis(sandbox)
print(now)  --> 0)"},
    {"Sandbox.GetTimeInSeconds", kCall<GetTimeInSeconds>, kIgnored, "sandbox: Sandbox", "number [s]",
     "The scripts' clock.", R"(print(Sandbox.GetTimeInSeconds(sandbox))  --> 0)"},
    {"Sandbox.GetTotalSimulationTime", kCall<NominalStep_us>, kError, "sandbox: Sandbox", "number [us]",
     "The time between the last two steps.", R"(print(Sandbox.GetTotalSimulationTime(sandbox) > 0)  --> true)"},
    {"Sandbox.PlaySound", PlaySound, kError,
     "sandbox: Sandbox, file: string, volume: number 0..1 = 1, position: Vector [m] = everywhere", "",
     "Plays a sound in the window and in pages: a WAV file of the scenario's folder with 8 or 16 bits, one or two "
     "channels and up to 8 MB. A sound with a position has a direction, and gets softer with distance. Nothing in the "
     "world depends on sounds. A file that cannot be used is an error that states the reason.",
     R"(Sandbox.PlaySound(sandbox, "bell.wav", 0.5, agent:GetPosition()))", true},
    {"Sandbox.SetAmbientLight", kCall<SetAmbientLight>, kIgnored, "sandbox: Sandbox, color: Vector", "",
     "Sets the ambient light, which has no direction; initially there is none.",
     R"(Sandbox.SetAmbientLight(sandbox, Vector.new(0.3)))"},
    {"Sandbox.SetCameraFixed", kCall<&Camera::SetFixed>, kError, "sandbox: Sandbox, fixed: boolean", "",
     "If true, the window shows the view of this camera until the user moves the camera. If false, the window keeps "
     "the agents in view.",
     R"(Sandbox.SetCameraFixed(sandbox, true))", true},
    {"Sandbox.SetCameraForward", kCall<&Camera::SetBackward>, kIgnored, "sandbox: Sandbox, direction: Vector", "",
     "Makes the camera look in the opposite of this direction, as in the first sandbox.",
     R"(Sandbox.SetCameraForward(sandbox, Vector.new(0, 0, -1))
print(Sandbox.GetCameraForward(sandbox).z)  --> 1)"},
    {"Sandbox.SetCameraOrientation", kCall<&Camera::SetRotationVector>, kIgnored,
     "sandbox: Sandbox, rotation: Vector [deg]", "", "Turns the camera.",
     R"(Sandbox.SetCameraOrientation(sandbox, Vector.new(-160, 0, -180)))"},
    {"Sandbox.SetCameraPosition", kCall<&Camera::SetPosition>, kIgnored, "sandbox: Sandbox, position: Vector [m]", "",
     "Moves the camera.", R"(Sandbox.SetCameraPosition(sandbox, Vector.new(7, 5, -18)))"},
    {"Sandbox.SetDrawPhysicsWorld", kCall<&World::SetDrawPhysics>, kError, "sandbox: Sandbox, draw: boolean", "",
     "Shows or hides all bodies as wires.", R"(Sandbox.SetDrawPhysicsWorld(sandbox, true))"},
    {"Sandbox.SetMarkupColor", SetMarkupColor, kError,
     "sandbox: Sandbox, index: number, red: number 0..1, green: number 0..1, blue: number 0..1, alpha: number 0..1 = 1",
     "", "Changes the colour of a code %0 to %9 in markup texts; 0 to 1 per channel.",
     R"(Sandbox.SetMarkupColor(sandbox, 1, 1, 0, 0))", false, 5},
};

}  // namespace

std::span<const ApiFunction> SandboxViewApi() {
  return kSandboxViewFunctions;
}

}  // namespace soarbox::script
