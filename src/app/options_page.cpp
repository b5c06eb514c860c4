// SPDX-License-Identifier: BSD-2-Clause
#include "app/options_page.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "app/argument_kinds.h"
#include "app/usage_text.h"

namespace soarbox::app {
namespace {

/// A text as a cell of a table.
std::string TableCell(std::string_view text) {
  std::string cell;
  for (const char c : text) {
    if (c == '|') cell += '\\';
    cell += c;
  }
  return cell;
}

/// "`--folder FOLDER`" of an option, "`SCENARIO`" of a positional argument.
std::string ShownName(const CLI::App& command, const CLI::Option& option) {
  const std::string value = TakesValue(option) ? NameOf(KindOf(command, option)) : "";
  if (option.get_positional()) return value + (MayRepeat(option) ? "..." : "");
  std::string names;
  for (const std::string& name : option.get_lnames()) names += (names.empty() ? "--" : ", --") + name;
  for (const std::string& name : option.get_snames()) names += (names.empty() ? "-" : ", -") + name;
  return names + (value.empty() ? "" : " " + value);
}

void AddCommandTo(std::string& page, const CLI::App& command) {
  const std::string name = command.get_name();
  page += "\n## soarbox " + name + "\n\n" + command.get_description() + ".\n\n";
  page += "<!-- not run: the form of the command -->\n\n    soarbox " + name + " [OPTION...]";
  const std::vector<const CLI::Option*> positionals = PositionalsOf(command);
  for (const CLI::Option* option : positionals) {
    const std::string word = ShownName(command, *option);
    page += option->get_required() ? " " + word : " [" + word + "]";
  }
  page += "\n";
  std::vector<const CLI::Option*> all = positionals;
  for (const CLI::Option* option : OptionsOf(command))
    if (option->get_lnames() != std::vector<std::string>{"help"}) all.push_back(option);
  if (!all.empty()) page += "\n| argument | default | |\n| --- | --- | --- |\n";
  for (const CLI::Option* option : all) {
    const std::string value = option->get_default_str();
    page += "| `" + TableCell(ShownName(command, *option)) + "` | " +
            (value.empty() ? "" : "`" + TableCell(value) + "`") + " | " + TableCell(option->get_description()) + " |\n";
  }
  const std::vector<UsageExample> examples = ExamplesOf(name);
  if (!examples.empty()) page += "\n| example | |\n| --- | --- |\n";
  for (const auto& [line, about] : examples) page += "| `" + TableCell(line) + "` | " + TableCell(about) + " |\n";
  page += "\nExit code: ";
  std::string codes;
  for (const auto& [code, meaning] : ExitStatusesOf(name))
    codes += (codes.empty() ? "" : "; ") + std::string(code) + ": " + std::string(meaning);
  page += codes + ".\n";
}

}  // namespace

std::string OptionsPage(const CLI::App& program) {
  std::string page =
      "# Options of each command\n\n<!-- Made by `soarbox help --markdown`, from the same tables as the help and the "
      "manual pages. Change those. -->\n\nAll sub-commands of `soarbox` with their arguments, examples and exit codes, "
      "as `soarbox COMMAND --help` and the manual pages print them. What the commands are for and what they print: "
      "[the soarbox command](command.md).\n\n| command | |\n| --- | --- |\n";
  const std::vector<const CLI::App*> commands = ListedCommands(program);
  for (const CLI::App* command : commands)
    page += "| [" + command->get_name() + "](#soarbox-" + command->get_name() + ") | " +
            TableCell(command->get_description()) + " |\n";
  for (const CLI::App* command : commands) AddCommandTo(page, *command);
  return page;
}

}  // namespace soarbox::app
