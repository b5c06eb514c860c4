// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <map>
#include <string>
#include <variant>

#include "diagnostics/result.h"
#include "world/ids.h"

namespace soarbox::script {

/// What a script asked for with Sandbox.CreateAgent or one of the CreateSoar... functions.
struct AgentCreationRequest {
  /// "lua" for an agent that its script alone drives; "seeking", "follower" and "waypoint" for the thesis' three kinds;
  /// "soar" for any other agent with rules.
  std::string kind = "lua";
  std::string script;  ///< Its body script, "SeekingAgent.lua".
  std::string rules;   ///< The .soar file that was named; empty: the kind's own.
  /// The options table, field by field. "name" is the agent's name.
  std::map<std::string, std::variant<bool, double, std::string>> options;

  /// The script and its line where this was asked for; empty if none.
  std::string made_in;
  int made_in_line = 0;

  bool HasMind() const { return kind != "lua"; }
};

/// Makes the minds of agents that are not driven by Lua alone. Scripts know nothing of rules: whoever runs the
/// simulation implements this.
class MindFactory {
 public:
  virtual ~MindFactory() = default;

  /// Called when the agent has its body and its target and Agent_Initialize has run. On failure the agent stays in the
  /// world, marked as failed, and the diagnostic is reported; the script goes on.
  virtual Result<void> MakeMind(world::EntityId agent, const AgentCreationRequest& request) = 0;
  /// What all minds take of the world's memory, as last measured.
  virtual std::size_t MemoryBytes() const { return 0; }
};

}  // namespace soarbox::script
