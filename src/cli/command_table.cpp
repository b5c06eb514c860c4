// SPDX-License-Identifier: BSD-2-Clause
#include "cli/command.h"

namespace soarbox::cli {

/// The one table that carries out, completes and documents commands. Sorted by name.
std::span<const CommandInfo> Commands() {
  static const CommandInfo kCommands[] = {
      {"alias", "[-r] [NAME [COMMAND...]]", "short names for commands", CommandAlias, {}, {},
       "Without words it lists all aliases, with a name it shows one. An alias stands for a command with its first "
       "arguments; what follows the alias is added. The expansion of an alias is not expanded again."},
      {"cd", "[DIRECTORY]", "changes the directory that file names start from", CommandCd, {}, {},
       "Without a directory it goes to the user's home."},
      {"chunk", "[SETTING [VALUE]]", "settings of learning", CommandChunk, {}, kChunkSubcommands,
       "Settings are kept and shown, so that agents' files load; rules are not learned in this build."},
      {"debug", "SUBCOMMAND", "times of commands, symbols in use", CommandDebug, {}, kDebugSubcommands},
      {"decide", "[SUBCOMMAND]", "how operators are chosen", CommandDecide, {}, kDecideSubcommands},
      {"dirs", "", "the stack of directories, the current one first", CommandDirs},
      {"echo", "[--nonewline] WORDS...", "prints words", CommandEcho},
      {"epmem", "[OPTIONS]", "settings of episodic memory", CommandEpmem, kEpmemOptions, {},
       "Settings are kept and shown; there is no episodic memory in this build."},
      {"explain", "[SUBCOMMAND]", "how learned rules came about", CommandExplain, {}, kExplainSubcommands,
       "Settings are kept and shown; rules are not learned in this build."},
      {"gp", "{ RULE }", "makes several rules from one text", CommandGp, {}, {},
       "Each [list of values] in the text stands for one of its values in turn. The rules get the numbers *1, *2, ... "
       "behind their name; the first list changes fastest. See also: soar max-gp."},
      {"help", "[COMMAND]", "lists the commands, or describes one", CommandHelp},
      {"learn", "[OPTIONS]", "the old form of chunk", CommandLearn, kLearnOptions},
      {"load", "SUBCOMMAND", "carries out files", CommandLoad, {}, kLoadSubcommands,
       "After a command that fails the file goes on, so that all its errors are reported at once. `source FILE` is "
       "short for `load file FILE`."},
      {"ls", "", "lists the current directory", CommandLs},
      {"output", "[SETTING [VALUE]]", "what is printed, and where it goes", CommandOutput, {}, kOutputSubcommands},
      {"popd", "", "goes back to the directory that pushd left", CommandPopd},
      {"preferences", "[OPTIONS] [ID [ATTRIBUTE]]", "the preferences for an attribute, and where they come from",
       CommandPreferences, kPreferencesOptions, {},
       "Without words it shows the operators of the lowest state. With an object that is no state it shows what the "
       "links to it rest on."},
      {"print", "[OPTIONS] [OBJECT | TIMETAG | RULE | (PATTERN)]", "objects, rules and the goal stack", CommandPrint,
       kPrintOptions, {},
       "<s> <ss> <sss> name the lowest states, <o> <so> <sso> their operators, <ts> <to> those at the top. A pattern "
       "(ID ^ATTRIBUTE VALUE) may hold * for anything; it prints the objects whose elements fit."},
      {"production", "[SUBCOMMAND]", "finds, removes, counts and watches rules", CommandProduction, {},
       kProductionSubcommands},
      {"pushd", "DIRECTORY", "changes the directory, remembering the old one", CommandPushd},
      {"pwd", "", "the current directory", CommandPwd},
      {"rl", "[OPTIONS]", "settings of reinforcement learning", CommandRl, kRlOptions, {},
       "Settings are kept and shown; values are not learned in this build."},
      {"run", "[OPTIONS] [COUNT]", "lets the agents run", CommandRun, kRunOptions, {},
       "Without a count and a unit it runs until something stops it; a unit alone counts to one; a count alone counts "
       "decisions. A run by decisions stops before the phase that `soar stop-phase` names. All agents of the kernel "
       "run, unless --self is given. `run 0` goes on to the stop phase only."},
      {"save", "SUBCOMMAND", "writes rules and settings to files", CommandSave, {}, kSaveSubcommands},
      {"smem", "[OPTIONS]", "settings of semantic memory", CommandSmem, kSmemOptions, {},
       "Settings are kept and shown; there is no semantic memory in this build."},
      {"soar", "[SUBCOMMAND | SETTING [VALUE]]", "general commands and settings", CommandSoar, {}, kSoarSubcommands},
      {"sp", "{ RULE }", "loads a rule", CommandSp, {}, {},
       "Answers * if the rule was loaded, #* if it took the place of a rule of the same name. A rule that equals "
       "another one is ignored."},
      {"stats", "[OPTIONS]", "figures about the run", CommandStats, kStatsOptions},
      {"svs", "", "the spatial visual system, which is not available in this build", CommandSvs},
      {"trace", "[LEVEL] [OPTIONS]", "what is shown of a run", CommandTrace, kTraceOptions, {},
       "Levels: 0 nothing, 1 operators and states, 2 phases and removals of states, 3 firings of rules, 4 changes of "
       "working memory, 5 preferences; each includes those before it. An option switches one thing on, or off if "
       "`remove` or 0 follows. Without words it shows what is on."},
      {"visualize", "[SUBCOMMAND]", "settings of drawings", CommandVisualize, {}, kVisualizeSubcommands},
      {"wm", "SUBCOMMAND", "adds and removes elements of working memory by hand", CommandWm, {}, kWmSubcommands},
  };
  return kCommands;
}

}  // namespace soarbox::cli
