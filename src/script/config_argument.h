// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <initializer_list>

#include "diagnostics/diagnostic.h"
#include "world/math.h"
#include "world/scene_snapshot.h"

struct lua_State;

namespace soarbox::script {

/// A key of a table of settings, and the variable for its value; the other pointers are null.
struct ConfigKey {
  const char* name;
  float* number = nullptr;
  world::Vec3* vector = nullptr;
  bool* truth = nullptr;
};

/// Reads the table at `index`, if there is one. Variables of missing keys are unchanged. A value of a wrong type is a
/// Lua error. An unknown key is ignored with a warning that suggests a similar one.
void ReadConfig(lua_State* state, int index, std::initializer_list<ConfigKey> keys);

/// An array {red, green, blue, alpha}, 0 to 1 each; missing values are 0.
world::Color ColorArgument(lua_State* state, int index);

/// Raises the diagnostic as a Lua error at the current line of the script.
int RaiseDiagnostic(lua_State* state, const Diagnostic& error);

}  // namespace soarbox::script
