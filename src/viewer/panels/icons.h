// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

namespace soarbox::viewer {

enum class Icon {
  kPlay,
  kPause,
  kStepTick,
  kStepDecision,
  kStepPhase,
  kReset,
  kNextSeed,
  kStepBack,
  kToBegin,
  kToEnd,
  kBranch,
};

/// A button with an icon, a word after it (may be empty), and a tooltip. Returns true when it is clicked.
bool IconButton(Icon icon, const char* id, std::string_view word, std::string_view tooltip, bool enabled = true,
                bool lit = false);

}  // namespace soarbox::viewer
