// SPDX-License-Identifier: BSD-2-Clause
#include <lua.hpp>
#include <span>

#include "script/bind_api.h"
#include "script/lua_library.h"

namespace soarbox::script {
namespace {

/// Upvalues: the function's name, what is lacking.
int RaiseUnavailable(lua_State* state) {
  return luaL_error(state, "%s cannot be used: this version of the sandbox has no %s",
                    lua_tostring(state, lua_upvalueindex(1)), lua_tostring(state, lua_upvalueindex(2)));
}

constexpr const char* kAnimation[] = {
    "AttachToBone", "GetAnimation", "GetBoneNames", "GetBonePosition",    "GetBoneRotation",
    "GetLength",    "GetName",      "GetTime",      "GetNormalizedTime",  "GetWeight",
    "IsEnabled",    "IsLooping",    "Reset",        "SetDisplaySkeleton", "SetEnabled",
    "SetLooping",   "SetTime",      "SetWeight",    "SetNormalizedTime",  "StepAnimation",
};

constexpr const char* kNavigation[] = {
    "CreateNavigationMesh", "FindClosestPoint", "FindPath", "RandomPoint", "SetDebugNavigationMesh",
};

constexpr const char* kInfluence[] = {
    "ClearInfluenceMap",   "CreateInfluenceMap", "DrawInfluenceMap", "GetInertia",   "GetInfluence",
    "SetDrawInfluenceMap", "SetFalloff",         "SetInertia",       "SetInfluence", "SpreadInfluenceMap",
};

/// Registers functions that this build of the world cannot serve: each raises a Lua error that names it.
void RegisterUnavailable(lua_State* state, const char* table, const char* what, std::span<const char* const> names) {
  lua_getglobal(state, table);
  if (!lua_istable(state, -1)) {
    lua_pop(state, 1);
    lua_newtable(state);
    lua_pushvalue(state, -1);
    lua_setglobal(state, table);
    MarkLoaded(state, table);
  }
  for (const char* name : names) {
    lua_pushfstring(state, "%s.%s", table, name);
    lua_pushstring(state, what);
    lua_pushcclosure(state, RaiseUnavailable, 2);
    lua_setfield(state, -2, name);
  }
  lua_pop(state, 1);
}

}  // namespace

void BindAnimation(lua_State* state) {
  RegisterUnavailable(state, "Animation", "animated meshes", kAnimation);
}

void BindSandboxNavigation(lua_State* state) {
  RegisterUnavailable(state, "Sandbox", "navigation meshes", kNavigation);
  RegisterUnavailable(state, "Sandbox", "influence maps", kInfluence);
}

}  // namespace soarbox::script
