// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cmath>
#include <lua.hpp>

#include "script/binding.h"
#include "script/lua_machine.h"
#include "script/lua_values.h"
#include "script/script_context.h"

namespace soarbox::script {

/// A fast path for a function that scripts call in every step (Binding::plain). It does the same as the function if
/// each argument has exactly the expected type. Otherwise it returns kNotPlain before it has any effect, and the
/// function itself handles the call. Without all fast paths, worlds take 0.1 to 9 % more instructions; only that of
/// Vector.new saves more than 3 % (docs/dev/performance.md).
inline constexpr int kNotPlain = -1;

/// Returns the full name of the running API function, "Agent.GetPosition"; null if it is none.
const char* NameOfRunning(lua_State* state);

/// PushVector for callers that already have the state's machine.
void PushVector(lua_State* state, const LuaMachine& machine, world::Vec3 vector);

// Arguments: each of these functions rejects all other values.

/// The agent at `index`; null for everything else, also for a removed agent.
inline world::Agent* PlainAgent(lua_State* state, const LuaMachine& machine, int index) {
  const auto* handle = static_cast<const Handle*>(lua_touserdata(state, index));
  if (!handle || handle->kind != ValueKind::kAgent) return nullptr;
  world::Agent* agent = machine.context()->world.FindAgent(world::EntityId{handle->number});
  return agent != nullptr && !agent->IsGone() ? agent : nullptr;
}

/// Reads the number at `index`, if it is one.
inline bool PlainNumber(lua_State* state, int index, double& number) {
  number = lua_tonumber(state, index);
  return number != 0 || lua_type(state, index) == LUA_TNUMBER;
}
inline bool PlainFloat(lua_State* state, int index, float& number) {
  double full = 0;
  if (!PlainNumber(state, index, full)) return false;
  number = static_cast<float>(full);
  return true;
}

/// Finite, and within every range of the API's table, except the ranges that end at 0.
inline bool IsUsual(float number) {
  return std::abs(number) <= 1e5f;
}
inline bool IsUsual(world::Vec3 vector) {
  return IsUsual(vector.x) && IsUsual(vector.y) && IsUsual(vector.z);
}

/// Returns the agent if it is the call's only argument.
inline world::Agent* OnlyAgent(lua_State* state, const LuaMachine& machine) {
  return lua_gettop(state) == 1 ? PlainAgent(state, machine, 1) : nullptr;
}

/// Reads the call's two arguments, if they are an agent and a usual vector.
inline bool AgentAndVector(lua_State* state, const LuaMachine& machine, world::Agent*& agent, world::Vec3& vector) {
  if (lua_gettop(state) != 2) return false;
  agent = PlainAgent(state, machine, 1);
  const world::Vec3* given = ToVector(state, 2);
  if (!agent || !given || !IsUsual(*given)) return false;
  vector = *given;
  return true;
}

}  // namespace soarbox::script
