// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "record/export.h"
#include "wording/mind_words.h"

namespace soarbox::record {
namespace {

using Json = nlohmann::ordered_json;

/// Texts of scenarios can contain any bytes; invalid UTF-8 is replaced.
std::string Line(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json Components(world::Vec3 v) {
  return Json::array({v.x, v.y, v.z});
}

Json OfAgent(const world::AgentSnapshot& agent) {
  Json json;
  json["name"] = agent.name;
  json["kind"] = agent.kind;
  json["position"] = Components(agent.position);
  json["velocity"] = Components(agent.velocity);
  json["forward"] = Components(agent.forward);
  json["health"] = agent.health;
  json["alive"] = agent.alive;
  if (!agent.last_command.empty()) json["command"] = agent.last_command;
  if (agent.failed) json["failed"] = true;
  return json;
}

Json OfEvent(const sim::RunEvent& event) {
  Json json;
  json["kind"] = sim::EventName(event.kind);
  if (!event.agent.empty()) json["agent"] = event.agent;
  if (!event.news.empty()) json["news"] = event.news;
  if (!event.text.empty()) json["text"] = event.text;
  // The text of an outcome contains its reason.
  if (event.kind != sim::EventKind::kOutcome)
    for (std::string& remark : sim::Remarks(event)) json["reasons"].push_back(std::move(remark));
  if (!event.parameters.empty()) json["parameters"] = event.parameters;
  if (!event.diagnostic.message.empty()) json["diagnostic"] = Format(event.diagnostic);
  return json;
}

Json OfMind(const MindRecord& mind) {
  Json json;
  json["agent"] = mind.agent;
  const wording::MindWords words = wording::Words(mind.events);
  if (!words.percepts.empty()) json["percepts"] = words.percepts;
  if (!words.decisions.empty()) json["decisions"] = words.decisions;
  if (!words.reasons.empty()) json["reasons"] = words.reasons;
  if (!words.details.empty()) json["details"] = words.details;
  if (!words.commands.empty()) json["commands"] = words.commands;
  if (!words.command_rules.empty()) json["command_rules"] = words.command_rules;
  return json;
}

}  // namespace

Result<void> ExportJson(Reader& recording, TickRange range, std::ostream& out) {
  const Header& header = recording.header();
  Json head;
  head["build"] = header.build;
  head["scenario"] = header.scenario;
  head["seed"] = header.seed;
  head["level"] = NameOf(header.level);
  if (!header.branched_from.empty()) {
    head["branched_from"] = header.branched_from;
    head["branch_tick"] = header.branch_tick;
  }
  head["step_s"] = header.step_s;
  head["first_tick"] = recording.first_tick();
  head["last_tick"] = recording.last_tick();
  out << Line(head);
  return ForEachTick(recording, range, [&](const TickRecord& record) {
    Json json;
    json["tick"] = record.tick;
    json["time_s"] = record.scene.time_s;
    json["state"] = fmt::format("{:016x}", record.state_hash);
    if (!record.inputs.empty()) json["inputs"] = record.inputs;
    json["agents"] = Json::array();
    for (const world::AgentSnapshot& agent : record.scene.agents) json["agents"].push_back(OfAgent(agent));
    for (const sim::RunEvent& event : record.events) json["events"].push_back(OfEvent(event));
    for (const MindRecord& mind : record.minds) json["minds"].push_back(OfMind(mind));
    out << Line(json);
  });
}

}  // namespace soarbox::record
