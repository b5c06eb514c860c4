// SPDX-License-Identifier: BSD-2-Clause
#include "app/manual.h"

#include <cctype>
#include <fstream>
#include <iostream>
#include <system_error>
#include <vector>

#include "app/argument_kinds.h"
#include "app/exit_codes.h"
#include "app/options_page.h"
#include "app/refuse.h"
#include "app/usage_text.h"
#include "diagnostics/problem.h"

namespace soarbox::app {
namespace {

/// Escapes a text for roff. Text between backquotes becomes bold.
std::string Plain(std::string_view text) {
  std::string out;
  bool is_bold = false;
  for (const char c : text) {
    switch (c) {
      case '\\':
        out += "\\e";
        break;
      case '-':
        out += "\\-";
        break;
      case '~':
        out += "\\(ti";
        break;
      case '^':
        out += "\\(ha";
        break;
      case '\'':
        out += "\\(aq";
        break;
      case '"':
        out += "\\(dq";
        break;
      case '`':
        is_bold = !is_bold;
        out += is_bold ? "\\fB" : "\\fR";
        break;
      default:
        out += c;
    }
  }
  return out.starts_with('.') ? "\\&" + out : out;
}

std::string Bold(std::string_view text) {
  return "\\fB" + Plain(text) + "\\fR";
}

std::string Italic(std::string_view text) {
  return "\\fI" + Plain(text) + "\\fR";
}

/// "--folder FOLDER" of options, "SCENARIO" of positional arguments.
std::string NameIn(const CLI::App& command, const CLI::Option& option) {
  const std::string value = TakesValue(option) ? Italic(NameOf(KindOf(command, option))) : "";
  if (option.get_positional()) return value + (MayRepeat(option) ? "..." : "");
  std::string names;
  for (const std::string& name : option.get_snames()) names += (names.empty() ? "" : ", ") + Bold("-" + name);
  for (const std::string& name : option.get_lnames()) names += (names.empty() ? "" : ", ") + Bold("--" + name);
  return names + (value.empty() ? "" : " " + value);
}

std::string Sentence(std::string text) {
  if (!text.empty() && text.back() != '.' && text.back() != '?' && text.back() != ')') text += '.';
  return text;
}

/// "soarbox-run" of run.
std::string PageName(const CLI::App& program, const CLI::App& command) {
  return &program == &command ? program.get_name() : program.get_name() + "-" + command.get_name();
}

std::string Capitals(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

void AddArgument(std::string& page, const CLI::App& command, const CLI::Option& option) {
  page += ".TP\n" + NameIn(command, option) + "\n";
  std::string about = option.get_description();
  if (const std::string value = option.get_default_str(); !value.empty()) about += " (default: " + value + ")";
  page += Plain(Sentence(about)) + "\n";
}

void AddSynopsis(std::string& page, const CLI::App& program, const CLI::App& command) {
  page += ".SH SYNOPSIS\n";
  if (&program == &command) {
    page += Bold("soarbox") + " " + Italic("COMMAND") + " [" + Italic("ARGUMENT") + "...]\n";
    return;
  }
  page += Bold("soarbox " + command.get_name()) + " [" + Italic("OPTION") + "...]";
  for (const CLI::Option* option : PositionalsOf(command)) {
    const std::string name = NameIn(command, *option);
    page += option->get_required() ? " " + name : " [" + name + "]";
  }
  page += "\n";
}

}  // namespace

std::string ManualPage(const CLI::App& program, const CLI::App& command, std::string_view version) {
  const bool is_program = &program == &command;
  const std::string name = PageName(program, command);
  std::string about = command.get_description();
  // The name is already printed before "Soarbox: a sandbox".
  if (is_program) about = about.substr(about.find(": ") + 2);
  about[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(about[0])));
  std::string page =
      ".TH " + Capitals(Plain(name)) + " 1 " SOARBOX_DATE " \"Soarbox " + std::string(version) + "\" Soarbox\n";
  page += ".SH NAME\n" + Plain(name) + " \\- " + Plain(about) + "\n";
  AddSynopsis(page, program, command);
  if (is_program) {
    page += ".SH COMMANDS\n";
    for (const CLI::App* each : ListedCommands(program))
      page += ".TP\n" + Bold(each->get_name()) + "\n" + Plain(Sentence(each->get_description())) + "\n";
  }
  page += ".SH OPTIONS\n";
  for (const CLI::Option* option : PositionalsOf(command)) AddArgument(page, command, *option);
  for (const CLI::Option* option : OptionsOf(command)) AddArgument(page, command, *option);
  const std::string text_name = is_program ? "" : command.get_name();
  if (const std::vector<UsageExample> examples = ExamplesOf(text_name); !examples.empty()) {
    page += ".SH EXAMPLES\n";
    for (const auto& [line, what] : examples)
      page += ".TP\n" + Bold(line) + "\n" + Plain(Sentence(std::string(what))) + "\n";
  }
  page += ".SH EXIT STATUS\n";
  for (const auto& [code, meaning] : ExitStatusesOf(text_name))
    page += ".TP\n" + Bold(code) + "\n" + Plain(Sentence(std::string(meaning))) + "\n";
  page += ".SH SEE ALSO\n";
  if (!is_program) {
    page += ".BR soarbox (1)\n";
  } else {
    const std::vector<const CLI::App*> others = ListedCommands(program);
    for (const CLI::App* each : others)
      page += ".BR " + Plain(PageName(program, *each)) + (each == others.back() ? " (1)\n" : " (1),\n");
  }
  page += ".PP\nAll pages of the documentation are in the package soarbox\\-doc.\n";
  return page;
}

int Help(const CLI::App& program, const HelpOptions& options, std::string_view version) {
  if (!options.pages.empty()) {
    std::error_code error;
    std::filesystem::create_directories(options.pages, error);
    std::vector<const CLI::App*> commands = ListedCommands(program);
    commands.push_back(&program);
    for (const CLI::App* command : commands) {
      const std::filesystem::path file = options.pages / (PageName(program, *command) + ".1");
      std::ofstream out(file, std::ios::binary);
      out << ManualPage(program, *command, version);
      out.close();
      if (!out) return Refuse(ProblemIn(file, "this file cannot be written", "check the folder and its permissions"));
    }
    return kOk;
  }
  if (options.markdown) {
    std::cout << OptionsPage(program);
    return kOk;
  }
  const CLI::App* command = options.command.empty() ? &program : FindCommand(program, options.command);
  if (command == nullptr) {
    std::vector<std::string_view> names;
    for (const CLI::App* each : ListedCommands(program)) names.push_back(each->get_name());
    const std::string near(Suggest(options.command, names));
    Refuse(NewProblem("soarbox has no sub-command '" + options.command + "'",
                      near.empty() ? "soarbox help lists them" : "did you mean soarbox help " + near + "?"));
    return kUsage;
  }
  if (options.man) {
    std::cout << ManualPage(program, *command, version);
  } else {
    // The library's own call would name the executed sub-command, which is help.
    const std::string name = program.get_name() + (command == &program ? "" : " " + command->get_name());
    std::cout << command->get_formatter()->make_help(command, name, CLI::AppFormatMode::Normal);
  }
  return kOk;
}

}  // namespace soarbox::app
