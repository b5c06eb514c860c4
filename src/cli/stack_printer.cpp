// SPDX-License-Identifier: BSD-2-Clause
#include "cli/stack_printer.h"

#include "cli/object_printer.h"

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

}  // namespace

const char* ImpasseName(kernel::ImpasseType type) {
  switch (type) {
    case kernel::ImpasseType::kTie:
      return "tie";
    case kernel::ImpasseType::kConflict:
      return "conflict";
    case kernel::ImpasseType::kConstraintFailure:
      return "constraint-failure";
    case kernel::ImpasseType::kNoChange:
      return "no-change";
    case kernel::ImpasseType::kNone:
      break;
  }
  return "none";
}

std::string ImpasseText(const GoalInfo& goal) {
  if (goal.impasse == kernel::ImpasseType::kNone) return {};
  return std::string("(") + (goal.on_operator ? "operator " : "state ") + ImpasseName(goal.impasse) + ")";
}

std::string StateLine(const Agent& agent, const GoalInfo& goal, const std::string& cycle) {
  return LineStart(goal, cycle) + "==>S: " + SymbolText(agent, goal.goal) + " " + ImpasseText(goal);
}

std::string OperatorLine(const Agent& agent, const GoalInfo& goal, const std::string& cycle) {
  const std::string name = OperatorName(agent, goal.op);
  return LineStart(goal, cycle) + "   O: " + SymbolText(agent, goal.op) +
         (!name.empty()            ? " (" + name + ")"
          : goal.op.IsIdentifier() ? " "
                                   : "");
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
