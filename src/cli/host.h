// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

#include "kernel/agent.h"

namespace soarbox::cli {

class Session;

/// `run` with its options parsed.
struct RunRequest {
  kernel::RunUnit unit = kernel::RunUnit::kForever;
  std::uint64_t count = 1;
  kernel::RunUnit interleave = kernel::RunUnit::kPhase;
  bool interleave_given = false;  ///< Otherwise the host chooses: the run's unit, or phases for a run without end.
  bool self_only = false;         ///< Only the agent that the command is addressed to.
  bool until_goal_removed = false;
  bool update_world = true;  ///< Ask the environment to advance.
};

/// Owns the agents and runs them: the command line asks, the host acts. The default host serves one agent without an
/// environment; a kernel with many agents brings its own.
class Host {
 public:
  virtual ~Host() = default;

  /// Runs the agents and returns when they have stopped. `result` is that of the addressed agent.
  virtual kernel::RunResult Run(Session& session, const RunRequest& request);
  /// Asks running agents to stop at the next step.
  virtual void Stop(Session& session, bool self_only);
  /// init-soar with everything that belongs to it (input is sent again).
  virtual void Reinitialize(Session& session);
  /// True while Run is active: commands that change the agent are then refused.
  virtual bool IsRunning(Session& session) const;
  /// The port that the kernel listens on, 0 for none.
  virtual int Port() const { return 0; }
};

}  // namespace soarbox::cli
