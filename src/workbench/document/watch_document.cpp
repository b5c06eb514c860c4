// SPDX-License-Identifier: BSD-2-Clause
// Watch: values and commands that are evaluated after each decision, with a row for each and a column for each agent.
#include <utility>

#include "workbench/document/build.h"
#include "workbench/document/panels.h"

namespace soarbox::workbench::document {

Nodes WatchDocument(const Contents& contents) {
  Form form = LineForm(
      "watch", WatchRequest{},
      {Field::Kind::kLine, "what",
       "A path is followed from the top state: io.input-link.self.health; <s> is the lowest state, <o> its operator",
       "Watch: a path, or print s1 -d 2"},
      "Watch");
  form.clears = form.repeats = true;
  Nodes nodes{std::move(form)};
  if (!contents.watch_fault.empty()) nodes.push_back(Text(contents.watch_fault, Role::kBad));
  nodes.push_back(BesideLine(contents));
  Table table{"watches", {{"Watch", false, false, true}}};
  for (const std::string& agent : contents.beside) table.columns.push_back({agent, false, false, true});
  if (contents.beside.empty()) table.columns.push_back({"", false, false, true});
  for (const WatchRow& watch : contents.watches) {
    TableRow& row = table.Add(watch.what, {ButtonCell(kRemove, WatchRequest{watch.what, false}, "No longer watch it")});
    row.cells[0].spans.push_back({" " + watch.what, Role::kName});
    for (const WatchRow::Cell& cell : watch.cells) {
      const Role role = cell.text.empty() ? Role::kQuiet
                        : cell.is_error   ? Role::kBad
                        : cell.is_new     ? Role::kWarn
                                          : Role::kCode;
      row.cells.push_back(TextCell(cell.text.empty() ? "nothing" : cell.text, role));
      if (cell.tick > 0)
        row.cells.back().spans[0].hint =
            "So since " + ClockText(static_cast<double>(cell.tick) * contents.moment.step_s);
    }
  }
  nodes.push_back(OrEmpty(std::move(table), "Nothing is watched yet.",
                          "Type a path above (io.input-link.self.health, <s>.operator.name) or a command that prints "
                          "(print s1 -d 2, preferences, matches RULE). It is evaluated again at each decision."));
  return nodes;
}

}  // namespace soarbox::workbench::document
