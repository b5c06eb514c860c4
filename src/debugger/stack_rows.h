// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <vector>

#include "explain/inspector.h"

namespace soarbox::debugger {

struct StackLevel {
  int level = 1;
  std::string state;                       ///< "S1"
  std::string impasse;                     ///< "operator tie"; empty for the top state.
  std::string operator_id, operator_name;  ///< Empty if none is selected.
};

/// The goal stack of a mind and its position in the decision cycle.
struct StackView {
  std::string note;   ///< If not empty: why something is missing.
  std::string phase;  ///< The phase that runs next: "input", "propose", "decide", "apply", "output"; empty if it is not
                      ///< known.
  bool within_phase = false;  ///< The phase has begun and not ended.
  bool halted = false;
  std::string breakdown;  ///< If the mind ran out of memory: what used it.
  std::uint64_t decisions = 0, elaborations = 0, firings = 0;
  std::size_t elements = 0, rules = 0;
  std::vector<StackLevel> levels;  ///< Top state first.
};

/// The phases of a decision cycle, in order.
const std::vector<std::string>& Phases();

StackView LookAtStack(explain::Inspector& mind);

std::string ToText(const StackView& view);

}  // namespace soarbox::debugger
