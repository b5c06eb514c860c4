// SPDX-License-Identifier: BSD-2-Clause
#include <lua.hpp>
#include <optional>

#include "script/bind_api.h"
#include "script/bind_arguments.h"
#include "script/binding.h"
#include "script/script_asset.h"

// Sandbox.PlaySound.

namespace soarbox::script {
namespace {

/// (sandbox, file [, volume [, position]])
int PlaySound(lua_State* state) {
  if (!SandboxArgument(state, 1)) return 0;
  const int count = lua_gettop(state);
  const float volume = count >= 3 ? CheckFloat(state, 3) : 1;
  const std::optional<world::Vec3> position = count >= 4 ? std::optional(CheckVector(state, 4)) : std::nullopt;
  ContextOf(state).world.PlaySound(SoundArgument(state, 2), volume, position);
  return 0;
}

constexpr Binding kSandboxSoundBindings[] = {
    {"PlaySound", PlaySound, 2, 4, WrongCount::kError},
};

}  // namespace

void BindSandboxSound(lua_State* state) {
  RegisterTable(state, "Sandbox", kSandboxSoundBindings);
}

}  // namespace soarbox::script
