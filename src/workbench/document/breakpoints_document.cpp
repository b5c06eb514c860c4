// SPDX-License-Identifier: BSD-2-Clause
// Breakpoints: when the world stops.
#include <utility>

#include "workbench/document/build.h"
#include "workbench/document/panels.h"

namespace soarbox::workbench::document {
namespace {

Form NewBreakpoint(const Contents& contents) {
  Form form{"new", {BreakRequest{}}, {}, "Add"};
  form.clears = true;
  Field kind{Field::Kind::kChoice, "kind", "What to wait for"};
  for (const debugger::BreakKindWords& each : debugger::kBreakKinds) kind.options.emplace_back(each.name, each.title);
  form.fields.push_back(std::move(kind));
  if (!contents.agent.empty()) {
    Field agent{Field::Kind::kCheck, "agent", "in " + contents.agent + " only"};
    agent.options = {{"", ""}, {contents.agent, contents.agent}};
    form.fields.push_back(std::move(agent));
  }
  form.fields.push_back(
      {Field::Kind::kLine, "what",
       "A rule, ID ^attribute value, ^attribute < number, an operator, an impasse, a command, a check or seconds; "
       "* stands for any text",
       "the rule's name, ^health < 20, ..."});
  return form;
}

}  // namespace

Nodes BreakpointsDocument(const Contents& contents) {
  Nodes nodes;
  for (const debugger::BreakHit& hit : contents.hits)
    nodes.push_back(Text(Spans{{"stopped", Role::kTag}, {" "}, Time(hit.tick), {" " + hit.why, Role::kWarn}}));
  if (contents.moment.is_recording) {
    nodes.push_back(Empty("Breakpoints stop a run, not a recording.", "Search its trace or click in its timeline."));
    return nodes;
  }
  nodes.push_back(Heading("Stop the world when"));
  nodes.push_back(NewBreakpoint(contents));
  using What = ChangeBreakRequest::What;
  Table table{"breakpoints", {{"On"}, {"When", false, false, true}, {"Hits", true}, {""}}};
  for (const debugger::Breakpoint& point : contents.breakpoints) {
    const std::string what = point.what.empty() ? "" : ": " + point.what;
    table.Add(std::to_string(point.number),
              {ButtonCell(point.enabled ? "on" : "off",
                          ChangeBreakRequest{point.number, point.enabled ? What::kDisable : What::kEnable},
                          point.enabled ? "Switch it off" : "Switch it on"),
               TextCell((point.agent.empty() ? "any agent" : point.agent) + ": " +
                            std::string(debugger::kBreakKinds[static_cast<std::size_t>(point.kind)].title) + what,
                        point.enabled ? Role::kPlain : Role::kQuiet),
               CountCell(point.hits), ButtonCell(kRemove, ChangeBreakRequest{point.number, What::kClear}, "Remove")});
  }
  nodes.push_back(OrEmpty(std::move(table), "No breakpoints.",
                          "The world pauses at the end of the tick in which what you wait for happens."));
  return nodes;
}

}  // namespace soarbox::workbench::document
