// SPDX-License-Identifier: BSD-2-Clause
#include "cli/host.h"

#include "cli/session.h"

namespace soarbox::cli {

namespace {

kernel::RunResult RunAlone(kernel::Agent& agent, const RunRequest& request) {
  agent.ClearStopRequest();
  if (request.unit == kernel::RunUnit::kDecision && request.count == 0) {
    return agent.RunToPhase(agent.settings().stop_phase);
  }
  if (!request.until_goal_removed) return agent.Run(request.unit, request.count);

  if (!agent.goals().empty()) agent.SetGoalToWatch(agent.goals().bottom().id);
  const kernel::RunResult total = agent.Run(request.unit, request.count);
  agent.SetGoalToWatch({});
  return total;
}

}  // namespace

kernel::RunResult Host::Run(Session& session, const RunRequest& request) {
  if (!session.times().on()) return RunAlone(session.agent(), request);
  const RunTimes::Clock::time_point began = RunTimes::Clock::now();
  const kernel::RunResult result = RunAlone(session.agent(), request);
  session.times().AddRun(RunTimes::Clock::now() - began);
  return result;
}

void Host::Stop(Session& session, bool) {
  session.agent().RequestStop();
}

void Host::Reinitialize(Session& session) {
  session.agent().InitSoar();
}

bool Host::IsRunning(Session& session) const {
  return session.agent().running();
}

}  // namespace soarbox::cli
