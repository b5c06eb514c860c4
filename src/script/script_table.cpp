// SPDX-License-Identifier: BSD-2-Clause
#include "script/script_table.h"

#include <algorithm>
#include <cmath>
#include <lua.hpp>

#include "script/lua_values.h"
#include "script/script_context.h"

namespace soarbox::script {
namespace {

constexpr int kDeepestTable = 8;
constexpr int kMostFields = 1000;

void CopyFields(lua_State* state, int index, Table& table, int depth, int& left, const std::string& list_name);

/// Copies the value on top of the stack under this name.
void CopyValue(lua_State* state, const std::string& name, Table& table, int depth, int& left) {
  if (left <= 0) return;
  --left;
  const int top = lua_gettop(state);
  switch (lua_type(state, top)) {
    case LUA_TNUMBER:
      if (std::isfinite(lua_tonumber(state, top))) table.push_back({name, lua_tonumber(state, top)});
      return;
    case LUA_TSTRING:
      table.push_back({name, std::string(lua_tostring(state, top))});
      return;
    case LUA_TBOOLEAN:
      table.push_back({name, std::string(lua_toboolean(state, top) != 0 ? "yes" : "no")});
      return;
    case LUA_TUSERDATA:
      if (const world::Vec3* vector = ToVector(state, top)) {
        table.push_back({name, Table{{"x", static_cast<double>(vector->x)},
                                     {"y", static_cast<double>(vector->y)},
                                     {"z", static_cast<double>(vector->z)}}});
      } else if (const Handle* handle = ToHandle(state, top); handle && handle->kind == ValueKind::kAgent) {
        if (const auto* agent = ContextOf(state).world.FindAgent(world::EntityId{handle->number}))
          table.push_back({name, agent->name()});
      }
      return;
    case LUA_TTABLE: {
      if (depth >= kDeepestTable) return;
      // A list becomes several attributes with the list's name; any other table becomes an object.
      lua_rawgeti(state, top, 1);
      const bool is_list = !lua_isnil(state, -1);
      lua_pop(state, 1);
      if (is_list) {
        CopyFields(state, top, table, depth + 1, left, name);
      } else {
        Table below;
        CopyFields(state, top, below, depth + 1, left, {});
        table.push_back({name, std::move(below)});
      }
      return;
    }
    default:
      return;
  }
}

void CopyFields(lua_State* state, int index, Table& table, int depth, int& left, const std::string& list_name) {
  luaL_checkstack(state, 4, "nested tables");
  if (!list_name.empty()) {
    for (int i = 1; left > 0; ++i) {
      lua_rawgeti(state, index, i);
      const bool at_end = lua_isnil(state, -1);
      if (!at_end) CopyValue(state, list_name, table, depth, left);
      lua_pop(state, 1);
      if (at_end) return;
    }
    return;
  }
  lua_pushnil(state);
  while (lua_next(state, index) != 0) {
    if (lua_type(state, -2) == LUA_TSTRING) CopyValue(state, lua_tostring(state, -2), table, depth, left);
    lua_pop(state, 1);
  }
  // Lua's own order differs from process to process.
  std::stable_sort(table.begin(), table.end(),
                   [](const TableField& a, const TableField& b) { return a.name < b.name; });
}

}  // namespace

Table CopyTable(lua_State* state, int index) {
  Table table;
  int left = kMostFields;
  CopyFields(state, index, table, 0, left, {});
  return table;
}

void PushTable(lua_State* state, const Table& table) {
  luaL_checkstack(state, 4, "nested tables");
  lua_createtable(state, 0, static_cast<int>(table.size()));
  for (const TableField& field : table) {
    lua_getfield(state, -1, field.name.c_str());
    const bool is_new = lua_isnil(state, -1);
    lua_pop(state, 1);
    if (!is_new) continue;
    if (const auto* number = std::get_if<double>(&field.value)) {
      lua_pushnumber(state, *number);
    } else if (const auto* text = std::get_if<std::string>(&field.value)) {
      lua_pushlstring(state, text->data(), text->size());
    } else {
      PushTable(state, std::get<Table>(field.value));
    }
    lua_setfield(state, -2, field.name.c_str());
  }
}

}  // namespace soarbox::script
