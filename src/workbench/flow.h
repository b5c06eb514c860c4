// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

namespace soarbox::workbench {

/// Commands of the user that control the run.
enum class Flow : std::uint8_t {
  kTogglePause,
  kStepTick,      ///< Pauses after one more tick.
  kStepDecision,  ///< Pauses after a tick in which the selected agent makes one decision.
  kStepPhase,     ///< Pauses the world; only the selected agent's mind advances, by one phase.
  kStepChange,    ///< Runs until the selected agent's operator, goal stack or command changes, then pauses.
  kFaster,
  kSlower,
  kNormalSpeed,
  kUnlimited,  ///< Runs as fast as possible; a second time: returns to the previous speed.
  kReset,      ///< Restarts with the same seed.
  kNextSeed,   ///< Restarts with the next seed.
  kQuit,
  kStepTurn,  ///< Pauses at the end of the game's turn; after one tick in a world without turns.
};

/// Whether the command lets the world or a mind advance by a step.
inline constexpr bool IsStep(Flow flow) {
  return flow == Flow::kStepTick || flow == Flow::kStepTurn || flow == Flow::kStepDecision ||
         flow == Flow::kStepPhase || flow == Flow::kStepChange;
}

}  // namespace soarbox::workbench
