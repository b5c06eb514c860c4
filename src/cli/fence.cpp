// SPDX-License-Identifier: BSD-2-Clause
#include "cli/fence.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "diagnostics/lower_case.h"

namespace soarbox::cli {
namespace {

namespace fs = std::filesystem;

using Subcommand = std::pair<std::string_view, std::string_view>;

/// Commands that open files only through functions that can be refused, start no program and change only their agent.
constexpr std::string_view kAllowed[] = {"cd",    "chunk",      "decide", "dirs",  "echo",   "epmem", "explain",
                                         "gp",    "help",       "learn",  "load",  "output", "popd",  "preferences",
                                         "print", "production", "pushd",  "pwd",   "rl",     "smem",  "soar",
                                         "sp",    "stats",      "svs",    "trace", "wm"};
/// Commands that are additionally allowed when a recorded run is repeated, so that the run is the same.
constexpr std::string_view kAllowedInRecordings[] = {"alias", "debug", "run"};
/// The commands that are executed for Source::kRulesOnly. Others are skipped.
constexpr std::string_view kRules[] = {"cd", "gp", "load", "popd", "production", "pushd", "sp"};
/// If a command is in this table, only these sub-commands of it are executed for Source::kRulesOnly.
constexpr Subcommand kRuleWords[] = {{"load", "file"}, {"production", "excise"}, {"production", "optimize-attribute"}};

/// Words of commands of long-term memories that open no file. All other words are refused.
constexpr std::string_view kMemoryWords[] = {
    "-e",        "--enable", "--on",  "-d",      "--disable", "--off",    "-a",      "--add",   "-g",
    "--get",     "-s",       "--set", "-i",      "--init",    "-p",       "--print", "-q",      "--query",
    "-r",        "--remove", "-S",    "--stats", "-t",        "--timers", "-c",      "--clear", "-h",
    "--history", "-v",       "--viz", "-?",      "--help",    "--close"};

template <typename List>
bool IsIn(const List& list, std::string_view word) {
  return std::find(std::begin(list), std::end(list), word) != std::end(list);
}

bool IsBelow(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

/// Whether a command opens a file or connects to a viewer. Examples: `smem --set path FILE` and `smem --set database
/// file` open a file, `smem --set path :memory:` does not.
bool OpensFile(std::span<const Word> words) {
  const std::string& name = words.front().text;
  if (name == "svs") return words.size() > 1 && LowerCase(words[1].text).starts_with("connect_viewer");
  if (name == "rl") return std::ranges::any_of(words, [](const Word& word) { return word.text == "update-log-path"; });
  if ((name != "smem" && name != "epmem") || words.size() < 2) return false;
  const std::string& option = words[1].text;
  if (!option.starts_with('-')) return option != "?";
  if (!IsIn(kMemoryWords, option)) return true;
  if ((option != "-s" && option != "--set") || words.size() < 4) return false;
  const std::string &setting = words[2].text, &value = words[3].text;
  if (setting == "path") return value != ":memory:";
  return setting == "database" && value != "memory";
}

bool IsBeginningOf(std::string_view word, std::string_view name) {
  return !word.empty() && name.starts_with(word);
}

}  // namespace

Fence::Fence(std::vector<fs::path> folders, Source source) : source_(source) {
  for (const fs::path& folder : folders) {
    std::error_code error;
    fs::path canonical = fs::canonical(folder, error);
    if (!error) folders_.push_back(std::move(canonical));
  }
}

Fence Fence::For(Source source) const {
  Fence other = *this;
  other.source_ = source;
  return other;
}

bool Fence::MayRead(const fs::path& path) const {
  std::error_code error;
  const fs::path canonical = fs::weakly_canonical(path, error);
  if (error) return false;
  const fs::file_status status = fs::status(canonical, error);
  // If it does not exist, the function that opens it reports this.
  const bool is_plain = fs::is_regular_file(status) || fs::is_directory(status) || !fs::exists(status);
  return is_plain && std::any_of(folders_.begin(), folders_.end(),
                                 [&](const fs::path& folder) { return IsBelow(canonical, folder); });
}

Fence::Answer Fence::Ask(std::span<const Word> words) const {
  const std::string& name = words.front().text;
  if (source_ == Source::kRulesOnly) {
    if (!IsIn(kRules, name)) {
      // A skipped command with "-->" is probably a rule whose `sp` is misspelt.
      const auto holds_rule = [](const Word& word) { return word.text.find("-->") != std::string::npos; };
      return {false, std::ranges::any_of(words, holds_rule) ? "no such command for a rule: " + name : std::string()};
    }
    const auto is_about = [&](const Subcommand& row) { return row.first == name; };
    const auto is_meant = [&](const Subcommand& row) {
      return is_about(row) && words.size() > 1 && IsBeginningOf(words[1].text, row.second);
    };
    if (std::ranges::any_of(kRuleWords, is_about) && std::ranges::none_of(kRuleWords, is_meant)) return {false, {}};
    return {};
  }
  const bool is_recorded = source_ == Source::kRecording;
  const bool is_library = name == "load" && words.size() > 1 && IsBeginningOf(words[1].text, "library");
  const bool is_allowed = (IsIn(kAllowed, name) && !is_library) || (is_recorded && IsIn(kAllowedInRecordings, name));
  if (is_allowed && !OpensFile(words)) return {};
  const std::string what = is_allowed ? "open files with '" + name + "'" : "use '" + name + "'";
  if (is_recorded)
    return {false, "Commands of a recording, of a file of inputs or of a page in a browser may not " + what +
                       ". You can type it in a shell or window of your own."};
  return {false, "The files of a scenario may not " + what + ". Type it yourself, or in a debugger."};
}

}  // namespace soarbox::cli
