// SPDX-License-Identifier: BSD-2-Clause
#include "sim/run_event.h"

namespace soarbox::sim {

std::string_view EventName(EventKind kind) {
  switch (kind) {
    case EventKind::kAgentCreated:
      return "agent";
    case EventKind::kCommand:
      return "command";
    case EventKind::kOutcome:
      return "outcome";
    case EventKind::kNews:
      return "news";
    case EventKind::kEnded:
      return "reached";
    case EventKind::kGap:
      return "gap";
    case EventKind::kLog:
      return "log";
    case EventKind::kDiagnostic:
      return "diagnostic";
    case EventKind::kAgentFailed:
    case EventKind::kMindFailed:
      return "failed";
    case EventKind::kMindLost:
      return "lost";
    case EventKind::kMindBack:
      return "back";
    case EventKind::kAnswer:
      return "answer";
  }
  return "unknown";
}

}  // namespace soarbox::sim
