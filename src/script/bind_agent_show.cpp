// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <cstdio>
#include <lua.hpp>
#include <string>
#include <vector>

#include "script/api_call.h"
#include "script/lua_order.h"
#include "world/shown_state.h"

// Agent.Show: a script shows the state of an agent to users.

namespace soarbox::script {
namespace {

using world::ShownRow;
using world::ShownState;
using enum WrongCount;

constexpr int kDeepestShown = 8;

/// Formats a value for users; empty for tables and functions.
std::string ShownText(lua_State* state, int index) {
  switch (lua_type(state, index)) {
    case LUA_TNUMBER: {
      char text[32];
      std::snprintf(text, sizeof text, "%.6g", lua_tonumber(state, index));
      return text;
    }
    case LUA_TSTRING:
      return lua_tostring(state, index);
    case LUA_TBOOLEAN:
      return lua_toboolean(state, index) != 0 ? "true" : "false";
    case LUA_TNIL:
      return "nil";
    default:
      break;
  }
  if (const world::Vec3* vector = ToVector(state, index)) {
    char text[96];
    std::snprintf(text, sizeof text, "(%.2f, %.2f, %.2f)", static_cast<double>(vector->x),
                  static_cast<double>(vector->y), static_cast<double>(vector->z));
    return text;
  }
  if (const Handle* handle = ToHandle(state, index)) {
    const world::Agent* agent =
        handle->kind == ValueKind::kAgent ? ContextOf(state).world.FindAgent(world::EntityId{handle->number}) : nullptr;
    return agent != nullptr ? agent->name() : std::string(NameOf(handle->kind));
  }
  return {};
}

void PushRawField(lua_State* state, int table, std::string_view name) {
  lua_pushlstring(state, name.data(), name.size());
  lua_rawget(state, table);
}

/// Reads a table's fields "name", "value" and "active" as properties of its own row.
void ReadOwnFields(lua_State* state, int table, ShownRow& row) {
  PushRawField(state, table, "name");
  if (lua_type(state, -1) == LUA_TSTRING) row.name = lua_tostring(state, -1);
  lua_pop(state, 1);
  PushRawField(state, table, "value");
  if (!lua_isnil(state, -1)) row.value = ShownText(state, lua_gettop(state));
  lua_pop(state, 1);
  PushRawField(state, table, "active");
  row.active = lua_toboolean(state, -1) != 0;
  lua_pop(state, 1);
}

bool IsOwnField(const std::string& name) {
  return name == "name" || name == "value" || name == "active";
}

/// Adds a row for the value on top of the stack, and rows for the contents of a table: its list in order, then its
/// fields by name. Reads tables raw, so no function of the script runs.
void ReadShownValue(lua_State* state, std::string name, int depth, std::vector<ShownRow>& rows) {
  if (rows.size() >= ShownState::kMostRows) return;
  const int index = lua_gettop(state);
  const std::size_t at = rows.size();
  ShownRow& row = rows.emplace_back();
  row.depth = depth;
  row.name = std::move(name);
  if (!lua_istable(state, index)) {
    rows[at].value = ShownText(state, index);
    return;
  }
  ReadOwnFields(state, index, rows[at]);
  if (depth >= kDeepestShown) return;
  const int length = static_cast<int>(std::min<std::size_t>(lua_objlen(state, index), ShownState::kMostRows));
  for (int i = 1; i <= length; ++i) {
    lua_rawgeti(state, index, i);
    ReadShownValue(state, std::to_string(i), depth + 1, rows);
    lua_pop(state, 1);
  }
  std::vector<std::string> names;
  for (lua_pushnil(state); lua_next(state, index) != 0; lua_pop(state, 1)) {
    if (lua_type(state, -2) != LUA_TSTRING || lua_isfunction(state, -1)) continue;
    if (std::string field = lua_tostring(state, -2); !IsOwnField(field)) names.push_back(std::move(field));
  }
  std::sort(names.begin(), names.end());
  for (const std::string& field : names) {
    PushRawField(state, index, field);
    ReadShownValue(state, field, depth + 1, rows);
    lua_pop(state, 1);
  }
}

/// (agent, name [, value])
int Show(lua_State* state) {
  world::Agent& agent = AgentArgument(state, 1);
  const std::string topic(TextArgument(state, 2));
  lua_settop(state, 3);
  luaL_checkstack(state, 6 * kDeepestShown, "too many nested calls");
  std::vector<ShownRow> rows;
  if (!lua_isnil(state, 3)) ReadShownValue(state, topic, 0, rows);
  if (rows.size() >= ShownState::kMostRows)
    WarnAtCallerOnce(state, "an agent shows at most " + std::to_string(ShownState::kMostRows) + " rows", "rows");
  LuaMachine::Of(state).Charge(20 + 20 * rows.size());
  agent.Show(topic, std::move(rows), ContextOf(state).world.tick());
  // An agent with a mind gets its last command from the mind.
  if (agent.kind() == "lua") agent.SetLastCommand(world::DoingOf(agent.Shown().rows()));
  return 0;
}

int Self(lua_State* state) {
  const std::uint32_t owner = LuaMachine::Of(state).owner();
  if (owner == 0) {
    lua_pushnil(state);
  } else {
    PushAgent(state, world::EntityId{owner});
  }
  return 1;
}

constexpr ApiFunction kAgentShowFunctions[] = {
    {"Agent.Self", Self, kError, "", "Agent",
     "The agent that the calling script belongs to; nil in the sandbox's own scripts. Use it in modules that do not "
     "get the agent as an argument.",
     R"(print(Agent.Self())  --> nil)", true},
    {"Agent.Show", Show, kError, "agent: Agent, name: string, value: value = nil", "",
     "Shows a part of the agent's state to people, in the panel Mind and in recordings. The value is a number, a text, "
     "a vector or a table of such values, of any depth; nil removes it. In a table, `active = true` marks an entry "
     "that is chosen or in progress, and `name` and `value` are the text of the table's own line. List items are shown "
     "in their order, other fields sorted by name. Labels show the first value, or the one called \"doing\", as the "
     "agent's activity.",
     R"(agent:Show("state", "patrol")
agent:Show("scores", { attack = 0.2, flee = { value = 0.9, active = true } })
agent:Show("tree", { { name = "fight", active = true, { name = "reload", active = true }, { name = "shoot" } } }))",
     true},
};

}  // namespace

std::span<const ApiFunction> AgentShowApi() {
  return kAgentShowFunctions;
}

}  // namespace soarbox::script
