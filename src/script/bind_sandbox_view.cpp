// SPDX-License-Identifier: BSD-2-Clause
#include <lua.hpp>

#include "script/argument_check.h"
#include "script/bind_api.h"
#include "script/bind_arguments.h"
#include "script/binding.h"
#include "world/rotation.h"

// Sandbox: camera, light, sky, time, screen, user interface.

namespace soarbox::script {
namespace {

using world::Vec3;

world::World& WorldOf(lua_State* state) {
  return ContextOf(state).world;
}

template <Vec3 (world::Camera::*Getter)() const>
int GetOfCamera(lua_State* state) {
  if (!SandboxArgument(state, 1)) return 0;
  PushVector(state, (WorldOf(state).camera().*Getter)());
  return 1;
}

int SetCameraPosition(lua_State* state) {
  const Vec3 position = CheckVector(state, 2);
  if (SandboxArgument(state, 1)) WarnUnless(state, WorldOf(state).camera().SetPosition(position));
  return 0;
}
int SetCameraOrientation(lua_State* state) {
  const Vec3 degrees = CheckVector(state, 2);
  if (SandboxArgument(state, 1)) WarnUnless(state, WorldOf(state).camera().SetRotationVector(degrees));
  return 0;
}
int SetCameraFixed(lua_State* state) {
  if (SandboxArgument(state, 1)) WorldOf(state).camera().SetFixed(lua_toboolean(state, 2) != 0);
  return 0;
}
/// The camera looks along -direction, as in the original sandbox.
int SetCameraForward(lua_State* state) {
  const Vec3 direction = CheckVector(state, 2);
  if (SandboxArgument(state, 1)) WarnUnless(state, WorldOf(state).camera().SetBackward(direction));
  return 0;
}

int CreateSkyBox(lua_State* state) {
  const std::string_view material = TextArgument(state, 2);
  const Vec3 rotation = lua_gettop(state) == 3 ? CheckVector(state, 3) : Vec3{};
  if (SandboxArgument(state, 1)) WorldOf(state).scene().SetSky(material, rotation);
  return 0;
}

int SetAmbientLight(lua_State* state) {
  const Vec3 color = CheckVector(state, 2);
  if (SandboxArgument(state, 1)) WorldOf(state).scene().SetAmbient(color);
  return 0;
}

template <class Value>
int PushOfSandbox(lua_State* state, Value value) {
  if (!SandboxArgument(state, 1)) return 0;
  lua_pushnumber(state, static_cast<lua_Number>(value(ContextOf(state))));
  return 1;
}

int GetTimeInMillis(lua_State* state) {
  return PushOfSandbox(state, [](const ScriptContext& context) { return context.world.time_millis(); });
}
int GetTimeInSeconds(lua_State* state) {
  return PushOfSandbox(
      state, [](const ScriptContext& context) { return static_cast<double>(context.world.time_millis()) / 1000.0; });
}
int GetScreenWidth(lua_State* state) {
  return PushOfSandbox(state, [](const ScriptContext& context) { return context.world.screen_width(); });
}
int GetScreenHeight(lua_State* state) {
  return PushOfSandbox(state, [](const ScriptContext& context) { return context.world.screen_height(); });
}

/// Scripts get nominal times in microseconds: measured times differ from run to run, and a script could act on them.
/// The window shows the measured ones.
double NominalStep_us(const ScriptContext& context) {
  return static_cast<double>(context.world.settings().step_s) * 1e6;
}
int GetRenderTime(lua_State* state) {
  return PushOfSandbox(state, NominalStep_us);
}
int GetSimulationTime(lua_State* state) {
  return PushOfSandbox(state, [](const ScriptContext&) { return 0; });
}
int GetTotalSimulationTime(lua_State* state) {
  return PushOfSandbox(state, NominalStep_us);
}

int GetDrawPhysicsWorld(lua_State* state) {
  if (!SandboxArgument(state, 1)) return 0;
  lua_pushboolean(state, WorldOf(state).draw_physics());
  return 1;
}
int SetDrawPhysicsWorld(lua_State* state) {
  if (SandboxArgument(state, 1)) WorldOf(state).SetDrawPhysics(TruthArgument(state, 2));
  return 0;
}

int CreateUIComponent(lua_State* state) {
  const double layer = luaL_checknumber(state, 2);
  if (!SandboxArgument(state, 1)) return 0;
  if (!(layer >= 0 && layer < 16)) return ArgumentError(state, 2, "a layer is a number from 0 to 15");
  ChargeForCreation(state, Made::kPanel);
  PushHandle(state, {ValueKind::kUi, Number(WorldOf(state).ui().Create(static_cast<int>(layer)))});
  return 1;
}
int CreateUIComponent3d(lua_State* state) {
  const Vec3 position = CheckVector(state, 2);
  if (!SandboxArgument(state, 1)) return 0;
  ChargeForCreation(state, Made::kPanel);
  PushHandle(state, {ValueKind::kUi, Number(WorldOf(state).ui().CreateInWorld(position))});
  return 1;
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
  const int index = ColorIndex(state);
  const float alpha = lua_gettop(state) == 6 ? CheckFloat(state, 6) : 1;
  const world::Color color{CheckFloat(state, 3), CheckFloat(state, 4), CheckFloat(state, 5), alpha};
  if (SandboxArgument(state, 1)) WorldOf(state).ui().SetMarkupColor(index, color);
  return 0;
}
/// Two results, as in the original sandbox: the index and the colour as a table.
int GetMarkupColor(lua_State* state) {
  const int index = ColorIndex(state);
  if (!SandboxArgument(state, 1)) return 0;
  const world::Color color = WorldOf(state).ui().MarkupColor(index);
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

constexpr Binding kSandboxViewBindings[] = {
    {"CreateSkyBox", CreateSkyBox, 2, 3, WrongCount::kIgnored},
    {"CreateUIComponent", CreateUIComponent, 2, 2, WrongCount::kError},
    {"CreateUIComponent3d", CreateUIComponent3d, 2, 2, WrongCount::kError},
    {"GetCameraForward", GetOfCamera<&world::Camera::Forward>, 1, 1, WrongCount::kIgnored},
    {"GetCameraLeft", GetOfCamera<&world::Camera::Left>, 1, 1, WrongCount::kIgnored},
    {"GetCameraOrientation", GetOfCamera<&world::Camera::RotationVector>, 1, 1, WrongCount::kIgnored},
    {"GetCameraPosition", GetOfCamera<&world::Camera::Position>, 1, 1, WrongCount::kIgnored},
    {"GetCameraUp", GetOfCamera<&world::Camera::Up>, 1, 1, WrongCount::kIgnored},
    {"GetDrawPhysicsWorld", GetDrawPhysicsWorld, 1, 1, WrongCount::kIgnored},
    {"GetMarkupColor", GetMarkupColor, 2, 2, WrongCount::kIgnored},
    {"GetRenderTime", GetRenderTime, 1, 1, WrongCount::kError},
    {"GetScreenHeight", GetScreenHeight, 1, 1, WrongCount::kError},
    {"GetScreenWidth", GetScreenWidth, 1, 1, WrongCount::kError},
    {"GetSimulationTime", GetSimulationTime, 1, 1, WrongCount::kError},
    {"GetTimeInMillis", GetTimeInMillis, 1, 1, WrongCount::kIgnored},
    {"GetTimeInSeconds", GetTimeInSeconds, 1, 1, WrongCount::kIgnored},
    {"GetTotalSimulationTime", GetTotalSimulationTime, 1, 1, WrongCount::kError},
    {"SetAmbientLight", SetAmbientLight, 2, 2, WrongCount::kIgnored},
    {"SetCameraFixed", SetCameraFixed, 2, 2, WrongCount::kError},
    {"SetCameraForward", SetCameraForward, 2, 2, WrongCount::kIgnored},
    {"SetCameraOrientation", SetCameraOrientation, 2, 2, WrongCount::kIgnored},
    {"SetCameraPosition", SetCameraPosition, 2, 2, WrongCount::kIgnored},
    {"SetDrawPhysicsWorld", SetDrawPhysicsWorld, 2, 2, WrongCount::kError},
    {"SetMarkupColor", SetMarkupColor, 5, 11, WrongCount::kError},
};

}  // namespace

void BindSandboxView(lua_State* state) {
  RegisterTable(state, "Sandbox", kSandboxViewBindings);
}

}  // namespace soarbox::script
