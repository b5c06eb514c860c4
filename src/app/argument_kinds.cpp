// SPDX-License-Identifier: BSD-2-Clause
#include "app/argument_kinds.h"

#include <algorithm>
#include <iterator>
#include <sstream>

#include "debugger/views.h"

namespace soarbox::app {
namespace {

constexpr ArgumentKind kNumber{"N"}, kMegabytes{"MB"}, kAddress{"HOST:PORT"}, kName{"NAME"};
constexpr ArgumentKind kFile{"FILE", Offers::kFiles}, kFolder{"FOLDER", Offers::kFolders};
constexpr ArgumentKind kRules{"RULES", Offers::kFiles, ".soar"};
constexpr ArgumentKind kRulesOf{"NAME=FILE", Offers::kNamedFiles, ".soar"};
constexpr ArgumentKind kRecording{"RECORDING", Offers::kFiles, ".soarrec"};
constexpr ArgumentKind kScenario{"SCENARIO", Offers::kScenarios, ".soar .lua .toml"};
constexpr ArgumentKind kRun{"SCENARIO|RECORDING", Offers::kScenarios, ".soar .lua .toml .soarrec"};
constexpr ArgumentKind kSource{"SCENARIO|FILE", Offers::kScenarios, ".soar .lua .toml"};

struct Row {
  std::string_view command;  ///< Empty: all sub-commands with such an argument.
  std::string_view argument;
  ArgumentKind kind;
};

/// The first row that matches is used. A number that is not in the table is called N.
constexpr Row kRows[] = {
    {"run", "scenario", kScenario},
    {"serve", "scenario", kScenario},
    {"why", "scenario", kRun},
    {"why", "topic", {"COMMAND|OPERATOR|RULE"}},
    {"inspect", "source", kRun},
    {"report", "source", {"RECORDING|FOLDER", Offers::kFiles, ".soarrec .toml"}},
    {"soar", "files", kRules},
    {"kernel", "agents", kRules},
    {"format", "files", kRules},
    {"datamap", "rules", kRules},
    {"check", "files", kSource},
    {"test", "paths", kSource},
    {"sweep", "spec", {"SWEEP", Offers::kScenarios, ".toml"}},
    {"learn", "words", {"LESSON", Offers::kLessons}},
    {"new", "name", kFolder},
    {"help", "command", {"COMMAND", Offers::kCommands}},
    {"", "file", kRecording},
    {"", "other", kRecording},
    {"learn", "--from", kFolder},
    {"resume", "--rules", kRules},
    {"", "--rules", kRulesOf},
    {"", "--path", kFolder},
    {"", "--page", kFolder},
    {"", "--folder", kFolder},
    {"", "--state", kFolder},
    {"", "--keep", kFolder},
    {"", "--pages", kFolder},
    {"", "--pictures", kFolder},
    {"", "--plots", kFolder},
    {"", "--video", {"FILE", Offers::kFiles, ".gif .mp4 .webm"}},
    {"", "--screenshot", {"FILE", Offers::kFiles, ".png"}},
    {"watch", "address", kAddress},
    {"kernel", "--record", kFile},
    {"kernel", "--secret-file", kFile},
    {"", "--record", kRecording},
    {"report", "--output", {"FILE", Offers::kFiles, ".html"}},
    {"", "--output", kFile},
    {"", "--ui-script", kFile},
    {"", "--input", kFile},
    {"", "--junit", kFile},
    {"", "--class", kFile},
    {"", "--lti", kFile},
    {"", "--memory", kMegabytes},
    {"", "--record-limit", kMegabytes},
    {"", "--detail", {"DETAIL", Offers::kWords, "auto low full"}},
    {"", "--record-level", {"LEVEL", Offers::kWords, "world decisions all"}},
    {"", "--on", {"PLACE", Offers::kWords, "here slurm"}},
    {"", "--camera", {"MODE", Offers::kWords, "free orbit follow eyes map"}},
    {"",
     "--show",
     {"LIST", Offers::kList,
      "labels trails senses paths targets shots messages forces belief navigation influence physics"}},
    {"", "--panels", {"LIST"}},
    {"", "--seeds", {"LIST"}},
    {"", "--view", {"VIEW", Offers::kWords}},
    {"", "--until", {"EVENT"}},
    {"", "--select", kName},
    {"", "--agent", kName},
    {"", "--host", kName},
    {"", "--sample", kNumber},
    {"", "--sbatch", {"ARGUMENT"}},
    {"", "--kernel", kAddress},
    {"", "--listen", {"ADDRESS:PORT"}},
    {"", "--dis", {"ADDRESS:PORT[,SITE,APPLICATION,EXERCISE]"}},
    {"", "--proxy", {"ADDRESS"}},
    {"", "--embed", {"SITE"}},
    {"", "--token", {"SECRET"}},
};

/// If there are more words, the help shows the kind's name.
constexpr std::size_t kFewWords = 5;

/// "--output" of "-o,--output".
std::string FullNameOf(const CLI::Option& option) {
  if (option.get_positional()) return option.get_name();
  return option.get_lnames().empty() ? option.get_name() : "--" + option.get_lnames().front();
}

const Row* FindRow(std::string_view command, std::string_view argument) {
  const auto fits = [&](const Row& row) {
    return row.argument == argument && (row.command.empty() || row.command == command);
  };
  const auto* const row = std::find_if(std::begin(kRows), std::end(kRows), fits);
  return row == std::end(kRows) ? nullptr : row;
}

std::string_view ViewNames() {
  static const std::string names = [] {
    std::string text;
    for (const debugger::ViewInfo& view : debugger::Views()) text += std::string(view.name) + " ";
    return text;
  }();
  return names;
}

std::vector<const CLI::Option*> Those(const CLI::App& command, bool positional) {
  std::vector<const CLI::Option*> options;
  for (const CLI::Option* option : command.get_options())
    if (option->get_positional() == positional) options.push_back(option);
  return options;
}

}  // namespace

std::vector<std::string> SplitAtBlanks(std::string_view text) {
  std::istringstream words{std::string(text)};
  return {std::istream_iterator<std::string>(words), {}};
}

ArgumentKind KindOf(const CLI::App& command, const CLI::Option& option) {
  const std::string name = FullNameOf(option);
  const Row* row = FindRow(command.get_name(), name);
  if (row == nullptr) {
    const std::string type = option.get_type_name();
    const bool is_number =
        type == "N" || type.starts_with("INT") || type.starts_with("UINT") || type.starts_with("FLOAT");
    return is_number ? kNumber : ArgumentKind{};
  }
  ArgumentKind kind = row->kind;
  if (name == "--view") kind.words = ViewNames();
  return kind;
}

std::string NameOf(const ArgumentKind& kind) {
  std::vector<std::string> words = SplitAtBlanks(kind.words);
  if (kind.offers != Offers::kWords || words.size() > kFewWords) return std::string(kind.name);
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : "|") + word;
  return text;
}

void NameArguments(CLI::App& program) {
  for (CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
    for (CLI::Option* option : command->get_options()) {
      if (!TakesValue(*option)) continue;
      const std::string name = NameOf(KindOf(*command, *option));
      // Removes the descriptions of checks from the help: the argument's name or description contains the same.
      try {
        for (int i = 0;; ++i) option->get_validator(i)->description("");
      } catch (const CLI::OptionNotFound&) {
      }
      option->type_name(name);
    }
  }
}

std::vector<std::string> WordsOf(std::string_view option) {
  const Row* row = FindRow("", option);
  return row == nullptr ? std::vector<std::string>{} : SplitAtBlanks(row->kind.words);
}

std::string ListedWordsOf(std::string_view option) {
  std::string text;
  for (const std::string& word : WordsOf(option)) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::vector<const CLI::App*> SubCommands(const CLI::App& program) {
  return program.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<const CLI::App*> ListedCommands(const CLI::App& program) {
  return program.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

const CLI::App* FindCommand(const CLI::App& program, std::string_view name) {
  for (const CLI::App* each : SubCommands(program))
    if (each->get_name() == name) return each;
  return nullptr;
}

std::vector<const CLI::Option*> PositionalsOf(const CLI::App& command) {
  return Those(command, true);
}

std::vector<const CLI::Option*> OptionsOf(const CLI::App& command) {
  return Those(command, false);
}

bool TakesValue(const CLI::Option& option) {
  return option.get_positional() || option.get_items_expected_min() > 0;
}

bool MayRepeat(const CLI::Option& option) {
  return option.get_expected_max() > 1;
}

}  // namespace soarbox::app
