// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <initializer_list>

#include "cli/command.h"
#include "cli/interpreter.h"
#include "cli/knowledge_printer.h"
#include "cli/load_image.h"
#include "cli/percepts.h"
#include "cli/printed_rule.h"
#include "cli/setting_store.h"
#include "cli/summary.h"
#include "kernel/decide/exploration.h"
#include "kernel/longterm/long_term.h"
#include "kernel/longterm/semantic_memory.h"

namespace soarbox::cli {
namespace {

/// The rules of these types, in the order of `print`.
std::string RulesText(const kernel::Agent& agent, std::initializer_list<kernel::ProductionType> types) {
  std::string text;
  for (const kernel::ProductionType type : types) {
    for (const kernel::ProductionId id : RulesOfType(agent, type)) {
      text += RuleText(agent, agent.production(id), false) + "\n";
    }
  }
  return text;
}

/// The settings of `chunk` that Soar always writes. Others are written only if they differ from their defaults.
constexpr std::string_view kAlwaysOfChunk[] = {"bottom-only",   "add-osk",    "allow-local-negations",
                                               "add-ltm-links", "max-chunks", "max-dupes"};

/// The commands that restore the settings: those that Soar writes, and all that differ from their defaults.
std::string SettingsText(CommandCall& call) {
  const kernel::AgentSettings& settings = call.agent().settings();
  const kernel::AgentSettings initial;
  const SettingStore& store = call.session.settings();
  std::string text = "chunk " + store.Get("chunk", "mode") + "\n";
  for (const std::string_view name : kAlwaysOfChunk)
    text += fmt::format("chunk {} {}\n", name, store.Get("chunk", name));
  text += fmt::format("soar max-elaborations {}\n", settings.max_elaborations);
  text += fmt::format("soar max-goal-depth {}\n", settings.max_goal_depth);
  text += fmt::format("soar wait-snc {}\n", OnOff(settings.wait_snc));
  if (settings.like != initial.like) text += fmt::format("soar like {}\n", TextOf(settings.like));

  const auto number = [&](std::string_view name, std::int64_t value, std::int64_t usual) {
    if (value != usual) text += fmt::format("soar {} {}\n", name, value);
  };
  number("max-nil-output-cycles", settings.max_nil_output_cycles, initial.max_nil_output_cycles);
  number("max-dc-time", settings.max_decision_time_us, initial.max_decision_time_us);
  number("max-gp", settings.max_gp, initial.max_gp);
  number("max-partial-matches", settings.max_partial_matches, initial.max_partial_matches);
  if (settings.keep_all_top_o_preferences) text += "soar keep-all-top-oprefs on\n";

  const kernel::ExplorationSettings& exploration = call.agent().exploration();
  constexpr const char* kPolicies[] = {"boltzmann", "epsilon-greedy", "softmax", "first", "last"};
  if (exploration.policy != kernel::ExplorationPolicy::kSoftmax) {
    text += fmt::format("decide indifferent-selection --{}\n", kPolicies[static_cast<int>(exploration.policy)]);
  }
  if (exploration.average_numbers) text += "decide numeric-indifferent-mode --avg\n";
  const auto parameter = [&](std::string_view name, double value, double usual) {
    if (value != usual) text += fmt::format("decide indifferent-selection --{} {}\n", name, Shortest(value));
  };
  parameter("epsilon", exploration.epsilon.value, 0.1);
  parameter("temperature", exploration.temperature.value, 25);
  for (const SettingStore::Changed& changed : store.Differences()) {
    if (changed.group == "chunk" && (changed.name == "mode" || std::ranges::count(kAlwaysOfChunk, changed.name) > 0)) {
      continue;
    }
    if (changed.group == "chunk" || changed.group == "explain" || changed.group == "visualize" ||
        changed.group == "soar") {
      text += fmt::format("{} {} {}\n", changed.group, changed.name, QuoteWord(changed.value));
    } else if (changed.name == "apoptosis-thresh") {
      // The command takes the threshold without its sign.
      text += fmt::format("rl --set apoptosis-thresh {}\n", changed.value.substr(1));
    } else {
      text += fmt::format("{} --set {} {}\n", changed.group, changed.name, QuoteWord(changed.value));
    }
  }
  return text;
}

bool Write(CommandCall& call, const std::string& file, const std::string& text) {
  std::filesystem::path path;
  if (!call.interpreter.ResolveForWriting(call, file, path)) return false;
  std::ofstream out(path, std::ios::binary | std::ios::trunc);
  out << text;
  out.close();
  if (!out) return call.Fail("Failed to open file for writing: " + file);
  return true;
}

bool SaveAgent(CommandCall& call) {
  if (call.words.size() != 2) return call.Fail("Syntax: save agent <filename>");
  using kernel::ProductionType;
  const std::string rules = RulesText(call.agent(), {ProductionType::kDefault, ProductionType::kUser,
                                                     ProductionType::kTemplate, ProductionType::kChunk});
  const kernel::SemanticMemory& memory = kernel::SemanticMemory::Of(call.agent().long_term());
  const bool has_facts = memory.knowledge().object_count() > 0;
  // Soar also writes this line if semantic memory is on but empty.
  const std::string facts = has_facts
                                ? "# Semantic Memory\n\n" + ExportText(memory, {}, call.agent().settings().like) + "\n"
                                : "# Semantic memory is not enabled.  Did not save.\n";
  const std::string text =
      fmt::format("# Settings\n\n{}\n# Procedural Memory\n\n{}\n\n{}", SettingsText(call), rules, facts);
  if (!Write(call, call.words[1].text, text)) return false;
  call.Out("Procedural memory, semantic memory and settings written to file.\n");
  return true;
}

bool SaveChunks(CommandCall& call) {
  if (call.words.size() != 2) return call.Fail("Syntax: save chunks <filename>");
  const std::string& file = call.words[1].text;
  if (!Write(call, file, RulesText(call.agent(), {kernel::ProductionType::kChunk}))) return false;
  call.Out("Chunks written to file " + file + ".\n");
  return true;
}

constexpr OptionSpec kPerceptsOptions[] = {
    {'o', "open", OptionArgument::kRequired, "the file"},
    {'c', "close", OptionArgument::kNone, "end the recording"},
    {'f', "flush", OptionArgument::kNone, "write out what is recorded"},
};

bool SavePercepts(CommandCall& call) {
  ParsedWords parsed;
  if (!call.Parse(kPerceptsOptions, parsed)) return false;
  if (!parsed.arguments.empty()) return call.Fail("Syntax: save percepts [--open <filename> | --close | --flush]");
  std::unique_ptr<PerceptRecorder>& recorder = call.session.percept_recorder();
  if (parsed.Has('o')) {
    const std::string file = *parsed.Argument('o');
    if (recorder) return call.Fail("Input is being recorded already: end that with 'save percepts --close'.");
    if (call.session.percept_player()) {
      return call.Fail("Input is being replayed: end that with 'load percepts --close' before recording.");
    }
    std::filesystem::path path;
    if (!call.interpreter.ResolveForWriting(call, file, path)) return false;
    auto opened = std::make_unique<PerceptRecorder>(call.agent(), path.string());
    if (!opened->good()) return call.Fail("Failed to open file for writing: " + file);
    recorder = std::move(opened);
    call.Out(fmt::format("Capturing input with random seed: {}", recorder->seed()));
    return true;
  }
  if (!parsed.Has('c') && !parsed.Has('f')) {
    call.Out(recorder ? "open" : "closed");
    return true;
  }
  if (!recorder) return call.Fail("Input is not being recorded: begin with 'save percepts --open FILE'.");
  if (parsed.Has('f')) {
    recorder->Flush();
    if (!recorder->good()) return call.Fail("The recorded input could not be written: the disk may be full.");
  }
  if (parsed.Has('c')) {
    const bool written = recorder->Close();
    const std::uint64_t changes = recorder->changes();
    recorder.reset();
    if (!written) return call.Fail("The recorded input could not be written: the disk may be full.");
    call.Out(fmt::format("Captured {} actions.", changes));
  }
  return true;
}

constexpr OptionSpec kReteOptions[] = {{'s', "save", OptionArgument::kRequired, "the file"},
                                       {'l', "load", OptionArgument::kRequired, "read an image instead"}};

bool SaveRete(CommandCall& call) {
  ParsedWords parsed;
  if (!call.Parse(kReteOptions, parsed)) return false;
  const std::optional<std::string> load = parsed.Argument('l'), file = parsed.Argument('s');
  if (load && parsed.arguments.empty()) return LoadRuleImage(call, *load);
  if (!file || !parsed.arguments.empty()) return call.Fail("Syntax: save rete-network --save <filename>");
  return SaveRuleImage(call, *file);
}

constexpr SubcommandInfo kSaveSubcommandList[] = {
    {"agent", "FILE", "writes the agent's settings and rules to a file that can be sourced", {}, SaveAgent},
    {"chunks", "FILE", "writes learned rules to a file", {}, SaveChunks},
    {"percepts", "[--open FILE | --close | --flush]", "records what clients put on the input link", kPerceptsOptions,
     SavePercepts},
    {"rete-network", "--save FILE", "writes the rules with the numbers that they learned, for load rete-network",
     kReteOptions, SaveRete},
};

}  // namespace

const std::span<const SubcommandInfo> kSaveSubcommands = kSaveSubcommandList;

bool CommandSave(CommandCall& call) {
  if (call.words.size() < 2) {
    return call.Fail("File type is required. \n\nUse 'save ?' or 'help save' to learn more about the save command.");
  }
  return RunSubcommand(call, {});
}

}  // namespace soarbox::cli
