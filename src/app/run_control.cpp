// SPDX-License-Identifier: BSD-2-Clause
#include "app/run_control.h"

namespace soarbox::app {
namespace {

void StepMind(RunSession& session, viewer::Viewer& viewer, const world::SceneSnapshot& scene, bool whole_decision) {
  std::string name;
  for (const world::AgentSnapshot& agent : scene.agents) {
    if (agent.id == viewer.selected_agent()) name = agent.name;
  }
  sim::Simulation& simulation = session.simulation();
  if (name.empty()) return viewer.Tell("Select the Soar agent whose mind is to take a step");
  if (!simulation.HasMind(name)) return viewer.Tell(name + " has no Soar mind to step");
  const Result<std::string> answer = simulation.Command(name, whole_decision ? "run -d 1 --self" : "run -p 1 --self");
  if (!answer) return viewer.Tell(answer.error().message);
  std::string next;
  if (const std::unique_ptr<sim::Inspector> mind = simulation.Inspect(name)) next = mind->Mind().phase;
  viewer.Tell(name + (whole_decision ? ": one decision" : ": one phase") +
              (next.empty() || whole_decision ? "" : ", next is " + next) +
              "; the world stands still and takes its commands in the next tick");
}

}  // namespace

Result<bool> RunControl::Obey(viewer::ViewerCommand command, RunSession& session, viewer::Viewer& viewer,
                              const world::SceneSnapshot& scene) {
  switch (command) {
    case viewer::ViewerCommand::kStepDecision:
    case viewer::ViewerCommand::kStepPhase:
      StepMind(session, viewer, scene, command == viewer::ViewerCommand::kStepDecision);
      return true;
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
