// SPDX-License-Identifier: BSD-2-Clause
#include "app/usage_text.h"

#include <algorithm>
#include <iterator>

#include "app/argument_kinds.h"

namespace soarbox::app {
namespace {

struct ExampleRow {
  std::string_view command;
  UsageExample example;
};

/// In an order in which they can be executed one after the other; tests/app/test_manual.py does so.
constexpr ExampleRow kExamples[] = {
    {"", {"soarbox new scout", "Write a scenario of your own into the folder scout"}},
    {"", {"soarbox run scout", "Open it: change scout/scout.soar, and the agent changes at once"}},
    {"", {"soarbox learn", "List the lessons, from your first rule to agents that learn"}},
    {"new", {"soarbox new scout", "One agent made of Soar rules, in the folder scout"}},
    {"new", {"soarbox new --team fight", "Two teams of Soar agents, in the folder fight"}},
    {"run", {"soarbox run scout", "The scenario in the folder scout, in a window if there is a display"}},
    {"run",
     {"soarbox run soar_hallway --headless --seconds 10 --record hallway.soarrec",
      "One that comes with the program, without a window for 10 simulated seconds, recorded"}},
    {"run", {"soarbox run scout --headless --seed 7 --rules scout=scout/scout.soar", "With other rules for one agent"}},
    {"soar", {"soarbox soar scout/scout.soar", "Load these rules, then type commands"}},
    {"kernel", {"soarbox kernel --port 12121 scout/scout.soar", "One agent, on the port at which debuggers look"}},
    {"watch", {"soarbox watch 127.0.0.1:12121", "The agents of the kernel that listens there"}},
    {"replay", {"soarbox replay hallway.soarrec", "Watch it again, forwards and backwards"}},
    {"replay", {"soarbox replay hallway.soarrec --headless --from 2 --to 3", "Print one second of it"}},
    {"verify", {"soarbox verify hallway.soarrec", "Is the run still the same?"}},
    {"replay", {"soarbox replay hallway.soarrec --video hallway.gif", "Draw it without a window"}},
    {"export", {"soarbox export hallway.soarrec -o hallway.csv", "A row for each agent and tick"}},
    {"export",
     {"soarbox export hallway.soarrec --recording --from 2 --to 6 -o part.soarrec", "Four seconds as a recording"}},
    {"resume",
     {"soarbox resume hallway.soarrec --at 5 --seconds 2 --record other.soarrec", "Live again from second 5 on"}},
    {"compare", {"soarbox compare hallway.soarrec other.soarrec", "Where does the second begin to differ?"}},
    {"check", {"soarbox check scout", "All rules, scripts and scenario files in this folder"}},
    {"why", {"soarbox why soar_hallway --at 3", "What the first agent does at second 3, and why"}},
    {"why", {"soarbox why soar_flee flee --agent rabbit", "Why the rabbit flees, or what prevents it"}},
    {"inspect",
     {"soarbox inspect soar_skirmish --agent blue-3 --view operators --at 6",
      "The operators and what decided between them"}},
    {"inspect", {"soarbox inspect hallway.soarrec --view memory --json", "Working memory as JSON, from a recording"}},
    {"test", {"soarbox test scout --seeds 1..3", "The checks of this scenario, with three seeds"}},
    {"sweep",
     {"soarbox sweep soar_skirmish", "Three variants with ten seeds each; the table goes into soar_skirmish.sweep"}},
    {"sweep", {"soarbox sweep --verify soar_skirmish.sweep --sample 3", "Three of its runs made again, and compared"}},
    {"report", {"soarbox report hallway.soarrec -o hallway.html", "A page about this run"}},
    {"learn", {"soarbox learn", "List the lessons"}},
    {"learn", {"soarbox learn 1", "Begin the first: copy its files and open its world"}},
    {"learn", {"soarbox learn check 1", "Grade it"}},
    {"learn", {"soarbox learn eaters", "List the course about the Eaters of Soar's tutorial"}},
    {"list", {"soarbox list", "Each with a line about it"}},
    {"format", {"soarbox format scout", "Format all rules below this folder"}},
    {"format", {"soarbox format --check scout", "Only name the files that would change"}},
    {"datamap", {"soarbox datamap scout/scout.soar -o scout/scout.vsa.json", "A project that VisualSoar opens"}},
    {"mcp", {"soarbox mcp --folder scout", "An assistant may read this folder and nothing else"}},
    {"serve", {"soarbox serve", "For browsers on this machine"}},
    {"serve",
     {"soarbox serve --class names.txt --token SECRET --listen 0.0.0.0:8080", "For a class, with a link for each"}},
    {"help", {"soarbox help run", "The same as soarbox run --help"}},
    {"help", {"soarbox help run --man | man -l -", "The same as a manual page"}},
};

struct StatusRow {
  std::string_view commands;  ///< Separated by blanks; empty: all.
  ExitStatus status;
};

constexpr StatusRow kStatuses[] = {
    {"", {"0", "It ran, and nothing was wrong"}},
    {"run watch resume", {"1", "It ran to the end, but scripts or rules had errors; each is reported"}},
    {"soar", {"1", "A command of a script failed"}},
    {"check", {"1", "There are errors or warnings"}},
    {"verify compare", {"1", "They differ"}},
    {"test", {"1", "A check failed"}},
    {"learn", {"1", "The lesson is not passed"}},
    {"sweep", {"1", "Runs are missing, reported errors, or differ from their rows"}},
    {"lsp", {"1", "The connection ended without the request shutdown"}},
    {"format", {"1", "A file cannot be read as rules, or with --check: one would change"}},
    {"", {"2", "The command line was wrong"}},
    {"", {"3", "A scenario, a file, a port or the display could not be used"}},
    {"test", {"4", "A run crashed, hung or is undecided, and nothing worse"}},
    {"test", {"5", "There is no mission"}},
    {"run", {"N", "A script called os.exit(N)"}},
    {"test sweep", {"130", "It was interrupted"}},
};

bool IsAmong(std::string_view commands, std::string_view command) {
  const std::vector<std::string> words = SplitAtBlanks(commands);
  return commands.empty() || std::find(words.begin(), words.end(), command) != words.end();
}

std::string FooterOf(std::string_view command) {
  std::string text;
  const std::vector<UsageExample> examples = ExamplesOf(command);
  if (!examples.empty()) text += "Examples:\n";
  for (const auto& [line, about] : examples) text += "  " + std::string(line) + "\n      " + std::string(about) + "\n";
  text += (text.empty() ? "Exit status:\n" : "\nExit status:\n");
  for (const auto& [code, meaning] : ExitStatusesOf(command))
    text += "  " + std::string(code) + std::string(4 - code.size(), ' ') + std::string(meaning) + "\n";
  text.pop_back();
  return text;
}

}  // namespace

std::vector<UsageExample> ExamplesOf(std::string_view command) {
  std::vector<UsageExample> examples;
  for (const ExampleRow& row : kExamples)
    if (row.command == command) examples.push_back(row.example);
  return examples;
}

std::vector<ExitStatus> ExitStatusesOf(std::string_view command) {
  std::vector<ExitStatus> statuses;
  for (const StatusRow& row : kStatuses)
    if (IsAmong(row.commands, command)) statuses.push_back(row.status);
  return statuses;
}

void AddUsageTexts(CLI::App& program) {
  program.footer(FooterOf(""));
  for (CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
    command->footer(FooterOf(command->get_name()));
}

}  // namespace soarbox::app
