// SPDX-License-Identifier: BSD-2-Clause
#include <lua.hpp>

#include "script/argument_check.h"
#include "script/bind_api.h"
#include "script/bind_arguments.h"
#include "script/binding.h"
#include "script/lua_machine.h"
#include "script/script_asset.h"

// UI: buttons, bars and images of panels.

namespace soarbox::script {
namespace {

using world::UiId;

world::Ui& Panels(lua_State* state) {
  return ContextOf(state).world.ui();
}

int GetBar(lua_State* state) {
  const auto fraction = Panels(state).Bar(UiArgument(state, 1));
  fraction ? lua_pushnumber(state, *fraction) : lua_pushnil(state);
  return 1;
}

int GetButton(lua_State* state) {
  const std::string& name = Panels(state).Button(UiArgument(state, 1));
  name.empty() ? lua_pushnil(state) : lua_pushlstring(state, name.data(), name.size());
  return 1;
}

int RemoveBar(lua_State* state) {
  Panels(state).RemoveBar(UiArgument(state, 1));
  return 0;
}

int RemoveButton(lua_State* state) {
  const UiId id = UiArgument(state, 1);
  Panels(state).SetButton(id, {});
  ContextOf(state).buttons.Remove(id);
  return 0;
}

int RemoveImage(lua_State* state) {
  Panels(state).SetImage(UiArgument(state, 1), {});
  return 0;
}

/// (ui, fraction [, r, g, b [, a]])
int SetBar(lua_State* state) {
  const UiId id = UiArgument(state, 1);
  world::Color color{0.30f, 0.69f, 0.31f, 1};
  int index = 3;
  for (float* const channel : {&color.r, &color.g, &color.b, &color.a}) {
    if (index > lua_gettop(state)) break;
    *channel = CheckFloat(state, index++);
  }
  WarnUnless(state, Panels(state).SetBar(id, CheckFloat(state, 2), color));
  return 0;
}

int SetButton(lua_State* state) {
  const UiId id = UiArgument(state, 1);
  const std::string_view name = TextArgument(state, 2);
  luaL_checktype(state, 3, LUA_TFUNCTION);
  constexpr std::size_t kLongestName = 100;
  if (name.empty() || name.size() > kLongestName)
    return ArgumentError(state, 2, "a button's name has 1 to 100 letters");
  ScriptContext& context = ContextOf(state);
  if (!context.world.ui().SetButton(id, name)) return ArgumentError(state, 2, "another button has this name");
  lua_pushvalue(state, 3);
  context.buttons.Set(id, LuaMachine::Of(state), luaL_ref(state, LUA_REGISTRYINDEX));
  return 0;
}

int SetImage(lua_State* state) {
  const UiId id = UiArgument(state, 1);
  Panels(state).SetImage(id, ImageArgument(state, 2));
  return 0;
}

constexpr Binding kUiPartsBindings[] = {
    {"GetBar", GetBar, 1, 1, WrongCount::kError},           {"GetButton", GetButton, 1, 1, WrongCount::kError},
    {"RemoveBar", RemoveBar, 1, 1, WrongCount::kError},     {"RemoveButton", RemoveButton, 1, 1, WrongCount::kError},
    {"RemoveImage", RemoveImage, 1, 1, WrongCount::kError}, {"SetBar", SetBar, 2, 6, WrongCount::kError},
    {"SetButton", SetButton, 3, 3, WrongCount::kError},     {"SetImage", SetImage, 2, 2, WrongCount::kError},
};

}  // namespace

void BindUiParts(lua_State* state) {
  RegisterTable(state, "UI", kUiPartsBindings);
}

}  // namespace soarbox::script
