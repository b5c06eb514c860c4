// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <tuple>

#include "cli/command.h"
#include "cli/episode_text.h"
#include "cli/interpreter.h"
#include "cli/lookup.h"
#include "cli/memory_database.h"
#include "cli/session.h"
#include "cli/setting_store.h"
#include "cli/summary.h"
#include "journal/sqlite_journal.h"
#include "kernel/agent.h"
#include "kernel/longterm/episodic_memory.h"
#include "kernel/longterm/long_term.h"

namespace soarbox::cli {
namespace {

using kernel::EpisodicMemory;
using kernel::EpisodicSettings;
constexpr LongTermMemory kEpisodic{"epmem", "epmem", "EpMem", "episodic", journal::Memory::kEpisodic};
constexpr auto kEpmemOptional = OptionArgument::kOptional;

constexpr OptionSpec kEpmemTable[] = {
    {'b', "backup", kEpmemOptional, "copy the database"},
    {'c', "close", OptionArgument::kNone, "close the database"},
    {'e', "enable", OptionArgument::kNone, "switch on"},
    {'e', "on"},
    {'d', "disable", OptionArgument::kNone, "switch off"},
    {'d', "off"},
    {'g', "get", kEpmemOptional, "show a setting"},
    {'i', "init", OptionArgument::kNone, "forget all episodes"},
    {'p', "print", kEpmemOptional, "show an episode"},
    {'s', "set", kEpmemOptional, "change a setting"},
    {'S', "stats", kEpmemOptional, "figures"},
    {'t', "timers", kEpmemOptional, "times"},
    {'v', "viz", kEpmemOptional, "an episode as a graph"},
};

EpisodicMemory& Memory(CommandCall& call) {
  return EpisodicMemory::Of(call.agent().long_term());
}

std::string Exclusions(const EpisodicMemory& memory) {
  std::string text;
  for (const std::string& name : memory.settings().exclusions) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// Updates the stored setting `force`: the kernel obeys it once and then resets it.
void Refresh(CommandCall& call) {
  const EpisodicMemory* memory = EpisodicMemory::Find(call.agent().long_term());
  if (memory == nullptr) return;
  SettingStore& store = call.session.settings();
  if (memory->settings().force == EpisodicSettings::Force::kOff) store.Set("epmem", "force", "off");
}

bool GetEpmemParameter(CommandCall& call, const std::string& name) {
  if (!SettingStore::Find("epmem", name)) {
    return call.Fail("Invalid epmem parameter.");
  }
  Refresh(call);
  call.Out(fmt::format("{} is {}\n", name, call.session.settings().Get("epmem", name)));
  return true;
}

/// Sets the file that the memory uses when it is opened the next time.
void ApplyDatabase(CommandCall& call) {
  const Database database = DatabaseOf(call, kEpisodic);
  if (!database.is_file || database.path.empty()) {
    Memory(call).SetOpener(nullptr, false);
    return;
  }
  const auto open = [database](EpisodicMemory& memory) {
    memory.SetJournal(nullptr);
    return LoadFrom(memory, database, kEpisodic.kind);
  };
  Memory(call).SetOpener(open, !database.options.overwrite);
}

/// Opens the memory for a command that uses it. If its file cannot be opened, fails the command and returns false.
bool Use(CommandCall& call) {
  const Result<void> opened = Memory(call).TryOpen();
  return opened || FailWith(call, opened.error());
}

bool InitEpisodes(CommandCall& call) {
  Memory(call).Close();
  if (!Use(call)) return false;
  call.Out("Episodic memory system re-initialized.\n");
  return true;
}

bool BackUpEpisodes(CommandCall& call, const std::string& file) {
  std::filesystem::path path;
  if (!call.interpreter.ResolveForWriting(call, file, path) || !Use(call)) return false;
  return BackUp(call, kEpisodic, Memory(call), path, file);
}

/// Applies a stored setting to the kernel.
void Apply(CommandCall& call, std::string_view name) {
  EpisodicMemory& memory = Memory(call);
  EpisodicSettings& settings = memory.mutable_settings();
  const SettingStore& store = call.session.settings();
  const std::string value = store.Get("epmem", name);
  const bool on = value == "on";
  if (name == "learning") {
    memory.SetLearning(on);
  } else if (name == "phase") {
    settings.phase = value == "output" ? EpisodicSettings::Phase::kOutput : EpisodicSettings::Phase::kSelection;
  } else if (name == "trigger") {
    settings.trigger = value == "none"     ? EpisodicSettings::Trigger::kNone
                       : value == "output" ? EpisodicSettings::Trigger::kOutput
                                           : EpisodicSettings::Trigger::kDecision;
  } else if (name == "force") {
    settings.force = value == "remember" ? EpisodicSettings::Force::kRemember
                     : value == "ignore" ? EpisodicSettings::Force::kIgnore
                                         : EpisodicSettings::Force::kOff;
  } else if (name == "balance") {
    settings.balance = std::strtod(value.c_str(), nullptr);
  } else if (name == "graph-match") {
    settings.graph_match = on;
  } else if (name == "database" || name == "append" || name == "path" || name == "optimization") {
    ApplyDatabase(call);
  }
}

bool SetEpmemParameter(CommandCall& call, const ParsedWords& parsed) {
  const std::string name = *parsed.Argument('s');
  std::string value;
  if (parsed.arguments.empty()) return call.Fail("Too few arguments.");
  value = parsed.arguments.front().text;
  SettingStore& store = call.session.settings();
  if (name == "exclusions") {
    Memory(call).ToggleExclusion(value);
    call.Out("exclusions is now " + value + "\n");
    return store.Set("epmem", name, Exclusions(Memory(call))) == SettingStore::SetResult::kOk;
  }
  constexpr std::string_view kClosedOnly[] = {"cache-size", "page-size", "lazy-commit", "optimization"};
  if (!MayTake(call, name, value) || !Store(call, kEpisodic, name, value, Memory(call).opened(), kClosedOnly))
    return false;
  Apply(call, name);
  call.Out(fmt::format("{} is now {}\n", name, value));
  if ((name == "path" || name == "database") && Memory(call).opened()) {
    call.Out("To finalize episodic memory database switch, issue an epmem --init command.\n");
  }
  if (name == "append" && value == "off") WarnOfAppend(call, kEpisodic);
  return true;
}

bool SwitchEpmem(CommandCall& call, bool on) {
  call.session.settings().Set("epmem", "learning", std::string(OnOff(on)));
  Apply(call, "learning");
  call.Out(fmt::format("Episodic memory {}.\n", on ? "enabled" : "disabled"));
  return true;
}

bool Statistics(CommandCall& call, std::string_view wanted) {
  const EpisodicMemory& memory = Memory(call);
  const kernel::EpisodicCounters& counters = memory.counters();
  const std::string bytes = std::to_string(memory.MemoryBytes());
  const std::tuple<std::string_view, std::string_view, std::string> rows[] = {
      {"time", "Time", std::to_string(memory.time())},
      {"db-lib-version", "SQLite Version", std::string(journal::SqliteVersion())},
      {"mem-usage", "Memory Usage", bytes},
      {"mem-high", "Memory Highwater", bytes},
      {"retrievals", "Retrievals", std::to_string(counters.retrievals)},
      {"queries", "Queries", std::to_string(counters.queries)},
      {"nexts", "Nexts", std::to_string(counters.nexts)},
      {"prevs", "Prevs", std::to_string(counters.previous)},
      {"ncb-wmes", "Last Retrieval WMEs", std::to_string(counters.last_retrieval_wmes)},
      {"qry-pos", "Last Query Positive", std::to_string(counters.query_positive)},
      {"qry-neg", "Last Query Negative", std::to_string(counters.query_negative)},
      {"qry-ret", "Last Query Retrieved", std::to_string(counters.query_retrieved)},
      {"qry-card", "Last Query Cardinality", std::to_string(counters.query_cardinality)},
      {"qry-lits", "Last Query Literals", std::to_string(counters.query_literals)},
  };
  if (!wanted.empty()) {
    for (const auto& [name, title, value] : rows) {
      if (name != wanted) continue;
      call.Out(fmt::format(" {}\n", value));
      return true;
    }
    return call.Fail("Invalid statistic.");
  }
  Summary summary(40);
  summary.Rule('=').Text("       Episodic Memory Statistics       \n").Rule('=');
  for (const auto& [name, title, value] : rows) summary.Row(std::string(title) + ":", value);
  call.Out(summary.Take());
  return true;
}

bool EpmemTimers(CommandCall& call, std::string_view wanted) {
  constexpr std::string_view kNames[] = {"_total",
                                         "epmem_api",
                                         "epmem_hash",
                                         "epmem_init",
                                         "epmem_ncb_retrieval",
                                         "epmem_next",
                                         "epmem_prev",
                                         "epmem_query",
                                         "epmem_storage",
                                         "epmem_trigger",
                                         "epmem_wm_phase",
                                         "ncb_edge",
                                         "ncb_edge_rit",
                                         "ncb_node",
                                         "ncb_node_rit",
                                         "query_cleanup",
                                         "query_dnf",
                                         "query_graph_match",
                                         "query_result",
                                         "query_sql_edge",
                                         "query_sql_end_ep",
                                         "query_sql_end_now",
                                         "query_sql_end_point",
                                         "query_sql_start_ep",
                                         "query_sql_start_now",
                                         "query_sql_start_point",
                                         "query_walk",
                                         "query_walk_edge",
                                         "query_walk_interval"};
  return ShowTimers(call, "         Episodic Memory Timers         ", kNames, wanted);
}

/// The number of an episode, or 0 if the word is not the number of an existing one.
kernel::EpisodeNumber EpisodeOf(CommandCall& call, const std::string& word) {
  const auto number = ParseInteger(word);
  const EpisodicMemory& memory = Memory(call);
  if (!number || *number < 1 || *number > memory.store().last()) return 0;
  return static_cast<kernel::EpisodeNumber>(*number);
}

bool PrintEpisode(CommandCall& call, const std::string& word) {
  const kernel::EpisodeNumber episode = EpisodeOf(call, word);
  if (!ParseInteger(word)) return call.Fail("Invalid epmem time tag.");
  if (episode == 0) return call.Fail("Invalid episode.");
  Summary summary(40);
  const std::string title = fmt::format("Episode {}", word);
  summary.Rule('=').Text(fmt::format("{:^40}\n", title)).Rule('=');
  call.Out(summary.Take() + EpisodeText(Memory(call), episode) + "\n");
  return true;
}

bool DrawEpisode(CommandCall& call, const std::string& word) {
  const kernel::EpisodeNumber episode = EpisodeOf(call, word);
  if (!ParseInteger(word)) return call.Fail("Invalid epmem time tag.");
  if (episode == 0) return call.Fail("Invalid episode.");
  call.Out(EpisodeGraph(Memory(call), episode));
  return true;
}

void Heading(Summary& summary, std::string_view title, int width) {
  const int free = width - static_cast<int>(title.size()) - 2;
  const int left = free / 2;
  summary.Text(std::string(static_cast<std::size_t>(left), '-') + " " + std::string(title) + " " +
               std::string(static_cast<std::size_t>(free - left), '-') + "\n");
}

bool EpmemOverview(CommandCall& call) {
  Refresh(call);
  const SettingStore& store = call.session.settings();
  Summary summary(40);
  const auto rows = [&](std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names) summary.Row(std::string(name) + ":", store.Get("epmem", name));
  };
  summary.Rule('=').Text("        Episodic Memory Settings        \n").Rule('=');
  rows({"learning"});
  Heading(summary, "Encoding", 40);
  rows({"phase", "trigger", "force", "exclusions"});
  Heading(summary, "Storage", 40);
  rows({"database", "append", "path", "lazy-commit"});
  Heading(summary, "Retrieval", 40);
  rows({"balance", "graph-match", "graph-match-ordering"});
  Heading(summary, "Performance", 40);
  rows({"page-size", "cache-size", "optimization", "timers"});
  Heading(summary, "Experimental", 40);
  rows({"merge"});
  call.Out(summary.Take() + "\n");
  return true;
}

}  // namespace

const std::span<const OptionSpec> kEpmemOptions = kEpmemTable;

bool CommandEpmem(CommandCall& call) {
  if (call.words.size() == 2 && (call.words[1].text == "?" || call.words[1].text == "help"))
    return ShowHelp(call, "epmem");
  ParsedWords parsed;
  if (!call.Parse(kEpmemTable, parsed)) return false;
  if (parsed.options.empty()) {
    return parsed.arguments.empty() ? EpmemOverview(call) : call.Fail("Too many arguments, check syntax.");
  }
  const char letter = parsed.options.front().letter;
  if (parsed.arguments.size() > (letter == 's' ? 1u : 0u)) return call.Fail("Too many arguments.");
  const bool needs_word = letter == 'g' || letter == 's' || letter == 'b';
  if (needs_word && !parsed.Argument(letter)) return call.Fail("Too few arguments.");
  if (const auto name = parsed.Argument('g')) return GetEpmemParameter(call, *name);
  if (parsed.Has('s')) return SetEpmemParameter(call, parsed);
  if (parsed.Has('e')) return SwitchEpmem(call, true);
  if (parsed.Has('d')) return SwitchEpmem(call, false);
  if (parsed.Has('S')) return Statistics(call, parsed.Argument('S').value_or(""));
  if (parsed.Has('t')) return EpmemTimers(call, parsed.Argument('t').value_or(""));
  for (const char option : {'p', 'v'}) {
    if (!parsed.Has(option)) continue;
    const auto episode = parsed.Argument(option);
    if (!episode) return call.Fail("Too few arguments.");
    if (!Use(call)) return false;
    return option == 'p' ? PrintEpisode(call, *episode) : DrawEpisode(call, *episode);
  }
  if (parsed.Has('i')) return InitEpisodes(call);
  if (const auto file = parsed.Argument('b')) return BackUpEpisodes(call, *file);
  if (parsed.Has('c')) {
    Memory(call).Close();
    call.Out("Episodic memory database closed.\n");
    return true;
  }
  return call.Fail("Invalid syntax.");
}

}  // namespace soarbox::cli
