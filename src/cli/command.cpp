// SPDX-License-Identifier: BSD-2-Clause
#include "cli/command.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/interpreter.h"

namespace soarbox::cli {

kernel::Agent& CommandCall::agent() const {
  return session.agent();
}

PrintStream& CommandCall::stream() const {
  return session.stream();
}

bool CommandCall::Fail(std::string_view message) {
  Out(message);
  failure = Failure::kWithMessage;
  Diagnostic diagnostic;
  if (!words.empty()) {
    diagnostic.line = words.front().line;
    diagnostic.column = words.front().column;
  }
  diagnostic.message = std::string(message.substr(0, message.find('\n')));
  result.diagnostics.push_back(std::move(diagnostic));
  return false;
}

bool CommandCall::FailPrinted() {
  failure = Failure::kWithoutMessage;
  return false;
}

void CommandCall::Hint(std::string message, std::string hint) {
  Diagnostic diagnostic;
  diagnostic.severity = Severity::kNote;
  diagnostic.message = std::move(message);
  diagnostic.hint = std::move(hint);
  result.diagnostics.push_back(std::move(diagnostic));
}

void CommandCall::AddArgument(std::string param, std::string type, std::string value) {
  result.structured.AddArgument(std::move(param), std::move(type), std::move(value));
}

bool CommandCall::Parse(std::span<const OptionSpec> specs, ParsedWords& parsed) {
  parsed = ParseOptions(words.subspan(1), specs, agent().settings().like != kernel::SoarVersion::k963);
  if (parsed.error.empty()) return true;
  return Fail(parsed.error);
}

bool RunSubcommand(CommandCall& call, const SubcommandTexts& texts) {
  std::string error;
  const CommandInfo& command = *FindCommand(call.words[0].text, error);
  const std::string invalid =
      !texts.invalid.empty()
          ? texts.invalid
          : fmt::format("Invalid {0} command.  Use '{0} ?' to see a list of valid settings.", command.name);
  const std::string usage_hint =
      !texts.usage_hint.empty()
          ? texts.usage_hint
          : fmt::format("Use '{0} ?' or 'help {0}' to learn more about the {0} command.", command.name);
  // Like Soar, first check the options against those of all sub-commands. The options of the named sub-command come
  // first in the list: if another one uses the same letter in another way, they count.
  std::vector<OptionSpec> all;
  for (const SubcommandInfo& subcommand : command.subcommands) {
    if (subcommand.name == call.words[1].text) all.assign(subcommand.options.begin(), subcommand.options.end());
  }
  for (const SubcommandInfo& subcommand : command.subcommands) {
    for (const OptionSpec& option : subcommand.options) {
      bool known = false;
      for (const OptionSpec& other : all) known = known || (other.letter == option.letter && other.name == option.name);
      if (!known) all.push_back(option);
    }
  }
  for (const char letter : texts.also_known) all.push_back({letter, ""});
  const ParsedWords checked =
      ParseOptions(call.words.subspan(1), all, call.agent().settings().like != kernel::SoarVersion::k963);
  if (!checked.error.empty()) {
    return call.Fail(checked.error + "\n" + usage_hint);
  }

  const std::string& word = call.words[1].text;
  std::vector<const SubcommandInfo*> found;
  for (const SubcommandInfo& subcommand : command.subcommands) {
    if (subcommand.name == word) {
      found = {&subcommand};
      break;
    }
    if (!word.empty() && subcommand.name.starts_with(word)) found.push_back(&subcommand);
  }
  if (found.size() > 1) {
    std::vector<std::string_view> names;
    for (const SubcommandInfo* subcommand : found) names.push_back(subcommand->name);
    return call.Fail(DidYouMean(std::move(names)) + invalid);
  }
  if (found.empty() && (word == "?" || word == "help"))
    return ShowHelp(call, command.name) && (!texts.fails_after_help || call.FailPrinted());
  if (found.empty()) {
    std::vector<std::string_view> names;
    for (const SubcommandInfo& subcommand : command.subcommands) names.push_back(subcommand.name);
    const std::string_view nearest = Suggest(word, names);
    if (!nearest.empty()) {
      call.Hint("'" + word + "' is not a sub-command of " + std::string(command.name),
                "did you mean '" + std::string(nearest) + "'?");
    }
    return call.Fail(invalid);
  }
  std::vector<Word> words(call.words.begin() + 1, call.words.end());
  words.front().text = found.front()->name;
  const std::span<const Word> outer = call.words;
  call.words = words;
  const bool ok = found.front()->handler(call);
  call.words = outer;
  return ok;
}

std::string DidYouMean(std::vector<std::string_view> names) {
  std::ranges::sort(names);
  std::string message = "%?  Did you mean ";
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) message += i + 1 == names.size() ? ", or " : " ";
    message += names[i];
  }
  return message + "?\n";
}

const CommandInfo* FindCommand(std::string_view word, std::string& error) {
  const auto exact = std::ranges::lower_bound(Commands(), word, {}, &CommandInfo::name);
  if (exact != Commands().end() && exact->name == word) return &*exact;
  std::vector<const CommandInfo*> found;
  for (const CommandInfo& command : Commands()) {
    if (!word.empty() && command.name.starts_with(word)) found.push_back(&command);
  }
  if (found.size() == 1) return found.front();
  if (found.empty()) {
    error = "No such command: " + std::string(word);
  } else {
    error = "Ambiguous command, possibilities: ";
    for (const CommandInfo* command : found) error += "'" + std::string(command->name) + "' ";
  }
  return nullptr;
}

std::string NearestCommand(std::string_view word, const std::vector<std::pair<std::string, std::string>>& aliases) {
  std::vector<std::string_view> names;
  for (const CommandInfo& command : Commands()) names.push_back(command.name);
  for (const auto& [name, expansion] : aliases) names.push_back(name);
  return std::string(Suggest(word, names));
}

}  // namespace soarbox::cli
