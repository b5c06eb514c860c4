// SPDX-License-Identifier: BSD-2-Clause
#include "cli/smem_tables.h"

#include <fmt/format.h>

#include "cli/setting_store.h"
#include "cli/summary.h"
#include "journal/sqlite_journal.h"
#include "kernel/agent.h"
#include "kernel/longterm/long_term.h"
#include "kernel/longterm/semantic_memory.h"

namespace soarbox::cli {
namespace {

/// A line of `smem ?`: a text, or a setting with its value.
struct HelpLine {
  std::string_view text;     ///< The line, or the words before the value.
  std::string_view setting;  ///< Its name; none for a line of text.
  std::string_view meaning = {};
};

constexpr HelpLine kHelp[] = {
    {"=======================================================", {}},
    {"-      Semantic Memory Sub-Commands and Options       -", {}},
    {"=======================================================", {}},
    {"enabled", "learning", ""},
    {"database", "database", "Store database in memory or file"},
    {"append", "append", "Append or overwrite after init"},
    {"path", "path", "Path to database on disk"},
    {"-------------------------------------------------------", {}},
    {"smem [? | help]                                           Print this help screen", {}},
    {"smem [--enable | --disable ]                              Enable/disable semantic memory", {}},
    {"smem [--get | --set]                 <option> [<value>]   Print or set value of an SMem parameter", {}},
    {"smem --add                        { (id ^attr value)* }   Add concepts to semantic memory", {}},
    {"smem --backup                                <filename>   Saves a copy of database", {}},
    {"smem --clear                                              Deletes all semantic knowledge", {}},
    {"smem --export                        <filename> [<LTI>]   Export database to text file", {}},
    {"smem --init                                               Reinitialize semantic memory store", {}},
    {"smem --query                           {(cue)* [<num>]}   Query for concepts in semantic store matching cue", {}},
    {"smem --remove                 { (id [^attr [value]])* }   Remove semantic memory structures", {}},
    {"------------------------ Printing ---------------------", {}},
    {"print                                                 @   Print all of semantic memory", {}},
    {"print                                             <LTI>   Print specific semantic memory", {}},
    {"smem --history                                    <LTI>   Print activation history for some LTM", {}},
    {"---------------------- Activation --------------------", {}},
    {"activation-mode", "activation-mode", "recency, frequency, base-level"},
    {"activate-on-query", "activate-on-query", "on, off"},
    {"base-decay", "base-decay", "Decay parameter for base-level activation computation"},
    {"base-update-policy", "base-update-policy", "stable, naive, incremental"},
    {"base-incremental-threshes", "base-incremental-threshes", "integer > 0"},
    {"thresh", "thresh", "integer >= 0"},
    {"base-inhibition", "base-inhibition", "on, off"},
    {"------------ Experimental Spreading Activation --------", {}},
    {"spreading", "spreading", "on, off"},
    {"spreading-limit", "spreading-limit", "integer > 0"},
    {"spreading-depth-limit", "spreading-depth-limit", "integer > 0"},
    {"spreading-baseline", "spreading-baseline", "1 > decimal > 0"},
    {"spreading-continue-probability", "spreading-continue-probability", "1 > decimal > 0"},
    {"spreading-loop-avoidance", "spreading-loop-avoidance", "on, off"},
    {"spreading-edge-updating", "spreading-edge-updating", "on, off"},
    {"spreading-wma-source", "spreading-wma-source", "on, off"},
    {"spreading-edge-update-factor", "spreading-edge-update-factor", "1 > decimal > 0"},
    {"------------- Database Optimization Settings ----------", {}},
    {"lazy-commit", "lazy-commit", "Delay writing semantic store until exit"},
    {"optimization", "optimization", "safety, performance"},
    {"cache-size", "cache-size", "Number of memory pages used for SQLite cache"},
    {"page-size", "page-size", "Size of each memory page used"},
    {"----------------- Timers and Statistics ---------------", {}},
    {"timers <detail>", "timers", "How detailed timers should be (use --set)"},
    {"smem --timers                                 [<timer>]   Print timer summary or specific statistic", {}},
    {"smem --stats                                   [<stat>]   Print statistic summary or specific statistic", {}},
    {"                  ---------------------", {}},
    {"Detail: off, one, two, three", {}},
    {"Timers: smem_api, smem_hash, smem_init, smem_query,", {}},
    {"        smem_ncb_retrieval, three_activation", {}},
    {"        smem_storage, _total", {}},
    {"Stats:  act_updates, db-lib-version, edges, mem-usage,", {}},
    {"        mem-high, nodes, queries, retrieves, stores", {}},
    {"-------------------------------------------------------", {}},
    {"", {}},
    {"For a detailed explanation of these settings:             help smem", {}},
};

const kernel::SemanticMemory* SessionMemory(Session& session) {
  return kernel::SemanticMemory::Find(session.agent().long_term());
}

}  // namespace

std::string SmemHelpTable(const SettingStore& settings) {
  std::string text;
  for (const HelpLine& line : kHelp) {
    if (line.setting.empty()) {
      text += fmt::format("{}\n", line.text);
      continue;
    }
    const std::string value = settings.Get("smem", line.setting);
    const std::size_t width = line.text.size() < 55 ? 55 - line.text.size() : 1;
    text += fmt::format("{}{:>{}}   {}\n", line.text, value, width, line.meaning);
  }
  return text;
}

std::string SmemSummary(Session& session) {
  const SettingStore& store = session.settings();
  const kernel::SemanticMemory* const memory = SessionMemory(session);
  Summary summary(52);
  const auto row = [&](std::string_view name, std::string_view value, std::string_view after) {
    summary.Text(fmt::format("{:<{}}{}   {}\n", name, 52 - value.size(), value, after));
  };
  summary.Rule('=').Text("              Semantic Memory Summary\n").Rule('=');
  row("Enabled", store.Get("smem", "learning"), "");
  row("Storage", store.Get("smem", "database") == "memory" ? "Memory" : "File",
      store.IsOn("smem", "append") ? "(append after init)" : "(overwrite after init)");
  summary.Rule('-');
  row("Nodes", std::to_string(memory == nullptr ? 0 : memory->knowledge().object_count()), "");
  row("Edges", std::to_string(memory == nullptr ? 0 : memory->knowledge().edge_count()), "");
  row("Memory Usage", std::to_string(memory == nullptr ? 0 : memory->MemoryBytes()), "bytes");
  summary.Rule('-');
  summary.Text("For a full list of smem's sub-commands and settings:  smem ?");
  return summary.Take();
}

std::string SmemStatistic(Session& session, const std::string& name) {
  const kernel::SemanticMemory* const memory = SessionMemory(session);
  const auto figure = [&](auto get) { return memory == nullptr ? std::string("0") : std::to_string(get(*memory)); };
  using Memory = kernel::SemanticMemory;
  if (name == "nodes") return figure([](const Memory& m) { return m.knowledge().object_count(); });
  if (name == "edges") return figure([](const Memory& m) { return m.knowledge().edge_count(); });
  if (name == "retrieves") return figure([](const Memory& m) { return m.counters().retrieves; });
  if (name == "queries") return figure([](const Memory& m) { return m.counters().queries; });
  if (name == "stores") return figure([](const Memory& m) { return m.counters().stores; });
  if (name == "act_updates") return figure([](const Memory& m) { return m.activations().updates(); });
  if (name == "mem-usage" || name == "mem-high") return figure([](const Memory& m) { return m.MemoryBytes(); });
  if (name == "spread-size") return figure([](const Memory& m) { return m.spread_size(); });
  if (name == "db-lib-version") return std::string(journal::SqliteVersion());
  return {};
}

std::string SmemStatistics(Session& session) {
  Summary summary(40);
  summary.Rule('=').Text("       Semantic Memory Statistics       \n").Rule('=');
  constexpr std::pair<std::string_view, std::string_view> kRows[] = {
      {"SQLite Version:", "db-lib-version"},
      {"Memory Usage:", "mem-usage"},
      {"Memory Highwater:", "mem-high"},
      {"Retrieves:", "retrieves"},
      {"Queries:", "queries"},
      {"Stores:", "stores"},
      {"Activation Updates:", "act_updates"},
      {"Nodes:", "nodes"},
      {"Edges:", "edges"},
      {"Spread Size:", "spread-size"},
  };
  for (const auto& [title, name] : kRows) summary.Row(title, SmemStatistic(session, std::string(name)));
  return summary.Take();
}

}  // namespace soarbox::cli
