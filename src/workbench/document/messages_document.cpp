// SPDX-License-Identifier: BSD-2-Clause
// Messages: what agents said to each other, the newest first.
#include <utility>

#include "workbench/document/build.h"
#include "workbench/document/panels.h"

namespace soarbox::workbench::document {

Nodes MessagesDocument(const Contents& contents) {
  constexpr std::size_t kMost = 500;
  constexpr std::uint32_t kAll = 1, kOfSelected = 2;
  Table table{"messages", {{"Time"}, {"From"}, {"To"}, {"About", false, true}, {"Message", false, false, true}}};
  table.filter = "Search";
  table.none_fits = {"No message is like this.", ""};
  if (!contents.agent.empty()) table.groups = {"all", "selected agent"};
  const std::size_t count = contents.messages == nullptr ? 0 : contents.messages->rows().size();
  if (count > kMost) table.caption = "The newest " + std::to_string(kMost) + " of " + std::to_string(count);
  std::string team;
  for (const debugger::AgentRow& agent : contents.agents)
    if (agent.name == contents.agent && !agent.team.empty()) team = "team " + agent.team;
  for (std::size_t i = count; i > 0 && table.rows.size() < kMost; --i) {
    const debugger::MessageRow& message = contents.messages->rows()[i - 1];
    const bool is_of_selected =
        message.from == contents.agent || message.to == contents.agent || (!team.empty() && message.to == team);
    table
        .Add(std::to_string(i), {TimeCell(message.tick),
                                 {{message.from.empty() ? Span{"you"} : AgentLink(message.from)}},
                                 TextCell(message.to),
                                 TextCell(message.about),
                                 TextCell(message.text)})
        .groups = kAll | (is_of_selected ? kOfSelected : 0u);
  }
  return {OrEmpty(std::move(table), "No agent has sent a message yet.",
                  "An agent speaks when its rules give the command broadcast or say (docs/commands.md).")};
}

}  // namespace soarbox::workbench::document
