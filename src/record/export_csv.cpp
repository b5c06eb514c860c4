// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "record/export.h"
#include "record/percept_values.h"
#include "wording/mind_words.h"

namespace soarbox::record {
namespace {

/// A cell of the table; quoted if it contains separators (RFC 4180).
std::string CsvCell(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

std::string LastDecision(const mind::EventLog& events) {
  std::string last;
  mind::Event event;
  for (std::size_t at = 0; events.Next(at, event);)
    if (std::string line = wording::DecisionLine(event); !line.empty()) last = std::move(line);
  return last;
}

}  // namespace

Result<void> ExportCsv(Reader& recording, TickRange range, std::ostream& out) {
  // The first pass collects the names of percepts. Percepts from before the range are also valid in it.
  std::set<std::string> names;
  std::map<std::string, PerceptValues> perceived;
  const TickRange before_too{recording.first_tick(), range.last};
  Result<void> read = ForEachTick(recording, before_too, [&](const TickRecord& record) {
    for (const MindRecord& mind : record.minds) {
      PerceptValues& values = perceived[mind.agent];
      ApplyPercepts(mind.events, values);
      if (record.tick < range.first) continue;
      for (const auto& [path, value] : values) names.insert(path);
    }
  });
  if (!read) return read;

  out << "tick,time_s,agent,x_m,y_m,z_m,vx_mps,vy_mps,vz_mps,speed_mps,heading_deg,health,command,decision";
  for (const std::string& name : names) out << ',' << CsvCell(name);
  out << '\n';
  perceived.clear();
  return ForEachTick(recording, before_too, [&](const TickRecord& record) {
    for (const MindRecord& mind : record.minds) ApplyPercepts(mind.events, perceived[mind.agent]);
    if (record.tick < range.first) return;
    for (const world::AgentSnapshot& agent : record.scene.agents) {
      const double heading = std::atan2(agent.forward.x, agent.forward.z) * 180 / std::numbers::pi;
      const MindRecord* mind = FindMind(record, agent.name);
      const std::string decision = mind != nullptr ? LastDecision(mind->events) : std::string();
      out << fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{}", record.tick, record.scene.time_s,
                         CsvCell(agent.name), agent.position.x, agent.position.y, agent.position.z, agent.velocity.x,
                         agent.velocity.y, agent.velocity.z, world::Length(agent.velocity), static_cast<float>(heading),
                         agent.health, CsvCell(agent.last_command), CsvCell(decision));
      const PerceptValues& values = perceived[agent.name];
      for (const std::string& name : names) {
        const auto at = values.find(name);
        out << ',' << (at == values.end() ? std::string() : CsvCell(TextOf(at->second)));
      }
      out << '\n';
    }
  });
}

}  // namespace soarbox::record
