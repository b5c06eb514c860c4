// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include "cli/command.h"
#include "cli/interpreter.h"

namespace soarbox::cli {
namespace {

void List(CommandCall& call) {
  const std::string rule(43, '=');
  std::string text = rule + "\n               Soar Aliases                \n" + rule + "\n";
  for (const char* heading : {rule.c_str(), "               Soar Aliases                ", rule.c_str()}) {
    call.AddArgument("value", "string", heading);
  }
  for (const auto& [name, expansion] : call.interpreter.aliases().All()) {
    text += fmt::format("{:<42}= {}\n", name, expansion);
    call.AddArgument("alias", "string", name);
    call.AddArgument("aliasedcommand", "string", expansion);
  }
  call.Out(text);
}

}  // namespace

bool CommandAlias(CommandCall& call) {
  AliasTable& aliases = call.interpreter.aliases();
  std::span<const Word> words = call.words.subspan(1);
  const bool remove = !words.empty() && (words.front().text == "-r" || words.front().text == "--remove");
  if (remove) words = words.subspan(1);
  if (words.empty()) {
    List(call);
    return true;
  }
  const std::string& name = words.front().text;
  if (remove) {
    if (words.size() > 1) return call.Fail("If your alias has -r or --remove, enclose in quotes.");
    aliases.Remove(name);
    return true;
  }
  if (words.size() == 1) {
    const std::string expansion = aliases.Expansion(name);
    if (!expansion.empty()) {
      call.Out(fmt::format("{} = \"{}\"\n", name, expansion));
      call.AddArgument("alias", "string", name);
      call.AddArgument("aliasedcommand", "string", expansion);
    }
    return true;
  }
  std::vector<std::string> expansion;
  for (const Word& word : words.subspan(1)) expansion.push_back(word.text);
  aliases.Define(name, std::move(expansion));
  return true;
}

}  // namespace soarbox::cli
