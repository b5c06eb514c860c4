// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <map>
#include <string>
#include <variant>

#include "diagnostics/result.h"
#include "world/entity_ids.h"

namespace soarbox::script {

/// The arguments of Sandbox.CreateAgent or of one of the CreateSoar... functions.
struct AgentCreationRequest {
  /// "lua" for an agent that only its script controls; "seeking", "follower" and "waypoint" for the three kinds of the
  /// thesis; "soar" for any other agent with rules.
  std::string kind = "lua";
  std::string script;  ///< Its body script, "SeekingAgent.lua".
  std::string rules;   ///< The .soar file that was given; empty: the default of the kind.
  /// The options table, field by field. "name" is the agent's name.
  std::map<std::string, std::variant<bool, double, std::string>> options;

  /// The script and the line of the call; empty if none.
  std::string made_in;
  int made_in_line = 0;

  bool HasMind() const { return kind != "lua"; }
};

/// Creates the minds of agents that are not controlled by Lua alone. The script module does not depend on rules; the
/// simulation implements this interface.
class MindFactory {
 public:
  virtual ~MindFactory() = default;

  /// Called after Agent_Initialize, when the agent has its body and its target. For an agent without a script, it also
  /// creates the body. If it fails, the agent stays in the
  /// world, marked as failed, the diagnostic is reported, and the script continues.
  virtual Result<void> MakeMind(world::EntityId agent, const AgentCreationRequest& request) = 0;
  /// Memory of all minds, as last measured.
  virtual std::size_t MemoryBytes() const { return 0; }
};

}  // namespace soarbox::script
