// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string>

struct lua_State;

namespace soarbox::script {

/// The result of Agent_Update for a command of the agent's mind (docs/scenarios.md).
struct CommandAnswer {
  enum class State : unsigned char {
    kComplete,  ///< Nothing, or "complete".
    kRunning,   ///< "running": the call is repeated in the next tick.
    kError,     ///< "error", with a reason in one word and a text for users.
  } state = State::kComplete;
  std::optional<float> progress = {};  ///< 0 to 1, for a running command.
  std::string reason = {}, text = {};
  std::string unknown = {};  ///< A word that is none of these; the command counts as complete.
};

/// Number of values that ReadCommandAnswer reads.
inline constexpr int kCommandResults = 3;
/// Reads the values on top of the stack. Raises no Lua error.
CommandAnswer ReadCommandAnswer(lua_State* state);

}  // namespace soarbox::script
