// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/io_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "debugger/facts_text.h"

namespace soarbox::debugger {
namespace {

constexpr std::size_t kDepth = 6;

CommandRow CommandOf(const MemoryRow& row) {
  CommandRow command;
  command.name = row.element.attribute;
  command.timetag = row.element.timetag;
  command.status = "under way";
  if (!row.element.is_object) {
    command.parameters.push_back(row);
    return command;
  }
  command.id = row.element.value;
  for (const MemoryRow& below : row.below) {
    const explain::ElementFact& element = below.element;
    if (element.attribute == "status") {
      command.status = element.value;
    } else if (element.attribute == "progress") {
      command.progress = std::strtod(element.value.c_str(), nullptr);
    } else if (element.attribute == "reason" || element.attribute == "parameter") {
      command.reason += (command.reason.empty() ? "" : " ") + element.value;
    } else {
      command.parameters.push_back(below);
    }
  }
  return command;
}

}  // namespace

std::string ParameterText(const CommandRow& command) {
  std::string text;
  for (const MemoryRow& row : command.parameters) text += " ^" + row.element.attribute + " " + row.element.value;
  return text;
}

IoView LookAtIo(explain::Inspector& mind, const MemoryChanges& changes) {
  const explain::MindFacts facts = mind.Mind();
  IoView view;
  view.input = LookAtObject(mind, facts.input_link, changes, kDepth);
  view.output = LookAtObject(mind, facts.output_link, changes, kDepth);
  view.input.about = "input-link";
  view.output.about = "output-link";
  // The links exist even if they have no elements.
  if (!facts.input_link.empty()) view.input.exists = true, view.input.note.clear();
  if (!facts.output_link.empty()) view.output.exists = true, view.output.note.clear();
  for (const MemoryRow& row : view.output.rows)
    if (row.change != Change::kRemoved) view.commands.push_back(CommandOf(row));
  std::ranges::stable_sort(view.commands, std::ranges::greater(), &CommandRow::timetag);
  return view;
}

std::string ToText(const IoView& view) {
  std::string text = ToText(view.input);
  text += "commands\n";
  if (view.commands.empty()) text += "  none\n";
  for (const CommandRow& command : view.commands) {
    text += "  " + command.name + ParameterText(command) + ": " + command.status;
    if (!command.reason.empty()) text += " " + command.reason;
    if (command.progress >= 0 && command.status == "under way")
      text += fmt::format(", {:.0f} %", 100 * command.progress);
    text += "\n";
  }
  return text;
}

}  // namespace soarbox::debugger
