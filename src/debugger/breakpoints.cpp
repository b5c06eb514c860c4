// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/breakpoints.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <system_error>
#include <utility>
#include <variant>

#include "debugger/facts_text.h"
#include "debugger/fields.h"
#include "debugger/memory.h"
#include "diagnostics/number_from_chars.h"
#include "diagnostics/problem.h"
#include "diagnostics/wildcard.h"
#include "explain/command_text.h"
#include "wording/mind_words.h"
#include "world/world.h"

namespace soarbox::debugger {
namespace {

constexpr std::string_view kRelations[] = {"<", "<=", ">", ">=", "=", "<>"};

/// The parts of "ID ^attribute < 20".
struct NumberTest {
  std::string id = "*", attribute, relation;
  double limit = 0;
};

std::optional<double> NumberOf(std::string_view text) {
  double number = 0;
  const auto [end, error] = NumberFromChars(text, number);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(number)) return std::nullopt;
  return number;
}

std::optional<NumberTest> ReadNumberTest(std::string_view text) {
  std::istringstream words{std::string(text)};
  NumberTest test;
  std::string word, limit, more;
  if (!(words >> word)) return std::nullopt;
  if (!word.starts_with('^')) {
    test.id = word;
    if (!(words >> word)) return std::nullopt;
  }
  if (!word.starts_with('^') || word.size() == 1 || !(words >> test.relation >> limit) || words >> more)
    return std::nullopt;
  const std::optional<double> number = NumberOf(limit);
  if (!number || std::ranges::find(kRelations, test.relation) == std::end(kRelations)) return std::nullopt;
  test.attribute = word.substr(1);
  test.limit = *number;
  return test;
}

bool Holds(const NumberTest& test, double number) {
  if (test.relation == "<") return number < test.limit;
  if (test.relation == "<=") return number <= test.limit;
  if (test.relation == ">") return number > test.limit;
  if (test.relation == ">=") return number >= test.limit;
  return (number == test.limit) == (test.relation == "=");
}

/// Names of rules can contain *, so an exact match is tested first.
bool IsRule(std::string_view name, std::string_view pattern) {
  return name == pattern || IsLikePattern(name, pattern);
}

/// Whether a name matches the pattern of a breakpoint, which may be empty or contain *.
bool IsNamed(const Breakpoint& point, std::string_view name) {
  return point.what.empty() || IsLikePattern(name, point.what);
}

std::optional<Breakpoints::Cause> CauseIn(const Breakpoint& point, const mind::Event& event) {
  using Cause = Breakpoints::Cause;
  switch (point.kind) {
    case BreakKind::kFire: {
      const auto* fired = std::get_if<mind::RuleFired>(&event);
      if (fired == nullptr || fired->retracts || !IsRule(fired->rule, point.what)) return std::nullopt;
      return Cause("rule " + std::string(fired->rule) + " fired", std::string(fired->rule));
    }
    case BreakKind::kElement:
    case BreakKind::kRemoved: {
      const auto* element = std::get_if<mind::ElementChanged>(&event);
      if (element == nullptr || element->added != (point.kind == BreakKind::kElement)) return std::nullopt;
      const explain::ElementFact fact = FactOf(*element);
      if (!IsLike(fact, point.what)) return std::nullopt;
      return Describe(fact) + (element->added ? " came" : " went");
    }
    case BreakKind::kOperator: {
      const auto* selected = std::get_if<mind::OperatorSelected>(&event);
      if (selected == nullptr || !IsNamed(point, selected->name)) return std::nullopt;
      return "operator " + std::string(selected->name) + " (" + std::string(selected->id) + ") was selected";
    }
    case BreakKind::kImpasse: {
      const auto* made = std::get_if<mind::StateMade>(&event);
      if (made == nullptr || made->level <= 1) return std::nullopt;
      const std::string impasse = wording::ImpasseText(made->reason, made->on_operator);
      if (!IsLikePattern(impasse, "*" + point.what + "*")) return std::nullopt;
      return "impasse: " + wording::DecisionLine(event);
    }
    case BreakKind::kCommand: {
      const auto* said = std::get_if<mind::CommandSaid>(&event);
      if (said == nullptr || !IsNamed(point, said->name)) return std::nullopt;
      return "command " + wording::CommandText(*said);
    }
    case BreakKind::kFailed: {
      const auto* ended = std::get_if<mind::CommandEnded>(&event);
      if (ended == nullptr || ended->status != mind::CommandStatus::kError || !IsNamed(point, ended->name))
        return std::nullopt;
      return "command " + std::string(ended->name) + " failed" +
             (ended->fault.empty() ? std::string() : ": " + std::string(ended->fault));
    }
    default:
      return std::nullopt;
  }
}

/// For events of the world, not of a mind.
std::optional<Breakpoints::Cause> CauseIn(const Breakpoint& point, const sim::RunEvent& event) {
  if (point.kind == BreakKind::kDeath && event.kind == sim::EventKind::kNews && event.news == "dies") {
    if (!point.agent.empty() && point.agent != event.agent) return std::nullopt;
    return "it dies" + (event.text.empty() ? std::string() : ", " + event.text);
  }
  // An event about an open check reports that the check exists.
  if (point.kind == BreakKind::kCheck && std::holds_alternative<sim::CheckReport>(event.values) &&
      event.parameters != "open" && IsNamed(point, event.text))
    return "check '" + event.text + "': " + event.parameters;
  return std::nullopt;
}

}  // namespace

std::optional<BreakKind> BreakKindNamed(std::string_view name) {
  const auto at = std::ranges::find(kBreakKinds, name, &BreakKindWords::name);
  if (at == std::end(kBreakKinds)) return std::nullopt;
  return static_cast<BreakKind>(at - std::begin(kBreakKinds));
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
  what = explain::Trimmed(what);
  if (what.empty() && (kind == BreakKind::kFire || kind == BreakKind::kMatch))
    return NewProblem("a breakpoint on a rule needs the rule's name", "for example: fire propose*move");
  if ((kind == BreakKind::kElement || kind == BreakKind::kRemoved) && what.find('^') == std::string::npos)
    return NewProblem("a breakpoint on an element needs an attribute", "for example: ^enemy *, or S1 ^operator O1 +");
  if (kind == BreakKind::kNumber && !ReadNumberTest(what))
    return NewProblem("a breakpoint on a number needs an attribute, a comparison and a number",
                      "for example: ^health < 20, or I3 ^x >= 1.5");
  if (const auto second = NumberOf(what); kind == BreakKind::kTime && (!second || *second <= 0))
    return NewProblem("a breakpoint on a time needs a second of the world's time", "for example: 12.5");
  Breakpoint& point = list_.emplace_back();
  point.number = ++last_number_;
  point.kind = kind;
  point.agent = std::move(agent);
  point.what = std::move(what);
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

std::optional<Breakpoints::Cause> Breakpoints::NumberCause(const Breakpoint& point, const sim::MindReport& report) {
  const NumberTest test = *ReadNumberTest(point.what);
  std::optional<Cause> first;
  // Tests all elements of the tick, also after a hit: held_ must contain the last value for the next tick.
  report.events.ForEachOf<mind::ElementChanged>([&](const mind::ElementChanged& element) {
    if (!element.added || element.is_object || !IsLikePattern(element.attribute, test.attribute) ||
        !IsLikePattern(element.id, test.id))
      return;
    const std::optional<double> number = NumberOf(element.value);
    if (!number) return;
    const std::string where = std::string(element.id) + " ^" + std::string(element.attribute);
    const bool holds = Holds(test, *number);
    const bool held = std::exchange(held_[{point.number, std::string(report.agent) + ' ' + where}], holds);
    if (holds && !held && !first) first = where + " is " + std::string(element.value);
  });
  return first;
}

std::optional<Breakpoints::Cause> Breakpoints::CauseInMind(const Breakpoint& point, const sim::Simulation& simulation,
                                                           const sim::MindReport& report) {
  if (point.kind == BreakKind::kMatch) {
    const std::unique_ptr<explain::Inspector> mind = simulation.Inspect(report.agent);
    const std::optional<explain::MatchFacts> match = mind == nullptr ? std::nullopt : mind->Match(point.what);
    const bool matches = match && !match->failing;
    const bool did = std::exchange(held_[{point.number, report.agent}], matches);
    if (!matches || did) return std::nullopt;
    return "rule " + point.what + " matches";
  }
  if (point.kind == BreakKind::kNumber) return NumberCause(point, report);
  // Names of rules contain *: a rule whose name equals the pattern is reported before others that match it.
  mind::Event event;
  std::optional<Cause> first;
  for (std::size_t at = 0; report.events.Next(at, event);) {
    std::optional<Cause> cause = CauseIn(point, event);
    if (!cause) continue;
    if (point.kind != BreakKind::kFire || cause->rule == point.what) return cause;
    if (!first) first = std::move(cause);
  }
  return first;
}

std::vector<BreakHit> Breakpoints::Check(const sim::Simulation& simulation, const sim::EventList& events) {
  std::vector<BreakHit> hits;
  const auto hit = [&](Breakpoint& point, const std::string& agent, const Cause& cause) {
    ++point.hits;
    hits.push_back(
        {point.number, agent, simulation.tick(),
         "breakpoint " + std::to_string(point.number) + ": " + (agent.empty() ? "" : agent + ": ") + cause.text,
         cause.rule});
  };
  const double step_s = simulation.world().settings().step_s, now_s = static_cast<double>(simulation.tick()) * step_s;
  for (Breakpoint& point : list_) {
    if (!point.enabled) continue;
    if (point.kind == BreakKind::kTime) {
      const double second = *NumberOf(point.what);
      if (second <= now_s + step_s / 2 && second > now_s - step_s / 2) hit(point, "", "it is " + point.what + " s");
      continue;
    }
    for (const sim::RunEvent& event : events)
      if (const std::optional<Cause> cause = CauseIn(point, event)) hit(point, event.agent, *cause);
    for (std::size_t i = 0; i < simulation.soar_agents(); ++i) {
      const sim::MindReport report = simulation.Mind(i);
      if (!point.agent.empty() && point.agent != report.agent) continue;
      if (const std::optional<Cause> cause = CauseInMind(point, simulation, report)) hit(point, report.agent, *cause);
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

}  // namespace soarbox::debugger
