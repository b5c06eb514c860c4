// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox::app {

/// The candidates that a shell may offer for an argument.
enum class Offers : std::uint8_t {
  kNothing,
  kFiles,  ///< Files with these extensions, and folders.
  kFolders,
  kNamedFiles,  ///< The same after NAME=.
  kScenarios,   ///< Names of scenarios, and files.
  kLessons,     ///< The arguments of `soarbox learn`.
  kCommands,    ///< Sub-commands.
  kWords,       ///< One of these words.
  kList,        ///< Several of these words, separated by commas.
};

/// The kind of an argument. Help, manual pages and completion use it.
struct ArgumentKind {
  std::string_view name = "TEXT";  ///< The name in the help: "FILE", "N".
  Offers offers = Offers::kNothing;
  std::string_view words = {};  ///< Separated by blanks: the allowed words, or the extensions of files (".soar .lua").
};

/// Returns the kind of an option or a positional argument of a sub-command.
ArgumentKind KindOf(const CLI::App& command, const CLI::Option& option);
/// The name in the help: the kind's name, or its words if there are few ("auto|low|full").
std::string NameOf(const ArgumentKind& kind);
/// Sets these names for the arguments of all sub-commands.
void NameArguments(CLI::App& program);

/// Returns the words that an option accepts, in any sub-command.
std::vector<std::string> WordsOf(std::string_view option);
/// The same as text: "labels, trails, senses".
std::string ListedWordsOf(std::string_view option);

std::vector<std::string> SplitAtBlanks(std::string_view text);

/// Returns all sub-commands, including internal ones.
std::vector<const CLI::App*> SubCommands(const CLI::App& program);
/// Returns the sub-commands that the help lists.
std::vector<const CLI::App*> ListedCommands(const CLI::App& program);
/// Returns the sub-command with this name; null if there is none.
const CLI::App* FindCommand(const CLI::App& program, std::string_view name);
/// PositionalsOf returns the positional arguments in their order, OptionsOf all other arguments.
std::vector<const CLI::Option*> PositionalsOf(const CLI::App& command);
std::vector<const CLI::Option*> OptionsOf(const CLI::App& command);
bool TakesValue(const CLI::Option& option);
bool MayRepeat(const CLI::Option& option);

}  // namespace soarbox::app
