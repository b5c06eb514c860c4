// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

#include "kernel/agent.h"

namespace soarbox::cli {

class Session;

/// A parsed `run` command.
struct RunRequest {
  kernel::RunUnit unit = kernel::RunUnit::kForever;
  std::uint64_t count = 1;
  kernel::RunUnit interleave = kernel::RunUnit::kPhase;
  bool interleave_given = false;  ///< If not, the host chooses: the unit of the run, or phases for a run without a
                                  ///< limit.
  bool self_only = false;         ///< Run only the agent of the session.
  bool until_goal_removed = false;
  bool update_world = true;  ///< Also advance the environment.
};

/// Owns the agents and runs them for the command line. The default host has one agent and no environment; a kernel with
/// several agents implements its own.
class Host {
 public:
  virtual ~Host() = default;

  /// Runs the agents and returns when they have stopped. The result is that of the session's agent.
  virtual kernel::RunResult Run(Session& session, const RunRequest& request);
  /// Requests running agents to stop at the next step.
  virtual void Stop(Session& session, bool self_only);
  /// Executes init-soar and sends input again.
  virtual void Reinitialize(Session& session);
  /// Whether Run is active. Commands that change the agent are then refused.
  virtual bool IsRunning(Session& session) const;
  /// The port that the kernel listens on; 0 if it does not listen.
  virtual int Port() const { return 0; }
};

}  // namespace soarbox::cli
