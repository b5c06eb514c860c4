// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "cli/command.h"
#include "cli/interpreter.h"
#include "cli/lookup.h"
#include "cli/print_stream.h"
#include "cli/setting_store.h"
#include "cli/summary.h"
#include "kernel/agent.h"
#include "kernel/longterm/long_term.h"
#include "kernel/longterm/wm_activation.h"

namespace soarbox::cli {
namespace {

using kernel::Symbol;

/// Identifiers that `wm add` creates by name have smaller numbers, so that numbers remain for later ones.
constexpr std::uint64_t kMostOfName = 1'000'000'000'000;

/// The attribute or value that a word of `wm add` denotes. `parent` is the object for a value, and null for an
/// attribute. `*` creates an identifier with the letter I. A value may also be the name of an identifier that does not
/// exist yet: it is created, except in the behavior of Soar 9.6.3. A string as an attribute must not contain a dot,
/// unless it is quoted, because `wm add` adds only one element. If the word is wrong, fails the command and returns the
/// null symbol.
Symbol ReadField(CommandCall& call, const std::string& word, std::string_view field, Symbol parent) {
  kernel::Agent& agent = call.agent();
  if (word == "*") return agent.NewIdentifier('I');
  const auto identifier = ParseIdentifierName(word);
  const bool is_variable = word.size() > 2 && word.front() == '<' && word.back() == '>';
  if (identifier || is_variable) {
    if (const Symbol named = FindIdentifier(agent, word)) return named;
    if (identifier && parent && agent.settings().like != kernel::SoarVersion::k963 && identifier->number > 0 &&
        identifier->number < kMostOfName && !agent.symbols().FindIdentifier(identifier->letter, identifier->number)) {
      return agent.NewIdentifier(identifier->letter, identifier->number, parent);
    }
    const PrintStream::Capture capture(call.stream(), &call.result.text);
    if (identifier) {
      call.stream().Print(fmt::format("There is no identifier {}{}.\n", identifier->letter, identifier->number));
    } else {
      call.stream().Print(IsContextVariable(word) ? "There is no current " + word + ".\n"
                                                  : std::string("Expected identifier (or context variable)\n"));
    }
    call.Fail(fmt::format("Invalid {}.", field));
    return {};
  }
  const bool quoted = word.size() > 1 && word.front() == '|' && word.back() == '|';
  if (!quoted && (word.empty() || word.find_first_of(" \t\n\"(){}^~&") != std::string::npos)) {
    call.Fail(fmt::format("Unknown {} type.", field));
    return {};
  }
  const Symbol constant = MakeConstant(agent, word);
  if (!parent && !quoted && !constant.IsNumber() && word.find('.') != std::string::npos) {
    call.Fail(fmt::format("Unknown {} type.", field));
    return {};
  }
  return constant;
}

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
  if (attribute_word.size() > 1 && attribute_word.front() == '^') attribute_word.erase(0, 1);
  const Symbol attribute = ReadField(call, attribute_word, "attribute", {});
  if (!attribute) return false;
  const Symbol value = ReadField(call, words[2].text, "value", id);
  if (!value) return false;
  auto added = agent.AddWme(id, attribute, value, words.size() == 4);
  if (!added) return call.Fail(added.error().message);
  call.Out(fmt::format("Timetag: {}", agent.memory().wme(*added).timetag));
  return true;
}

bool Remove(CommandCall& call) {
  if (call.words.size() != 2) return call.Fail("Syntax: wm remove <time-tag>");
  const auto timetag = ParseLeadingInteger(call.words[1].text);
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

/// Formats a field of a filter; false if it names an identifier that does not exist.
bool ReadFilterField(CommandCall& call, const std::string& word, std::string& field) {
  field = word;
  if (const auto name = ParseIdentifierName(word)) field = name->letter + std::to_string(name->number);
  const bool names = field != word || ParseIdentifierName(word) || IsContextVariable(word);
  if (!names) return true;
  const Symbol found = FindIdentifier(call.agent(), word);
  if (found) field = ToString(call.agent().symbols(), found);
  return static_cast<bool>(found);
}

constexpr OptionSpec kWatchOptions[] = {
    {'a', "add-filter", OptionArgument::kNone, "trace only elements that fit"},
    {'r', "remove-filter", OptionArgument::kNone, "remove a filter"},
    {'l', "list-filter", OptionArgument::kNone, "list the filters"},
    {'R', "reset-filter", OptionArgument::kNone, "remove all filters"},
    {'t', "type", OptionArgument::kRequired, "adds, removes or both"},
};

bool Watch(CommandCall& call) {
  constexpr std::string_view kSyntax = "Syntax: wm watch -[a|r]  -t <type>  <pattern>\nwm watch -[l|R] [-t <type>]";
  ParsedWords parsed;
  if (!call.Parse(kWatchOptions, parsed)) return false;
  // The list begins with the newest filter.
  std::vector<WmeFilter>& filters = call.session.wme_filters();
  const std::optional<std::string> type = parsed.Argument('t');
  if (type && *type != "adds" && *type != "removes" && *type != "both") {
    return call.Fail("Invalid wme filter type, got: " + *type);
  }
  const bool adds = type.value_or("both") != "removes", removes = type.value_or("both") != "adds";
  const auto text = [](const WmeFilter& filter) {
    return fmt::format("({} ^{} {}) {} {}\n", filter.id, filter.attribute, filter.value, filter.adds ? "adds" : "",
                       filter.removes ? "removes" : "");
  };
  const auto concerned = [&](const WmeFilter& filter) { return (adds && filter.adds) || (removes && filter.removes); };
  const bool changes_one = parsed.Has('a') || parsed.Has('r');
  if (!changes_one && !parsed.arguments.empty()) return call.Fail(kSyntax);
  if (parsed.Has('R')) {
    if (std::none_of(filters.begin(), filters.end(), concerned)) {
      return call.Fail("The specified WME filter was not found.");
    }
    for (const WmeFilter& filter : filters) {
      if (concerned(filter)) call.Out("Removed: " + text(filter));
    }
    std::erase_if(filters, concerned);
    call.session.UpdateTrace();
    return true;
  }
  if (!changes_one) {
    for (const WmeFilter& filter : filters) {
      if (concerned(filter)) call.Out("wme filter: " + text(filter));
    }
    return true;
  }
  if (!type) return call.Fail("Wme type required.");
  if (parsed.arguments.size() != 3) return call.Fail(kSyntax);
  WmeFilter filter{"", "", "", adds, removes};
  std::string attribute = parsed.arguments[1].text;
  if (attribute.size() > 1 && attribute.front() == '^') attribute.erase(0, 1);
  const std::string &id = parsed.arguments[0].text, &value = parsed.arguments[2].text;
  if (!ReadFilterField(call, id, filter.id)) return call.Fail("Invalid id, got: " + id);
  if (!ReadFilterField(call, attribute, filter.attribute)) return call.Fail("Invalid attribute, got: " + attribute);
  if (!ReadFilterField(call, value, filter.value)) return call.Fail("Invalid value, got: " + value);
  const auto found = std::find_if(filters.begin(), filters.end(), [&](const WmeFilter& other) {
    return other.id == filter.id && other.attribute == filter.attribute && other.value == filter.value &&
           other.adds == filter.adds && other.removes == filter.removes;
  });
  if (parsed.Has('a')) {
    if (found != filters.end()) return call.Fail("That WME filter already exists.");
    filters.insert(filters.begin(), filter);
  } else {
    if (found == filters.end()) return call.Fail("The specified WME filter was not found.");
    filters.erase(found);
  }
  call.session.UpdateTrace();
  return true;
}

/// Applies the texts of the settings to the kernel.
void ApplyActivation(CommandCall& call) {
  const SettingStore& store = call.session.settings();
  kernel::WmActivation& module = kernel::WmActivation::Of(call.agent().long_term());
  kernel::WmaSettings& settings = module.mutable_settings();
  settings.activation = store.IsOn("wma", "activation");
  settings.decay_rate = ParseDouble(store.Get("wma", "decay-rate")).value_or(-0.5);
  settings.decay_thresh = ParseDouble(store.Get("wma", "decay-thresh")).value_or(-2);
  settings.petrov_approx = store.IsOn("wma", "petrov-approx");
  const std::string forgetting = store.Get("wma", "forgetting");
  settings.forgetting = forgetting == "off"     ? kernel::WmaSettings::Forgetting::kOff
                        : forgetting == "naive" ? kernel::WmaSettings::Forgetting::kNaive
                                                : kernel::WmaSettings::Forgetting::kBisection;
  settings.forget_linked_only = store.Get("wma", "forget-wme") == "lti";
  settings.fake_forgetting = store.IsOn("wma", "fake-forgetting");
  module.SettingsChanged();
}

bool SetActivation(CommandCall& call, const std::string& name, const std::string& value) {
  SettingStore& store = call.session.settings();
  if (!SettingStore::Find("wma", name)) return call.Fail("Invalid activation setting.");
  std::string kept = value;
  if (name == "decay-rate" || name == "decay-thresh") {
    // Both are stored as negative numbers. Users may type them with or without the sign.
    const double size = std::abs(std::strtod(value.c_str(), nullptr));
    const bool fits = name == "decay-rate" ? size <= 1 : size > 0;
    if (!fits) return call.Fail("Invalid value for activation setting.");
    kept = size == 0 ? "-0" : Shortest(-size);
  }
  const bool is_protected = name != "activation" && name != "timers" && store.IsOn("wma", "activation");
  const std::string before = store.Get("wma", name);
  if (store.Set("wma", name, kept) != SettingStore::SetResult::kOk) {
    return call.Fail("Invalid value for activation setting.");
  }
  if (is_protected) {
    store.Set("wma", name, before);
    return call.Fail("ERROR: this parameter is protected while WMA is on.");
  }
  ApplyActivation(call);
  return true;
}

bool ActivationHistory(CommandCall& call, const std::string& tag) {
  const auto timetag = ParseLeadingInteger(tag);
  if (!timetag) return call.Fail("Invalid timetag.");
  const kernel::WmActivation* const module = kernel::WmActivation::Find(call.agent().long_term());
  const kernel::WmeId wme =
      *timetag < 1 ? kernel::WmeId::kNone : call.agent().memory().FindByTimetag(static_cast<std::uint64_t>(*timetag));
  if (wme == kernel::WmeId::kNone) return true;
  const kernel::WmActivation::History* const history = module == nullptr ? nullptr : module->HistoryOf(wme);
  if (history == nullptr) {
    call.Out("WME has no decay history");
    return true;
  }
  std::uint64_t kept = 0;
  for (std::size_t n = 0; n < history->count; ++n) kept += history->uses[n];
  call.Out(fmt::format("history ({}/{}, first @ d{}):\n", kept, history->total, history->first));
  for (std::size_t n = 0; n < history->count; ++n) {
    call.Out(
        fmt::format(" {} @ d{} (-{})\n", history->uses[n], history->cycles[n], module->now() - history->cycles[n]));
  }
  if (module->settings().forgetting != kernel::WmaSettings::Forgetting::kOff && history->due > 0) {
    call.Out(fmt::format("\nconsidering WME for decay @ d{}\n", history->due));
  }
  return true;
}

constexpr OptionSpec kActivationOptions[] = {
    {'g', "get", OptionArgument::kOptional, "show a setting"},
    {'s', "set", OptionArgument::kOptional, "change a setting"},
    {'h', "history", OptionArgument::kOptional, "when an element was used"},
    {'S', "stats", OptionArgument::kOptional, "what was forgotten"},
};

bool Activation(CommandCall& call) {
  ParsedWords parsed;
  if (!call.Parse(kActivationOptions, parsed)) return false;
  const SettingStore& store = call.session.settings();
  for (const char letter : {'g', 's', 'h'}) {
    if (parsed.Has(letter) && !parsed.Argument(letter)) return call.Fail("Too few arguments.");
  }
  const bool sets = parsed.Has('s');
  if (parsed.arguments.size() > (sets ? 1u : 0u)) return call.Fail(sets ? "Too many arguments." : "Too many args.");
  if (parsed.Has('g')) {
    const std::string name = *parsed.Argument('g');
    if (!SettingStore::Find("wma", name)) return call.Fail("Invalid activation setting.");
    call.Out(store.Get("wma", name));
    return true;
  }
  if (sets) {
    if (parsed.arguments.empty()) return call.Fail("Too few arguments.");
    return SetActivation(call, *parsed.Argument('s'), parsed.arguments.front().text);
  }
  if (const auto tag = parsed.Argument('h')) return ActivationHistory(call, *tag);
  if (parsed.Has('S')) {
    const kernel::WmActivation* const module = kernel::WmActivation::Find(call.agent().long_term());
    const std::uint64_t forgotten = module == nullptr ? 0 : module->forgotten();
    const auto name = parsed.Argument('S');
    if (name && *name != "forgotten-wmes") return call.Fail("Invalid statistic.");
    call.Out(name ? std::to_string(forgotten) : fmt::format("Forgotten WMEs: {}\n", forgotten));
    return true;
  }
  if (parsed.Has('t')) return call.Fail("Activation of working memory takes no times.");
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

constexpr SubcommandInfo kWmSubcommandList[] = {
    {"add", "ID [^]ATTRIBUTE VALUE [+]", "adds an element to working memory, as input", {}, Add},
    {"remove", "TIMETAG", "removes an element from working memory", {}, Remove},
    {"activation", "[--get NAME | --set NAME VALUE]", "settings of activation and forgetting", kActivationOptions,
     Activation},
    {"watch", "[--add-filter ID ATTRIBUTE VALUE]", "limits the trace of elements (trace --wmes) to certain ones",
     kWatchOptions, Watch},
};

}  // namespace

const std::span<const SubcommandInfo> kWmSubcommands = kWmSubcommandList;

bool CommandWm(CommandCall& call) {
  if (call.words.size() < 2) {
    return call.Fail(
        "The 'wm' commands contains commands and settings related to working memomory: add, remove, "
        "activation and watch.\n\nUse 'wm ?' to see an overview of the command or 'help wm' to read the "
        "manual page.");
  }
  return RunSubcommand(call, {});
}

}  // namespace soarbox::cli
