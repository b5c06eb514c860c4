// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/options.h"
#include "cli/result_node.h"
#include "cli/tokens.h"

namespace soarbox::kernel {
class Agent;
}

namespace soarbox::cli {

class Interpreter;
class PrintStream;
class Session;

/// A command that is being executed: its words, and its result.
struct CommandCall {
  Interpreter& interpreter;
  Session& session;
  std::span<const Word> words;  ///< words[0] is the command's full name; aliases are expanded.
  CommandResult& result;
  /// Determines the line that Execute appends after a failure: nothing more (kReported), a line end (kPlain), "Error
  /// while sourcing file" (kWithMessage), or "command failed" (kWithoutMessage).
  enum class Failure { kNone, kPlain, kWithMessage, kWithoutMessage, kReported } failure = Failure::kNone;

  kernel::Agent& agent() const;
  PrintStream& stream() const;

  /// Appends to the answer.
  void Out(std::string_view text) { result.text += text; }
  /// Ends the command with an error; returns false, for `return call.Fail(...)`.
  bool Fail(std::string_view message);
  /// Ends the command with an error whose text is already printed.
  bool FailPrinted();
  /// Adds a hint for users. It is not part of the text that programs parse.
  void Hint(std::string message, std::string hint);
  void AddArgument(std::string param, std::string type, std::string value);

  /// Parses the words after `words[0]`. Returns false, after Fail, if they are invalid.
  bool Parse(std::span<const OptionSpec> specs, ParsedWords& parsed);
};

struct CommandInfo;

/// The second word of a command: a sub-command or a setting.
struct SubcommandInfo {
  std::string_view name;
  std::string_view usage;    ///< What follows the name: "[on | off]", "NAME".
  std::string_view summary;  ///< One line.
  std::span<const OptionSpec> options = {};
  bool (*handler)(CommandCall& call) =
      nullptr;  ///< Called with the subcommand's name as words[0]. Null: CommandInfo::handler executes it, and
                ///< RunSubcommand must not be called.
};

/// A command: its implementation and its help.
struct CommandInfo {
  std::string_view name;
  std::string_view usage;
  std::string_view summary;
  bool (*handler)(CommandCall& call);
  std::span<const OptionSpec> options = {};
  std::span<const SubcommandInfo> subcommands = {};
  std::string_view details = {};  ///< Paragraphs for `help NAME`.
};

/// All commands, sorted by name.
std::span<const CommandInfo> Commands();

/// The command with this full name or unique prefix. If there is none, returns null and sets `error` to Soar's message.
const CommandInfo* FindCommand(std::string_view word, std::string& error);

/// Prints the output of `help NAME`. The `?` of a command prints it, too, if no program could rely on what that prints
/// in Soar. Whether `NAME ?` succeeds is as in Soar (SubcommandTexts::fails_after_help).
bool ShowHelp(CommandCall& call, std::string_view name);

/// The line that lists the possible meanings of an ambiguous word.
std::string DidYouMean(std::vector<std::string_view> names);

/// Texts of a command with subcommands. If one is empty, it is the usual one.
struct SubcommandTexts {
  std::string invalid = {};          ///< If there is no such subcommand.
  std::string usage_hint = {};       ///< Follows the message about an invalid option.
  std::string_view also_known = {};  ///< Letters of options that are accepted although no subcommand has them.
  bool fails_after_help = true;      ///< `?` prints the help, then fails, as in Soar 9.6.3.
};

/// Executes the subcommand of words[0] that words[1] names by its full name or a unique prefix; `?` and `help` print
/// the help of the command. As in Soar, the options are first checked against those of all subcommands of the command.
bool RunSubcommand(CommandCall& call, const SubcommandTexts& texts);

/// The name of a command or alias that is most similar to a misspelt word; empty if none is similar.
std::string NearestCommand(std::string_view word, const std::vector<std::pair<std::string, std::string>>& aliases);

// The commands, by file.
bool CommandAlias(CommandCall& call);
bool CommandCd(CommandCall& call);
bool CommandChunk(CommandCall& call);
bool CommandDebug(CommandCall& call);
bool CommandDecide(CommandCall& call);
bool CommandDirs(CommandCall& call);
bool CommandEcho(CommandCall& call);
bool CommandEpmem(CommandCall& call);
bool CommandExplain(CommandCall& call);
bool CommandGp(CommandCall& call);
bool CommandHelp(CommandCall& call);
bool CommandLearn(CommandCall& call);
bool CommandLoad(CommandCall& call);
bool CommandLs(CommandCall& call);
bool CommandOutput(CommandCall& call);
bool CommandPopd(CommandCall& call);
bool CommandPreferences(CommandCall& call);
bool CommandPrint(CommandCall& call);
bool CommandProduction(CommandCall& call);
bool CommandPushd(CommandCall& call);
bool CommandPwd(CommandCall& call);
bool CommandRl(CommandCall& call);
bool CommandRun(CommandCall& call);
bool CommandSave(CommandCall& call);
bool CommandSmem(CommandCall& call);
bool CommandSoar(CommandCall& call);
bool CommandSp(CommandCall& call);
bool CommandStats(CommandCall& call);
bool CommandSvs(CommandCall& call);
bool CommandTrace(CommandCall& call);
bool CommandVisualize(CommandCall& call);
bool CommandWm(CommandCall& call);

// Option tables that are defined with the commands and used by the table of commands.
extern const std::span<const OptionSpec> kRunOptions;
extern const std::span<const OptionSpec> kTraceOptions;
extern const std::span<const OptionSpec> kPrintOptions;
extern const std::span<const OptionSpec> kPreferencesOptions;
extern const std::span<const OptionSpec> kStatsOptions;
extern const std::span<const OptionSpec> kSmemOptions;
extern const std::span<const OptionSpec> kEpmemOptions;
extern const std::span<const OptionSpec> kRlOptions;
extern const std::span<const OptionSpec> kLearnOptions;
extern const std::span<const SubcommandInfo> kChunkSubcommands;
extern const std::span<const SubcommandInfo> kDebugSubcommands;
extern const std::span<const SubcommandInfo> kDecideSubcommands;
extern const std::span<const SubcommandInfo> kExplainSubcommands;
extern const std::span<const SubcommandInfo> kLoadSubcommands;
extern const std::span<const SubcommandInfo> kOutputSubcommands;
extern const std::span<const SubcommandInfo> kProductionSubcommands;
extern const std::span<const SubcommandInfo> kSaveSubcommands;
extern const std::span<const SubcommandInfo> kSoarSubcommands;
extern const std::span<const SubcommandInfo> kVisualizeSubcommands;
extern const std::span<const SubcommandInfo> kWmSubcommands;

}  // namespace soarbox::cli
