// SPDX-License-Identifier: BSD-2-Clause
#include "app/usage_errors.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "app/argument_kinds.h"
#include "app/data_folders.h"
#include "diagnostics/problem.h"
#include "sim/scenario.h"

namespace soarbox::app {
namespace {

namespace fs = std::filesystem;

std::string Quoted(std::string_view word) {
  return "'" + std::string(word) + "'";
}

std::vector<std::string> OptionNamesOf(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

bool Holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string NearestOf(const std::string& word, const std::vector<std::string>& names) {
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  return std::string(Suggest(word, candidates));
}

/// An argument of `soarbox run`, given without the word run.
bool IsScenario(const std::string& word) {
  std::error_code error;
  const std::string extension = fs::path(word).extension().string();
  if (extension == ".soar" || extension == ".toml" || extension == ".lua") return true;
  if (fs::is_directory(word, error)) return true;
  const Result<sim::DataFolders> data = FindDataFolders();
  return data && Holds(sim::ListScenarios(data.value()), word);
}

/// An option before any sub-command, or without a sub-command.
Diagnostic StrayOption(const CLI::App& program, const std::string& option) {
  Diagnostic problem;
  problem.message = "soarbox has no option " + option;
  for (const CLI::App* command : SubCommands(program)) {
    if (!Holds(OptionNamesOf(*command), option)) continue;
    problem.hint = "write it after a sub-command: soarbox " + command->get_name() + " " + option;
    return problem;
  }
  std::string near = NearestOf(option, OptionNamesOf(program));
  for (const std::string& name : OptionNamesOf(program))
    if (option.size() == 2 && name.starts_with("-" + option)) near = name;
  problem.hint = near.empty() ? "soarbox --help lists the sub-commands" : "did you mean " + near + "?";
  return problem;
}

Diagnostic UnknownCommand(const CLI::App& program, const std::string& word) {
  if (word.starts_with('-')) return StrayOption(program, word.substr(0, word.find('=')));
  Diagnostic problem;
  problem.message = "soarbox has no sub-command " + Quoted(word);
  std::vector<std::string> names;
  for (const CLI::App* command : ListedCommands(program)) names.push_back(command->get_name());
  const std::string near = NearestOf(word, names);
  if (IsScenario(word)) {
    problem.hint = "did you mean soarbox run " + word + "?";
  } else if (!near.empty()) {
    problem.hint = "did you mean soarbox " + near + "?";
  } else {
    problem.hint = "there are:";
    for (const std::string& name : names) problem.hint += " " + name;
  }
  return problem;
}

Diagnostic UnknownArgument(const CLI::App& program, const CLI::App& command, const std::string& argument) {
  const std::string name = "soarbox " + command.get_name();
  Diagnostic problem;
  if (!argument.starts_with('-')) {
    problem.message = name + " takes no further argument " + Quoted(argument);
    problem.hint = name + " --help lists what it takes";
    if (const CLI::Option* view = command.get_option_no_throw("--view"); view != nullptr && view->count() > 0)
      problem.hint = "a view of two words is one argument: --view \"" + view->as<std::string>() + " " + argument + "\"";
    return problem;
  }
  const std::string option = argument.substr(0, argument.find('='));
  problem.message = name + " has no option " + option;
  if (option == "--rules" && (command.get_name() == "why" || command.get_name() == "inspect")) {
    problem.hint =
        "record a run with these rules, and ask about the recording: soarbox run SCENARIO --rules "
        "AGENT=FILE --record run.soarrec; " +
        name + " run.soarrec";
    return problem;
  }
  if (option == "--rules" && command.get_name() == "check") {
    problem.hint = "name the file of rules itself: soarbox check FILE";
    return problem;
  }
  const std::vector<std::string> mine = OptionNamesOf(command);
  if (const std::string near = NearestOf(option, mine); !near.empty()) {
    problem.hint = "did you mean " + near + "?";
    return problem;
  }
  problem.hint = name + " --help lists its options";
  for (const CLI::App* other : SubCommands(program))
    if (Holds(OptionNamesOf(*other), option))
      problem.hint = "soarbox " + other->get_name() + " has it; " + problem.hint;
  return problem;
}

/// The library's sentences about values, without its line of advice.
std::string FirstLine(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

/// The option with which a sentence of the library begins: "--seconds: ...", "files is required".
const CLI::Option* OptionNamed(const CLI::App& command, const std::string& sentence) {
  const std::string name = sentence.substr(0, sentence.find_first_of(": "));
  for (const CLI::Option* option : command.get_options())
    if (option->get_name() == name) return option;
  return nullptr;
}

/// A missing or invalid value.
Diagnostic BadValue(const CLI::App& command, const CLI::ParseError& error) {
  const std::string name = "soarbox " + command.get_name();
  const std::string sentence = FirstLine(error.what());
  Diagnostic problem;
  problem.message = name + ": " + sentence;
  // Messages of this project's own checks are sentences about the option.
  if (const std::size_t takes = problem.message.find(": takes "); takes != std::string::npos)
    problem.message.erase(takes, 1);
  problem.hint = name + " --help lists what it takes";
  const CLI::Option* option = OptionNamed(command, sentence);
  if (option == nullptr) return problem;
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr)
    problem.message = name + ": " + option->get_name() +
                      (option->count() > 1 ? " is given more than once" : " takes a value, and none is given");
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr)
    problem.message =
        name + ": " + (option->get_positional() ? "the argument " : "") + option->get_name() + " is missing";
  problem.hint = option->get_name() + ": " + option->get_description();
  return problem;
}

}  // namespace

Diagnostic ExplainUsage(const CLI::App& program, const CLI::ParseError& error) {
  const std::vector<std::string> stray = program.remaining(false);
  if (!stray.empty()) return UnknownCommand(program, stray.front());
  const std::vector<CLI::App*> used = program.get_subcommands();
  if (used.empty()) {
    return NewProblem(FirstLine(error.what()), "soarbox --help lists the sub-commands");
  }
  const CLI::App& command = *used.front();
  // If there is an unknown option, the library reports a missing value first, although the unknown option is the cause.
  const std::vector<std::string> unknown = command.remaining(true);
  if (!unknown.empty()) return UnknownArgument(program, command, unknown.front());
  return BadValue(command, error);
}

std::optional<Diagnostic> FindSingleDash(const CLI::App& program, int argc, const char* const* argv) {
  const CLI::App* command = nullptr;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (command == nullptr) command = FindCommand(program, word);
    const bool is_word = word.size() > 2 && word[0] == '-' && std::isalpha(static_cast<unsigned char>(word[1])) != 0;
    if (!is_word || (command != nullptr && command->get_name() == "soar")) continue;
    const std::string doubled = "-" + word.substr(0, word.find('='));
    if (!Holds(OptionNamesOf(command == nullptr ? program : *command), doubled)) continue;
    return NewProblem("soarbox" + (command == nullptr ? "" : " " + command->get_name()) + " has no option " + word,
                      "did you mean " + doubled + "?");
  }
  return std::nullopt;
}

std::optional<Diagnostic> FindMissingValue(const CLI::App& program, int argc, const char* const* argv) {
  const CLI::App* command = nullptr;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (command == nullptr) command = FindCommand(program, word);
    if (command == nullptr || !word.starts_with("--")) continue;
    const CLI::Option* option = command->get_option_no_throw(word);
    const bool is_followed = i + 1 < argc && Holds(OptionNamesOf(*command), argv[i + 1]);
    if (option == nullptr || option->get_items_expected_min() == 0 || !is_followed) continue;
    return NewProblem("soarbox " + command->get_name() + ": " + word + " takes a value, and none is given",
                      word + ": " + option->get_description());
  }
  return std::nullopt;
}

CLI::Validator NumberIn(double least, double most) {
  const auto check = [least, most](std::string& text) -> std::string {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (!text.empty() && *end == '\0' && value >= least && value <= most) return {};
    char wanted[80];
    std::snprintf(wanted, sizeof wanted, "a number from %.10g to %.10g", least, most);
    return "takes " + std::string(wanted) + ", not '" + text + "'";
  };
  return CLI::Validator(check, "");
}

CLI::Validator WholeNumber() {
  const auto check = [](std::string& text) -> std::string {
    const bool is_good =
        !text.empty() && text.size() <= 18 && text.find_first_not_of("0123456789") == std::string::npos;
    return is_good ? "" : "takes a whole number, not '" + text + "'";
  };
  return CLI::Validator(check, "");
}

}  // namespace soarbox::app
