// SPDX-License-Identifier: BSD-2-Clause
#include "workbench/checks.h"

#include <algorithm>

namespace soarbox::workbench {

bool NoteCheck(const sim::RunEvent& event, std::vector<CheckRow>& checks) {
  // MissionWatch stores a check in the event's reasons: what is expected, the value found instead, the agent, and a
  // text that is not empty if the check is a marker.
  constexpr std::size_t kParts = 4;
  if (event.news != "check" || event.reasons.size() != kParts) return false;
  const auto known = std::ranges::find(checks, event.text, &CheckRow::name);
  CheckRow& row = known != checks.end() ? *known : checks.emplace_back();
  row = {event.text,
         event.reasons[0].text,
         event.reasons[1].text,
         event.reasons[2].text,
         !event.reasons[3].text.empty(),
         event.parameters,
         event.tick,
         event.time_s};
  return true;
}

}  // namespace soarbox::workbench
