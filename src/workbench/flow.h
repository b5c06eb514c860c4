// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

namespace soarbox::workbench {

/// What a user can do to the flow of time.
enum class Flow : std::uint8_t {
  kTogglePause,
  kStepTick,      ///< Pauses and goes on by one tick.
  kStepDecision,  ///< Pauses; goes on by a tick in which the selected agent makes one decision.
  kStepPhase,     ///< Pauses; the selected agent's mind alone goes on by a phase, its world stands still.
  kStepChange,    ///< Goes on until the selected agent's operator, goal stack or command changes, and pauses.
  kFaster,
  kSlower,
  kNormalSpeed,
  kUnlimited,  ///< As fast as it goes; again: back to the speed before.
  kReset,      ///< From the beginning with the same seed.
  kNextSeed,   ///< From the beginning with the next seed.
  kQuit,
  kStepTurn,  ///< Pauses and goes on to the end of a turn of the game; by one tick where there are no turns.
};

}  // namespace soarbox::workbench
