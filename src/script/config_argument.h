// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <initializer_list>

#include "diagnostics/diagnostic.h"
#include "world/math.h"
#include "world/scene_snapshot.h"

struct lua_State;

namespace soarbox::script {

/// One key of a table of settings, and where its value goes; the others are null.
struct ConfigKey {
  const char* name;
  float* number = nullptr;
  world::Vec3* vector = nullptr;
  bool* truth = nullptr;
};

/// Reads the table at `index`, if there is one: keys that it lacks leave their values alone. A value of a wrong type is
/// a Lua error; a key that is not listed is ignored with a warning that names a near one.
void ReadConfig(lua_State* state, int index, std::initializer_list<ConfigKey> keys);

/// An array {red, green, blue, alpha}, 0 to 1 each; what is missing counts as 0.
world::Color ColorArgument(lua_State* state, int index);

/// Raises the diagnostic as a Lua error at the script's line.
int RaiseDiagnostic(lua_State* state, const Diagnostic& error);

}  // namespace soarbox::script
