// SPDX-License-Identifier: BSD-2-Clause
#include "cli/command.h"

namespace soarbox::cli {

/// The table by which commands are executed, completed and documented. Sorted by name.
std::span<const CommandInfo> Commands() {
  static const CommandInfo kCommands[] = {
      {"alias",
       "[-r] [NAME [COMMAND...]]",
       "short names for commands",
       CommandAlias,
       {},
       {},
       "Without words it lists all aliases, with a name it shows one. An alias is short for a command with its first "
       "arguments; what follows the alias is added. The expansion of an alias is not expanded again."},
      {"cd",
       "[DIRECTORY]",
       "changes the directory that file names start from",
       CommandCd,
       {},
       {},
       "Without a directory it goes to the user's home."},
      {"chunk",
       "[SETTING [VALUE]]",
       "settings of learning",
       CommandChunk,
       {},
       kChunkSubcommands,
       "`chunk always` turns what substates work out into rules: see docs/learning.md."},
      {"debug", "SUBCOMMAND", "times of commands, symbols in use", CommandDebug, {}, kDebugSubcommands},
      {"decide", "[SUBCOMMAND]", "how operators are chosen", CommandDecide, {}, kDecideSubcommands},
      {"dirs", "", "the stack of directories, the current one first", CommandDirs},
      {"echo", "[--nonewline] WORDS...", "prints words", CommandEcho},
      {"epmem",
       "[OPTIONS]",
       "episodic memory",
       CommandEpmem,
       kEpmemOptions,
       {},
       "Episodes of working memory: when they are taken, how they are found, and a look at each."},
      {"explain",
       "[SUBCOMMAND]",
       "how learned rules came about",
       CommandExplain,
       {},
       kExplainSubcommands,
       "Say `explain all on` before the agent learns, then `explain chunk 1`: see docs/learning.md."},
      {"gp",
       "{ RULE }",
       "makes several rules from one text",
       CommandGp,
       {},
       {},
       "Each [list of values] in the text is replaced by each of its values in turn. The rules get the numbers *1, *2, "
       "... "
       "behind their name; the first list changes fastest. See also: soar max-gp."},
      {"help", "[COMMAND]", "lists the commands, or describes one", CommandHelp},
      {"learn", "[OPTIONS]", "the old form of chunk", CommandLearn, kLearnOptions},
      {"load",
       "SUBCOMMAND",
       "carries out files",
       CommandLoad,
       {},
       kLoadSubcommands,
       "Loading continues after a command that fails, so that all errors are reported at once. `source FILE` is "
       "short for `load file FILE`. A replay of input begins the random numbers with the recording's seed; until it "
       "has "
       "come to its end, what clients put on the input link is dropped. Replay into an agent with the same rules, from "
       "the same beginning: the replay says when the two runs part."},
      {"ls", "", "lists the current directory", CommandLs},
      {"output", "[SETTING [VALUE]]", "what is printed, and where it goes", CommandOutput, {}, kOutputSubcommands},
      {"popd", "", "goes back to the directory that pushd left", CommandPopd},
      {"preferences",
       "[OPTIONS] [ID [ATTRIBUTE]]",
       "the preferences for an attribute, and where they come from",
       CommandPreferences,
       kPreferencesOptions,
       {},
       "Without words it shows the operators of the lowest state. With an object that is no state it shows what the "
       "links to it rest on."},
      {"print",
       "[OPTIONS] [OBJECT | TIMETAG | RULE | (PATTERN)]",
       "objects, rules and the goal stack",
       CommandPrint,
       kPrintOptions,
       {},
       "<s> <ss> <sss> name the lowest states, <o> <so> <sso> their operators, <ts> <to> those at the top. A pattern "
       "(ID ^ATTRIBUTE VALUE) may hold * for anything; it prints the objects whose elements fit."},
      {"production",
       "[SUBCOMMAND]",
       "finds, removes, counts and watches rules",
       CommandProduction,
       {},
       kProductionSubcommands},
      {"pushd", "DIRECTORY", "changes the directory, remembering the old one", CommandPushd},
      {"pwd", "", "the current directory", CommandPwd},
      {"rl",
       "[OPTIONS]",
       "settings of reinforcement learning",
       CommandRl,
       kRlOptions,
       {},
       "While learning is on, rules whose only action is a numeric preference for an operator learn how good it is "
       "from (reward-link ^reward.value) of each state. `print --rl` shows what they learned."},
      {"run",
       "[OPTIONS] [COUNT]",
       "lets the agents run",
       CommandRun,
       kRunOptions,
       {},
       "Without a count and a unit it runs until something stops it; a unit alone counts to one; a count alone counts "
       "decisions. A run by decisions stops before the phase that `soar stop-phase` names. All agents of the kernel "
       "run, unless --self is given. `run 0` runs only up to the stop phase."},
      {"save",
       "SUBCOMMAND",
       "writes rules, settings and input to files",
       CommandSave,
       {},
       kSaveSubcommands,
       "An image of rules cannot be written while there are justifications. A recording of input begins the agent's "
       "random numbers again and keeps their seed. It holds what clients change on the input link, cycle by cycle; "
       "`wm add` and `wm remove` are commands, and not in it."},
      {"smem",
       "[OPTIONS]",
       "semantic memory: facts that last",
       CommandSmem,
       kSmemOptions,
       {},
       "Rules ask by ^smem.command of a state and are answered on ^smem.result. `smem ?` shows all settings with their "
       "values; docs/memory.md explains them."},
      {"soar", "[SUBCOMMAND | SETTING [VALUE]]", "general commands and settings", CommandSoar, {}, kSoarSubcommands},
      {"sp",
       "{ RULE }",
       "loads a rule",
       CommandSp,
       {},
       {},
       "Answers * if the rule was loaded, #* if it took the place of a rule of the same name. A rule that equals "
       "another one is ignored."},
      {"stats",
       "[OPTIONS]",
       "figures about the run",
       CommandStats,
       kStatsOptions,
       {},
       "Whole runs are timed from the start; phases and decision cycles from `soar timers on`, as that makes runs "
       "slower; nothing after `soar timers off`. Agents that run together share the time of the run."},
      {"svs",
       "[--enable | --disable | --enable-in-substates | --disable-in-substates | PATH [ARGUMENTS]]",
       "the spatial visual system: scenes that states imagine",
       CommandSvs,
       {},
       {},
       "Without a word: whether it is on. With it on, each state has a scene below ^svs. A path leads through it: "
       "svs S1.scene.world.NODE shows a node, svs S1.scene.properties all of them, svs S1.scene.sgel LINE changes the "
       "scene, svs S1.scene.clear empties it, svs filters and svs commands list what rules can ask, svs connect_viewer "
       "PORT shows scenes to a viewer (svs S1.scene.draw on or off), and svs . dir shows all paths."},
      {"trace",
       "[LEVEL] [OPTIONS]",
       "what is shown of a run",
       CommandTrace,
       kTraceOptions,
       {},
       "Levels: 0 nothing, 1 operators and states, 2 phases and removals of states, 3 firings of rules, 4 changes of "
       "working memory, 5 preferences; each includes those before it. An option switches one thing on, or off if "
       "`remove` or 0 follows. Without words it shows what is on."},
      {"visualize",
       "[SUBCOMMAND]",
       "drawings of memories, for Graphviz",
       CommandVisualize,
       {},
       kVisualizeSubcommands,
       "Drawings are files in the language of Graphviz, named soar_viz1.gv and so on. An image is made if Graphviz's "
       "program dot is installed; the drawing itself needs nothing."},
      {"wm", "SUBCOMMAND", "adds and removes elements of working memory by hand", CommandWm, {}, kWmSubcommands},
  };
  return kCommands;
}

}  // namespace soarbox::cli
