// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include <ostream>

#include "app/diagnostic_json.h"
#include "app/event_printer.h"

namespace soarbox::app {
namespace {

Json Components(const world::Vec3& v) {
  return Json::array({v.x, v.y, v.z});
}

class JsonPrinter : public EventPrinter {
 public:
  explicit JsonPrinter(std::ostream& out) : out_(out) {}

  void Begin(const RunHeader& header) override {
    Json json;
    json["event"] = "begin";
    json["scenario"] = header.scenario;
    json["seed"] = header.seed;
    json["headless"] = header.headless;
    Write(json);
  }

  void Print(const sim::RunEvent& event) override {
    Json json;
    json["event"] = sim::EventName(event.kind);
    json["tick"] = event.tick;
    json["time"] = event.time_s;
    if (!event.agent.empty()) json["agent"] = event.agent;
    switch (event.kind) {
      case sim::EventKind::kCommand:
        json["command"] = event.text;
        if (!event.parameters.empty()) json["parameters"] = event.parameters;
        if (event.has_perceived) json["distance"] = event.perceived;
        json["position"] = Components(event.position);
        break;
      case sim::EventKind::kDiagnostic:
      case sim::EventKind::kAgentFailed:
      case sim::EventKind::kMindFailed:
        json["diagnostic"] = ToJson(event.diagnostic);
        break;
      case sim::EventKind::kOutcome:
        json["command"] = event.news;
        json["text"] = event.text;
        json["position"] = Components(event.position);
        break;
      case sim::EventKind::kNews:
        json["news"] = event.news;
        json["text"] = event.text;
        json["position"] = Components(event.position);
        break;
      case sim::EventKind::kAnswer:
        json["line"] = event.news;
        json["text"] = event.text;
        break;
      default:
        json["text"] = event.text;
        for (const explain::Reason& reason : event.reasons) json["reasons"].push_back(reason.text);
        break;
    }
    Write(json);
  }

  void Report(const world::SceneSnapshot& snapshot) override {
    Json json;
    json["event"] = "state";
    json["tick"] = snapshot.tick;
    json["time"] = snapshot.time_s;
    json["agents"] = Json::array();
    for (const world::AgentSnapshot& agent : snapshot.agents) {
      Json entry;
      entry["name"] = agent.name;
      entry["kind"] = agent.kind;
      entry["position"] = Components(agent.position);
      entry["velocity"] = Components(agent.velocity);
      entry["radius"] = agent.radius_m;
      entry["health"] = agent.health;
      if (!agent.last_command.empty()) entry["command"] = agent.last_command;
      if (agent.failed) entry["failed"] = true;
      json["agents"].push_back(std::move(entry));
    }
    Write(json);
  }

  void End(const RunFooter& footer) override {
    for (const sim::Finding& finding : footer.findings) {
      Json json{{"event", "finding"}, {"tick", finding.tick}, {"time", finding.time_s}};
      if (!finding.agent.empty()) json["agent"] = finding.agent;
      json["cause"] = sim::CauseName(finding.cause);
      json["text"] = finding.text;
      Write(json);
    }
    Json json;
    json["event"] = "end";
    json["ticks"] = footer.ticks;
    json["time"] = footer.time_s;
    json["agents"] = footer.agents;
    json["soar_agents"] = footer.soar_agents;
    json["problems"] = footer.problems;
    json["state"] = fmt::format("{:016x}", footer.state_hash);
    Write(json);
    out_.flush();
  }

 private:
  void Write(const Json& json) { out_ << JsonText(json) << '\n'; }

  std::ostream& out_;
};

}  // namespace

std::unique_ptr<EventPrinter> EventPrinter::MakeJson(std::ostream& out) {
  return std::make_unique<JsonPrinter>(out);
}

}  // namespace soarbox::app
