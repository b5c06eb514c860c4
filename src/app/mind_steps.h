// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>

#include "app/run_session.h"

namespace soarbox::app {

/// How far a mind goes in one step. Steps are inputs of the run, so that a recording repeats them.
enum class MindStep : std::uint8_t {
  kDecision,  ///< A tick in which the agent decides once: it perceives what is new, and the world goes on with what it
              ///< said.
  kPhase,     ///< A phase of its decision cycle, between two ticks.
};

/// Lets this agent's mind take a step, and says what it did or why it cannot. `has_ticked`: the world went on.
struct MindStepped {
  std::string told;
  bool has_ticked = false;
};
MindStepped StepMind(RunSession& session, const std::string& agent, MindStep step);

}  // namespace soarbox::app
