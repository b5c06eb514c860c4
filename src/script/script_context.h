// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <map>
#include <string>

#include "diagnostics/result.h"
#include "script/callbacks.h"
#include "script/event_queue.h"
#include "script/mind_factory.h"
#include "script/script_reporter.h"
#include "world/world.h"

namespace soarbox::script {

/// Creates an agent with its own machine. ScriptHost implements it.
class AgentMaker {
 public:
  virtual ~AgentMaker() = default;
  virtual Result<world::EntityId> MakeAgent(const AgentCreationRequest& request) = 0;
};

/// The data of the functions of the sandbox's API. One for all machines of a sandbox.
struct ScriptContext {
  world::World& world;
  ScriptReporter& reporter;
  AgentMaker& agents;
  WorldBudget& budget;
  EventQueue events{};
  Callbacks listeners{};   ///< Of events: callback(sandbox, listener, type, event). One per listener.
  Callbacks collisions{};  ///< Of objects: callback(sandbox, collision).
  Callbacks buttons{};     ///< Of panels: callback(sandbox, panel). One per panel.
  std::map<std::string, std::string, std::less<>>
      assets{};  ///< Keys of files, by the names of the files (script_asset.h).
};

/// Returns the context of a state's machine. The API is bound only in machines that have one.
ScriptContext& ContextOf(lua_State* state);

}  // namespace soarbox::script
