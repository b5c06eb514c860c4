// SPDX-License-Identifier: BSD-2-Clause
#include "workbench/console_desk.h"

#include <utility>

namespace soarbox::workbench {

void ConsoleDesk::Bring(Belongings belongings) {
  consoles_ = std::move(belongings.consoles);
  counts_ = std::move(belongings.counts);
  for (auto& [agent, count] : counts_) ++count;
}

void ConsoleDesk::Type(const ConsoleRequest& request) {
  sim::Simulation* const world = common_.Looked();
  ++counts_[request.agent];
  unsent_[request.agent] = {{}, true};
  if (world == nullptr) return ConsoleOf(request.agent).Refuse(request.line, common_.past.rebuilt().Note());
  ConsoleOf(request.agent).Run(*world, request.line);
  if (common_.run == nullptr) common_.past.rebuilt().Spoil();
}

void ConsoleDesk::Complete(const CompleteRequest& request) {
  completed_line_ = request.line;
  completion_ = {};
  sim::Simulation* const world = common_.Looked();
  if (world == nullptr) return;
  if (const auto mind = world->Inspect(request.agent)) completion_ = debugger::Complete(*mind, request.line);
}

void ConsoleDesk::Add(const sim::EventList& events) {
  for (auto& [agent, console] : consoles_) {
    const std::size_t before = console.lines().size();
    console.Add(events);
    if (console.lines().size() != before) ++counts_[agent];
  }
}

void ConsoleDesk::KeepDrafts() {
  for (auto& [agent, line] : unsent_) {
    if (!std::exchange(line.has_draft, false)) continue;
    if (line.text.find_first_not_of(" \t") == std::string::npos) {
      drafts_.Drop(PlaceOfLine(agent));
    } else if (const Result<void> kept = drafts_.Keep(PlaceOfLine(agent), line.text); !kept) {
      common_.note_problem(kept.error(), {});
    }
  }
}

const std::string& ConsoleDesk::BegunLine(const std::string& agent) {
  const auto [line, is_new] = unsent_.try_emplace(agent);
  if (is_new && !agent.empty()) line->second.text = drafts_.Find(PlaceOfLine(agent)).value_or("");
  return line->second.text;
}

void ConsoleDesk::Fill(Contents& contents) {
  contents.console = contents.agent.empty() ? nullptr : &ConsoleOf(contents.agent);
  contents.console_lines = counts_[contents.agent];
  contents.completion = completion_;
  contents.completed_line = completed_line_;
  contents.begun_line = BegunLine(contents.agent);
}

}  // namespace soarbox::workbench
