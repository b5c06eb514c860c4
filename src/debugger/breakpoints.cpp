// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/breakpoints.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <variant>

#include "debugger/facts_text.h"
#include "debugger/memory.h"
#include "diagnostics/problem.h"
#include "diagnostics/wildcard.h"
#include "tell/mind_words.h"

namespace soarbox::debugger {
namespace {

constexpr std::string_view kKinds[] = {"fire", "match", "element", "impasse", "command"};

/// A rule's name holds * itself: one that is meant literally is found first.
bool IsRule(std::string_view name, std::string_view pattern) {
  return name == pattern || IsLikePattern(name, pattern);
}

std::optional<std::string> CauseIn(const Breakpoint& point, const mind::Event& event) {
  if (const auto* fired = std::get_if<mind::RuleFired>(&event); point.kind == BreakKind::kFire && fired != nullptr) {
    if (!fired->retracts && IsRule(fired->rule, point.what)) return "rule " + std::string(fired->rule) + " fired";
  }
  if (const auto* element = std::get_if<mind::ElementChanged>(&event);
      point.kind == BreakKind::kElement && element != nullptr && element->added) {
    const explain::ElementFact fact = FactOf(*element);
    if (IsLike(fact, point.what)) return Describe(fact) + " came";
  }
  if (const auto* made = std::get_if<mind::StateMade>(&event);
      point.kind == BreakKind::kImpasse && made != nullptr && made->level > 1) {
    const std::string impasse = tell::ImpasseText(made->reason, made->on_operator);
    if (impasse.find(point.what) != std::string::npos) return "impasse: " + tell::DecisionLine(event);
  }
  if (const auto* said = std::get_if<mind::CommandSaid>(&event); point.kind == BreakKind::kCommand && said != nullptr) {
    if (point.what.empty() || IsLikePattern(said->name, point.what)) return "command " + tell::CommandText(*said);
  }
  return std::nullopt;
}

std::optional<std::string> CauseIn(const Breakpoint& point, const mind::EventLog& events) {
  mind::Event event;
  for (std::size_t at = 0; events.Next(at, event);)
    if (std::optional<std::string> cause = CauseIn(point, event)) return cause;
  return std::nullopt;
}

}  // namespace

std::string_view NameOf(BreakKind kind) {
  return kKinds[static_cast<std::size_t>(kind)];
}

std::optional<BreakKind> BreakKindNamed(std::string_view name) {
  const auto at = std::ranges::find(kKinds, name);
  if (at == std::end(kKinds)) return std::nullopt;
  return static_cast<BreakKind>(at - std::begin(kKinds));
}

bool IsLike(const explain::ElementFact& element, std::string_view pattern) {
  std::istringstream words{std::string(pattern)};
  std::string word, id = "*", attribute = "*", value = "*";
  int place = 0;
  bool acceptable = false;
  while (words >> word) {
    if (word.starts_with('^')) {
      attribute = word.substr(1);
      place = 1;
    } else if (word == "+" && place == 2) {
      acceptable = true;
    } else if (place == 0) {
      id = word;
    } else {
      value = word;
      place = 2;
    }
  }
  return IsLikePattern(element.id, id) && IsLikePattern(element.attribute, attribute) &&
         IsLikePattern(element.value, value) && (!acceptable || element.acceptable);
}

Result<int> Breakpoints::Set(BreakKind kind, std::string agent, std::string what) {
  const bool is_blank = what.find_first_not_of(" \t") == std::string::npos;
  if (is_blank && (kind == BreakKind::kFire || kind == BreakKind::kMatch))
    return NewProblem("a breakpoint on a rule needs the rule's name", "for example: fire propose*move");
  if (kind == BreakKind::kElement && what.find('^') == std::string::npos)
    return NewProblem("a breakpoint on an element needs an attribute", "for example: ^enemy *, or S1 ^operator O1 +");
  Breakpoint& point = list_.emplace_back();
  point.number = ++last_number_;
  point.kind = kind;
  point.agent = std::move(agent);
  point.what = is_blank ? std::string() : std::move(what);
  return point.number;
}

bool Breakpoints::Clear(int number) {
  return std::erase_if(list_, [number](const Breakpoint& point) { return point.number == number; }) != 0;
}

bool Breakpoints::Enable(int number, bool on) {
  const auto at = std::ranges::find(list_, number, &Breakpoint::number);
  if (at == list_.end()) return false;
  at->enabled = on;
  return true;
}

void Breakpoints::Prepare(sim::Simulation& simulation) {
  if (list_.empty()) return;
  for (std::size_t i = 0; i < simulation.soar_agents(); ++i) {
    const std::string agent = simulation.Mind(i).agent;
    const bool is_meant = std::ranges::any_of(
        list_, [&](const Breakpoint& point) { return point.enabled && (point.agent.empty() || point.agent == agent); });
    if (is_meant && noted_.insert(agent).second) simulation.NoteMind(agent, sim::MindDetail::kAll);
  }
}

std::vector<BreakHit> Breakpoints::Check(const sim::Simulation& simulation) {
  std::vector<BreakHit> hits;
  for (Breakpoint& point : list_) {
    if (!point.enabled) continue;
    for (std::size_t i = 0; i < simulation.soar_agents(); ++i) {
      const sim::MindReport report = simulation.Mind(i);
      if (!point.agent.empty() && point.agent != report.agent) continue;
      std::optional<std::string> cause = CauseIn(point, report.events);
      if (point.kind == BreakKind::kMatch) {
        const std::unique_ptr<explain::Inspector> mind = simulation.Inspect(report.agent);
        const std::optional<explain::MatchFacts> match = mind == nullptr ? std::nullopt : mind->Match(point.what);
        const bool matches = match && !match->failing;
        bool& before = matched_[{point.number, report.agent}];
        if (matches && !before) cause = "rule " + point.what + " matches";
        before = matches;
      }
      if (!cause) continue;
      ++point.hits;
      hits.push_back({point.number, report.agent, simulation.tick(),
                      "breakpoint " + std::to_string(point.number) + ": " + report.agent + ": " + *cause});
    }
  }
  return hits;
}

std::string ToText(const std::vector<Breakpoint>& list) {
  std::vector<std::vector<std::string>> table = {{"number", "on", "what", "agent", "hits", ""}};
  for (const Breakpoint& point : list)
    table.push_back({std::to_string(point.number), std::string(NameOf(point.kind)), point.what,
                     point.agent.empty() ? "any" : point.agent, std::to_string(point.hits),
                     point.enabled ? "" : "off"});
  return list.empty() ? "no breakpoints\n" : Table(table);
}

Json ToJson(const std::vector<Breakpoint>& list) {
  Json json = Json::array();
  for (const Breakpoint& point : list) {
    json.push_back(Json{{"number", point.number},
                        {"kind", NameOf(point.kind)},
                        {"agent", point.agent},
                        {"what", point.what},
                        {"enabled", point.enabled},
                        {"hits", point.hits}});
  }
  return json;
}

}  // namespace soarbox::debugger
