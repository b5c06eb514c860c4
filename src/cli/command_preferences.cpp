// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include <algorithm>

#include "cli/command.h"
#include "cli/lookup.h"
#include "cli/object_printer.h"
#include "cli/session.h"
#include "cli/stack_printer.h"
#include "cli/summary.h"
#include "cli/trace_printer.h"
#include "kernel/rules/print_production.h"

namespace soarbox::cli {
namespace {

using kernel::Agent;
using kernel::Preference;
using kernel::PreferenceId;
using kernel::PreferenceType;
using kernel::Slot;
using kernel::SlotId;
using kernel::Symbol;
using kernel::WmeId;

constexpr OptionSpec kPreferencesOptionList[] = {
    {'0', "none", OptionArgument::kNone, "preferences only"},
    {'1', "names", OptionArgument::kNone, "with the rules that made them"},
    {'n', "names"},
    {'N', "names"},
    {'2', "timetags", OptionArgument::kNone, "with the time tags of what the rules matched"},
    {'t', "timetags"},
    {'3', "wmes", OptionArgument::kNone, "with what the rules matched"},
    {'w', "wmes"},
    {'o', "object", OptionArgument::kNone, "all attributes of the object"},
};

struct Section {
  PreferenceType type;
  std::string_view title;
};
constexpr Section kSections[] = {
    {PreferenceType::kAcceptable, "acceptables"},
    {PreferenceType::kRequire, "requires"},
    {PreferenceType::kReject, "rejects"},
    {PreferenceType::kProhibit, "prohibits"},
    {PreferenceType::kUnaryIndifferent, "unary indifferents"},
    {PreferenceType::kBest, "bests"},
    {PreferenceType::kWorst, "worsts"},
    {PreferenceType::kBinaryIndifferent, "binary indifferents"},
    {PreferenceType::kBetter, "betters"},
    {PreferenceType::kWorse, "worses"},
    {PreferenceType::kNumericIndifferent, "numeric indifferents"},
};

/// The level of detail about the origin of a preference.
enum class Detail { kNone, kNames, kTimetags, kWmes };

class PreferencePrinter {
 public:
  PreferencePrinter(CommandCall& call, Detail detail) : call_(call), agent_(call.agent()), detail_(detail) {}

  /// Prints the preferences of a slot, by type; `chances`: with selection probabilities, if there are any.
  void PrintSlot(SlotId slot, bool chances) {
    for (const Section& section : kSections) {
      const std::vector<PreferenceId> preferences = agent_.PreferencesOf(slot, section.type);
      if (preferences.empty()) continue;
      Print(fmt::format("\n{}:\n", section.title));
      for (const PreferenceId id : preferences) PrintPreference(id, nullptr);
    }
    if (!chances) return;
    const kernel::Goal* goal = GoalOf(agent_.memory().slot(slot).id);
    if (!goal) return;
    const std::vector<Agent::CandidateChance> candidates = agent_.SelectionProbabilities(*goal);
    if (candidates.empty()) return;
    Print("\nselection probabilities:\n");
    for (const Agent::CandidateChance& candidate : candidates) PrintPreference(candidate.preference, &candidate);
  }

  /// Prints all slots of an object.
  void PrintObject(Symbol id) {
    const kernel::WorkingMemory& memory = agent_.memory();
    for (SlotId slot_id = memory.identifier(id).slots; slot_id != SlotId::kNone; slot_id = memory.slot(slot_id).next) {
      const Slot& slot = memory.slot(slot_id);
      if (slot.is_operator) {
        Print("Preferences for " + Name(slot) + ":");
        PrintSlot(slot_id, false);
        continue;
      }
      Print("Support for " + Name(slot) + ":\n");
      for (const PreferenceId preference : agent_.PreferencesOf(slot_id, PreferenceType::kAcceptable)) {
        PrintPreference(preference, nullptr);
      }
    }
    PrintWmes("Arch-created wmes for ", id, memory.identifier(id).architecture_wmes);
    PrintWmes("Input (IO) wmes for ", id, memory.identifier(id).input_wmes);
  }

  /// Prints the origins of the elements that lead to an object.
  void PrintSupportOf(Symbol value) {
    const kernel::WorkingMemory& memory = agent_.memory();
    std::vector<WmeId> links;
    for (std::uint32_t i = 0; i < memory.wmes().size(); ++i) {
      if (memory.wmes()[i].live && memory.wmes()[i].value == value) links.push_back(static_cast<WmeId>(i));
    }
    // The newest first.
    std::sort(links.begin(), links.end(),
              [&](WmeId a, WmeId b) { return ArrivalOf(agent_.rete(), a) > ArrivalOf(agent_.rete(), b); });
    for (const WmeId link : links) {
      std::string text = WmeText(agent_, link);
      if (text.ends_with(" +)")) text.replace(text.size() - 3, 2, "");  // Soar prints proposals here without the sign.
      Print("Support for " + text + "\n");
      const kernel::WmeRecord& record = memory.record(link);
      if (record.slot() == SlotId::kNone || record.preference == PreferenceId::kNone) {
        // Like Soar, call only the items of a tie "arch"; other elements of the architecture are called "input" too.
        const std::string attribute = SymbolText(agent_, memory.wme(link).attribute);
        const bool is_item =
            record.kind == kernel::WmeKind::kArchitecture && (attribute == "item" || attribute == "non-numeric");
        Print(fmt::format("    This is an {}-wme and has no prefs.\n", is_item ? "arch" : "input"));
        continue;
      }
      for (const Section& section : kSections) {
        for (const PreferenceId id : agent_.PreferencesOf(record.slot(), section.type)) {
          if (memory.preference(id).value != value) continue;
          const Agent::CandidateChance certain{id, value, 0, 1};
          PrintPreference(id, section.type == PreferenceType::kAcceptable ? &certain : nullptr);
        }
      }
    }
  }

  bool HasPreferences(SlotId slot) const {
    return agent_.memory().slot(slot).acceptable != PreferenceId::kNone ||
           agent_.memory().slot(slot).others != PreferenceId::kNone;
  }

  std::string Name(const Slot& slot) const {
    return SymbolText(agent_, slot.id) + " ^" + SymbolText(agent_, slot.attribute);
  }

  const kernel::Goal* GoalOf(Symbol id) const {
    for (std::size_t level = 1; level <= agent_.goals().depth(); ++level) {
      const kernel::Goal& goal = agent_.goals().at(static_cast<kernel::GoalLevel>(level));
      if (goal.id == id) return &goal;
    }
    return nullptr;
  }

  void Print(const std::string& text) { call_.stream().Print(text); }

 private:
  void PrintPreference(PreferenceId id, const Agent::CandidateChance* chance) {
    const Preference& preference = agent_.memory().preference(id);
    const bool is_operator = preference.slot != SlotId::kNone && agent_.memory().slot(preference.slot).is_operator;
    std::string text = "  ";
    if (is_operator) {
      text += OperatorText(agent_, preference.value) + " " + std::string(kernel::PreferenceSign(preference.type));
    } else {
      text += fmt::format("({} ^{} {})", SymbolText(agent_, preference.id), SymbolText(agent_, preference.attribute),
                          SymbolText(agent_, preference.value));
    }
    text += ' ';
    if (preference.referent) {
      text += preference.referent.IsIdentifier() ? OperatorText(agent_, preference.referent)
                                                 : SymbolText(agent_, preference.referent);
    }
    if (chance) {
      std::string value = fmt::format("{:.16g}", chance->numeric_value);
      if (value.find_first_of(".e") == std::string::npos) value += '.';
      text += " = " + value;
    }
    text += preference.o_supported ? " :O " : " :I ";
    // The level is shown only for substates.
    if (!chance && preference.level > 1) text += fmt::format(" [level {}] ", preference.level);
    if (chance) text += fmt::format("({:.2f}%)", chance->probability * 100);
    Print(text + "\n");
    PrintOrigin(preference);
  }

  void PrintOrigin(const Preference& preference) {
    if (detail_ == Detail::kNone) return;
    const std::string name(agent_.ProductionName(preference.instantiation));
    Print("    From " + name + "\n");
    ResultNode& node = call_.result.structured.Add("production");
    node.Set("prodname", name);
    const std::span<const WmeId> wmes = agent_.MatchedWmes(preference.instantiation);
    if (detail_ == Detail::kTimetags) {
      std::string tags;
      for (const WmeId wme : wmes) tags += " " + std::to_string(agent_.memory().wme(wme).timetag);
      Print(tags + "\n");
      return;
    }
    if (detail_ == Detail::kWmes) {
      for (const WmeId wme : wmes) {
        // Of elements of the top state, only the time tags are printed, because they may have been removed.
        Print(MatchedText(agent_, wme, agent_.memory().level(agent_.memory().wme(wme).id)) + "\n");
        AddWmeNode(node, agent_, wme);
      }
    }
    Print("\n");
  }

  void PrintWmes(std::string_view title, Symbol id, WmeId first) {
    if (first == WmeId::kNone) return;
    Print(fmt::format("{}{} :\n", title, SymbolText(agent_, id)));
    for (WmeId wme = first; wme != WmeId::kNone; wme = agent_.memory().record(wme).next) {
      Print(WmeText(agent_, wme) + "\n");
    }
  }

  CommandCall& call_;
  const Agent& agent_;
  Detail detail_;
};

/// Whether a number is the attribute or value of an element; true for strings.
bool IsKnown(const Agent& agent, Symbol constant) {
  if (!constant.IsNumber()) return true;
  const kernel::WmeTable& wmes = agent.memory().wmes();
  for (std::uint32_t i = 0; i < wmes.size(); ++i) {
    const kernel::Wme& wme = wmes[i];
    if (wme.live && (wme.attribute == constant || wme.value == constant)) return true;
  }
  return false;
}

/// The identifier or constant that a word names; the null symbol if there is no such string, or no element with such a
/// number.
Symbol FindAttribute(Agent& agent, const std::string& word) {
  if (const Symbol identifier = FindIdentifier(agent, word)) return identifier;
  const bool quoted = word.size() > 1 && word.front() == '|' && word.back() == '|';
  const bool number = !quoted && ParseDouble(word).has_value();
  if (!quoted && !number) return agent.symbols().FindString(word);
  if (quoted && !agent.symbols().FindString(word.substr(1, word.size() - 2))) return {};
  const Symbol constant = MakeConstant(agent, word);
  return IsKnown(agent, constant) ? constant : Symbol();
}

bool NotFound(CommandCall& call, const std::string& what) {
  call.Out(what + "\n");
  call.stream().SetColumn(0);
  return call.Fail("An Error occured trying to print the prefs.");
}

/// Links of a state that the architecture creates in slots without preferences.
bool IsLinkToModule(std::string_view attribute) {
  return attribute == "smem" || attribute == "epmem" || attribute == "reward-link";
}

}  // namespace

const std::span<const OptionSpec> kPreferencesOptions = kPreferencesOptionList;

bool CommandPreferences(CommandCall& call) {
  ParsedWords parsed;
  if (!call.Parse(kPreferencesOptions, parsed)) return false;
  if (parsed.arguments.size() > 2) return call.Fail("Syntax: preferences [options] [identifier [attribute]]");
  PrintStream::Capture capture(call.stream(), &call.result.text);
  Detail detail = Detail::kNone;
  for (const ParsedOption& option : parsed.options) {
    switch (option.letter) {
      case '0':
        detail = Detail::kNone;
        break;
      case '1':
      case 'n':
      case 'N':
        detail = Detail::kNames;
        break;
      case '2':
      case 't':
        detail = Detail::kTimetags;
        break;
      case '3':
      case 'w':
        detail = Detail::kWmes;
        break;
      default:
        break;
    }
  }
  Agent& agent = call.agent();
  if (agent.goals().empty()) return NotFound(call, "There is no state.");
  Symbol id = agent.goals().bottom().id;
  std::string id_word = SymbolText(agent, id);
  if (!parsed.arguments.empty()) {
    id_word = parsed.arguments[0].text;
    id = FindIdentifier(agent, id_word);
  }
  if (!id) {
    return NotFound(call, "Could not find the id '" + id_word + "'");
  }
  PreferencePrinter printer(call, detail);
  if (parsed.Has('o')) {
    printer.PrintObject(id);
    return true;
  }
  const bool is_goal = printer.GoalOf(id) != nullptr;
  const std::string word = parsed.arguments.size() > 1 ? parsed.arguments[1].text : "operator";
  if (word == "operator" && !is_goal) {
    printer.PrintSupportOf(id);
    return true;
  }
  std::string attribute_word = word;
  if (attribute_word.size() > 1 && attribute_word.front() == '^') attribute_word.erase(0, 1);
  const Symbol attribute = FindAttribute(agent, attribute_word);
  const SlotId slot = attribute ? agent.memory().FindSlot(id, attribute) : SlotId::kNone;
  const bool is_operator = is_goal && word == "operator";
  if (!is_operator && !attribute) {
    return NotFound(call, "Could not find prefs for the id,attribute pair: " + id_word + " " + word);
  }
  if (!is_operator && !(is_goal && IsLinkToModule(attribute_word)) &&
      (slot == SlotId::kNone || (!printer.HasPreferences(slot) && !agent.memory().slot(slot).is_operator))) {
    call.stream().Print("  This is probably an io- or arch-wme and does not have preferences\n");
    return true;
  }
  printer.Print("\nPreferences for " + SymbolText(agent, id) + " ^" + SymbolText(agent, attribute) + ":\n");
  if (slot != SlotId::kNone) printer.PrintSlot(slot, word == "operator");
  return true;
}

}  // namespace soarbox::cli
