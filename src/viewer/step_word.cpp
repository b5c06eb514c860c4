// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/step_word.h"

namespace soarbox::viewer {
namespace {

int turn_ticks = 1;  ///< Of the run that the window shows.

}  // namespace

const char* StepWord() {
  return turn_ticks > 1 ? "Turn" : "Tick";
}

void SetTurnTicks(int ticks) {
  turn_ticks = ticks;
}

}  // namespace soarbox::viewer
