// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "world/entity_ids.h"

struct lua_State;

namespace soarbox::script {

class LuaMachine;

/// Arrays of all agents, for one machine. The scripts of a flock request one in each step and pass it to several
/// steering forces. Creating and reading such an array element by element would take most of the time of a large flock.
///
/// LuaJIT keeps the elements of a long array in one block of our memory (ScriptMemory). This class keeps a template: an
/// array that no script can reach. A new array is made by copying the template's block. An array that a script passes
/// back is compared with that block in one operation. If blocks do not have the expected size, as in other
/// implementations of Lua, elements are used one by one.
class AgentLists {
 public:
  /// Pushes a new array of the handles of these agents.
  void Push(lua_State* state, std::span<const world::EntityId> ids);
  /// Returns true if the table at `index` is the array that was pushed last, and it contains exactly the handles of
  /// these agents in this order. Returns false if that is not certain.
  bool Holds(lua_State* state, int index, std::span<const world::EntityId> ids) const;

 private:
  /// The block of the array that was just created; null if its size is not as expected.
  static void* BlockOfNewArray(LuaMachine& machine, std::size_t count);
  void MakeTemplate(lua_State* state, std::span<const world::EntityId> ids);

  std::vector<world::EntityId> ids_;  ///< The agents in the template.
  int template_ = 0;                  ///< Reference of the template in the registry; 0: there is none.
  const void* template_block_ = nullptr;
  const void* last_ = nullptr;  ///< The table that was pushed last; its block is the one that the memory watches.
};

}  // namespace soarbox::script
