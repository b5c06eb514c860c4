// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

struct lua_State;

namespace soarbox::script {

/// The answer of a game's script to a command.
struct GameAnswer {
  std::string reason = {};       ///< Why it was not executed, in one word; empty if it was.
  std::string text = {};         ///< The reason for users; or, if it was executed, a remark.
  std::string drops = {};        ///< A command of the same turn that is not executed because of this one.
  std::string drop_reason = {};  ///< Why, in one word.
};

/// Reads the two values on top of the stack, the results of Sandbox_Command (docs/scenarios.md): nothing or a word, and
/// nothing or a table with `text`, `given` and `known`, `drops` and `reason`. Raises no Lua error.
GameAnswer ReadGameAnswer(lua_State* state);

}  // namespace soarbox::script
