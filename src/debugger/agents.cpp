// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/agents.h"

#include <algorithm>

#include "debugger/facts_text.h"
#include "diagnostics/diagnostic.h"

namespace soarbox::debugger {
namespace {

/// The data at the end of tick `tick`. `troubles` may also contain later ones.
AgentRow RowOf(const world::AgentSnapshot& agent, const AgentTroubles& troubles, std::uint64_t tick) {
  AgentRow row;
  row.id = agent.id;
  row.name = agent.name;
  row.kind = agent.kind;
  row.team = agent.team;
  row.script = agent.script;
  row.alive = agent.alive;
  row.failed = agent.failed;
  row.health = agent.health;
  row.command = agent.last_command;
  const std::vector<AgentTroubles::Trouble>& told = troubles.Of(agent.name);
  row.errors = static_cast<std::size_t>(
      std::count_if(told.begin(), told.end(), [&](const AgentTroubles::Trouble& t) { return t.tick <= tick; }));
  if (row.errors == 0) return row;
  const Diagnostic& newest = told[row.errors - 1].diagnostic;
  row.error = Format(newest);
  row.error_file = newest.file;
  row.error_line = newest.line;
  return row;
}

/// The last operator up to a tick.
OperatorName LastOperator(const Timeline& timeline, std::string_view agent, std::uint64_t tick) {
  const TimelineTrack* track = timeline.Find(agent);
  if (track == nullptr) return {};
  const auto is_meant = [&](const TimelineSpan& span) { return !span.is_state && span.first_tick <= tick; };
  if (const auto at = std::find_if(track->open.rbegin(), track->open.rend(), is_meant); at != track->open.rend())
    return {at->text, at->id};
  const auto at = std::find_if(track->spans.rbegin(), track->spans.rend(), is_meant);
  return at == track->spans.rend() ? OperatorName() : OperatorName{at->text, at->id};
}

std::string FirstLine(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

}  // namespace

void AgentTroubles::Add(const sim::EventList& events) {
  using Kind = sim::EventKind;
  for (const sim::RunEvent& event : events) {
    const bool is_error = event.kind == Kind::kAgentFailed || event.kind == Kind::kMindFailed ||
                          (event.kind == Kind::kDiagnostic && event.diagnostic.severity == Severity::kError);
    if (!is_error) continue;
    std::vector<Trouble>& list = troubles_[event.agent];
    if (list.size() == kMost) list.erase(list.begin());
    list.push_back({event.tick, event.diagnostic});
  }
}

const std::vector<AgentTroubles::Trouble>& AgentTroubles::Of(std::string_view agent) const {
  static const std::vector<Trouble> none;
  const auto at = troubles_.find(agent);
  return at == troubles_.end() ? none : at->second;
}

std::vector<AgentRow> ListAgents(const sim::Simulation& simulation, const AgentTroubles& troubles,
                                 const Timeline* timeline) {
  std::map<std::string, double> times_us;
  for (std::size_t i = 0; i < simulation.soar_agents(); ++i) {
    const sim::MindReport report = simulation.Mind(i);
    times_us[report.agent] = report.decide_s * 1e6;
  }
  std::vector<AgentRow> rows;
  for (const world::AgentSnapshot& agent : simulation.Snapshot().agents) {
    AgentRow& row = rows.emplace_back(RowOf(agent, troubles, simulation.tick()));
    const auto time = times_us.find(agent.name);
    row.has_mind = time != times_us.end();
    if (!row.has_mind) continue;
    row.decide_us = time->second;
    const std::unique_ptr<explain::Inspector> mind = simulation.Inspect(agent.name);
    if (mind == nullptr) {
      row.failed = true;
      continue;
    }
    row.decisions = mind->Mind().decisions;
    for (const explain::StateFact& state : mind->Stack()) {
      row.state = state.id;
      row.impasse = state.level == 1 ? std::string() : state.attribute + " " + state.impasse;
      if (!state.operator_id.empty()) row.op = {state.operator_name, state.operator_id};
    }
    row.last_op =
        row.op.id.empty() && timeline != nullptr ? LastOperator(*timeline, row.name, simulation.tick()) : row.op;
  }
  return rows;
}

std::vector<AgentRow> ListAgents(const record::TickRecord& tick, const Timeline& timeline,
                                 const AgentTroubles& troubles) {
  std::vector<AgentRow> rows;
  for (const world::AgentSnapshot& agent : tick.scene.agents) {
    AgentRow& row = rows.emplace_back(RowOf(agent, troubles, tick.tick));
    for (const TimelineSpan& span : timeline.At(agent.name, tick.tick)) {
      row.has_mind = true;
      if (span.is_state) {
        row.state = span.id;
        row.impasse = span.level == 1 ? std::string() : span.text;
      } else {
        row.op = {span.text, span.id};
      }
    }
    row.last_op = row.op.id.empty() ? LastOperator(timeline, row.name, tick.tick) : row.op;
  }
  return rows;
}

std::string ToText(const OperatorName& op) {
  return NameAndId(op.name, op.id);
}

std::string StateText(const AgentRow& row) {
  return row.impasse.empty() ? row.state : row.state + " (" + row.impasse + ")";
}

std::string ToText(const std::vector<AgentRow>& rows) {
  std::vector<std::vector<std::string>> table = {
      {"agent", "kind", "team", "health", "state", "operator", "last operator", "command", "decisions", "errors"}};
  std::string errors;
  for (const AgentRow& row : rows) {
    const std::string health = row.alive ? std::to_string(static_cast<int>(row.health)) : "dead";
    table.push_back({row.name, row.kind, row.team, health, row.has_mind ? StateText(row) : "-", ToText(row.op),
                     ToText(row.last_op), row.command, row.has_mind ? std::to_string(row.decisions) : "-",
                     row.errors == 0 ? "" : std::to_string(row.errors)});
    if (!row.error.empty()) errors += row.name + ": " + FirstLine(row.error) + "\n";
  }
  return Table(table) + errors;
}

}  // namespace soarbox::debugger
