// SPDX-License-Identifier: BSD-2-Clause
#include "sim/run_event.h"

#include "diagnostics/name_table.h"

namespace soarbox::sim {

std::string_view EventName(EventKind kind) {
  static constexpr const char* kNames[] = {"agent",      "command", "outcome", "news", "reached", "gap",   "log",
                                           "diagnostic", "failed",  "failed",  "lost", "back",    "answer"};
  return NameIn(kNames, kind);
}

std::vector<std::string> Remarks(const RunEvent& event) {
  std::vector<std::string> remarks;
  for (const explain::Reason& reason : event.reasons) remarks.push_back(reason.text);
  if (const auto* check = std::get_if<CheckReport>(&event.values))
    remarks.insert(remarks.end(), {check->expected, check->was});
  std::erase(remarks, "");
  return remarks;
}

}  // namespace soarbox::sim
