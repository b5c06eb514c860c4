// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox::app {

/// What a shell may offer where an argument is wanted.
enum class Offers : std::uint8_t {
  kNothing,
  kFiles,  ///< Files of these kinds, and folders on the way to them.
  kFolders,
  kNamedFiles,  ///< The same behind NAME=.
  kScenarios,   ///< Scenarios by name, and files.
  kLessons,     ///< What `soarbox learn` takes.
  kCommands,    ///< Sub-commands.
  kWords,       ///< One of these words.
  kList,        ///< Some of them, separated by commas.
};

/// What may stand where an argument is wanted. Help, manual pages and completion all take it from here.
struct ArgumentKind {
  std::string_view name = "TEXT";  ///< What the help calls it: "FILE", "N".
  Offers offers = Offers::kNothing;
  std::string_view words = {};  ///< Separated by blanks: what it may be, or the extensions of files (".soar .lua").
};

/// Of an option or a positional argument of a sub-command.
ArgumentKind KindOf(const CLI::App& command, const CLI::Option& option);
/// What the help calls it: the kind's name, or its words if there are few ("auto|low|full").
std::string NameOf(const ArgumentKind& kind);
/// Calls the arguments of all sub-commands by these names.
void NameArguments(CLI::App& program);

/// The words that such an option takes, whatever its sub-command.
std::vector<std::string> WordsOf(std::string_view option);
/// The same as text: "labels, trails, senses".
std::string ListedWordsOf(std::string_view option);

std::vector<std::string> SplitAtBlanks(std::string_view text);

/// All sub-commands, those that are not for people, too.
std::vector<const CLI::App*> SubCommands(const CLI::App& program);
/// Those that help lists.
std::vector<const CLI::App*> ListedCommands(const CLI::App& program);
/// The sub-command of this name; null: there is none.
const CLI::App* FindCommand(const CLI::App& program, std::string_view name);
/// Positional arguments, in their order, or all others.
std::vector<const CLI::Option*> PositionalsOf(const CLI::App& command);
std::vector<const CLI::Option*> OptionsOf(const CLI::App& command);
bool TakesValue(const CLI::Option& option);
bool MayRepeat(const CLI::Option& option);

}  // namespace soarbox::app
