// SPDX-License-Identifier: BSD-2-Clause
#include "workbench/mind_change.h"

#include <memory>
#include <utility>

#include "explain/inspector.h"
#include "wording/mind_words.h"

namespace soarbox::workbench {

std::string LastCommand(const mind::EventLog& events) {
  std::string last;
  events.ForEach(mind::Cases{[&](const mind::CommandSaid& said) { last = wording::CommandText(said); },
                             [&](const mind::CommandEnded& ended) { last = wording::CommandText(ended); },
                             [](const auto&) {}});
  return last;
}

MindChange::Mind MindChange::Now(sim::Simulation* live, const std::string& agent, std::uint64_t tick) {
  Mind now{agent, {}, {}, tick};
  const std::unique_ptr<explain::Inspector> mind = live != nullptr ? live->Inspect(agent) : nullptr;
  if (mind == nullptr) return {};
  for (const explain::StateFact& state : mind->Stack()) {
    if (!state.operator_id.empty()) {
      now.operators += now.operators.empty() ? "" : ", ";
      now.operators +=
          state.operator_name.empty() ? state.operator_id : state.operator_name + " (" + state.operator_id + ")";
    }
    // An operator no-change is ignored: it is normal while a command takes time.
    if (state.level > 1 && !(state.attribute == "operator" && state.impasse == "no-change"))
      now.impasse += (now.impasse.empty() ? "" : ", ") + state.attribute + " " + state.impasse;
  }
  return now;
}

std::string MindChange::Await(sim::Simulation* live, const std::string& agent, std::uint64_t tick) {
  AwaitNothing();
  if (agent.empty()) return "Select the Soar agent whose mind is to change";
  before_ = Now(live, agent, tick);
  return before_.agent.empty() ? agent + " has no Soar mind that can be inspected" : std::string();
}

void MindChange::Look(sim::Simulation& live, const record::TickRecord& tick) {
  constexpr std::uint64_t kLongest_ticks = 3600;
  if (before_.agent.empty() || !change_.empty()) return;
  const Mind now = Now(&live, before_.agent, tick.tick);
  const record::MindRecord* mind = record::FindMind(tick, before_.agent);
  std::string change;
  if (now.agent.empty()) {
    change = "its mind has gone";
  } else if (now.impasse != before_.impasse) {
    change = now.impasse.empty() ? "out of the impasse " + before_.impasse : "impasse " + now.impasse;
  } else if (mind != nullptr && !LastCommand(mind->events).empty()) {
    change = "gave " + LastCommand(mind->events);
  } else if (now.operators != before_.operators) {
    change = now.operators.empty() ? "no operator is left" : "now " + now.operators;
  } else if (tick.tick > before_.tick + kLongest_ticks) {
    change = "nothing has changed for two minutes";
  }
  if (!change.empty()) change_ = before_.agent + ": " + change;
}

std::string MindChange::Take() {
  std::string change = std::exchange(change_, {});
  if (!change.empty()) AwaitNothing();
  return change;
}

}  // namespace soarbox::workbench
