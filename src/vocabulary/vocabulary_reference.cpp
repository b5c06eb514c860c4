// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>

#include "vocabulary/vocabulary.h"

// Generates pages of docs/ from the tables.
namespace soarbox::vocabulary {
namespace {

std::string Row(std::initializer_list<std::string_view> cells) {
  std::string line = "|";
  for (const std::string_view cell : cells) {
    line += ' ';
    line += cell;
    line += " |";
  }
  return line + "\n";
}

std::string Code(std::string_view text) {
  return "`" + std::string(text) + "`";
}

std::string WordList(std::string_view words) {
  std::string text;
  while (!words.empty()) {
    const std::size_t end = std::min(words.find(' '), words.size());
    if (!text.empty()) text += ", ";
    text += Code(words.substr(0, end));
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return text;
}

void AddParameter(std::string& text, const ParameterRow& row) {
  const std::string range = DescribeRange(row.unit, row.min, row.max, row.words);
  std::string what(NameOf(row.type));
  if (!range.empty()) what += " (" + range + ")";
  if (row.required) what += ", required";
  text += "* " + Code("^" + std::string(row.name)) + ": " + what + ". " + std::string(row.meaning) + ".\n";
}

}  // namespace

std::string PerceptReference() {
  std::string text =
      "# Percepts\n\n"
      "This page lists what a Soar agent perceives: attributes below `^io.input-link`. It is made from the table in\n"
      "`src/vocabulary/vocabulary_percepts.h`, which also drives the input link. Numbers are rounded to the step that "
      "the\n"
      "table gives. Only changes are written, so what stays the same costs nothing.\n\n"
      "You choose an agent's senses where you create the agent: `senses = { only = [\"self\", \"agents\"], sight = "
      "40 }`; see\n"
      "[scenarios](scenarios.md). A Lua body can add its own percepts with `Agent_Sense(agent)`: the table that it "
      "returns\n"
      "appears on the input link, with nested tables as identifiers.\n\n"
      "## Senses\n\n| sense | what it is about |\n| --- | --- |\n";
  for (const SenseRow& sense : Senses()) text += Row({Code(sense.name), sense.meaning});
  for (const SenseRow& sense : Senses()) {
    text += "\n## " + std::string(sense.name) + "\n\n| attribute | value | meaning |\n| --- | --- | --- |\n";
    for (const PerceptRow& row : Percepts()) {
      if (row.sense != sense.name) continue;
      std::string value(NameOf(row.type));
      const std::string range = DescribeRange(row.unit, row.min, row.max, row.words);
      if (!range.empty()) value += "; " + range;
      text += Row({Code("^" + std::string(row.path)), value, row.meaning});
    }
  }
  return text;
}

std::string CommandReference() {
  std::string text =
      "# Commands\n\n"
      "What a Soar agent can do: identifiers directly below `^io.output-link`, with their parameters below them. This "
      "page is\n"
      "made from the table in `src/vocabulary/vocabulary_commands.cpp`. The output link is checked against the same "
      "table.\n\n"
      "```\nsp {scout*apply*move-to\n   (state <s> ^operator <o> ^io.output-link <out>)\n"
      "   (<o> ^name move-to ^waypoint <name>)\n-->\n   (<out> ^move-to <command>)\n   (<command> ^waypoint "
      "<name>)\n}\n```\n\n"
      "A command is carried out once. The world answers below it:\n\n"
      "* `^status complete`: it is done;\n"
      "* `^status error` with a `^reason` (see below), and `^parameter` if one is wrong;\n"
      "* `^status interrupted`: another command needed the same part of the body;\n"
      "* `^progress`: how much of a lasting command is done, from 0 to 1 in steps of 0.1.\n\n"
      "If your rules remove a command from the output link before it has ended, the body stops carrying it out. "
      "Commands for\n"
      "different parts of the body run at the same time.\n\n"
      "Name a place with one of these parameters:\n\n";
  for (const ParameterRow& row : PlaceParameters()) AddParameter(text, row);
  text += "\n| command | part | |\n| --- | --- | --- |\n";
  for (const CommandRow& row : Commands()) text += Row({Code(row.name), NameOf(row.part), row.meaning});
  for (const CommandRow& row : Commands()) {
    text += "\n## " + std::string(row.name) + "\n\n" + std::string(row.meaning) +
            ". Complete when: " + std::string(row.ends) + ".\n";
    if (row.place != TakesPlace::kNo || !row.parameters.empty()) text += "\n";
    if (row.place == TakesPlace::kRequired) text += "* a place.\n";
    if (row.place == TakesPlace::kOptional) text += "* a place (optional).\n";
    for (const ParameterRow& parameter : row.parameters) AddParameter(text, parameter);
    if (!row.reasons.empty()) text += "\nMay fail with " + WordList(row.reasons) + ".\n";
  }
  text += "\n## Reasons\n\n| `^reason` | meaning |\n| --- | --- |\n";
  for (const ReasonRow& row : Reasons()) text += Row({Code(row.name), row.meaning});
  return text;
}

}  // namespace soarbox::vocabulary
