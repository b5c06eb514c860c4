// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "cli/command.h"
#include "cli/interpreter.h"
#include "cli/lookup.h"
#include "cli/summary.h"

namespace soarbox::cli {
namespace {

constexpr std::string_view kInvalidArgument =
    "Invalid argument for output command. Use 'output ?' to see a list of valid sub-commands.";

std::string ChannelText(const OutputSettings& output) {
  std::string disabled;
  for (std::size_t i = 0; i < output.log_channels.size(); ++i) {
    if (!output.log_channels[i]) disabled += fmt::format(" {}", i + 1);
  }
  return disabled.empty() ? "All agent log channels enabled.\n"
                          : "All agent log channels enabled except" + disabled + ".\n";
}

bool OutputOverview(CommandCall& call) {
  const OutputSettings& output = call.session.output();
  Summary summary(55);
  summary.Rule('=').Text("-                   Output Status                     -\n").Rule('=');
  summary.Text(fmt::format("{:<52}{:<6}\n", "Printing enabled", call.stream().enabled() ? "Yes" : "No")).Rule('-');
  summary.Row("Agent RHS write output", OnOff(output.agent_writes), "   ");
  summary.Text(ChannelText(output));
  summary.Rule('-').Row("Warnings", OnOff(output.warnings), "   ").Rule('-');
  summary.Text(
      "\nTo enable specific types of trace messages, use the 'trace' command.\n"
      "Use 'output ?' for a command overview or 'help output' for the manual page.");
  call.Out(summary.Take());
  return true;
}

/// Shows or sets an on/off setting.
template <typename Apply>
bool Switch(CommandCall& call, std::string_view name, bool current, Apply apply) {
  if (call.words.size() < 2) {
    call.Out(fmt::format("{} is {}\n", name, OnOff(current)));
    return true;
  }
  const std::string& word = call.words[1].text;
  if (word != "on" && word != "off") return call.Fail(kInvalidArgument);
  apply(word == "on");
  call.Out(fmt::format("{} is now {}\n", name, word));
  return true;
}

bool Enabled(CommandCall& call) {
  return Switch(call, "enabled", call.stream().enabled(), [&](bool on) { call.stream().SetEnabled(on); });
}

bool Console(CommandCall& call) {
  return Switch(call, "console", call.stream().console(), [&](bool on) { call.stream().SetConsole(on); });
}

bool Callbacks(CommandCall& call) {
  return Switch(call, "callbacks", call.stream().sink_enabled(), [&](bool on) { call.stream().SetSinkEnabled(on); });
}

bool AgentWrites(CommandCall& call) {
  OutputSettings& output = call.session.output();
  return Switch(call, "agent-writes", output.agent_writes, [&](bool on) {
    output.agent_writes = on;
    call.agent().SetAgentWrites(on);
  });
}

bool EchoCommands(CommandCall& call) {
  OutputSettings& output = call.session.output();
  return Switch(call, "echo-commands", output.echo_commands, [&](bool on) { output.echo_commands = on; });
}

constexpr OptionSpec kWarningOptions[] = {
    {'e', "on"},
    {'e', "enable", OptionArgument::kNone, "switch on"},
    {'d', "off"},
    {'d', "disable", OptionArgument::kNone, "switch off"},
};

bool Warnings(CommandCall& call) {
  OutputSettings& output = call.session.output();
  ParsedWords parsed;
  if (!call.Parse(kWarningOptions, parsed)) return false;
  if (!parsed.options.empty()) {
    output.warnings = parsed.Has('e');
    call.agent().mutable_settings().warn_of_mixed_support = output.warnings;
    call.Out(fmt::format("warnings is now {}\n", OnOff(output.warnings)));
    return true;
  }
  return Switch(call, "warnings", output.warnings, [&](bool on) {
    output.warnings = on;
    call.agent().mutable_settings().warn_of_mixed_support = on;
  });
}

bool AgentLogs(CommandCall& call) {
  OutputSettings& output = call.session.output();
  if (call.words.size() < 2) {
    call.Out(ChannelText(output));
    return true;
  }
  const auto channel = ParseInteger(call.words[1].text);
  if (call.words.size() != 3 || !channel || *channel < 1 || *channel > OutputSettings::kLogChannels) {
    return call.Fail(call.words.size() == 3 && (!channel || *channel < 1)
                         ? "Agent trace channel must be an integer between 1 and 100."
                         : "Wrong number of arguments to output agent-trace command.");
  }
  const auto index = static_cast<std::size_t>(*channel - 1);
  const std::string& word = call.words[2].text;
  if (word != "on" && word != "off") {
    return call.Fail(
        "Agent trace channel setting must be 'on' or 'off'. Use 'output ?' to see a list of valid sub-commands.");
  }
  output.log_channels[index] = word == "on";
  return true;
}

bool PrintDepth(CommandCall& call) {
  OutputSettings& output = call.session.output();
  if (call.words.size() < 2) {
    call.Out(fmt::format("print-depth is {}\n", output.print_depth));
    return true;
  }
  const auto depth = ParseLeadingInteger(call.words[1].text);
  if (!depth || *depth < 1 || *depth > 1000000) return call.Fail(kInvalidArgument);
  output.print_depth = static_cast<int>(*depth);
  call.Out(fmt::format("print-depth is now {}\n", call.words[1].text));
  return true;
}

constexpr OptionSpec kLogOptions[] = {
    {'a', "add", OptionArgument::kNone, "add the words that follow to the file"},
    {'A', "append", OptionArgument::kNone, "append to an existing file"},
    {'e', "existing", OptionArgument::kNone, "append to an existing file"},
    {'c', "close", OptionArgument::kNone, "close the file"},
    {'c', "off"},
};

bool Log(CommandCall& call) {
  constexpr std::string_view kUsage = "\nUse 'output ?' and 'help output' to learn more about the output command.";
  ParsedWords parsed;
  if (!call.Parse(kLogOptions, parsed)) return false;
  Session& session = call.session;
  if (parsed.Has('a')) {
    if (!session.log_open()) return call.Fail("Log is not open." + std::string(kUsage));
    std::string line;
    for (const Word& word : parsed.arguments) line += word.text + " ";
    session.Log(line + "\n");
    return true;
  }
  if (parsed.Has('c')) {
    if (!session.log_open()) return call.Fail("Log is not open." + std::string(kUsage));
    session.CloseLog();
    call.Out("Log file closed.");
    return true;
  }
  if (parsed.arguments.empty()) {
    call.Out(fmt::format("log is {}\n", OnOff(session.log_open())));
    return true;
  }
  if (parsed.arguments.size() > 1) {
    return call.Fail("Filename or nothing expected, enclose filename in quotes if there are spaces in the path." +
                     std::string(kUsage));
  }
  const std::string& file = parsed.arguments.front().text;
  if (session.log_open()) return call.Fail("Log is already open." + std::string(kUsage));
  std::filesystem::path path;
  if (!call.interpreter.ResolveForWriting(call, file, path)) return false;
  if (!session.OpenLog(path.string(), parsed.Has('A') || parsed.Has('e'))) {
    return call.Fail("Failed to open log file " + file + " for writing." + std::string(kUsage));
  }
  call.Out(fmt::format("Log file '{}' open.", file));
  return true;
}

bool CommandToFile(CommandCall& call) {
  std::span<const Word> words = call.words.subspan(1);
  bool append = false;
  if (!words.empty() &&
      (words.front().text == "-a" || words.front().text == "-A" || words.front().text == "--append")) {
    append = true;
    words = words.subspan(1);
  }
  if (words.empty()) {
    call.Out("command-to-file is on\n");
    return true;
  }
  if (words.size() < 2)
    return call.Fail(
        "Syntax: output command-to-file [-a] <filename> command [args]\nUse 'output ?' and 'help output' to learn more "
        "about the output command.");
  const std::string& file = words.front().text;
  std::filesystem::path path;
  if (!call.interpreter.ResolveForWriting(call, file, path)) return false;
  std::ofstream out(path, append ? std::ios::app : std::ios::trunc);
  if (!out) return call.Fail("Failed to open file for writing: " + file);
  const std::string before = std::exchange(call.result.text, {});
  std::vector<Word> command(words.begin() + 1, words.end());
  const bool ok = call.interpreter.ExecuteWords(call, command);
  const std::string text = std::exchange(call.result.text, before);
  out << text << "\n";
  if (!ok) call.Out(text);
  return ok;
}

constexpr OptionSpec kEchoOptions[] = {{'n', "nonewline", OptionArgument::kNone, "no newline at the end"}};

constexpr SubcommandInfo kOutputSubcommandList[] = {
    {"enabled", "[on | off]", "whether anything is printed at all", {}, Enabled},
    {"console", "[on | off]", "also print to the standard output of the program that runs the agent", {}, Console},
    {"callbacks", "[on | off]", "send output to clients that registered for it", {}, Callbacks},
    {"agent-logs", "CHANNEL [on | off]", "show what (log) prints on a channel", {}, AgentLogs},
    {"agent-writes", "[on | off]", "show what (write) prints", {}, AgentWrites},
    {"command-to-file", "[-a] FILE COMMAND...", "write what a command prints to a file", {}, CommandToFile},
    {"log", "[--append FILE | --add TEXT | --close]", "write all output to a file as well", kLogOptions, Log},
    {"echo-commands",
     "[on | off]",
     "show command lines and their answers to clients that listen for echoes",
     {},
     EchoCommands},
    {"warnings", "[on | off]", "print warnings", kWarningOptions, Warnings},
    {"print-depth", "[N]", "levels of objects that print shows", {}, PrintDepth},
};

}  // namespace

const std::span<const SubcommandInfo> kOutputSubcommands = kOutputSubcommandList;

bool CommandOutput(CommandCall& call) {
  if (call.words.size() < 2) return OutputOverview(call);
  // The command whose output goes to a file has its own options.
  if (std::string_view("command-to-file").starts_with(call.words[1].text) && call.words[1].text.size() > 1) {
    const std::span<const Word> outer = call.words;
    call.words = outer.subspan(1);
    const bool ok = CommandToFile(call);
    call.words = outer;
    return ok;
  }
  return RunSubcommand(call, {"Invalid output sub-command.  Use 'output ?' to see a list of valid sub-commands and "
                              "settings.",
                              "Use 'output ?' and 'help output' to learn more about the output command.",
                              {},
                              false});
}

bool CommandEcho(CommandCall& call) {
  ParsedWords parsed = ParseOptions(call.words.subspan(1), kEchoOptions);
  bool newline = true;
  std::size_t first = 1;
  if (call.words.size() > 1) {
    const std::string& word = call.words[1].text;
    if (word == "-n" || word == "--nonewline") {
      newline = false;
      ++first;
    } else if (!parsed.error.empty() && word.size() > 1 && word.front() == '-') {
      return call.Fail(parsed.error);
    }
  }
  std::string text;
  for (std::size_t i = first; i < call.words.size(); ++i) {
    const std::string& word = call.words[i].text;
    if (word == "-n" || word == "--nonewline") {
      newline = false;
      continue;
    }
    if (!text.empty() || i > first) text += ' ';
    text += word;
  }
  if (newline) text += '\n';
  call.AddArgument("message", "string", text);
  call.Out(text);
  return true;
}

}  // namespace soarbox::cli
