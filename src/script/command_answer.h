// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string>

struct lua_State;

namespace soarbox::script {

/// What Agent_Update returns for a command of the agent's mind (docs/scenarios.md).
struct CommandAnswer {
  enum class State : unsigned char {
    kComplete,  ///< Nothing, or "complete".
    kRunning,   ///< "running": the call comes again in the next tick.
    kError,     ///< "error", with a reason in one word and a text for people.
  } state = State::kComplete;
  std::optional<float> progress = {};  ///< 0 to 1, of a command that is running.
  std::string reason = {}, text = {};
  std::string unknown = {};  ///< A word that is none of these; it counts as complete.
};

/// How many values ReadCommandAnswer reads.
inline constexpr int kCommandResults = 3;
/// Reads the values on top of the stack. Raises no Lua error.
CommandAnswer ReadCommandAnswer(lua_State* state);

}  // namespace soarbox::script
