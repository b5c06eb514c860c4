// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/why.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "debugger/facts_text.h"
#include "debugger/io.h"
#include "debugger/operators.h"
#include "debugger/recorded_mind.h"
#include "debugger/rules.h"
#include "diagnostics/diagnostic.h"
#include "sim/rule_text.h"

namespace soarbox::debugger {
namespace {

constexpr int kDepth = 4;  ///< How many rules an answer goes back.
constexpr std::size_t kMostRulesRead = 2'000;
constexpr std::size_t kMostBelow = 12;

/// What matters of a rule's elements: neither the ways to the links nor those that only lead on to another one.
std::vector<sim::ElementFact> Telling(const std::vector<sim::ElementFact>& elements) {
  constexpr std::string_view kWays[] = {"superstate", "io", "input-link", "output-link"};
  std::vector<sim::ElementFact> telling;
  for (const sim::ElementFact& element : elements) {
    const auto leads_to = [&](const sim::ElementFact& other) { return other.id == element.value; };
    const bool is_way = std::ranges::find(kWays, element.attribute) != std::end(kWays);
    const bool leads_on =
        element.is_object && element.attribute != "operator" && std::ranges::any_of(elements, leads_to);
    if (!is_way && !leads_on && telling.size() < kMostBelow) telling.push_back(element);
  }
  return telling;
}

/// Follows elements back to where they come from; each is followed once.
class Tracer {
 public:
  explicit Tracer(sim::Inspector& mind) : mind_(mind) {}

  WhyNode Element(const sim::ElementFact& element, int depth) {
    WhyNode node{Describe(element), "element", std::to_string(element.timetag), {}};
    if (depth <= 0 || !followed_.insert(element.timetag).second) return node;
    for (const sim::MakerFact& maker : mind_.MakersOf(element.timetag)) {
      if (maker.kind == sim::MakerFact::Kind::kInput) {
        node.kind = "percept";
        node.text += " (perceived)";
      } else if (maker.kind == sim::MakerFact::Kind::kArchitecture) {
        node.text += " (made by the architecture)";
      } else {
        node.below.push_back(Rule(maker, depth));
      }
    }
    return node;
  }

  WhyNode Rule(const sim::MakerFact& maker, int depth) {
    WhyNode node{Describe(maker), "rule", maker.rule, {}};
    if (maker.elements.empty() && maker.o_supported) node.text += ": it matched then, and what it made stays";
    for (const sim::ElementFact& element : Telling(maker.elements)) node.below.push_back(Element(element, depth - 1));
    return node;
  }

  WhyNode Preference(const sim::PreferenceFact& preference) {
    WhyNode node{Describe(preference), "preference", preference.maker.rule, {}};
    for (const sim::ElementFact& element : Telling(preference.maker.elements))
      node.below.push_back(Element(element, 2));
    return node;
  }

 private:
  sim::Inspector& mind_;
  std::set<std::uint64_t> followed_;
};

/// An operator with the view of its state.
struct FoundOperator {
  OperatorsView view;
  OperatorRow row;
};

/// In the lowest state whose preferences speak of it, by name or identifier.
std::optional<FoundOperator> Find(sim::Inspector& mind, std::string_view op) {
  const std::vector<sim::StateFact> stack = mind.Stack();
  for (auto at = stack.rbegin(); at != stack.rend(); ++at) {
    OperatorsView view = LookAtOperators(mind, at->id);
    const auto row = std::ranges::find_if(
        view.rows, [&](const OperatorRow& candidate) { return candidate.id == op || candidate.name == op; });
    if (row == view.rows.end()) continue;
    // Of several with this name the one that is selected is meant.
    const auto selected = std::ranges::find_if(view.rows, [&](const OperatorRow& candidate) {
      return candidate.selected && (candidate.id == op || candidate.name == op);
    });
    OperatorRow meant = selected == view.rows.end() ? *row : *selected;
    return FoundOperator{std::move(view), std::move(meant)};
  }
  return std::nullopt;
}

std::vector<sim::RuleText> ReadAllRules(sim::Inspector& mind) {
  std::vector<sim::RuleText> rules;
  for (const sim::RuleFact& rule : mind.Rules()) {
    if (rules.size() >= kMostRulesRead) break;
    for (sim::RuleText& read : sim::ReadRules(mind.RuleSource(rule.name))) rules.push_back(std::move(read));
  }
  return rules;
}

/// One rule, and how far it matches.
WhyNode RuleState(sim::Inspector& mind, const std::string& rule, const std::string& does) {
  WhyNode node{"rule " + rule + " " + does, "rule", rule, {}};
  if (const std::optional<PartialMatch> match = LookAtMatch(mind, rule)) node.text += ", and " + match->sentence;
  return node;
}

WhyNode NotProposed(sim::Inspector& mind, const std::string& name, const std::vector<sim::RuleText>& rules) {
  WhyNode node{"no operator " + name + " is proposed now", "operator", name, {}};
  for (const sim::RuleText& rule : rules)
    if (rule.proposes.contains(name)) node.below.push_back(RuleState(mind, rule.name, "would propose it"));
  return node;
}

/// Names of operators and commands that rules speak of, near to this one.
std::string NearName(const std::vector<sim::RuleText>& rules, std::string_view name) {
  std::set<std::string> known;
  for (const sim::RuleText& rule : rules) {
    known.insert(rule.proposes.begin(), rule.proposes.end());
    known.insert(rule.says.begin(), rule.says.end());
  }
  known.erase("");
  const std::vector<std::string_view> names(known.begin(), known.end());
  return std::string(Suggest(name, names));
}

std::string CommandText(const CommandRow& command) {
  std::string text = "command " + command.name;
  for (const MemoryRow& row : command.parameters) text += " ^" + row.element.attribute + " " + row.element.value;
  return text + ": " + command.status + (command.reason.empty() ? "" : " " + command.reason);
}

/// Lines that are indented by two blanks per step, as a tree.
void Nest(WhyNode& root, const std::vector<std::string>& lines, std::size_t& next, std::size_t indent) {
  while (next < lines.size()) {
    const std::string& line = lines[next];
    const std::size_t blanks = std::min(line.find_first_not_of(' '), line.size());
    if (blanks < indent) return;
    WhyNode node{line.substr(blanks), "reason", "", {}};
    if (node.text.starts_with("command ")) node.kind = "command";
    if (node.text.starts_with('^')) node.kind = "percept";
    ++next;
    Nest(node, lines, next, blanks + 1);
    root.below.push_back(std::move(node));
  }
}

void Append(std::string& text, const WhyNode& node, std::size_t indent) {
  text += std::string(2 * indent, ' ') + node.text + "\n";
  for (const WhyNode& below : node.below) Append(text, below, indent + 1);
}

}  // namespace

WhyNode WhyElement(sim::Inspector& mind, std::uint64_t timetag) {
  const std::optional<sim::ElementFact> element = mind.Element(timetag);
  if (!element) return {"there is no element " + std::to_string(timetag) + " now", "reason", "", {}};
  WhyNode node = Tracer(mind).Element(*element, kDepth);
  if (!mind.TellsAll()) node.below.push_back({"who made it: " + std::string(Absence(mind)), "reason", "", {}});
  return node;
}

WhyNode WhyOperator(sim::Inspector& mind, std::string_view op) {
  const std::optional<FoundOperator> found = Find(mind, op);
  if (!found) return WhyNot(mind, op);
  const auto& [view, row] = *found;
  WhyNode node{view.sentence, "operator", row.id, {}};
  if (!row.selected) node.text = NameAndId(row.name, row.id) + ": " + row.verdict + ". " + view.sentence;
  Tracer tracer(mind);
  for (const sim::PreferenceFact& preference : row.preferences) node.below.push_back(tracer.Preference(preference));
  for (const OperatorRow& other : view.rows) {
    if (other.id == row.id || node.below.size() >= kMostBelow) continue;
    node.below.push_back(
        {"also there: " + NameAndId(other.name, other.id) + ", " + other.verdict, "operator", other.id, {}});
  }
  return node;
}

WhyNode WhyCommand(sim::Inspector& mind, std::string_view command) {
  for (const CommandRow& row : LookAtIo(mind).commands) {
    if (row.name != command && row.id != command) continue;
    WhyNode node{CommandText(row), "command", row.name, {}};
    if (const std::optional<sim::ElementFact> element = mind.Element(row.timetag)) {
      node.below = Tracer(mind).Element(*element, kDepth).below;
      if (!mind.TellsAll()) node.below.push_back({"who said it: " + std::string(Absence(mind)), "reason", "", {}});
    }
    return node;
  }
  return WhyNot(mind, command);
}

WhyNode WhyNot(sim::Inspector& mind, std::string_view given) {
  const std::string name(given);
  if (const std::optional<FoundOperator> found = Find(mind, given)) {
    const auto& [view, row] = *found;
    WhyNode node{NameAndId(row.name, row.id) + (row.selected ? " is selected: " : " is not selected: ") +
                     (row.selected ? view.sentence : row.verdict + ". " + view.sentence),
                 "operator",
                 row.id,
                 {}};
    Tracer tracer(mind);
    for (const sim::PreferenceFact& preference : row.preferences) node.below.push_back(tracer.Preference(preference));
    return node;
  }
  for (const CommandRow& command : LookAtIo(mind).commands)
    if (command.name == name) return {CommandText(command) + "; it stands on the output link", "command", name, {}};
  const std::vector<sim::RuleText> rules = ReadAllRules(mind);
  const auto proposes = [&](const sim::RuleText& rule) { return rule.proposes.contains(name); };
  if (std::ranges::any_of(rules, proposes)) return NotProposed(mind, name, rules);
  WhyNode node{"command " + name + " is not said now", "command", name, {}};
  std::set<std::string> told;
  for (const sim::RuleText& rule : rules) {
    if (!rule.says.contains(name)) continue;
    WhyNode& says = node.below.emplace_back(RuleState(mind, rule.name, "would say it"));
    for (const std::string& op : rule.applies) {
      if (op.empty() || !told.insert(op).second) continue;
      const std::optional<FoundOperator> applied = Find(mind, op);
      says.below.push_back(
          applied ? WhyNode{"operator " + NameAndId(applied->row.name, applied->row.id) + ": " + applied->row.verdict,
                            "operator",
                            applied->row.id,
                            {}}
                  : NotProposed(mind, op, rules));
    }
  }
  if (!node.below.empty()) return node;
  node.text = "no rule proposes an operator or says a command " + name;
  if (const std::string near = NearName(rules, name); !near.empty()) node.text += ": did you mean " + near + "?";
  return node;
}

WhyNode WhyAgent(const sim::Simulation& simulation, std::string_view agent) {
  const std::vector<std::string> lines = simulation.Why(agent);
  if (lines.empty())
    return {"there is no agent " + std::string(agent) + " with a mind of rules", "agent", std::string(agent), {}};
  WhyNode root{lines.front(), "agent", std::string(agent), {}};
  std::size_t next = 1;
  WhyNode told;
  Nest(told, lines, next, 0);
  const std::unique_ptr<sim::Inspector> mind = simulation.Inspect(agent);
  for (WhyNode& node : told.below) {
    // The operators stand below the command that they led to; our own kernel tells more of them.
    if (mind != nullptr && mind->TellsAll() && (node.kind == "command" || node.text == "has said no command")) {
      node.below.clear();
      if (node.kind == "command") {
        const std::string rest = node.text.substr(std::string_view("command ").size());
        node.link = rest.substr(0, rest.find_first_of(" ,"));
      }
      for (const sim::StateFact& state : mind->Stack())
        if (!state.operator_id.empty()) node.below.push_back(WhyOperator(*mind, state.operator_id));
      if (node.below.empty()) {
        // What said it may still stand, with what it rested on.
        if (!node.link.empty()) node.below = WhyCommand(*mind, node.link).below;
        node.below.push_back({"no operator is selected now", "reason", "", {}});
      }
    }
    root.below.push_back(std::move(node));
  }
  return root;
}

std::string ToText(const WhyNode& node) {
  std::string text;
  Append(text, node, 0);
  return text;
}

Json ToJson(const WhyNode& node) {
  Json json;
  json["text"] = node.text;
  json["kind"] = node.kind;
  if (!node.link.empty()) json["link"] = node.link;
  if (!node.below.empty()) {
    json["below"] = Json::array();
    for (const WhyNode& below : node.below) json["below"].push_back(ToJson(below));
  }
  return json;
}

}  // namespace soarbox::debugger
