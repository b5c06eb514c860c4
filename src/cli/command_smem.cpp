// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "cli/command.h"
#include "cli/interpreter.h"
#include "cli/knowledge_printer.h"
#include "cli/lookup.h"
#include "cli/memory_database.h"
#include "cli/session.h"
#include "cli/setting_store.h"
#include "cli/smem_tables.h"
#include "cli/summary.h"
#include "kernel/agent.h"
#include "kernel/longterm/knowledge_reader.h"
#include "kernel/longterm/long_term.h"
#include "kernel/longterm/semantic_memory.h"

namespace soarbox::cli {
namespace {

constexpr LongTermMemory kSemantic{"smem", "SMem", "SMem", "semantic", journal::Memory::kSemantic};
constexpr auto kSmemOptional = OptionArgument::kOptional;

constexpr OptionSpec kSmemTable[] = {
    {'a', "add", kSmemOptional, "add objects"},
    {'b', "backup", kSmemOptional, "copy the database"},
    {'c', "clear", OptionArgument::kNone, "forget everything"},
    {'e', "enable", OptionArgument::kNone, "switch on"},
    {'e', "on"},
    {'d', "disable", OptionArgument::kNone, "switch off"},
    {'d', "off"},
    {'g', "get", kSmemOptional, "show a setting"},
    {'h', "history", kSmemOptional, "when an object was used"},
    {'i', "init", OptionArgument::kNone, "open the database again"},
    {'P', "precalculate", OptionArgument::kNone,
     "refused as by Soar 9.6.3; spreading is worked out when it is asked for"},
    {'q', "query", kSmemOptional, "find objects"},
    {'r', "remove", kSmemOptional, "remove objects or their elements"},
    {'s', "set", kSmemOptional, "change a setting"},
    {'S', "stats", kSmemOptional, "figures"},
    {'t', "timers", kSmemOptional, "times"},
    {'x', "export", kSmemOptional, "write everything as commands"},
};

using kernel::SemanticMemory;

SemanticMemory& MemoryOf(CommandCall& call) {
  return SemanticMemory::Of(call.agent().long_term());
}

kernel::SoarVersion LikeOf(CommandCall& call) {
  return call.agent().settings().like;
}

// Settings ------------------------------------------------------------------------------------------------------------

/// Parses numbers separated by commas, as `base-incremental-threshes` prints them.
std::vector<std::uint64_t> Numbers(const std::string& text) {
  std::vector<std::uint64_t> numbers;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    const std::size_t first = text.find_first_not_of(' ', at);
    if (const auto number = ParseInteger(text.substr(first, end - first)); number && *number > 0) {
      numbers.push_back(static_cast<std::uint64_t>(*number));
    }
    at = end + 1;
  }
  return numbers;
}

/// Applies the texts of the settings to the memory.
void Apply(CommandCall& call) {
  const SettingStore& store = call.session.settings();
  SemanticMemory& memory = MemoryOf(call);
  kernel::SmemSettings& settings = memory.mutable_settings();
  const auto text = [&](std::string_view name) { return store.Get("smem", name); };
  const auto real = [&](std::string_view name) { return ParseDouble(text(name)).value_or(0); };
  const auto whole = [&](std::string_view name) {
    return static_cast<std::uint64_t>(ParseInteger(text(name)).value_or(0));
  };
  settings.enabled = store.IsOn("smem", "learning");
  const std::string mode = text("activation-mode");
  settings.activation_mode = mode == "base-level"  ? kernel::ActivationMode::kBaseLevel
                             : mode == "frequency" ? kernel::ActivationMode::kFrequency
                                                   : kernel::ActivationMode::kRecency;
  settings.initial_number = std::max<std::uint64_t>(whole("initial-variable-id"), 1);
  settings.activate_on_query = store.IsOn("smem", "activate-on-query");
  settings.base_decay = real("base-decay");
  const std::string policy = text("base-update-policy");
  settings.base_update_policy = policy == "naive"         ? kernel::BaseUpdatePolicy::kNaive
                                : policy == "incremental" ? kernel::BaseUpdatePolicy::kIncremental
                                                          : kernel::BaseUpdatePolicy::kStable;
  settings.base_incremental_threshes = Numbers(text("base-incremental-threshes"));
  settings.thresh = whole("thresh");
  settings.base_unused_age_offset = real("base-unused-age-offset");
  settings.base_inhibition = store.IsOn("smem", "base-inhibition");
  settings.spreading = store.IsOn("smem", "spreading");
  settings.spreading_limit = whole("spreading-limit");
  settings.spreading_depth_limit = whole("spreading-depth-limit");
  settings.spreading_baseline = real("spreading-baseline");
  settings.spreading_continue_probability = real("spreading-continue-probability");
  settings.spreading_loop_avoidance = store.IsOn("smem", "spreading-loop-avoidance");
  settings.spreading_edge_updating = store.IsOn("smem", "spreading-edge-updating");
  settings.spreading_wma_source = store.IsOn("smem", "spreading-wma-source");
  settings.spreading_edge_update_factor = real("spreading-edge-update-factor");
  memory.SettingsChanged();
}

// The database --------------------------------------------------------------------------------------------------------

/// Replaces the contents of the memory by those of the file, which stores changes from now on.
Result<void> OpenFile(SemanticMemory& memory, const Database& database) {
  memory.SetJournal(nullptr);
  memory.Clear();
  return LoadFrom(memory, database, kSemantic.kind);
}

/// Lets the memory open its file when it is used the next time, by a command or in a run.
void OpenLater(CommandCall& call) {
  SemanticMemory& memory = MemoryOf(call);
  const Database database = DatabaseOf(call, kSemantic);
  if (!database.is_file || database.path.empty()) {
    memory.SetOpener(nullptr);
    return;
  }
  memory.SetOpener([database](SemanticMemory& opened) { return OpenFile(opened, database); });
}

/// Opens the memory for a command that uses it. If its file cannot be opened, fails the command and returns false.
bool Use(CommandCall& call) {
  SemanticMemory& memory = MemoryOf(call);
  if (memory.opened()) return true;
  const Database database = DatabaseOf(call, kSemantic);
  memory.SetOpener(nullptr);
  memory.EnsureOpen();
  if (!database.is_file) return true;
  if (database.path.empty()) return true;
  const Result<void> result = OpenFile(memory, database);
  if (result) return true;
  memory.NoteClosed();
  OpenLater(call);  // The next run tries it again, and reports the problem too.
  return FailWith(call, result.error());
}

bool Init(CommandCall& call) {
  SemanticMemory& memory = MemoryOf(call);
  const bool was_file = memory.journal() != nullptr;
  const Database database = DatabaseOf(call, kSemantic);
  memory.Keep();
  memory.SetOpener(nullptr);
  if (database.is_file) {
    const Result<void> result = OpenFile(memory, database);
    if (!result) {
      memory.NoteClosed();
      return FailWith(call, result.error());
    }
  } else if (was_file) {
    memory.SetJournal(nullptr);
    memory.Clear();
  }
  memory.EnsureOpen();
  call.Out("Semantic memory system re-initialized.\n");
  if (call.session.settings().IsOn("smem", "append")) {
    call.Out(
        "Note: Since append mode is on, smem --init does not clear the database.\n"
        "      Use smem --clear to clear the contents.\n");
  }
  return true;
}

bool GetSmemParameter(CommandCall& call, const std::string& name) {
  if (!SettingStore::Find("smem", name)) {
    return call.Fail("Invalid semantic memory parameter.  Use 'help smem' to see list of valid settings.");
  }
  call.Out(fmt::format("{} is {}\n", name, call.session.settings().Get("smem", name)));
  return true;
}

/// The list after a number was added, or removed if it was there. Empty if the value is not a number above 0; a blank
/// if the list has no numbers.
std::string Toggled(const std::string& list, const std::string& value) {
  const auto number = ParseInteger(value);
  if (!number || *number <= 0) return {};
  std::vector<std::uint64_t> numbers = Numbers(list);
  const auto wanted = static_cast<std::uint64_t>(*number);
  if (std::erase(numbers, wanted) == 0) numbers.push_back(wanted);
  std::ranges::sort(numbers);
  std::string text;
  for (const std::uint64_t one : numbers) text += (text.empty() ? "" : ", ") + std::to_string(one);
  return text.empty() ? " " : text;
}

bool SetSmemParameter(CommandCall& call, const ParsedWords& parsed) {
  const std::string name = *parsed.Argument('s');
  std::string value;
  if (parsed.arguments.empty()) return call.Fail("Too few arguments.");
  value = parsed.arguments.front().text;
  SettingStore& store = call.session.settings();
  SemanticMemory& memory = MemoryOf(call);
  if (name == "spreading" && store.Get("smem", "activation-mode") != "base-level") {
    return call.Fail(
        "Spreading activation cannot be turned on until the 'activation-mode' is also set to base-level.\n"
        "Run 'smem --set activation-mode base-level' first if you intend to use spreading.");
  }
  if (name == "activation-mode" && store.IsOn("smem", "spreading")) {
    const std::string kept = store.Get("smem", name);
    if (store.Set("smem", name, value) == SettingStore::SetResult::kOk) {
      store.Set("smem", name, kept);
      return call.Fail("activation-mode cannot be changed while spreading activation is on.");
    }
  }
  if (name == "initial-variable-id") {
    const std::int64_t number = ParseLeadingInteger(value).value_or(0);
    if (number < 1) return call.Fail("The id counter must be at least 1.");
    // For an open memory, the setting is not changed, only the number of the next object.
    if (!memory.opened() && store.Set("smem", name, value) != SettingStore::SetResult::kOk) {
      return call.Fail("Invalid setting for SMem parameter.");
    }
    Apply(call);
    memory.SetNextNumber(static_cast<kernel::Lti>(number));
    call.Out(fmt::format("{} is now {}\n", name, value));
    return true;
  }
  std::string kept = value;
  if (name == "base-incremental-threshes") {
    kept = Toggled(store.Get("smem", name), value);
    if (kept.empty()) return call.Fail("Invalid setting for SMem parameter.");
  }
  const bool is_place = name == "path" || name == "database";
  if (!MayTake(call, name, value)) return false;
  constexpr std::string_view kClosedOnly[] = {"thresh", "cache-size", "page-size", "lazy-commit", "optimization"};
  const std::string before = store.Get("smem", name);
  if (!Store(call, kSemantic, name, kept, memory.opened(), kClosedOnly)) return false;
  constexpr std::string_view kFixed[] = {
      "spreading-baseline",       "spreading-depth-limit",          "spreading-limit",
      "spreading-loop-avoidance", "spreading-continue-probability", "spreading-wma-source"};
  if (store.IsOn("smem", "spreading") && std::ranges::find(kFixed, name) != std::end(kFixed)) {
    store.Set("smem", name, before);
    return call.Fail(
        "Some spreading activation settings cannot be changed once spreading activation has been turned on.");
  }
  Apply(call);
  call.Out(fmt::format("{} is now {}\n", name, value));
  if (is_place || name == "append" || name == "optimization") {
    if (!memory.opened()) {
      OpenLater(call);
    } else if (is_place) {
      call.Out("To finalize database switch, issue an smem --init command.\n");
    }
  }
  if (name == "append" && value == "off") WarnOfAppend(call, kSemantic);
  return true;
}

bool SwitchSmem(CommandCall& call, bool on) {
  call.session.settings().Set("smem", "learning", std::string(OnOff(on)));
  Apply(call);
  call.Out(fmt::format("Semantic memory {}.\n", on ? "enabled" : "disabled"));
  return true;
}

// Knowledge -----------------------------------------------------------------------------------------------------------

bool Add(CommandCall& call, const std::string& text) {
  if (!Use(call)) return false;
  std::string notes;
  const std::string problem = kernel::AddKnowledge(MemoryOf(call), text, notes);
  MemoryOf(call).Keep();
  call.Out(notes);
  if (!problem.empty()) return call.Fail(problem);
  call.Out("Knowledge added to semantic memory.\n");
  return true;
}

bool Query(CommandCall& call, const std::string& text, const ParsedWords& parsed) {
  std::size_t limit = 1;
  if (!parsed.arguments.empty()) {
    const auto number = ParseLeadingInteger(parsed.arguments.front().text);
    if (number) limit = static_cast<std::size_t>(std::max<std::int64_t>(*number, 0));
  }
  if (!Use(call)) return false;
  SemanticMemory& memory = MemoryOf(call);
  kernel::Cue cue;
  const std::string problem = kernel::ReadQuery(memory, text, cue);
  if (!problem.empty()) return call.Fail(problem);
  const std::vector<std::uint32_t> found = memory.Search(cue, limit);
  for (const std::uint32_t object : found) call.Out(ObjectLine(memory, object, LikeOf(call), 1.0));
  call.Out(found.empty() ? "SMem| No results for query." : "");
  call.Out("\nSMem| Query complete.\n");
  return true;
}

bool Remove(CommandCall& call, const std::string& text, const ParsedWords& parsed) {
  const bool force = !parsed.arguments.empty() && parsed.arguments.front().text == "force";
  if (!Use(call)) return false;
  bool failed = false;
  const std::string errors = kernel::RemoveKnowledge(MemoryOf(call), text, force, failed);
  MemoryOf(call).Keep();
  if (failed) return call.Fail("Error while attempting removal.\n" + errors);
  call.Out("\n" + errors + "\nSMem| Removal complete.\n");
  return true;
}

bool Clear(CommandCall& call) {
  if (!MemoryOf(call).opened()) {
    call.Out("Semantic memory is not enabled. Could not clear.\n");
    return call.FailPrinted();
  }
  MemoryOf(call).Clear();
  MemoryOf(call).Keep();
  call.Out("Semantic memory system cleared.\n");
  return true;
}

bool Export(CommandCall& call, const std::string& file, const ParsedWords& parsed) {
  std::filesystem::path path;
  if (!call.interpreter.ResolveForWriting(call, file, path) || !Use(call)) return false;
  const SemanticMemory& memory = MemoryOf(call);
  std::optional<std::uint32_t> root;
  if (!parsed.arguments.empty()) {
    const std::string& name = parsed.arguments.front().text;
    const kernel::Lti number = kernel::ObjectNamed(memory, name);
    if (number == 0) return call.Fail("LTI not found.");
    root = memory.knowledge().Find(number);
  }
  std::ofstream out(path, std::ios::binary | std::ios::trunc);
  out << ExportText(memory, root, LikeOf(call));
  out.close();
  if (!out) return call.Fail("The file '" + file + "' cannot be written.");
  call.Out("Exported semantic memory to file '" + file + "'.\n");
  return true;
}

bool BackUpKnowledge(CommandCall& call, const std::string& file) {
  std::filesystem::path path;
  if (!call.interpreter.ResolveForWriting(call, file, path) || !Use(call)) return false;
  return BackUp(call, kSemantic, MemoryOf(call), path, file);
}

bool History(CommandCall& call, const std::string& name) {
  if (!Use(call)) return false;
  const SemanticMemory& memory = MemoryOf(call);
  const kernel::Lti number = kernel::ObjectNamed(memory, name);
  if (number == 0) return call.Fail("LTI not found.");
  call.Out(ObjectLine(memory, memory.knowledge().Find(number), LikeOf(call)) + "\n");
  return true;
}

bool Stats(CommandCall& call, const std::string& name) {
  if (name.empty()) {
    call.Out(SmemStatistics(call.session));
    return true;
  }
  const std::string value = SmemStatistic(call.session, name);
  if (value.empty()) return call.Fail("Invalid statistic.");
  call.Out(" " + value + "\n");
  return true;
}

bool SmemTimers(CommandCall& call, std::string_view wanted) {
  constexpr std::string_view kNames[] = {
      "_total",          "smem_api",        "smem_hash",       "smem_init",       "smem_ncb_retrieval",
      "smem_query",      "smem_storage",    "spreading",       "spreading-1",     "spreading-2",
      "spreading-3",     "spreading-4",     "spreading-5",     "spreading-6",     "spreading-7",
      "spreading-7-1",   "spreading-7-2",   "spreading-7-2-1", "spreading-7-2-2", "spreading-7-2-3",
      "spreading-7-2-4", "spreading-7-2-5", "spreading-7-2-6", "spreading-7-2-7", "spreading-7-2-8",
      "spreading-wma-1", "spreading-wma-2", "spreading-wma-3", "three_activation"};
  return ShowTimers(call, "         Semantic Memory Timers         ", kNames, wanted);
}

/// Reads the argument of an option. Fails the command if there is none.
bool TextOf(CommandCall& call, const ParsedWords& parsed, char letter, std::string& text) {
  if (const auto argument = parsed.Argument(letter)) {
    text = *argument;
    return true;
  }
  return call.Fail("Too few arguments.");
}

}  // namespace

const std::span<const OptionSpec> kSmemOptions = kSmemTable;

bool CommandSmem(CommandCall& call) {
  if (call.words.size() == 2 && (call.words[1].text == "?" || call.words[1].text == "help")) {
    call.Out(SmemHelpTable(call.session.settings()));
    return true;
  }
  ParsedWords parsed;
  if (!call.Parse(kSmemTable, parsed)) return false;
  if (parsed.options.empty()) {
    if (!parsed.arguments.empty()) return call.Fail("Too many arguments.");
    call.Out(SmemSummary(call.session));
    return true;
  }
  std::string text;
  const char letter = parsed.options.front().letter;
  // Number of words that an option accepts after its own argument.
  const std::size_t most = letter == 's' || letter == 'q' || letter == 'r' || letter == 'x' ? 1 : 0;
  if (parsed.arguments.size() > most) return call.Fail("Too many arguments.");
  switch (letter) {
    case 'g':
      return TextOf(call, parsed, letter, text) && GetSmemParameter(call, text);
    case 's':
      return TextOf(call, parsed, letter, text) && SetSmemParameter(call, parsed);
    case 'e':
      return SwitchSmem(call, true);
    case 'd':
      return SwitchSmem(call, false);
    case 'a':
      return TextOf(call, parsed, letter, text) && Add(call, text);
    case 'q':
      return TextOf(call, parsed, letter, text) && Query(call, text, parsed);
    case 'r':
      return TextOf(call, parsed, letter, text) && Remove(call, text, parsed);
    case 'c':
      return Clear(call);
    case 'i':
      return Init(call);
    case 'x':
      return TextOf(call, parsed, letter, text) && Export(call, text, parsed);
    case 'b':
      return TextOf(call, parsed, letter, text) && BackUpKnowledge(call, text);
    case 'h':
      return TextOf(call, parsed, letter, text) && History(call, text);
    case 'S':
      return Stats(call, parsed.Argument('S').value_or(""));
    case 't':
      return SmemTimers(call, parsed.Argument('t').value_or(""));
    default:
      break;
  }
  // Soar 9.6.3 parses --precalculate but rejects it. Spreading is computed when it is needed.
  return call.Fail("Unknown option.");
}

}  // namespace soarbox::cli
