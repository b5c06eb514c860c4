// SPDX-License-Identifier: BSD-2-Clause
#include "script_runner.h"

#include <cmath>
#include <string_view>

#include "kernel/io/output_link.h"

using namespace soarbox;

ScriptRunner::ScriptRunner(const AgentScript& script) : script_(script), agent_("soar"), session_(agent_) {
  session_.stream().SetSink([this](std::string_view text) { transcript_ += text; });
  if (!script.folder.empty()) interpreter_.ChangeDirectory(script.folder.string());
}

bool ScriptRunner::Step() {
  if (next_ == script_.lines.size()) {
    DescribeState();
    return false;
  }
  const std::string& line = script_.lines[next_++];
  transcript_ += "% " + line + "\n";
  if (line == "!tick") {
    Tick();
  } else {
    transcript_ += interpreter_.Execute(session_, line).text + "\n";
  }
  return true;
}

void ScriptRunner::Tick() {
  const double range = std::abs(20.5 - ticks_++ % 41);
  if (range_ == kernel::InputElement::kNone) {
    range_ = agent_.input().Add(kernel::InputObject::kInputLink, "range", range);
  } else {
    agent_.input().Update(range_, range);
  }
  agent_.Step(kernel::RunUnit::kOutput);
  for (const kernel::OutputChange& change : agent_.output().changes()) {
    transcript_ += change.added ? "+" : "-";
    transcript_ += std::to_string(change.timetag) + "\n";
  }
  for (const kernel::OutputCommand& command : agent_.output().new_commands()) {
    agent_.input().Add(agent_.input().ObjectFor(command.identifier), "status", std::string_view("complete"));
  }
}

void ScriptRunner::DescribeState() {
  for (const char* line : {"print --depth 30 --internal s1", "print --stack", "preferences", "production firing-counts",
                           "print --justifications --full"}) {
    transcript_ += interpreter_.Execute(session_, line).text + "\n";
  }
  const kernel::AgentCounters& counters = agent_.counters();
  for (const std::uint64_t count : {counters.decision_phases, counters.elaborations, counters.inner_elaborations,
                                    counters.firings, counters.wme_additions, counters.wme_removals,
                                    counters.wm_size_sum, counters.max_wme_changes, counters.max_firings}) {
    transcript_ += std::to_string(count) + " ";
  }
  // The next number of its random stream shows whether it drew the right amount of numbers.
  transcript_ += std::to_string(agent_.random().Next32()) + "\n" + agent_.CheckInvariants() + "\n";
}
