// SPDX-License-Identifier: BSD-2-Clause
#include "sim/findings.h"

#include <array>
#include <cstdio>
#include <filesystem>

namespace soarbox::sim {
namespace {

/// Maximum number of different diagnostics that are kept.
constexpr std::size_t kMostReported = 500;

bool IsDiagnostic(const RunEvent& event) {
  return event.kind == EventKind::kDiagnostic || event.kind == EventKind::kAgentFailed ||
         event.kind == EventKind::kMindFailed;
}

}  // namespace

std::string_view CauseName(Cause cause) {
  constexpr std::array<std::string_view, static_cast<std::size_t>(kLastCause) + 1> kNames = {
      "broken",   "slip",   "mistake", "endless", "refused", "furthest",
      "happened", "awaits", "stalled", "missing", "waiting", "symptom"};
  return kNames.at(static_cast<std::size_t>(cause));
}

Cause CauseOf(const Diagnostic& problem) {
  if (problem.severity == Severity::kNote) return Cause::kSymptom;
  if (problem.topic == Topic::kEndless || problem.topic == Topic::kHaltedAtWork) return Cause::kEndless;
  return problem.severity == Severity::kError ? Cause::kBroken : Cause::kSlip;
}

std::string OneLine(const Diagnostic& problem) {
  std::string place = std::filesystem::path(problem.file).filename().string();
  if (!place.empty()) place += (problem.line > 0 ? ":" + std::to_string(problem.line) : "") + ": ";
  return place + problem.message + (problem.hint.empty() ? "" : "; " + problem.hint);
}

std::string SecondsText(double seconds) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f s", seconds);
  return text.data();
}

Cause CauseOf(const explain::Reason& reason) {
  switch (reason.kind) {
    case explain::Reason::Kind::kRefused:
      return Cause::kRefused;
    case explain::Reason::Kind::kStalled:
      return Cause::kStalled;
    case explain::Reason::Kind::kAwaitsTurn:
      return Cause::kWaiting;
    case explain::Reason::Kind::kStops:
    case explain::Reason::Kind::kStopsAtUnmade:
      return Cause::kFurthest;
    default:
      return Cause::kSymptom;
  }
}

void EventFindings::SeeIdle(const RunEvent& event) {
  const auto [at, is_new] = idle_.try_emplace(event.agent);
  if (!is_new) return;
  Idle& idle = at->second;
  idle.tick = event.tick;
  idle.time_s = event.time_s;
  idle.symptom = "At " + SecondsText(event.time_s) + " " + event.agent + " has nothing to do: " + event.text;
  for (const explain::Reason& reason : event.reasons) {
    // Percepts contain no information about the rules.
    if (reason.kind != explain::Reason::Kind::kPercepts) idle.reasons.push_back(reason);
  }
}

void EventFindings::See(const EventList& events) {
  for (const RunEvent& event : events) {
    if (event.kind == EventKind::kGap) SeeIdle(event);
    if (event.kind == EventKind::kOutcome && !event.reasons.empty()) {
      std::string text = "At " + SecondsText(event.time_s) + " the world refused " + event.news + " of " + event.agent +
                         ": " + event.reasons.front().text;
      refused_.try_emplace(event.agent,
                           Finding{Cause::kRefused, std::move(text), event.agent, event.tick, event.time_s});
    }
    if (!IsDiagnostic(event) || event.diagnostic.severity == Severity::kNote || reported_.size() >= kMostReported)
      continue;
    Finding finding{CauseOf(event.diagnostic), OneLine(event.diagnostic), event.agent, event.tick, event.time_s};
    finding.rule = event.diagnostic.rule;
    finding.topic = event.diagnostic.topic;
    const bool is_known =
        std::ranges::any_of(reported_, [&](const Reported& one) { return one.finding.text == finding.text; });
    if (!is_known) reported_.push_back({std::move(finding), event.diagnostic});
  }
}

std::vector<Finding> EventFindings::OfAgents() const {
  std::vector<Finding> found;
  for (const auto& [agent, refused] : refused_) found.push_back(refused);
  for (const auto& [agent, idle] : idle_) {
    Finding finding{Cause::kSymptom, idle.symptom, agent, idle.tick, idle.time_s};
    if (!idle.reasons.empty()) {
      // "no operator is proposed" is less informative than the condition at which the proposal stops.
      const explain::Reason& reason =
          *std::ranges::min_element(idle.reasons, {}, [](const explain::Reason& one) { return CauseOf(one); });
      finding.cause = CauseOf(reason);
      finding.text = "At " + SecondsText(idle.time_s) + " " + agent + " has nothing to do: " + reason.text;
    }
    found.push_back(std::move(finding));
  }
  std::ranges::stable_sort(found, {}, &Finding::tick);
  return found;
}

std::vector<Finding> EventFindings::Ranked() const {
  std::vector<Finding> found;
  for (const Reported& one : reported_) found.push_back(one.finding);
  for (Finding& finding : OfAgents()) found.push_back(std::move(finding));
  RankByCause(found);
  return found;
}

}  // namespace soarbox::sim
