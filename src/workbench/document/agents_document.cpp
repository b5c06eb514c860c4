// SPDX-License-Identifier: BSD-2-Clause
// Agents: all agents of the world, what each does, and whether it has a problem.
#include <cmath>
#include <utility>

#include "sim/agent_words.h"
#include "workbench/document/build.h"
#include "workbench/document/glossary.h"
#include "workbench/document/panels.h"

namespace soarbox::workbench::document {
namespace {

using debugger::AgentRow;

constexpr float kLowHealth = 35;

/// Whether an agent has a problem. An operator no-change during a long command is normal.
bool IsInTrouble(const AgentRow& row) {
  return !row.impasse.empty() && (row.op.id.empty() || row.impasse != "operator no-change");
}

Cell Doing(const Contents& contents, const AgentRow& row) {
  if (row.failed) return TextCell(sim::kStoppedByError, Role::kBad);
  if (!row.alive) return TextCell("dead", Role::kQuiet);
  if (IsInTrouble(row)) return {{Span{row.impasse, Role::kWarn, std::nullopt, std::string(MeaningOf(row.impasse))}}};
  const auto activity = contents.activities.find(row.id);
  if (activity != contents.activities.end() && !activity->second.empty()) return TextCell(activity->second);
  if (debugger::IsForeign(row)) return TextCell("foreign");
  // The panel Mind shows the identifier of an operator that has a name.
  const debugger::OperatorName& op = row.op.id.empty() ? row.last_op : row.op;
  const std::string& doing = op.id.empty() ? row.command : op.name.empty() ? op.id : op.name;
  if (!doing.empty()) return TextCell(doing);
  return TextCell(row.has_mind ? "idle" : row.script.empty() ? "" : "script " + row.script, Role::kQuiet);
}

std::string Microseconds(double time_us) {
  return std::to_string(std::llround(time_us)) + " \xc2\xb5s";
}

std::string HintOf(const AgentRow& row) {
  std::string text = row.name;
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) text += "\n" + std::string(name) + ": " + value;
  };
  add("kind", row.kind);
  add("team", row.team);
  add("script", row.script);
  add("state", row.has_mind               ? StateText(row)
               : debugger::IsForeign(row) ? "foreign: another simulation moves it"
                                          : "no Soar mind: its script decides");
  add("operator", ToText(row.op));
  add("command", row.command);
  add("error", row.error);
  return text;
}

void AddRow(const Contents& contents, const AgentRow& agent, Table& table) {
  const bool is_dull = !agent.alive || agent.failed;
  Cell name = TextCell(agent.name, is_dull ? Role::kQuiet : Role::kPlain);
  if (agent.errors > 0)
    name.spans.push_back({" \xe2\x9a\xa0" + std::to_string(agent.errors), Role::kBad,
                          Action{SelectRequest{agent.name}, PanelId::kProblems}, agent.error});
  const long health = std::lround(agent.health);
  const Role role = agent.health < kLowHealth || is_dull ? Role::kBad : Role::kQuiet;
  TableRow& row = table.Add(
      agent.name,
      {std::move(name), TextCell(agent.team, Role::kQuiet), Doing(contents, agent),
       NumberCell(static_cast<double>(health), std::to_string(health), role), TextCell(agent.kind, Role::kQuiet),
       agent.decide_us > 0 ? NumberCell(agent.decide_us, Microseconds(agent.decide_us), Role::kQuiet) : Cell()});
  row.hint = HintOf(agent);
  row.is_chosen = agent.name == contents.agent;
  row.sign = BodySign{agent.team, agent.kind, debugger::IsForeign(agent)};
}

}  // namespace

Nodes AgentsDocument(const Contents& contents) {
  Table table;
  table.key = "agents";
  table.columns = {{"Name"},         {"Team", false, true}, {"Doing"},
                   {"Health", true}, {"Kind", false, true}, {"Decision", true, true}};
  table.columns.back().hint = "Real time of the decisions in the last tick";
  table.press = RowAction{{SelectRequest{}}, "agent"};
  table.is_sortable = true;
  table.filter = "Filter";
  table.none_fits = {"No agent has this text.", ""};
  for (const AgentRow& agent : contents.agents) AddRow(contents, agent, table);
  return {OrEmpty(std::move(table), "There are no agents in this world yet.",
                  "A scenario makes them (docs/scenarios.md). Some worlds wait for a key: click the picture, and press "
                  "the key that the world names.")};
}

}  // namespace soarbox::workbench::document
