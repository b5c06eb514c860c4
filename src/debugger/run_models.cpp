// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/run_models.h"

namespace soarbox::debugger {

void RunModels::Add(const record::TickRecord& tick) {
  troubles.Add(tick.events);
  timeline.Add(tick);
  messages.Add(tick);
  trace.Add(tick);
  plots.Add(tick);
  for (auto& [agent, log] : recalls) log.CutFrom(tick.tick);
  for (auto& [agent, log] : learning) log.CutFrom(tick.tick);
  for (const record::MindRecord& mind : tick.minds) {
    coverage[mind.agent].Add(tick.tick, mind);
    recalls[mind.agent].Add(tick.tick, mind);
    learning[mind.agent].Add(tick.tick, mind);
  }
}

}  // namespace soarbox::debugger
