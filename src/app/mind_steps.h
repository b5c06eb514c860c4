// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>

#include "app/run_session.h"

namespace soarbox::app {

/// The length of a step of a mind. Steps are inputs of the run, so that a recording repeats them.
enum class MindStep : std::uint8_t {
  kDecision,  ///< A tick in which the agent decides once: it gets its new percepts, and the world executes its
              ///< commands.
  kPhase,     ///< A phase of its decision cycle, between two ticks.
};

struct MindStepped {
  std::string told;         ///< A sentence about the step, or why it was not possible.
  bool has_ticked = false;  ///< The world has advanced.
};
/// Executes a step of this agent's mind.
MindStepped StepMind(RunSession& session, const std::string& agent, MindStep step);

}  // namespace soarbox::app
