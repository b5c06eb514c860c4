// SPDX-License-Identifier: BSD-2-Clause
#include "cli/help.h"

#include <fmt/format.h>

namespace soarbox::cli {
namespace {

constexpr std::size_t kWidth = 79;

/// Wraps a paragraph.
std::string Wrap(std::string_view text, std::size_t indent) {
  std::string out, line(indent, ' ');
  std::size_t start = 0;
  while (start < text.size()) {
    std::size_t end = text.find(' ', start);
    if (end == std::string_view::npos) end = text.size();
    const std::string_view word = text.substr(start, end - start);
    if (line.size() > indent && line.size() + 1 + word.size() > kWidth) {
      out += line + "\n";
      line.assign(indent, ' ');
    }
    if (line.size() > indent) line += ' ';
    line += word;
    start = end + 1;
  }
  return out + line + "\n";
}

std::string Usage(const CommandInfo& command) {
  return std::string(command.name) + (command.usage.empty() ? "" : " ") + std::string(command.usage);
}

std::string OptionName(const OptionSpec& option) {
  std::string text = fmt::format("-{}, --{}", option.letter, option.name);
  if (option.argument == OptionArgument::kRequired) text += " X";
  if (option.argument == OptionArgument::kOptional) text += " [X]";
  return text;
}

void AppendOptions(std::string& text, std::span<const OptionSpec> options, std::string_view indent) {
  for (const OptionSpec& option : options) {
    if (!option.help.empty()) text += fmt::format("{}{:<26} {}\n", indent, OptionName(option), option.help);
  }
}

std::string_view FirstWord(std::string_view text) {
  return text.substr(0, text.find(' '));
}

}  // namespace

std::string HelpText(const CommandInfo& command, const AliasTable& aliases) {
  std::string text = fmt::format("{}\n\n  {}\n", Usage(command), command.summary);
  if (!command.details.empty()) text += "\n" + Wrap(command.details, 2);
  if (!command.options.empty()) {
    text += "\nOptions\n";
    AppendOptions(text, command.options, "  ");
  }
  if (!command.subcommands.empty()) {
    text += "\nSub-commands and settings\n";
    for (const SubcommandInfo& subcommand : command.subcommands) {
      if (subcommand.name == "?" || subcommand.name == "help") continue;
      text += fmt::format("  {:<28} {}\n", fmt::format("{} {}", subcommand.name, subcommand.usage), subcommand.summary);
      AppendOptions(text, subcommand.options, "      ");
    }
  }
  std::string known;
  for (const auto& [name, expansion] : aliases.All()) {
    if (FirstWord(expansion) == command.name) known += fmt::format("  {:<24} {}\n", name, expansion);
  }
  if (!known.empty()) text += "\nAliases\n" + known;
  return text;
}

std::string CommandReference() {
  std::string text =
      "# The Soar command language\n\nEvery command, with its options and sub-commands. A command or "
      "sub-command may be shortened to any unique beginning.\nThis page is made from the table that "
      "the command line itself works by (`help` shows the same).\n";
  for (const CommandInfo& command : Commands()) {
    text += fmt::format("\n## {}\n\n`{}`: {}.\n", command.name, Usage(command), command.summary);
    if (!command.details.empty()) text += fmt::format("\n{}\n", command.details);
    const auto options = [&](std::span<const OptionSpec> specs, std::string_view indent) {
      for (const OptionSpec& option : specs) {
        if (!option.help.empty()) text += fmt::format("{}* `{}`: {}\n", indent, OptionName(option), option.help);
      }
    };
    if (!command.options.empty()) text += "\n";
    options(command.options, "");
    if (!command.subcommands.empty()) text += "\n";
    for (const SubcommandInfo& subcommand : command.subcommands) {
      if (subcommand.name == "?" || subcommand.name == "help") continue;
      text += fmt::format("* `{} {}{}{}`: {}\n", command.name, subcommand.name, subcommand.usage.empty() ? "" : " ",
                          subcommand.usage, subcommand.summary);
      options(subcommand.options, "  ");
    }
  }
  return text;
}

}  // namespace soarbox::cli
