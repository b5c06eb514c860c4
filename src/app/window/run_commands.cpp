// SPDX-License-Identifier: BSD-2-Clause
#include "app/window/run_commands.h"

#include <string>

#include "app/mind_steps.h"

namespace soarbox::app {
namespace {

std::string NameOf(std::uint32_t agent_id, const world::SceneSnapshot& scene) {
  for (const world::AgentSnapshot& agent : scene.agents)
    if (agent.id == agent_id) return agent.name;
  return {};
}

}  // namespace

Result<bool> RunCommands::Obey(viewer::ViewerCommand command, RunSession& session, viewer::Viewer& viewer,
                               const world::SceneSnapshot& scene) {
  switch (command) {
    case viewer::ViewerCommand::kStepDecision:
    case viewer::ViewerCommand::kStepPhase: {
      const MindStepped stepped =
          StepMind(session, NameOf(viewer.selected_agent(), scene),
                   command == viewer::ViewerCommand::kStepDecision ? MindStep::kDecision : MindStep::kPhase);
      viewer.Tell(stepped.told);
      has_ticked |= stepped.has_ticked;
      return true;
    }
    case viewer::ViewerCommand::kReset:
    case viewer::ViewerCommand::kNextSeed: {
      const Result<void> begun = session.BeginAgain(command == viewer::ViewerCommand::kNextSeed);
      if (!begun) return begun.error();
      has_begun_again = true;
      viewer.Tell("From the beginning, seed " + std::to_string(session.seed()));
      return true;
    }
    default:
      return false;
  }
}

}  // namespace soarbox::app
