// SPDX-License-Identifier: BSD-2-Clause
#pragma once

namespace soarbox::viewer {

/// What a step goes on by, as the toolbar calls it: "Tick", or "Turn" of a game whose turns have that many ticks. A
/// process has one window, and that shows one run at a time.
const char* StepWord();
void SetTurnTicks(int ticks);

}  // namespace soarbox::viewer
