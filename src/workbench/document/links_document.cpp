// SPDX-License-Identifier: BSD-2-Clause
// Senses: the commands on the output link, and what the agent perceives on the input link.
#include <algorithm>
#include <utility>

#include "debugger/percept_help.h"
#include "workbench/document/build.h"
#include "workbench/document/element_spans.h"
#include "workbench/document/glossary.h"
#include "workbench/document/panels.h"

namespace soarbox::workbench::document {
namespace {

using debugger::CommandRow;
using debugger::MemoryRow;

constexpr std::size_t kDeepestPercept = 12;

Role RoleOfStatus(const std::string& status) {
  if (status == "error") return Role::kBad;
  if (status == "complete") return Role::kGood;
  return status == "interrupted" ? Role::kQuiet : Role::kWarn;
}

void AddCommand(const CommandRow& command, Table& table) {
  std::string parameters;
  for (const MemoryRow& row : command.parameters)
    parameters += (parameters.empty() ? "^" : "  ^") + row.element.attribute + " " + ShortNumber(row.element.value);
  Cell status = TextCell(command.status.empty() ? "under way" : command.status, RoleOfStatus(command.status));
  if (command.progress >= 0) {
    status.bar = command.progress;
    status.spans.push_back({" " + Rounded(command.progress * 100, 3) + " %"});
  }
  if (!command.reason.empty()) status.spans.push_back({" " + command.reason, Role::kBad});
  const Span name{command.name, Role::kNumber, AskWhy(WhyRequest::About::kCommand, command.name),
                  "Why does it give this command?"};
  table.Add(std::to_string(command.timetag), {{{name}}, TextCell(parameters, Role::kQuiet), std::move(status)});
}

/// Whether a removed element is replaced by an added one of the same attribute: its value has changed. It is then
/// omitted.
bool IsReplaced(const MemoryRow& row, const std::vector<MemoryRow>& beside) {
  return row.change == debugger::Change::kRemoved && !row.element.is_object &&
         std::ranges::any_of(beside, [&](const MemoryRow& other) {
           return other.change == debugger::Change::kAdded && other.element.attribute == row.element.attribute;
         });
}

TreeRow PerceptRow(const MemoryRow& element, const std::string& above, std::size_t depth, bool is_percept) {
  const std::string& attribute = element.element.attribute;
  const std::string path = above.empty() ? attribute : above + "." + attribute;
  std::string unit;
  if (const vocabulary::PerceptRow* known = is_percept ? debugger::PerceptOf(path) : nullptr; known != nullptr)
    unit = known->unit;
  TreeRow row;
  row.key = std::to_string(element.element.timetag);
  row.spans = ElementSpans(element, element.element.is_object ? std::string() : unit,
                           is_percept ? debugger::DescribePercept(path) : std::string());
  row.folds = !element.below.empty();
  row.is_open = true;
  if (depth < kDeepestPercept)
    for (const MemoryRow& below : element.below)
      if (!IsReplaced(below, element.below)) row.below.push_back(PerceptRow(below, path, depth + 1, is_percept));
  return row;
}

void AddLink(const char* key, const debugger::MemoryObject& object, bool is_percept, Nodes& nodes) {
  if (!object.note.empty()) nodes.push_back(Text(object.note, Role::kQuiet));
  Tree tree;
  tree.key = key;
  tree.label = is_percept ? "Percepts" : "Output link";
  tree.press = RowAction{{ElementRequest{}, PanelId::kMemory}, "timetag", 0, kElementHint};
  if (is_percept) tree.filter = "Filter by attribute or value";
  for (const MemoryRow& row : object.rows)
    if (!IsReplaced(row, object.rows)) tree.rows.push_back(PerceptRow(row, {}, 0, is_percept));
  nodes.push_back(std::move(tree));
}

}  // namespace

Nodes LinksDocument(const Contents& contents) {
  const debugger::IoView& io = contents.io;
  Nodes nodes;
  nodes.push_back(Heading("Commands (output link)", std::string(MeaningOf("output link"))));
  if (io.commands.empty()) {
    nodes.push_back(Text("There is no command on the output link. Rules give commands there.", Role::kQuiet));
  } else {
    Table table{"commands", {{"Command"}, {"Parameters", false, false, true}, {"Status", false, false, true}}};
    table.has_heads = false;
    for (const CommandRow& command : io.commands) AddCommand(command, table);
    nodes.push_back(std::move(table));
  }
  if (!io.output.rows.empty()) {
    Section output{"output", {{"Elements of the output link"}}, {}, false};
    AddLink("output", io.output, false, output.nodes);
    nodes.push_back(std::move(output));
  }
  nodes.push_back(Heading("Percepts (input link)", std::string(MeaningOf("input link"))));
  if (io.input.rows.empty() && io.input.note.empty()) nodes.push_back(Text("It perceives nothing.", Role::kQuiet));
  AddLink("percepts", io.input, true, nodes);
  return nodes;
}

}  // namespace soarbox::workbench::document
