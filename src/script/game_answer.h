// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

struct lua_State;

namespace soarbox::script {

/// What the script of a game answers to a command.
struct GameAnswer {
  std::string reason = {};       ///< Why it was not carried out, in one word; empty if it was.
  std::string text = {};         ///< The same for people; or, if it was carried out, what to say about it.
  std::string drops = {};        ///< A command of the same turn that is not carried out because of this one.
  std::string drop_reason = {};  ///< Why, in one word.
};

/// Reads the two values on top of the stack, as Sandbox_Command returns them (docs/scenarios.md): nothing or a word,
/// and nothing or a table with `text`, `given` and `known`, `drops` and `reason`. Raises no Lua error.
GameAnswer ReadGameAnswer(lua_State* state);

}  // namespace soarbox::script
