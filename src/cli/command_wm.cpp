// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include <algorithm>

#include "cli/command.h"
#include "cli/interpreter.h"
#include "cli/lookup.h"
#include "cli/setting_store.h"

namespace soarbox::cli {
namespace {

using kernel::Symbol;

bool Add(CommandCall& call) {
  constexpr std::string_view kSyntax = "Syntax: wm add id [^]attribute value [+]";
  std::span<const Word> words = call.words.subspan(1);
  if (words.size() < 3 || words.size() > 4) return call.Fail(kSyntax);
  if (words.size() == 4 && words[3].text != "+") return call.Fail(kSyntax);
  if (call.interpreter.host().IsRunning(call.session)) {
    return call.Fail("Elements cannot be added while the agent runs.");
  }
  kernel::Agent& agent = call.agent();
  const Symbol id = FindIdentifier(agent, words[0].text);
  if (!id) return call.Fail("Invalid identifier");
  std::string attribute_word = words[1].text;
  if (attribute_word.starts_with('^')) attribute_word.erase(0, 1);
  // Each `*` is a new identifier; it takes its letter from Soar's habit for input.
  const auto read = [&](const std::string& word) -> Symbol {
    if (word == "*") return agent.NewIdentifier('I');
    if (const Symbol named = FindIdentifier(agent, word)) return named;
    return MakeConstant(agent, word);
  };
  if (attribute_word.empty() || words[2].text.empty()) return call.Fail(kSyntax);
  // The value is made first, as its identifier gets the lower number.
  const Symbol value = read(words[2].text);
  const Symbol attribute = read(attribute_word);
  auto added = agent.AddWme(id, attribute, value, words.size() == 4);
  if (!added) return call.Fail(added.error().message);
  call.Out(fmt::format("Timetag: {}", agent.memory().wme(*added).timetag));
  return true;
}

bool Remove(CommandCall& call) {
  if (call.words.size() != 2) return call.Fail("Syntax: wm remove <time-tag>");
  const auto timetag = ParseInteger(call.words[1].text);
  if (!timetag || *timetag <= 0) return call.Fail("<time-tag> must be positive");
  if (call.interpreter.host().IsRunning(call.session)) {
    return call.Fail("Elements cannot be removed while the agent runs.");
  }
  kernel::Agent& agent = call.agent();
  const kernel::WmeId wme = agent.memory().FindByTimetag(static_cast<std::uint64_t>(*timetag));
  if (wme == kernel::WmeId::kNone) {
    call.Hint("there is no element with time tag " + call.words[1].text, "`print --internal s1` shows time tags");
    return true;
  }
  const auto removed = agent.RemoveWme(wme);
  if (!removed) return call.Fail(removed.error().message);
  return true;
}

std::string Upper(std::string word) {
  if (const auto name = ParseIdentifierName(word)) return name->letter + std::to_string(name->number);
  return word;
}

bool Watch(CommandCall& call) {
  ParsedWords parsed;
  if (!call.Parse(kWmSubcommands[3].options, parsed)) return false;
  std::vector<WmeFilter>& filters = call.session.wme_filters();
  const std::string type = parsed.Argument('t').value_or("both");
  bool adds = std::string_view("adds").starts_with(type);
  bool removes = std::string_view("removes").starts_with(type);
  if (std::string_view("both").starts_with(type)) adds = removes = true;
  if (type.empty() || (!adds && !removes)) return call.Fail("Unknown type: expected adds, removes or both.");
  if (parsed.Has('R')) {
    const std::size_t before = filters.size();
    for (WmeFilter& filter : filters) {
      filter.adds = filter.adds && !adds;
      filter.removes = filter.removes && !removes;
    }
    std::erase_if(filters, [](const WmeFilter& filter) { return !filter.adds && !filter.removes; });
    call.session.UpdateTrace();
    if (before == 0) return call.Fail("The specified WME filter was not found.");
    return true;
  }
  if (!parsed.Has('a') && !parsed.Has('r')) {
    for (const WmeFilter& filter : filters) {
      if ((adds && filter.adds) || (removes && filter.removes)) {
        call.Out(fmt::format("wme filter: ({} ^{} {}) {}{}\n", filter.id, filter.attribute, filter.value,
                             filter.adds ? "adds " : "", filter.removes ? "removes" : ""));
      }
    }
    return true;
  }
  if (parsed.arguments.size() != 3) {
    return call.Fail("Three fields expected: identifier, attribute and value, each of which may be *.");
  }
  WmeFilter filter{Upper(parsed.arguments[0].text), parsed.arguments[1].text, Upper(parsed.arguments[2].text), adds,
                   removes};
  if (filter.attribute.size() > 1 && filter.attribute.front() == '^') filter.attribute.erase(0, 1);
  const auto same = [&](const WmeFilter& other) {
    return other.id == filter.id && other.attribute == filter.attribute && other.value == filter.value;
  };
  const auto found = std::find_if(filters.begin(), filters.end(), same);
  if (parsed.Has('a')) {
    if (found == filters.end()) {
      filters.push_back(filter);
    } else {
      found->adds = found->adds || adds;
      found->removes = found->removes || removes;
    }
  } else {
    if (found == filters.end()) return call.Fail("The specified WME filter was not found.");
    found->adds = found->adds && !adds;
    found->removes = found->removes && !removes;
    if (!found->adds && !found->removes) filters.erase(found);
  }
  call.session.UpdateTrace();
  return true;
}

bool Activation(CommandCall& call) {
  ParsedWords parsed;
  if (!call.Parse(kWmSubcommands[2].options, parsed)) return false;
  SettingStore& store = call.session.settings();
  if (parsed.Has('g')) {
    const std::string name = *parsed.Argument('g');
    if (!SettingStore::Find("wma", name)) return call.Fail("Invalid setting.");
    call.Out(store.Get("wma", name));
    return true;
  }
  if (parsed.Has('s')) {
    const std::string name = *parsed.Argument('s');
    if (parsed.arguments.size() != 1) return call.Fail("Invalid number of arguments for set.");
    const std::string& value = parsed.arguments.front().text;
    if (name == "activation" && value == "on") {
      return call.Fail("Activation of working memory is not available in this build.");
    }
    switch (store.Set("wma", name, value)) {
      case SettingStore::SetResult::kUnknown:
        return call.Fail("Invalid setting.");
      case SettingStore::SetResult::kInvalid:
        return call.Fail("Invalid value for setting.");
      case SettingStore::SetResult::kOk:
        return true;
    }
  }
  if (parsed.Has('h')) {
    call.Out("WME has no decay history");
    return true;
  }
  if (parsed.Has('S')) {
    call.Out("Forgotten WMEs: 0\n");
    return true;
  }
  if (parsed.Has('t')) return call.Fail("Timers of activation are not available in this build.");
  const auto line = [&](std::string_view name) { call.Out(fmt::format("{}: {}\n", name, store.Get("wma", name))); };
  call.Out(fmt::format("\nWMA activation: {}\n\nActivation\n----------\n", store.Get("wma", "activation")));
  line("decay-rate");
  line("petrov-approx");
  call.Out("\nForgetting\n----------\n");
  for (const char* name : {"decay-thresh", "forgetting", "forget-wme", "fake-forgetting"}) line(name);
  call.Out("\nPerformance\n-----------\n");
  line("timers");
  line("max-pow-cache");
  call.Out("\n");
  return true;
}

bool Help(CommandCall& call) {
  call.Out(
      "=========================================================\n"
      "-               WM Sub-Commands and Options             -\n"
      "=========================================================\n"
      "wm add          <id> [^]<attribute> <value> [+]\n"
      "wm remove       <timetag>\n"
      "wm activation   --get <parameter>\n"
      "wm activation   --set <parameter> <value>\n"
      "wm activation   [--history <timetag> | --stats | --timers]\n"
      "wm watch        --add-filter    [--type <t>] <id> <attribute> <value>\n"
      "wm watch        --remove-filter [--type <t>] <id> <attribute> <value>\n"
      "wm watch        --list-filter   [--type <t>]\n"
      "wm watch        --reset-filter  [--type <t>]\n"
      "                <t> = adds, removes or both\n"
      "---------------------------------------------------------\n\n"
      "For a detailed explanation of sub-commands:       help wm\n");
  return call.FailPrinted();
}

constexpr OptionSpec kActivationOptions[] = {
    {'g', "get", OptionArgument::kRequired, "show a setting"},
    {'s', "set", OptionArgument::kRequired, "change a setting"},
    {'h', "history", OptionArgument::kRequired, "when an element was used"},
    {'S', "stats", OptionArgument::kOptional, "what was forgotten"},
};
constexpr OptionSpec kWatchOptions[] = {
    {'a', "add-filter", OptionArgument::kNone, "show changes of elements that fit"},
    {'r', "remove-filter", OptionArgument::kNone, "take a filter away"},
    {'l', "list-filter", OptionArgument::kNone, "list the filters"},
    {'R', "reset-filter", OptionArgument::kNone, "take all filters away"},
    {'t', "type", OptionArgument::kRequired, "adds, removes or both"},
};

constexpr SubcommandInfo kSubcommands[] = {
    {"add", "ID [^]ATTRIBUTE VALUE [+]", "adds an element to working memory, as input", {}, Add},
    {"remove", "TIMETAG", "removes an element from working memory", {}, Remove},
    {"activation", "[--get NAME | --set NAME VALUE]", "settings of activation and forgetting", kActivationOptions,
     Activation},
    {"watch", "[--add-filter ID ATTRIBUTE VALUE]", "shows changes of certain elements at any trace level",
     kWatchOptions, Watch},
    {"?", "", "an overview of the sub-commands", {}, Help},
    {"help", "", "an overview of the sub-commands", {}, Help},
};

}  // namespace

const std::span<const SubcommandInfo> kWmSubcommands = kSubcommands;

bool CommandWm(CommandCall& call) {
  if (call.words.size() < 2) {
    return call.Fail(
        "The 'wm' commands contains commands and settings related to working memomory: add, remove, "
        "activation and watch.\n\nUse 'wm ?' to see an overview of the command or 'help wm' to read the "
        "manual page.");
  }
  std::string error;
  return RunSubcommand(call, *FindCommand("wm", error),
                       "Invalid wm command.  Use 'wm ?' to see a list of valid settings.",
                       "Use 'wm ?' or 'help wm' to learn more about the wm command.");
}

}  // namespace soarbox::cli
