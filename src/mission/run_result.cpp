// SPDX-License-Identifier: BSD-2-Clause
#include <nlohmann/json.hpp>

#include "mission/run_mission.h"

namespace soarbox::mission {
namespace {

using Json = nlohmann::json;

State StateNamed(const std::string& name) {
  for (const State state : {State::kOpen, State::kTrue, State::kFalse, State::kUntested, State::kUndecided})
    if (NameOf(state) == name) return state;
  return State::kOpen;
}

}  // namespace

std::string ToJsonLine(const RunResult& result) {
  Json checks = Json::array();
  for (const CheckResult& check : result.checks) {
    Json& made = checks.emplace_back(
        Json{{"state", NameOf(check.verdict.state)}, {"tick", check.verdict.tick}, {"time", check.verdict.time_s}});
    if (!check.verdict.agent.empty()) made["agent"] = check.verdict.agent;
    if (!check.verdict.was.empty()) made["was"] = check.verdict.was;
    if (!check.expected.empty()) made["expected"] = check.expected;
    if (!check.reasons.empty()) made["reasons"] = check.reasons;
  }
  Json json{{"outcome", result.outcome},   {"seed", result.seed},
            {"passed", result.passed},     {"seconds", result.seconds},
            {"ticks", result.ticks},       {"state_hash", std::to_string(result.state_hash)},
            {"checks", std::move(checks)}, {"numbers", result.numbers}};
  if (!result.error.empty()) json["error"] = result.error;
  if (!result.recording.empty()) json["recording"] = result.recording;
  for (const sim::Finding& finding : result.account)
    json["account"].push_back(Json{{"cause", static_cast<int>(finding.cause)},
                                   {"text", finding.text},
                                   {"rule", finding.rule},
                                   {"topic", static_cast<int>(finding.topic)}});
  if (!result.problems.empty()) json["problems"] = result.problems;
  if (result.has_errors) json["has_errors"] = true;
  if (result.is_faulty) json["faulty"] = true;
  if (!result.idle_checks.empty()) json["idle_checks"] = result.idle_checks;
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<RunResult> FromJsonLine(const std::string& line) {
  Diagnostic problem;
  problem.message = "the result of a run is damaged";
  const Json json = Json::parse(line, nullptr, false);
  if (!json.is_object()) return problem;
  try {
    RunResult result;
    result.outcome = json.value("outcome", "");
    result.error = json.value("error", "");
    result.seed = json.value("seed", std::uint64_t{0});
    result.passed = json.value("passed", false);
    result.seconds = json.value("seconds", 0.0);
    result.ticks = json.value("ticks", std::uint64_t{0});
    result.state_hash = std::stoull(json.value("state_hash", "0"));
    result.recording = json.value("recording", "");
    for (const Json& each : json.value("account", Json::array())) {
      const int cause = each.value("cause", 0), topic = each.value("topic", 0);
      if (cause < 0 || cause > static_cast<int>(sim::kLastCause) || topic < 0 || topic > static_cast<int>(kLastTopic))
        return problem;
      result.account.push_back({.cause = static_cast<Cause>(cause),
                                .text = each.value("text", ""),
                                .rule = each.value("rule", ""),
                                .topic = static_cast<Topic>(topic)});
    }
    result.problems = json.value("problems", std::vector<std::string>{});
    result.has_errors = json.value("has_errors", false);
    result.is_faulty = json.value("faulty", false);
    result.idle_checks = json.value("idle_checks", std::vector<std::size_t>{});
    result.numbers = json.value("numbers", std::map<std::string, double>{});
    for (const Json& each : json.at("checks")) {
      CheckResult& check = result.checks.emplace_back();
      check.verdict = {StateNamed(each.value("state", "")), each.value("tick", std::uint64_t{0}),
                       each.value("time", 0.0), each.value("agent", ""), each.value("was", "")};
      check.expected = each.value("expected", "");
      check.reasons = each.value("reasons", std::vector<std::string>{});
    }
    return result;
  } catch (const std::exception&) {
    return problem;
  }
}

}  // namespace soarbox::mission
