// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/why.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>

#include "debugger/facts_text.h"
#include "debugger/fields.h"
#include "debugger/imagery_rows.h"
#include "debugger/io_rows.h"
#include "debugger/learned_rule.h"
#include "debugger/operators.h"
#include "debugger/recorded_mind.h"
#include "explain/origin_tree.h"
#include "wording/number_words.h"

namespace soarbox::debugger {
namespace {

constexpr int kRulesBack = 4;  ///< Maximum number of rules that an answer goes back.
constexpr std::size_t kMostBelow = 12;

/// The elements of a rule that are worth reporting: without the paths to the links, and elements that only lead to
/// another.
std::vector<explain::ElementFact> Telling(const std::vector<explain::ElementFact>& elements) {
  constexpr std::string_view kWays[] = {"superstate", "io", "input-link", "output-link"};
  std::vector<explain::ElementFact> telling;
  for (const explain::ElementFact& element : elements) {
    const auto leads_to = [&](const explain::ElementFact& other) { return other.id == element.value; };
    const bool is_way = std::ranges::find(kWays, element.attribute) != std::end(kWays);
    const bool leads_on =
        element.is_object && element.attribute != "operator" && std::ranges::any_of(elements, leads_to);
    if (!is_way && !leads_on && telling.size() < kMostBelow) telling.push_back(element);
  }
  return telling;
}

/// Follows elements back to their origins. Each is followed once.
class Tracer {
 public:
  explicit Tracer(explain::Inspector& mind) : mind_(mind) {}

  /// Adds how an element with o-support was made. It was made at one moment, whatever its rule matches now.
  void AddOrigin(std::uint64_t timetag, const explain::MakerFact& maker, int depth, WhyNode& node) {
    std::vector<WhyNode> then = explain::OriginTree(mind_.origins.Of(timetag), mind_.origins.time, false);
    if (then.empty()) {
      node.below.push_back(Rule(maker, depth));
      return;
    }
    if (std::optional<WhyNode> learned = OriginOf(mind_, then.front().link))
      then.front().below.insert(then.front().below.begin(), *std::move(learned));
    for (WhyNode& part : then) node.below.push_back(std::move(part));
  }

  WhyNode Element(const explain::ElementFact& element, int depth) {
    WhyNode node{Describe(element), WhyKind::kElement, std::to_string(element.timetag)};
    if (followed_.contains(element.timetag)) return node;
    // An imagined value is reported at any depth, because it depends on nothing else in memory.
    if (element.attribute == "value") {
      if (std::optional<WhyNode> imagined = WhyRecord(mind_, element.id)) {
        followed_.insert(element.timetag);
        node.below.push_back(*std::move(imagined));
        return node;
      }
    }
    if (depth <= 0) return node;
    followed_.insert(element.timetag);
    for (const explain::MakerFact& maker : mind_.MakersOf(element.timetag)) {
      if (maker.kind == explain::MakerFact::Kind::kInput) {
        node.kind = WhyKind::kPercept;
        node.text += " (perceived)";
      } else if (maker.kind == explain::MakerFact::Kind::kArchitecture) {
        node.text += " (made by the architecture)";
      } else if (maker.o_supported) {
        AddOrigin(element.timetag, maker, depth, node);
      } else {
        node.below.push_back(Rule(maker, depth));
      }
    }
    return node;
  }

  WhyNode Rule(const explain::MakerFact& maker, int depth) {
    WhyNode node{Describe(maker), WhyKind::kRule, maker.rule};
    if (maker.elements.empty() && maker.o_supported) node.text += ": it matched then, and what it made stays";
    if (std::optional<WhyNode> origin = OriginOf(mind_, maker.rule)) node.below.push_back(*std::move(origin));
    for (const explain::ElementFact& element : Telling(maker.elements))
      node.below.push_back(Element(element, depth - 1));
    return node;
  }

  WhyNode Preference(const explain::PreferenceFact& preference) {
    WhyNode node{Describe(preference), WhyKind::kPreference, preference.maker.rule};
    if (std::optional<WhyNode> origin = OriginOf(mind_, preference.maker.rule))
      node.below.push_back(*std::move(origin));
    for (const explain::ElementFact& element : Telling(preference.maker.elements))
      node.below.push_back(Element(element, 2));
    return node;
  }

 private:
  explain::Inspector& mind_;
  std::set<std::uint64_t> followed_;
};

/// An operator with the view of its state.
struct FoundOperator {
  OperatorsView view;
  OperatorRow row;
};

/// Finds an operator by name or identifier in the lowest state with a preference that mentions it.
std::optional<FoundOperator> Find(explain::Inspector& mind, std::string_view op) {
  const std::vector<explain::StateFact> stack = mind.Stack();
  for (auto at = stack.rbegin(); at != stack.rend(); ++at) {
    OperatorsView view = LookAtOperators(mind, at->id);
    const auto row = std::ranges::find_if(
        view.rows, [&](const OperatorRow& candidate) { return candidate.id == op || candidate.name == op; });
    if (row == view.rows.end()) continue;
    // If several have this name, the selected one is used.
    const auto selected = std::ranges::find_if(view.rows, [&](const OperatorRow& candidate) {
      return candidate.selected && (candidate.id == op || candidate.name == op);
    });
    OperatorRow meant = selected == view.rows.end() ? *row : *selected;
    return FoundOperator{std::move(view), std::move(meant)};
  }
  return std::nullopt;
}

std::string CommandText(const CommandRow& command) {
  std::string text = "command " + command.name;
  for (const MemoryRow& row : command.parameters)
    text += " ^" + row.element.attribute + " " + wording::WithoutZeros(row.element.value);
  return text + ": " + command.status + (command.reason.empty() ? "" : " " + command.reason);
}

/// The last command of an agent if it has this name and the world refused it or could not carry it out. It may be gone
/// from the output link.
std::optional<WhyNode> FailedCommand(const sim::Simulation& simulation, std::string_view agent, std::string_view name) {
  std::optional<WhyNode> root = simulation.Why(agent, false);
  if (!root) return std::nullopt;
  for (WhyNode& node : root->below)
    if (node.failed && node.link == name) return std::move(node);
  return std::nullopt;
}

}  // namespace

WhyNode WhyElement(explain::Inspector& mind, std::uint64_t timetag) {
  const std::optional<explain::ElementFact> element = mind.Element(timetag);
  if (!element) return {"there is no element " + std::to_string(timetag) + " now"};
  WhyNode node = Tracer(mind).Element(*element, kRulesBack);
  if (!mind.TellsAll()) node.below.push_back({"which rule made it: " + std::string(Absence(mind))});
  return node;
}

std::optional<WhyNode> WhyOperator(explain::Inspector& mind, std::string_view op) {
  const std::optional<FoundOperator> found = Find(mind, op);
  if (!found) return std::nullopt;
  const auto& [view, row] = *found;
  WhyNode node{view.sentence, WhyKind::kOperator, row.id};
  if (!row.selected) node.text = Title(row) + ": " + row.verdict + ". " + view.sentence;
  Tracer tracer(mind);
  for (const explain::PreferenceFact& preference : row.preferences) node.below.push_back(tracer.Preference(preference));
  for (const OperatorRow& other : view.rows) {
    if (other.id == row.id || node.below.size() >= kMostBelow) continue;
    node.below.push_back({"also there: " + Title(other) + ", " + other.verdict, WhyKind::kOperator, other.id});
  }
  return node;
}

std::optional<WhyNode> WhyCommand(explain::Inspector& mind, std::string_view command) {
  for (const CommandRow& row : LookAtIo(mind).commands) {
    if (row.name != command && row.id != command) continue;
    WhyNode node{CommandText(row), WhyKind::kCommand, row.name};
    const mind::OriginFacts origin = mind.origins.Of(row.timetag);
    node.below = explain::OriginTree(origin, mind.origins.time, true);
    if (!node.below.empty()) {
      std::vector<std::string> selected;
      for (const explain::StateFact& state : mind.Stack()) selected.push_back(state.operator_id);
      for (WhyNode& reason : explain::PresentReason(origin, selected)) node.below.push_back(std::move(reason));
    } else if (const std::optional<explain::ElementFact> element = mind.Element(row.timetag)) {
      node.below = Tracer(mind).Element(*element, kRulesBack).below;
      if (!mind.TellsAll()) node.below.push_back({"which rule gave it: " + std::string(Absence(mind))});
    }
    return node;
  }
  return std::nullopt;
}

Result<WhyNode> WhyName(sim::Simulation& simulation, std::string_view agent, std::string_view name) {
  if (const std::unique_ptr<explain::Inspector> mind = simulation.Inspect(agent)) {
    std::optional<WhyNode> failed = FailedCommand(simulation, agent, name);
    std::optional<WhyNode> command = WhyCommand(*mind, name), op = WhyOperator(*mind, name);
    if (failed) {
      // The command may have the name of its operator.
      if (op) failed->below.push_back(*std::move(op));
      return *std::move(failed);
    }
    if (command) return *std::move(command);
    if (op) return *std::move(op);
    if (std::optional<WhyNode> learned = WhyLearned(*mind, name)) return *std::move(learned);
  }
  Result<std::vector<WhyNode>> reasons = simulation.WhyTopic(agent, std::string(name));
  if (!reasons) return reasons.error();
  return WhyNode{"why not " + std::string(name), WhyKind::kTopic, "", std::move(*reasons)};
}

WhyNode WhyNameOrError(sim::Simulation& simulation, std::string_view agent, std::string_view name) {
  Result<WhyNode> why = WhyName(simulation, agent, name);
  if (why) return std::move(*why);
  std::string text = why.error().message;
  if (!why.error().hint.empty()) text += ": " + why.error().hint;
  return {std::move(text)};
}

WhyNode WhyAgent(const sim::Simulation& simulation, std::string_view agent) {
  const std::unique_ptr<explain::Inspector> mind = simulation.Inspect(agent);
  const bool tells_all = mind != nullptr && mind->TellsAll();
  std::optional<WhyNode> root = simulation.Why(agent, !tells_all);
  if (!root)
    return {"there is no agent " + std::string(agent) + " with a mind of rules", WhyKind::kAgent, std::string(agent)};
  // Our own kernel reports more about the selected operators. They are listed after the command.
  const auto command = std::ranges::find(root->below, WhyKind::kCommand, &WhyNode::kind);
  if (!tells_all || command == root->below.end()) return *std::move(root);
  std::vector<WhyNode> operators;
  for (const explain::StateFact& state : mind->Stack())
    if (std::optional<WhyNode> op = WhyOperator(*mind, state.operator_id)) operators.push_back(*std::move(op));
  if (operators.empty()) operators.push_back({"no operator is selected now"});
  root->below.insert(command + 1, std::make_move_iterator(operators.begin()), std::make_move_iterator(operators.end()));
  return *std::move(root);
}

std::string_view KindWord(WhyKind kind) {
  static constexpr std::string_view kWords[] = {"reason", "agent",   "command", "operator", "preference",
                                                "rule",   "element", "percept", "learned",  "condition",
                                                "recall", "topic",   "imagined"};
  return kWords[static_cast<std::size_t>(kind)];
}

std::string ToText(const WhyNode& node, std::size_t indent) {
  std::string text;
  for (const std::string& line : explain::Lines(node, indent)) text += line + "\n";
  return text;
}

Json ToJson(const WhyNode& node) {
  return JsonOf(node);
}

}  // namespace soarbox::debugger
