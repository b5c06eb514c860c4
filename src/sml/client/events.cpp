// SPDX-License-Identifier: BSD-2-Clause
#include <array>
#include <cstring>

#include "sml/client/sml_Events.h"

namespace sml {

namespace {

/// Indexed by event number. The name of 38 (a rule is about to be removed) is that of Soar.
constexpr std::array<char const*, smlEVENT_LAST> kNames = {
    nullptr,
    "before-shutdown",
    "after-connection",
    "system-start",
    "before-agents-run-step",
    "system-stop",
    "interrupt-check",
    "system-property-changed",
    "before-smallest-step",
    "after-smallest-step",
    "before-elaboration-cycle",
    "after-elaboration-cycle",
    "before-phase-executed",
    "before-input-phase",
    "before-propose-phase",
    "before-decide-phase",
    "before-apply-phase",
    "before-output-phase",
    "before-preference-phase",
    "before-wm-phase",
    "after-input-phase",
    "after-propose-phase",
    "after-decide-phase",
    "after-apply-phase",
    "after-output-phase",
    "after-preference-phase",
    "after-wm-phase",
    "after-phase-executed",
    "before-decision-cycle",
    "after-decision-cycle",
    "memory-usage-exceeded",
    "after-interrupt",
    "after-halted",
    "before-run-starts",
    "after-run-ends",
    "before-running",
    "after-running",
    "after-production-added",
    "before-production-added",
    "after-production-fired",
    "before-production-retracted",
    "after-agent-created",
    "before-agent-destroyed",
    "before-agent-reinitialized",
    "after-agent-reinitialized",
    "output-phase",
    "echo",
    "print",
    "rhs-user-function",
    "filter",
    "client-message",
    "xml-trace-output",
    "xml-input-received",
    "after-all-output-phases",
    "after-all-generated-output",
    "tcl",
    "load-library",
};

}  // namespace

int Events::ConvertToEvent(char const* pStr) const {
  if (!pStr) return smlEVENT_INVALID_EVENT;
  for (std::size_t i = 1; i < kNames.size(); ++i) {
    if (std::strcmp(kNames[i], pStr) == 0) return static_cast<int>(i);
  }
  return smlEVENT_INVALID_EVENT;
}

char const* Events::ConvertToString(int id) const {
  return id > 0 && id < smlEVENT_LAST ? kNames[static_cast<std::size_t>(id)] : nullptr;
}

}  // namespace sml
