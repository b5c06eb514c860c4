// SPDX-License-Identifier: BSD-2-Clause
#include "script/argument_check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <lua.hpp>
#include <string>

#include "script/bind_arguments.h"
#include "script/binding.h"

namespace soarbox::script {
namespace {

bool IsKind(const Handle* handle, std::initializer_list<ValueKind> kinds) {
  for (const ValueKind kind : kinds) {
    if (handle && handle->kind == kind) return true;
  }
  return false;
}

/// The expected kind of a lenient argument, for the warning; null if the argument is right or not lenient.
const char* WantedInstead(const ApiArgument& argument, const Handle* handle) {
  using enum ValueKind;
  switch (argument.type) {
    case ApiType::kSandbox:
      return IsKind(handle, {kSandbox}) ? nullptr : "the sandbox";
    case ApiType::kObject:
      return IsKind(handle, {kObject}) ? nullptr : "a sandbox object";
    case ApiType::kNode:
      // For objects, Core.Remove says what to use instead.
      return IsKind(handle, {kNode, kObject}) ? nullptr : "a scene node";
    case ApiType::kPlaced:
      return IsKind(handle, {kNode, kObject}) ? nullptr : "a scene node";
    case ApiType::kScene:
      return IsKind(handle, {kNode, kObject, kSandbox}) ? nullptr : "a scene node, an object or the sandbox";
    case ApiType::kMesh:
      // For agents, BodyArgument says what to use instead.
      return IsKind(handle, {kNode, kObject, kSandbox, kAgent}) ? nullptr : "a scene node, an object or the sandbox";
    case ApiType::kThing:
      return IsKind(handle, {kNode, kObject, kSandbox, kAgent}) ? nullptr : "a thing with a scene node";
    default:
      return nullptr;
  }
}

/// The expected type of a strict argument; null if the argument is right or not strict.
const char* ExpectedInstead(lua_State* state, int index, ApiType type) {
  switch (type) {
    case ApiType::kAgent:
      return IsKind(ToHandle(state, index), {ValueKind::kAgent}) ? nullptr : NameOf(ValueKind::kAgent);
    case ApiType::kUi:
      return IsKind(ToHandle(state, index), {ValueKind::kUi}) ? nullptr : NameOf(ValueKind::kUi);
    case ApiType::kAnimation:
      return IsKind(ToHandle(state, index), {ValueKind::kAnimation}) ? nullptr : NameOf(ValueKind::kAnimation);
    case ApiType::kVector:
      return ToVector(state, index) ? nullptr : NameOf(ValueKind::kVector);
    case ApiType::kNumber:
      return lua_isnumber(state, index) ? nullptr : "number";
    case ApiType::kString:
      return lua_isstring(state, index) ? nullptr : "string";
    case ApiType::kTable:
      return lua_istable(state, index) ? nullptr : "table";
    case ApiType::kAgents:
      return lua_istable(state, index) || lua_type(state, index) == LUA_TSTRING ? nullptr : "table or name of a team";
    case ApiType::kFunction:
      return lua_isfunction(state, index) ? nullptr : "function";
    default:
      return nullptr;
  }
}

bool IsWithin(double value, const ApiArgument& argument) {
  return value >= argument.low && value <= argument.high;
}

/// The nearest value in range; for NaN, the one nearest to 0.
double Nearest(double value, const ApiArgument& argument) {
  return std::clamp(std::isnan(value) ? 0.0 : value, argument.low, argument.high);
}

std::string Shortly(double value) {
  if (std::isnan(value)) return "nan";  // Without its sign.
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

/// Warns that a number or a component is out of range, with the value that is used instead.
void WarnOfRange(lua_State* state, int index, const ApiArgument& argument, double value, double taken) {
  const std::string unit = argument.unit.empty() ? std::string() : " " + std::string(argument.unit);
  const bool is_bounded = !argument.range.empty();
  std::string text = "argument " + std::to_string(index) + ", the " + std::string(argument.name) + ", ";
  if (argument.type == ApiType::kVector) text += "has a component that ";
  text += "is " + Shortly(value);
  if (is_bounded) text += ": " + Shortly(taken) + unit + " is used";
  if (!is_bounded) text += ", which is not a finite number";
  WarnAtCallerOnce(state, std::move(text), argument.name);
}

/// Checks the range if the argument is a number or a vector. False if the call must do nothing.
bool CheckRange(lua_State* state, int index, const ApiArgument& argument, const Binding& binding) {
  if (argument.type != ApiType::kNumber && argument.type != ApiType::kVector) return true;
  const world::Vec3* vector = argument.type == ApiType::kVector ? ToVector(state, index) : nullptr;
  world::Vec3 replaced = vector ? *vector : world::Vec3{static_cast<float>(lua_tonumber(state, index)), 0, 0};
  float* const components[] = {&replaced.x, &replaced.y, &replaced.z};
  bool is_changed = false;
  for (int i = 0; i < (vector ? 3 : 1); ++i) {
    const double value = *components[i];
    if (IsWithin(value, argument)) continue;
    if (!std::isfinite(value) && binding.function->results.empty()) {
      WarnIgnored(state, lua_pushfstring(state, "argument %d, the %s, is not finite", index,
                                         std::string(argument.name).c_str()));
      return false;
    }
    const double taken = Nearest(value, argument);
    if (!is_changed) WarnOfRange(state, index, argument, value, taken);
    is_changed = true;
    *components[i] = static_cast<float>(taken);
  }
  if (!is_changed || argument.range.empty()) return true;
  // A new vector: the caller's is unchanged.
  if (vector) {
    PushVector(state, replaced);
  } else {
    lua_pushnumber(state, replaced.x);
  }
  lua_replace(state, index);
  return true;
}

bool IsWithin(const world::Vec3& vector, const ApiArgument& argument) {
  return IsWithin(vector.x, argument) && IsWithin(vector.y, argument) && IsWithin(vector.z, argument);
}

/// Whether the argument has the right type and is in range; false if that is not certain. Most arguments need no more.
bool IsUsual(lua_State* state, int index, const ApiArgument& argument) {
  switch (argument.type) {
    case ApiType::kAgent:
      return IsKind(ToHandle(state, index), {ValueKind::kAgent});
    case ApiType::kVector: {
      const world::Vec3* vector = ToVector(state, index);
      return vector && IsWithin(*vector, argument);
    }
    case ApiType::kNumber: {
      const double number = lua_tonumber(state, index);
      // Other values than numbers give 0.
      return (number != 0 || lua_type(state, index) == LUA_TNUMBER) && IsWithin(static_cast<float>(number), argument);
    }
    case ApiType::kBoolean:
    case ApiType::kValue:
      return true;
    default:
      return false;
  }
}

/// Raises an error for the first handle before argument `end` that refers to a removed thing. A wrong argument after it
/// is not reported, because the removed thing is the first mistake.
void CheckAlive(lua_State* state, int end) {
  for (int index = 1; index < end; ++index) {
    const Handle* handle = ToHandle(state, index);
    if (!handle) continue;
    if (handle->kind == ValueKind::kObject) ObjectArgument(state, index);
    if (handle->kind == ValueKind::kNode) NodeArgument(state, index);
    if (handle->kind == ValueKind::kUi) UiArgument(state, index);
  }
}

/// Upvalue: the table's name. (table, key)
int ReadUnknownName(lua_State* state) {
  if (lua_type(state, 2) == LUA_TSTRING) {
    std::size_t length = 0, table_length = 0;
    const char* name = lua_tolstring(state, 2, &length);
    const char* table = lua_tolstring(state, lua_upvalueindex(1), &table_length);
    RaiseIfNear(state, {table, table_length}, {name, length});
  }
  return 0;
}

}  // namespace

bool CheckArguments(lua_State* state, const Binding& binding) {
  const int count = std::min(lua_gettop(state), static_cast<int>(binding.arguments.size()));
  for (int index = 1; index <= count; ++index) {
    const ApiArgument& argument = binding.arguments[static_cast<std::size_t>(index) - 1];
    if (IsUsual(state, index, argument)) continue;
    if (argument.optional && lua_isnil(state, index)) continue;
    if (const char* wanted = WantedInstead(argument, ToHandle(state, index))) {
      CheckAlive(state, index);
      WarnIgnored(state,
                  lua_pushfstring(state, "argument %d is not %s but %s", index, wanted, NameOfValue(state, index)));
      return false;
    }
    if (const char* expected = ExpectedInstead(state, index, argument.type)) {
      CheckAlive(state, index);
      ArgumentError(state, index, lua_pushfstring(state, "%s expected, got %s", expected, NameOfValue(state, index)));
    }
    if (!binding.takes_any_number && !CheckRange(state, index, argument, binding)) return false;
  }
  return true;
}

int ArgumentError(lua_State* state, int index, const char* text) {
  const char* name = NameOfRunning(state);
  if (!name) return luaL_argerror(state, index, text);
  lua_Debug frame;
  const bool is_method = lua_getstack(state, 0, &frame) == 1 && lua_getinfo(state, "n", &frame) != 0 &&
                         frame.namewhat && std::string_view(frame.namewhat) == "method";
  // In a method's call, the agent before the colon is not counted as an argument.
  if (is_method && index == 1) return luaL_error(state, "bad self of '%s' (%s)", name, text);
  return luaL_error(state, "bad argument #%d to '%s' (%s)", is_method ? index - 1 : index, name, text);
}

void RaiseIfNear(lua_State* state, std::string_view table, std::string_view name) {
  const std::string_view meant = SuggestApiName(table, name);
  if (meant.empty()) return;
  lua_pushlstring(state, table.data(), table.size());
  lua_pushlstring(state, name.data(), name.size());
  lua_pushlstring(state, meant.data(), meant.size());
  luaL_error(state, "%s has no function '%s': did you mean '%s'?", lua_tostring(state, -3), lua_tostring(state, -2),
             lua_tostring(state, -1));
}

void GuardNames(lua_State* state, const char* table) {
  lua_createtable(state, 0, 1);
  lua_pushstring(state, table);
  lua_pushcclosure(state, ReadUnknownName, 1);
  lua_setfield(state, -2, "__index");
  lua_setmetatable(state, -2);
}

}  // namespace soarbox::script
