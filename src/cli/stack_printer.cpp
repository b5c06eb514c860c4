// SPDX-License-Identifier: BSD-2-Clause
#include "cli/stack_printer.h"

#include <vector>

#include "cli/object_printer.h"
#include "diagnostics/name_table.h"

namespace soarbox::cli {
namespace {

using kernel::Agent;
using kernel::GoalInfo;
using kernel::Symbol;

std::string LineStart(const GoalInfo& goal, const std::string& cycle) {
  std::string line(cycle.size() < 6 ? 6 - cycle.size() : 0, ' ');
  line += cycle + ": ";
  line.append(static_cast<std::size_t>(3 * (goal.level > 0 ? goal.level - 1 : 0)), ' ');
  return line;
}

/// The values of an attribute, newest element first.
std::vector<Symbol> ValuesOf(const Agent& agent, Symbol id, const char* attribute) {
  const Symbol wanted = agent.symbols().FindString(attribute);
  std::vector<Symbol> values;
  if (!wanted) return values;
  for (const kernel::WmeId wme : agent.memory().WmesOf(id)) {
    const kernel::Wme& element = agent.memory().wme(wme);
    if (element.attribute == wanted && !element.acceptable) values.push_back(element.value);
  }
  return values;
}

bool IsProposed(const Agent& agent, Symbol id) {
  for (std::size_t level = 1; level <= agent.goals().depth(); ++level) {
    for (const kernel::WmeId wme : agent.memory().WmesOf(agent.goals().at(static_cast<kernel::GoalLevel>(level)).id)) {
      const kernel::Wme& element = agent.memory().wme(wme);
      if (element.acceptable && element.value == id) return true;
    }
  }
  return false;
}

/// An object in a line about an operator: "P1 (pump)", "S2 (state no-change)", "red".
std::string ObjectText(const Agent& agent, Symbol symbol, int depth);

/// The text after an operator or another object: "(name)" with all of its names, or nothing if it has none. For an
/// operator named evaluate-object, its objects.
std::string Label(const Agent& agent, Symbol id, bool is_operator, int depth) {
  const std::vector<Symbol> names = ValuesOf(agent, id, "name");
  if (names.empty()) return {};
  std::string text;
  const auto add = [&](const std::string& word) { text += (text.empty() ? "" : " ") + word; };
  constexpr int kDeepest = 8;  // Operators may evaluate themselves.
  if (is_operator && names.front() == agent.symbols().FindString("evaluate-object") && depth < kDeepest) {
    for (const Symbol object : ValuesOf(agent, id, "object")) add(ObjectText(agent, object, depth + 1));
    return "(evaluate-object " + text + ")";
  }
  for (const Symbol name : names) add(SymbolText(agent, name));
  return "(" + text + ")";
}

std::string ObjectText(const Agent& agent, Symbol symbol, int depth) {
  std::string text = SymbolText(agent, symbol);
  if (!symbol.IsIdentifier()) return text;
  for (std::size_t level = 1; level <= agent.goals().depth(); ++level) {
    const GoalInfo goal = agent.Describe(agent.goals().at(static_cast<kernel::GoalLevel>(level)));
    if (goal.goal == symbol) return text + " " + ImpasseText(goal);
  }
  const std::string label = Label(agent, symbol, IsProposed(agent, symbol), depth);
  return label.empty() ? text : text + " " + label;
}

}  // namespace

const char* PhaseName(kernel::Phase phase) {
  static constexpr const char* kNames[] = {"input", "propose", "decision", "apply", "output"};
  return NameIn(kNames, phase);
}

const char* ImpasseName(kernel::ImpasseType type) {
  static constexpr const char* kNames[] = {"none", "tie", "conflict", "constraint-failure", "no-change"};
  return NameIn(kNames, type);
}

std::string ImpasseText(const GoalInfo& goal) {
  if (goal.impasse == kernel::ImpasseType::kNone) return {};
  return std::string("(") + (goal.on_operator ? "operator " : "state ") + ImpasseName(goal.impasse) + ")";
}

std::string StateLine(const Agent& agent, const GoalInfo& goal, const std::string& cycle) {
  return LineStart(goal, cycle) + "==>S: " + SymbolText(agent, goal.goal) + " " + ImpasseText(goal);
}

std::string OperatorLine(const Agent& agent, const GoalInfo& goal, const std::string& cycle) {
  return LineStart(goal, cycle) + "   O: " + OperatorText(agent, goal.op);
}

std::string OperatorText(const Agent& agent, Symbol op) {
  return SymbolText(agent, op) + (op.IsIdentifier() ? " " + Label(agent, op, true, 0) : "");
}

std::string OperatorName(const Agent& agent, Symbol op) {
  if (!op.IsIdentifier()) return {};
  const Symbol attribute = agent.symbols().FindString("name");
  if (!attribute) return {};
  const Symbol name = agent.memory().ValueOf(op, attribute);
  return name ? SymbolText(agent, name) : std::string();
}

void PrintStack(PrintStream& stream, const Agent& agent, bool states, bool operators, ResultNode& structured) {
  for (std::size_t level = 1; level <= agent.goals().depth(); ++level) {
    const GoalInfo goal = agent.Describe(agent.goals().at(static_cast<kernel::GoalLevel>(level)));
    const std::string cycle = std::to_string(agent.counters().decision_phases);
    if (states) {
      stream.Print(StateLine(agent, goal, "") + "\n");
      ResultNode& node = structured.Add("state");
      node.Set("current_state_id", SymbolText(agent, goal.goal)).Set("decision_cycle_count", cycle);
      node.Set("stack_level", std::to_string(level - 1));
      if (goal.impasse != kernel::ImpasseType::kNone) {
        node.Set("impasse_object", goal.on_operator ? "operator" : "state");
        node.Set("impasse_type", ImpasseName(goal.impasse));
      }
    }
    if (operators && goal.op) {
      stream.Print(OperatorLine(agent, goal, "") + "\n");
      ResultNode& node = structured.Add("operator");
      node.Set("current_operator_id", SymbolText(agent, goal.op)).Set("decision_cycle_count", cycle);
      node.Set("name", OperatorName(agent, goal.op)).Set("stack_level", std::to_string(level - 1));
    }
  }
}

}  // namespace soarbox::cli
