// SPDX-License-Identifier: BSD-2-Clause
#include "mission/conditions.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "diagnostics/number_from_chars.h"
#include "diagnostics/wildcard.h"
#include "mission/check_sentences.h"

namespace soarbox::mission {
namespace {

/// The same distance as for ^here.
constexpr double kAtWaypoint_m = 1.5;

double Flat(world::Vec3 a, world::Vec3 b) {
  return std::hypot(static_cast<double>(a.x) - static_cast<double>(b.x),
                    static_cast<double>(a.z) - static_cast<double>(b.z));
}

double OutsideOf(const PlaceFacts& region, world::Vec3 point) {
  if (region.half_x_m > 0) {
    const double x =
        std::max(0.0, std::abs(static_cast<double>(point.x - region.center.x)) - static_cast<double>(region.half_x_m));
    const double z =
        std::max(0.0, std::abs(static_cast<double>(point.z - region.center.z)) - static_cast<double>(region.half_z_m));
    return std::hypot(x, z);
  }
  return std::max(0.0, Flat(point, region.center) - static_cast<double>(region.radius_m));
}

const PlaceFacts* FindPlace(const std::vector<PlaceFacts>& places, std::string_view name) {
  const auto at =
      std::find_if(places.begin(), places.end(), [&](const PlaceFacts& place) { return place.name == name; });
  return at == places.end() ? nullptr : &*at;
}

bool Holds(const std::vector<std::string>& list, std::string_view word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

std::optional<double> ToNumber(std::string_view text) {
  double value = 0;
  const auto [at, error] = NumberFromChars(text, value);
  if (error != std::errc{} || at != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Whether two values are equal; "3" and "3.0" are.
bool SameValue(std::string_view wanted, std::string_view there) {
  if (MatchesPattern(wanted, there)) return true;
  const auto a = ToNumber(wanted), b = ToNumber(there);
  return a && b && *a == *b;
}

bool HoldsAll(const std::vector<std::pair<std::string, std::string>>& wanted,
              const std::vector<std::pair<std::string, std::string>>& there) {
  return std::all_of(wanted.begin(), wanted.end(), [&](const auto& want) {
    return std::any_of(there.begin(), there.end(), [&](const auto& pair) {
      return pair.first == want.first && SameValue(want.second, pair.second);
    });
  });
}

const std::string* TeamOf(const TickFacts& facts, std::string_view name) {
  for (const AgentFacts& agent : facts.agents)
    if (agent.name == name) return &agent.team;
  return nullptr;
}

/// Whether a word of a check refers to a thing: by name, "any", "friend" or "enemy".
bool IsMeant(std::string_view word, const AgentFacts& self, std::string_view name, const TickFacts& facts) {
  if (word == "any" || word == name) return true;
  const std::string* team = TeamOf(facts, name);
  if (team == nullptr) return MatchesPattern(word, name);
  if (word == "friend") return *team == self.team;
  if (word == "enemy") return *team != self.team;
  return MatchesPattern(word, name);
}

/// The distance to the nearest of the named places; infinite if there is none.
double NearestOf(const Condition& condition, world::Vec3 from, const TickFacts& facts) {
  double nearest = 1e30;
  for (const std::string& word : condition.words) {
    if (condition.row->key == Key::kInside) {
      if (const PlaceFacts* region = FindPlace(facts.regions, word))
        nearest = std::min(nearest, OutsideOf(*region, from));
      continue;
    }
    if (const PlaceFacts* waypoint = FindPlace(facts.waypoints, word))
      nearest = std::min(nearest, Flat(waypoint->center, from));
    if (condition.row->key == Key::kAt) continue;
    for (const AgentFacts& agent : facts.agents)
      if (agent.name == word) nearest = std::min(nearest, Flat(agent.position, from));
    for (const ItemFacts& item : facts.items)
      if (item.name == word) nearest = std::min(nearest, Flat(item.position, from));
  }
  return nearest;
}

Finding LookAtPlace(const Condition& condition, world::Vec3 position, const TickFacts& facts) {
  Finding found;
  const double distance = NearestOf(condition, position, facts);
  if (distance > 1e29) return found;
  if (condition.row->key == Key::kNear) {
    found.holds = condition.bounds.Hold(distance);
    found.away =
        std::max({0.0, distance - condition.bounds.max.value_or(1e30), condition.bounds.min.value_or(0) - distance});
    found.detail = "it was " + NumberText(std::round(distance * 10) / 10) + " m away";
    return found;
  }
  const double limit = condition.row->key == Key::kAt ? kAtWaypoint_m : 0;
  found.holds = distance <= limit;
  found.away = std::max(0.0, distance - limit);
  found.detail = "it was " + NumberText(std::round(distance * 10) / 10) + " m away";
  return found;
}

Finding LookForEvents(const Condition& condition, const AgentFacts* agent, const TickFacts& facts) {
  Finding found;
  const std::vector<EventFact>& events = agent == nullptr ? facts.problems : agent->events;
  for (const EventFact& event : events) {
    if (event.key != condition.row->key) continue;
    const bool is_named = std::any_of(condition.words.begin(), condition.words.end(), [&](const std::string& word) {
      if (agent != nullptr && condition.row->names == Names::kThing) return IsMeant(word, *agent, event.word, facts);
      return word == "any" || MatchesPattern(word, event.word);
    });
    const bool any_status = condition.row->key == Key::kRetrieval && condition.status.empty();
    const bool is_impasse = condition.row->key == Key::kImpasse;
    if (!is_named || (!any_status && event.status != condition.status)) continue;
    if (!condition.reason.empty() && event.reason != condition.reason) continue;
    if (!HoldsAll(condition.with, event.with)) continue;
    ++found.times;
    if (event.key == Key::kProblem) {
      if (found.times == 1) found.detail = "it was " + event.reason;
      continue;
    }
    found.detail = "it was " + event.word;
    if (is_impasse) found.detail += " impasse";
    if (event.key == Key::kCommand && event.status.empty())
      for (const auto& [name, value] : event.with) found.detail.append(" ^").append(name).append(" ").append(value);
    if (!event.reason.empty()) found.detail += ": " + event.reason;
  }
  found.holds = found.times > 0;
  return found;
}

bool TeamLives(std::string_view team, const TickFacts& facts) {
  return std::any_of(facts.agents.begin(), facts.agents.end(),
                     [&](const AgentFacts& agent) { return agent.alive && agent.team == team; });
}

bool OthersLive(std::string_view team, const TickFacts& facts) {
  return std::any_of(facts.agents.begin(), facts.agents.end(),
                     [&](const AgentFacts& agent) { return agent.alive && agent.team != team; });
}

Finding LookAtElement(const Condition& condition, const AgentFacts& agent, const Wants& wants) {
  Finding found;
  int count = 0;
  std::string values;
  for (const ElementFact& element : agent.found) {
    if (element.path >= wants.elements.size() || !Holds(condition.words, wants.elements[element.path])) continue;
    if (!condition.is.empty() && !SameValue(condition.is, element.value)) {
      found.detail = "it was " + element.value;
      continue;
    }
    if (condition.support != 0 && condition.support != element.support) {
      found.detail = std::string("it had ") + element.support + "-support";
      continue;
    }
    if (condition.count) {
      values += (++count == 1 ? "" : ", ") + element.value;
      found.holds = count >= *condition.count;
      found.detail = "it was " + values;
      continue;
    }
    found.holds = true;
    found.detail = "it was " + element.value + " with " + element.support + "-support";
    break;
  }
  return found;
}

}  // namespace

bool MatchesPattern(std::string_view pattern, std::string_view text) {
  return IsLikePattern(text, pattern);
}

Finding LookAt(const Condition& condition, const AgentFacts* agent, const ItemFacts* item, const TickFacts& facts,
               const Wants& wants) {
  Finding found;
  const auto any_word = [&](auto&& test) { return std::any_of(condition.words.begin(), condition.words.end(), test); };
  switch (condition.row->key) {
    case Key::kAt:
    case Key::kInside:
    case Key::kNear:
      if (agent == nullptr && item == nullptr) return found;
      return LookAtPlace(condition, agent != nullptr ? agent->position : item->position, facts);
    case Key::kTeamDown:
      found.holds = any_word([&](const std::string& team) { return !TeamLives(team, facts); });
      return found;
    case Key::kTeamWins:
      found.holds =
          any_word([&](const std::string& team) { return TeamLives(team, facts) && !OthersLive(team, facts); });
      return found;
    case Key::kEnded:
      found.holds = any_word([&](const std::string& end) { return Holds(facts.ended, end); });
      return found;
    case Key::kCarried:
      found.holds = item != nullptr && item->carried == condition.truth;
      return found;
    case Key::kProblem:
      return LookForEvents(condition, nullptr, facts);
    default:
      break;
  }
  if (agent == nullptr) return found;
  switch (condition.row->key) {
    case Key::kAlive:
      found.holds = agent->alive == condition.truth;
      found.detail = agent->alive ? "it lived" : "it was dead";
      return found;
    case Key::kCarries:
      found.holds = any_word([&](const std::string& thing) { return Holds(agent->carried, thing); });
      return found;
    case Key::kSees:
      for (const std::string& seen : agent->sees) {
        if (!any_word([&](const std::string& word) { return IsMeant(word, *agent, seen, facts); })) continue;
        found.holds = true;
        found.detail = "it saw " + seen;
        break;
      }
      return found;
    case Key::kOperator:
      for (const OperatorFact& chosen : agent->operators) {
        if (!any_word([&](const std::string& name) { return MatchesPattern(name, chosen.name); })) continue;
        if (condition.level && *condition.level != chosen.level) continue;
        if (!condition.selected_by.empty() && condition.selected_by != chosen.selected_by) continue;
        if (HoldsAll(condition.with, chosen.with)) found.holds = true;
      }
      if (!agent->operators.empty()) {
        const OperatorFact& last = agent->operators.back();
        found.detail = "it had selected " + last.name;
        for (const auto& [name, value] : last.with)
          if (name != "name") found.detail += " ^" + name + " " + value;
        if (!last.why.empty()) found.detail += ", " + last.why;
      }
      return found;
    case Key::kElement:
      return LookAtElement(condition, *agent, wants);
    default:
      break;
  }
  if (condition.row->kind == Kind::kEvent) return LookForEvents(condition, agent, facts);
  if (const NumberRow* number = FindNumber(condition.row->key)) found.value = number->value(*agent);
  found.holds = condition.bounds.Hold(found.value);
  found.away = std::max(
      {0.0, found.value - condition.bounds.max.value_or(1e30), condition.bounds.min.value_or(-1e30) - found.value});
  found.detail = "it was " + NumberText(std::round(found.value * 100) / 100);
  return found;
}

}  // namespace soarbox::mission
