// SPDX-License-Identifier: BSD-2-Clause
#pragma once

struct lua_State;

namespace soarbox::script {

/// Replaces pairs, next and table.foreach in a machine. Tables are then visited in an order that depends only on their
/// contents: numbers ascending, then strings by their bytes, then false and true, then other objects in the order of
/// their creation. Lua's own order depends on hashes that differ from process to process.
///
/// `pairs` fixes the order when the loop begins; fields removed during the loop are skipped, new ones are not visited.
/// Call it inside a protected call.
void InstallOrder(lua_State* state);

/// Returns true, and sets `count`, if the table at `index` contains exactly the keys 1 to `count` and Lua also visits
/// them in this order. Then it can be iterated by number, without PushOrderedKeys.
bool IsPlainArray(lua_State* state, int index, int& count);

/// Pushes an array of the keys of the table at `index`, in that order. May raise for lack of memory.
void PushOrderedKeys(lua_State* state, int index);

}  // namespace soarbox::script
