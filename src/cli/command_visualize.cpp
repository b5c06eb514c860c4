// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <utility>

#include "cli/command.h"
#include "cli/episode_text.h"
#include "cli/explain_graph.h"
#include "cli/graph_text.h"
#include "cli/interpreter.h"
#include "cli/knowledge_printer.h"
#include "cli/lookup.h"
#include "cli/run_program.h"
#include "cli/session.h"
#include "cli/setting_store.h"
#include "cli/settings_command.h"
#include "kernel/agent.h"
#include "kernel/learn/explanation_log.h"
#include "kernel/longterm/episodic_memory.h"
#include "kernel/longterm/knowledge_reader.h"
#include "kernel/longterm/long_term.h"
#include "kernel/longterm/semantic_memory.h"

namespace soarbox::cli {
namespace {

constexpr SubcommandInfo kVisualizeSubcommandList[] = {
    {"wm", "[ID] [DEPTH]", "draws working memory: all states, or an object and everything below it"},
    {"smem", "[LTI] [DEPTH]", "draws semantic memory: all of it, or an object and what it leads to"},
    {"epmem", "[EPISODE]", "draws an episode, the newest if none is named"},
    {"identity_graph", "", "which identities of the explained rule became one"},
    {"ebc_analysis", "",
     "the firings that led to the explained rule, and which rules made the elements that they tested"},
    {"rule-format", "[name | full]", "rules with all conditions, or by name"},
    {"memory-format", "[node | record]", "objects as tables of their values, or each value as a node"},
    {"line-style", "[STYLE]", "how lines run: a value of Graphviz's splines"},
    {"separate-states", "[on | off]", "on leaves links between states out"},
    {"architectural-wmes", "[on | off]", "show what the architecture made: superstate, type, impasse and the like"},
    {"color-identities", "[on | off]", "colours for identities"},
    {"use-joined-identities", "[on | off]", "colours after identities were joined"},
    {"file-name", "[NAME]", "how files are named, without number and ending"},
    {"use-same-file", "[on | off]", "write over the last drawing instead of numbering them"},
    {"generate-image", "[on | off]", "make an image of the drawing, with the program dot of Graphviz"},
    {"image-type", "[TYPE]", "svg, png, pdf or another type that dot knows"},
    {"viewer-launch", "[on | off]", "show the image in a window, where there is a display"},
    {"editor-launch", "[on | off]", "open the drawing's text in a window, where there is a display"},
    {"print-debug", "[on | off]", "print the drawing's text"},
};

/// The file of the drawing. Its name ends with the first unused number, unless `use-same-file` is on.
std::filesystem::path NextFile(CommandCall& call) {
  const SettingStore& store = call.session.settings();
  std::string name = store.Get("visualize", "file-name");
  if (name.empty()) name = "soar_viz";
  if (store.IsOn("visualize", "use-same-file")) return call.interpreter.Resolve(name + ".gv");
  std::error_code error;
  for (int number = 1;; ++number) {
    std::filesystem::path file = call.interpreter.Resolve(fmt::format("{}{}.gv", name, number));
    if (!std::filesystem::exists(file, error)) return file;
  }
}

/// Creates and shows the image, if the settings request it. Fails without the program dot. If nothing can be shown,
/// prints a remark.
bool Present(CommandCall& call, const std::filesystem::path& file) {
  const SettingStore& store = call.session.settings();
  const auto show = [&](const std::filesystem::path& shown) {
    if (!HasDisplay() || !IsInstalled("xdg-open")) {
      call.Out(
          fmt::format("There is no window to show {} in: no display, or no xdg-open.\n", shown.filename().string()));
    } else if (!StartProgram({"xdg-open", shown.string()})) {
      call.Out(fmt::format("{} could not be shown: xdg-open did not start.\n", shown.filename().string()));
    }
  };
  if (store.IsOn("visualize", "editor-launch")) show(file);
  if (!store.IsOn("visualize", "generate-image")) return true;
  const std::string type = store.Get("visualize", "image-type");
  const auto usual = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_'; };
  if (type.empty() || !std::all_of(type.begin(), type.end(), usual)) {
    return call.Fail("'" + type + "' is not a type of images: set another with 'visualize image-type svg'.");
  }
  if (!IsInstalled("dot")) {
    call.Fail(
        "Error: Could not generate visualization image because `dot` command failed. Do you have GraphViz "
        "installed?!\n");
    Diagnostic& told = call.result.diagnostics.back();
    told.message = "the drawing is written, but there is no program 'dot' to make an image of it";
    told.hint = "install Graphviz, or leave images out with 'visualize generate-image off'";
    return false;
  }
  const std::filesystem::path image = std::filesystem::path(file).replace_extension("." + type);
  if (!RunProgram({"dot", "-T" + type, "-o", image.string(), file.string()})) {
    return call.Fail(fmt::format("The program 'dot' made no image of type {} from {}.", type, file.string()));
  }
  call.Out(fmt::format("Image written to {}.\n", image.string()));
  if (store.IsOn("visualize", "viewer-launch")) show(image);
  return true;
}

/// Writes a drawing to its file, and creates and shows an image of it if requested.
bool Write(CommandCall& call, const std::string& text) {
  const SettingStore& store = call.session.settings();
  call.Out("Generating visualization...\n");
  const std::filesystem::path file = NextFile(call);
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  out << text;
  out.close();
  if (!out) return call.Fail("Failed to open file for writing: " + file.string());
  call.Out(fmt::format("Drawing written to {}.\n", file.string()));
  call.AddArgument("filename", "string", file.string());
  if (store.IsOn("visualize", "print-debug")) call.Out(text);
  return Present(call, file);
}

/// Draws the rule that was chosen with `explain chunk`, or else the one that was recorded last.
bool LearnedRule(CommandCall& call, bool identities) {
  const std::vector<kernel::ExplainedRule>& rules = call.agent().explanations().rules();
  if (rules.empty()) {
    return call.Fail("No learned rule has been recorded: say 'explain all on' before the agent learns.");
  }
  const auto chosen = std::ranges::find(rules, call.session.explain().rule, &kernel::ExplainedRule::number);
  const kernel::ExplainedRule& rule = chosen != rules.end() ? *chosen : rules.back();
  const std::string line_style = call.session.settings().Get("visualize", "line-style");
  return Write(call, identities ? IdentityGraphText(rule, line_style) : AnalysisGraphText(rule, line_style));
}

bool Episode(CommandCall& call, std::span<const Word> words) {
  const kernel::EpisodicMemory* memory = kernel::EpisodicMemory::Find(std::as_const(call.agent()).long_term());
  const kernel::EpisodeNumber last = memory == nullptr ? 0 : memory->store().last();
  if (last == 0) return call.Fail("Episodic memory holds no episode: there is nothing to draw.");
  if (words.size() > 1) return call.Fail("Syntax: visualize epmem [episode]");
  const auto wanted = words.empty() ? std::optional<std::int64_t>(last) : ParseInteger(words[0].text);
  if (!wanted || *wanted < 1 || *wanted > last) {
    return call.Fail(fmt::format("There is no episode {}: they go from 1 to {}.", words[0].text, last));
  }
  return Write(call, EpisodeGraph(*memory, static_cast<kernel::EpisodeNumber>(*wanted)));
}

bool WorkingMemory(CommandCall& call, std::span<const Word> words) {
  constexpr std::string_view kSyntax = "Syntax: visualize wm [id] [depth]";
  const kernel::Agent& agent = call.agent();
  std::vector<kernel::Symbol> roots;
  int depth = std::numeric_limits<int>::max();
  for (const Word& word : words) {
    if (const auto number = ParseInteger(word.text)) {
      if (*number < 1 || *number > depth) return call.Fail("The depth must be a number above 0.");
      depth = static_cast<int>(*number);
    } else if (const kernel::Symbol id = FindIdentifier(agent, word.text); id && roots.empty()) {
      roots.push_back(id);
    } else if (!roots.empty()) {
      return call.Fail(kSyntax);
    } else {
      return call.Fail(fmt::format("There is no identifier {} in working memory.\n{}", word.text, kSyntax));
    }
  }
  if (words.size() > 2) return call.Fail(kSyntax);
  if (roots.empty()) {
    for (std::size_t level = 1; level <= agent.goals().depth(); ++level) {
      roots.push_back(agent.goals().at(static_cast<kernel::GoalLevel>(level)).id);
    }
  }
  const SettingStore& store = call.session.settings();
  GraphStyle style;
  style.records = store.Get("visualize", "memory-format") == "record";
  style.separate_states = store.IsOn("visualize", "separate-states");
  style.architecture = store.IsOn("visualize", "architectural-wmes");
  style.line_style = store.Get("visualize", "line-style");
  return Write(call, WorkingMemoryGraph(agent, roots, depth, style));
}

bool SemanticMemory(CommandCall& call, std::span<const Word> words) {
  constexpr std::string_view kSyntax = "Syntax: visualize smem [@number] [depth]";
  const kernel::SemanticMemory& memory = kernel::SemanticMemory::Of(call.agent().long_term());
  std::optional<std::uint32_t> root;
  int depth = std::numeric_limits<int>::max();
  for (const Word& word : words) {
    if (const auto number = ParseInteger(word.text)) {
      if (*number < 1 || *number > depth) return call.Fail("The depth must be a number above 0.");
      depth = static_cast<int>(*number);
    } else if (root || !word.text.starts_with('@')) {
      return call.Fail(kSyntax);
    } else if (const kernel::Lti number = kernel::ObjectNamed(memory, word.text); number != 0) {
      root = memory.knowledge().Find(number);
    } else {
      return call.Fail(fmt::format("LTI {} not found in semantic memory.", word.text));
    }
  }
  if (words.size() > 2) return call.Fail(kSyntax);
  if (memory.knowledge().object_count() == 0) return call.Fail("Semantic memory is empty: there is nothing to draw.");
  return Write(call, KnowledgeGraph(memory, root, depth, call.agent().settings().like));
}

}  // namespace

const std::span<const SubcommandInfo> kVisualizeSubcommands = kVisualizeSubcommandList;

bool CommandVisualize(CommandCall& call) {
  if (call.words.size() < 2) {
    call.Out(
        "Visualize draws what Soar's memories hold.\n\n"
        "Use 'visualize ?' and 'help visualize' to learn more about the visualize command.");
    return true;
  }
  const std::string& word = call.words[1].text;
  if (word == "?" || word == "help") return ShowHelp(call, "visualize");
  if (word == "wm") return WorkingMemory(call, call.words.subspan(2));
  if (word == "smem") return SemanticMemory(call, call.words.subspan(2));
  if (word == "epmem") return Episode(call, call.words.subspan(2));
  if (word == "identity_graph" || word == "ebc_analysis") {
    return LearnedRule(call, word == "identity_graph");
  }
  return NamedSetting(call, "visualize",
                      "Invalid visualize sub-command.  Use 'visualize ?' to see a list of valid sub-commands and "
                      "settings.",
                      "Invalid argument.  Use 'visualize ?' to see a list of valid settings.");
}

}  // namespace soarbox::cli
