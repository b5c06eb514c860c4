// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <variant>
#include <vector>

struct lua_State;

namespace soarbox::script {

/// A Lua table as plain data: named fields, and tables within. What a mind perceives from a script and gives to it.
struct TableField {
  std::string name;
  std::variant<double, std::string, std::vector<TableField>> value;
};
using Table = std::vector<TableField>;

/// Copies the table at `index`: keys that are strings, in their order; numbers in lists get the list's own name. Values
/// that are numbers, strings, booleans ("yes", "no"), vectors ({x, y, z}), agents (their names) and tables, at most 8
/// deep and 1000 in all; others are left out.
Table CopyTable(lua_State* state, int index);
/// Pushes a new table of these fields. Fields of one name become the first one's value; the rest is left out.
void PushTable(lua_State* state, const Table& table);

}  // namespace soarbox::script
