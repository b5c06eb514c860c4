// SPDX-License-Identifier: BSD-2-Clause
// Messages: what agents said to each other, the newest first.
#include <utility>

#include "workbench/document/build.h"
#include "workbench/document/panels.h"

namespace soarbox::workbench::document {

Nodes MessagesDocument(const Contents& contents) {
  constexpr std::size_t kMost = 500;
  constexpr std::uint32_t kAll = 1, kOfSelected = 2;
  if (contents.messages == nullptr || contents.messages->rows().empty())
    return {Empty("No agent has sent a message yet.",
                  "An agent speaks when its rules give the command broadcast or send (docs/commands.md).")};
  const auto& all = contents.messages->rows();
  Table table;
  table.key = "messages";
  table.columns = {{"Time"}, {"From"}, {"To"}, {"About", false, true}, {"Message", false, false, true}};
  table.filter = "Search";
  table.none_fits = {"No message is like this.", ""};
  if (!contents.agent.empty()) table.groups = {"all", "selected agent"};
  if (all.size() > kMost) table.caption = "The newest " + std::to_string(kMost) + " of " + std::to_string(all.size());
  std::string team;
  for (const debugger::AgentRow& agent : contents.agents)
    if (agent.name == contents.agent && !agent.team.empty()) team = "team " + agent.team;
  for (std::size_t i = all.size(); i > 0 && table.rows.size() < kMost; --i) {
    const debugger::MessageRow& message = all[i - 1];
    TableRow row;
    row.key = std::to_string(i);
    const bool is_of_selected =
        message.from == contents.agent || message.to == contents.agent || (!team.empty() && message.to == team);
    row.groups = kAll | (is_of_selected ? kOfSelected : 0u);
    row.cells = {TimeCell(message.tick),
                 {{message.from.empty() ? Span{"you"} : AgentLink(message.from)}},
                 TextCell(message.to),
                 TextCell(message.about),
                 TextCell(message.text)};
    table.rows.push_back(std::move(row));
  }
  return {std::move(table)};
}

}  // namespace soarbox::workbench::document
