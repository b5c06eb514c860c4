// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <set>
#include <system_error>

#include "cli/command.h"
#include "cli/interpreter.h"
#include "kernel/agent.h"

namespace soarbox::cli {
namespace {

void AddFiles(const std::filesystem::path& directory, const std::string& word, std::set<std::string>& found) {
  const std::size_t slash = word.rfind('/');
  const std::string folder = slash == std::string::npos ? "" : word.substr(0, slash + 1);
  const std::string name = slash == std::string::npos ? word : word.substr(slash + 1);
  std::error_code error;
  const std::filesystem::path start = folder.starts_with('/') ? std::filesystem::path(folder) : directory / folder;
  for (std::filesystem::directory_iterator entry(start, error), end; !error && entry != end; entry.increment(error)) {
    const std::string file = entry->path().filename().string();
    if (!file.starts_with(name) || (name.empty() && file.starts_with('.'))) continue;
    std::error_code ignored;
    found.insert(folder + file + (entry->is_directory(ignored) ? "/" : ""));
  }
}

}  // namespace

std::vector<std::string> Interpreter::Complete(Session& session, std::string_view line) const {
  const std::size_t command_start = line.find_last_of(";\n");
  if (command_start != std::string_view::npos) line.remove_prefix(command_start + 1);
  CommandReader reader(line);
  std::vector<Word> words;
  if (reader.Next(words) == CommandReader::Status::kError) return {};
  const bool new_word = line.empty() || line.back() == ' ' || line.back() == '\t';
  if (new_word || words.empty()) words.push_back({});
  const std::string word = words.back().text;

  std::set<std::string> found;
  const auto add = [&](std::string_view candidate) {
    if (candidate.starts_with(word)) found.insert(std::string(candidate));
  };
  if (words.size() == 1) {
    for (const CommandInfo& command : Commands()) add(command.name);
    for (const auto& [name, expansion] : aliases_.All()) add(name);
    return {found.begin(), found.end()};
  }
  words.pop_back();
  aliases_.Expand(words);
  std::string error;
  const CommandInfo* command = words.empty() ? nullptr : FindCommand(words.front().text, error);
  if (!command) return {};
  const SubcommandInfo* subcommand = nullptr;
  for (const SubcommandInfo& candidate : command->subcommands) {
    if (words.size() == 1)
      add(candidate.name);
    else if (candidate.name.starts_with(words[1].text) && !words[1].text.empty())
      subcommand = &candidate;
  }
  const std::span<const OptionSpec> options = subcommand ? subcommand->options : command->options;
  if (word.starts_with('-')) {
    for (const OptionSpec& option : options) add("--" + std::string(option.name));
    return {found.begin(), found.end()};
  }
  const std::string_view usage = subcommand ? subcommand->usage : command->usage;
  if (usage.find("RULE") != std::string_view::npos && command->name != "sp" && command->name != "gp") {
    for (const kernel::ProductionId id : session.agent().Productions()) add(session.agent().production(id).name);
  }
  if (usage.find("FILE") != std::string_view::npos || usage.find("DIRECTORY") != std::string_view::npos) {
    AddFiles(directory_, word, found);
  }
  if (usage.find("on | off") != std::string_view::npos) {
    add("on");
    add("off");
  }
  return {found.begin(), found.end()};
}

}  // namespace soarbox::cli
