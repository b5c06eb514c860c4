// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include "cli/command.h"
#include "cli/help.h"
#include "cli/interpreter.h"
#include "kernel/agent.h"

namespace soarbox::cli {
namespace {

void List(CommandCall& call) {
  std::string text = fmt::format("Soar {} Command List:\n\n", TextOf(call.agent().settings().like));
  for (const CommandInfo& command : Commands()) {
    if (command.name == "learn") continue;
    text += fmt::format("{}\n", command.name);
    if (command.name == "explain") text += "file-system\n";
  }
  text +=
      "\nTo read about a command:                          help <command>\n"
      "For an overview of its sub-commands and settings:  <command> ?\n\n"
      "Former commands are sub-commands now: 'help <former name>' finds them.";
  call.Out(text);
}

}  // namespace

bool ShowHelp(CommandCall& call, std::string_view name) {
  std::string error;
  const CommandInfo* command = FindCommand(name, error);
  if (!command) {
    call.Out("No such command '" + std::string(name) + "'.\n");
    return call.FailPrinted();
  }
  call.Out(HelpText(*command, call.interpreter.aliases()));
  return true;
}

bool CommandHelp(CommandCall& call) {
  if (call.words.size() < 2) {
    List(call);
    return true;
  }
  std::string word = call.words[1].text;
  if (word == "file-system") {
    call.Out(
        "cd, dirs, ls, popd, pushd and pwd move between directories, as in a shell.\n"
        "File names in other commands start from the current directory.\n");
    return true;
  }
  // An alias is described together with its command.
  const std::string expansion = call.interpreter.aliases().Expansion(word);
  if (!expansion.empty()) {
    call.Out(fmt::format("{} = \"{}\"\n\n", word, expansion));
    word = expansion.substr(0, expansion.find(' '));
  }
  return ShowHelp(call, word);
}

}  // namespace soarbox::cli
