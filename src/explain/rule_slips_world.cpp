// SPDX-License-Identifier: BSD-2-Clause
// Slips against the behaviour of the world: numbers that change all the time, the input link, places.
#include <algorithm>

#include "diagnostics/diagnostic.h"
#include "explain/mind_view.h"
#include "explain/rule_slips.h"
#include "explain/slip_words.h"
#include "vocabulary/vocabulary.h"

namespace soarbox::explain {
namespace {

/// Percepts whose value changes in almost every update while something moves.
constexpr std::string_view kRestless =
    "time range bearing position x z heading speed facing remaining last-seen confidence";

bool IsBelowInputLink(const std::vector<std::string>& path) {
  const auto link = std::find(path.begin(), path.end(), "input-link");
  return link != path.end() && link != path.begin() && *(link - 1) == "io";
}

/// The constantly changing percept that a rule tests, such as "range"; empty if there is none. Also empty if the rule
/// tests the status of the movement: such a rule stops matching when its command begins.
std::string RestlessPercept(const RuleText& rule) {
  const PathMap& paths = rule.paths;
  std::string found;
  for (const RuleAttribute& condition : rule.conditions) {
    const auto path = paths.find(condition.id);
    if (path == paths.end()) continue;
    if (!IsBelowInputLink(path->second)) {
      // The rule tests an element of the state as absent. The operator may add this element, which ends its proposal.
      if (condition.negated && path->second.empty()) return {};
      continue;
    }
    if (path->second.back() == "path" && (condition.attribute == "status" || condition.attribute == "command"))
      return {};
    // Of the elements directly on the input link, only `time` is ours; scripts can define others.
    const bool is_own = path->second.back() == "input-link" && condition.attribute != "time";
    if (!condition.negated && !is_own && vocabulary::HoldsWord(kRestless, condition.attribute) &&
        vocabulary::IsPerceptAttribute(condition.attribute) && found.empty())
      found = condition.attribute;
  }
  return found;
}

bool SpeaksOfSelectedOperator(const RuleText& rule) {
  return !rule.applies.empty();
}

void FindRestless(const RuleText& rule, std::vector<Slip>& slips) {
  const std::string percept = RestlessPercept(rule);
  if (percept.empty() || SpeaksOfSelectedOperator(rule)) return;
  if (!rule.proposes.empty()) {
    slips.push_back(
        {rule.name, percept, true,
         "rule " + rule.name + " proposes an operator while it tests ^" + percept +
             ", which changes all the time: each change proposes the operator again and repeats its command",
         "draw a conclusion in another rule, such as (<s> ^near <name>), and propose on that"});
  } else if (rule.calls.contains("write")) {
    slips.push_back(
        {rule.name, percept, true,
         "rule " + rule.name + " writes again at each change of ^" + percept + ", which changes all the time",
         "test a word that seldom changes, such as ^visible yes, or draw a conclusion in another rule first"});
    slips.back().topic = Topic::kRepeatedWrite;
  }
}

/// "(<s> ^seen <time>)" for a selected operator: the elements stay, one for each value of the percept.
void FindPiles(const RuleText& rule, const std::vector<RuleText>& rules, std::vector<Slip>& slips) {
  const std::string percept = RestlessPercept(rule);
  if (percept.empty() || !SpeaksOfSelectedOperator(rule)) return;
  std::set<std::string> values;  // The variables bound to constantly changing percepts.
  for (const RuleAttribute& condition : rule.conditions)
    if (!condition.negated && condition.attribute == percept)
      for (std::string& variable : VariablesIn(condition.value)) values.insert(std::move(variable));
  const std::set<std::string> states = StatesOf(rule);
  for (const RuleAttribute& action : rule.actions) {
    if (!states.contains(action.id) || !values.contains(action.value)) continue;
    const bool is_removed = std::ranges::any_of(rules, [&](const RuleText& other) {
      return std::ranges::any_of(other.actions, [&](const RuleAttribute& removal) {
        return removal.value.ends_with("-") && (removal.attribute == action.attribute || IsVariable(removal.attribute));
      });
    });
    if (is_removed) continue;
    slips.push_back({rule.name, action.attribute, true,
                     "rule " + rule.name + " adds another ^" + action.attribute + " at each change of ^" + percept +
                         ", and no rule removes the old ones",
                     "remove the old value in the same rule: (" + action.id + " ^" + action.attribute + " <old> -)",
                     true});
    return;
  }
}

/// Actions that write on the input link.
void FindInputWriters(const RuleText& rule, std::vector<Slip>& slips) {
  const PathMap& paths = rule.paths;
  for (const RuleAttribute& action : rule.actions) {
    const auto path = paths.find(action.id);
    if (path == paths.end() || path->second.empty()) continue;
    if (IsBelowInputLink(path->second) && path->second.back() != "input-link" &&
        vocabulary::IsPerceptAttribute(action.attribute)) {
      slips.push_back({rule.name, action.attribute, true,
                       "rule " + rule.name + " writes ^" + action.attribute + " where it is a percept: this changes " +
                           "nothing in the world",
                       "only the world changes percepts; commands change the world: docs/commands.md", true});
      return;
    }
    if (path->second.back() != "input-link") continue;
    slips.push_back({rule.name, action.attribute, true,
                     "rule " + rule.name + " writes ^" + action.attribute +
                         " on the input link, which is for percepts: this gives no command",
                     "commands go on ^io.output-link, and what the agent remembers goes on its state: (<s> ^" +
                         action.attribute + " ...)"});
    return;
  }
}

bool IsName(const std::string& value) {
  return !value.empty() && value.find_first_of(" <>{}()|") == std::string::npos;
}

class PlaceChecker {
 public:
  PlaceChecker(const KnownPlaces& known, std::vector<Slip>& slips) : known_(known), slips_(slips) {}

  void Check(const RuleText& rule) {
    std::map<std::string, std::string> kinds;  // Variables for a waypoint or a region.
    for (const RuleAttribute& condition : rule.conditions)
      if (condition.attribute == "waypoint" || condition.attribute == "region")
        kinds[FirstWord(condition.value)] = condition.attribute;
    for (const RuleAttribute& condition : rule.conditions) {
      const auto kind = kinds.find(condition.id);
      if (kind != kinds.end() && condition.attribute == "name") Look(rule, kind->second, condition.value);
    }
    for (const RuleAttribute& action : rule.actions)
      if (action.attribute == "waypoint" || action.attribute == "region")
        Look(rule, action.attribute, FirstWord(action.value));
  }

 private:
  void Look(const RuleText& rule, const std::string& kind, const std::string& name) {
    const std::set<std::string>& names = kind == "waypoint" ? known_.waypoints : known_.regions;
    if (!IsName(name) || names.contains(name)) return;
    const std::string_view near = Suggest(name, {names.begin(), names.end()});
    std::string hint = "did you mean " + std::string(near) + "?";
    if (near.empty()) {
      hint = names.empty() ? "the scenario has no " + kind + "s" : "its " + kind + "s are";
      for (const std::string& one : names) hint += (one == *names.begin() ? " " : ", ") + one;
    }
    slips_.push_back({rule.name, name, false,
                      "rule " + rule.name + " names the " + kind + " " + name + ", which the scenario does not have",
                      std::move(hint)});
  }

  const KnownPlaces& known_;
  std::vector<Slip>& slips_;
};

}  // namespace

std::vector<Slip> FindSlipsOfWorld(const std::vector<RuleText>& rules, const KnownWords& known) {
  const KnownPlaces& places = known.places;
  std::vector<Slip> slips;
  PlaceChecker checker(places, slips);
  for (const RuleText& rule : rules) {
    FindInputWriters(rule, slips);
    if (known.own_world) continue;
    FindRestless(rule, slips);
    FindPiles(rule, rules, slips);
    if (places.is_known) checker.Check(rule);
  }
  return slips;
}

}  // namespace soarbox::explain
