// SPDX-License-Identifier: BSD-2-Clause
#include "explain/reasons.h"

#include <algorithm>
#include <optional>

#include "diagnostics/diagnostic.h"
#include "explain/impasse_reasons.h"
#include "explain/inspector.h"
#include "explain/rule_makers.h"
#include "explain/rule_slips.h"
#include "explain/rule_text.h"
#include "explain/what_is_there.h"
#include "vocabulary/vocabulary.h"
#include "wording/number_words.h"
#include "wording/sentences.h"

namespace soarbox::explain {
namespace {

/// "justify3": the kernel's name for a result of a substate from which nothing was learned.
bool IsJustification(std::string_view rule) {
  constexpr std::string_view kPrefix = "justify";
  return rule.size() > kPrefix.size() && rule.starts_with(kPrefix) &&
         rule.find_first_not_of("0123456789-", kPrefix.size()) == std::string_view::npos;
}

constexpr std::size_t kMostRulesAsked = 60;
constexpr std::size_t kMostRulesTold = 3;
constexpr std::size_t kMostValuesShown = 4;
constexpr std::size_t kLongestCircle = 6;

using wording::Listed;
using wording::Say;
using wording::Situation;
using wording::WithoutZeros;

std::string List(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size() && i < kMostValuesShown; ++i)
    text += (i == 0 ? "" : ", ") + WithoutZeros(words[i]);
  if (words.size() > kMostValuesShown) text += " and " + std::to_string(words.size() - kMostValuesShown) + " more";
  return text;
}

/// Advice for a test "<> x" of an element that is absent; empty for other tests.
std::string AdviceForUnequal(const ConditionText& condition) {
  constexpr std::string_view kUnequal = "<> ";
  if (!condition.value.starts_with(kUnequal)) return {};
  const std::string value = condition.value.substr(kUnequal.size());
  if (value.find_first_of(" <>{}^.") != std::string::npos) return {};
  return "; a test with <> needs an element: -^" + condition.path.back() + " " + value +
         " also matches if there is none";
}

Reason ReasonOf(const RuleWait& wait) {
  using enum RuleWait::Kind;
  const Reason::Kind kind = wait.found.kind == kOperator ? Reason::Kind::kAwaitsTurn
                            : wait.found.kind == kUnmade ? Reason::Kind::kStopsAtUnmade
                                                         : Reason::Kind::kStops;
  return {wait.Text(), kind, wait.rule};
}

/// The percept ^clock has a new value at each turn of a world. A rule that tests it proposes its operator again at each
/// turn. Returns a sentence about such a rule if no rule that proposes `name` tests ^clock; else an empty string.
std::string WhoTestsClock(const std::vector<RuleText>& rules, const std::string& name) {
  const auto tests_clock = [](const RuleText& rule) {
    return std::ranges::any_of(rule.conditions, [&](const RuleAttribute& condition) {
      const auto path = rule.paths.find(condition.id);
      return condition.attribute == "clock" && !condition.negated && path != rule.paths.end() &&
             path->second == std::vector<std::string>{"io", "input-link"};
    });
  };
  const RuleText* other = nullptr;
  for (const RuleText& rule : rules) {
    if (rule.proposes.empty() || !tests_clock(rule)) continue;
    if (rule.proposes.contains(name)) return {};
    other = &rule;
  }
  return other == nullptr ? std::string() : Say(Situation::kOthersTestClock, {{"rule", other->name}});
}

}  // namespace

std::string SimilarAttribute(std::string_view attribute, const std::set<std::string>& known) {
  if (attribute.size() < 3) return {};
  const std::vector<std::string> more(known.begin(), known.end());
  return std::string(vocabulary::NearestAttribute(attribute, more));
}

std::string DidYouMean(const std::string& attribute) {
  return attribute.empty() ? std::string() : "did you mean ^" + attribute + "?";
}

MindReasons::Makers MindReasons::MakersOf(const RuleText& rule, const ConditionText& condition) {
  Makers makers;
  makers.is_known = StillFailed().empty();
  for (const RuleText& maker : rules()) {
    const Makes makes = WhetherMakes(maker, rule, condition);
    makers.is_known &= !MakesAnyAttribute(maker);
    if (makes != Makes::kNo) makers.all.push_back(&maker);
    if (makers.other == nullptr) {
      makers.other_value = OtherValueBy(maker, rule, condition);
      if (!makers.other_value.empty()) makers.other = &maker;
    }
    // A rule that requires the same element cannot be the first to make it.
    if (maker.name == rule.name || WaitsForTheSame(maker, condition)) continue;
    if (makes == Makes::kYes && makers.sure == nullptr) makers.sure = &maker;
    if (makes == Makes::kMaybe && makers.maybe == nullptr) makers.maybe = &maker;
  }
  return makers;
}

std::optional<ConditionText> MindReasons::WaitOf(const RuleText& rule) {
  const RuleMatch match = view_.Match(rule.name);
  if (match.failing.empty() || match.is_group) return std::nullopt;
  const std::vector<ConditionText> waits = ReadCondition(rule, match.failing);
  if (waits.empty() || waits.front().negated || waits.front().path.empty()) return std::nullopt;
  const std::vector<std::string> path = FromTop(waits.front().path);
  if (path.empty() || path.front() == "io" || IsArchitectureAttribute(path.front())) return std::nullopt;
  return waits.front();
}

std::vector<MindReasons::Wait> MindReasons::CircleFrom(const RuleText& rule, const ConditionText& condition) {
  std::vector<Wait> waits = {{&rule, condition}};
  while (waits.size() < kLongestCircle) {
    const Wait& last = waits.back();
    const std::vector<std::string>& path = last.condition.path;
    // The same object may have other paths through states and elements of the architecture.
    if (path.front() == "superstate" || path.front() == "io" || IsArchitectureAttribute(path.front())) return {};
    const Makers makers = MakersOf(*last.rule, last.condition);
    if (!makers.is_known || makers.all.size() != 1 || !view_.ValuesAt(StateOf(*last.rule), path).empty()) return {};
    const RuleText& maker = *makers.all.front();
    const std::optional<ConditionText> next = WaitOf(maker);
    if (!next) return {};
    const auto again = std::ranges::find_if(waits, [&](const Wait& wait) {
      return wait.condition.path == next->path && wait.condition.value == next->value;
    });
    const auto begin = again - waits.begin();
    const bool is_closed = again != waits.end();
    waits.push_back({&maker, *next});
    // If the circle does not include the first condition, it is reported for a later rule.
    if (is_closed && next->path != condition.path) return {};
    if (is_closed) return {waits.begin() + begin, waits.end()};
  }
  return {};
}

std::string MindReasons::Applying(const RuleText& maker) {
  std::string operators;
  for (const std::string& name : maker.applies)
    if (!name.empty()) operators += (operators.empty() ? "" : " or ") + name;
  return operators.empty() ? "" : Say(Situation::kWhenItApplies, {{"operators", operators}});
}

std::vector<FailedRule> MindReasons::StillFailed() {
  std::vector<FailedRule> failed = failed_;
  // The user may have fixed the rule in the meantime.
  std::erase_if(failed, [&](const FailedRule& one) { return view_.FindRule(one.rule) != nullptr; });
  return failed;
}

std::string MindReasons::WhatFailed() {
  const std::vector<FailedRule> failed = StillFailed();
  std::string text;
  for (std::size_t i = 0; i < failed.size() && i < kMostRulesTold; ++i) {
    const FailedRule& one = failed[i];
    text += (text.empty() ? "" : "; ") +
            (one.rule.empty()
                 ? Say(Situation::kErrorIn, {{"place", one.place}, {"problem", one.problem}})
                 : Say(Situation::kNotParsed, {{"rule", one.rule}, {"place", one.place}, {"problem", one.problem}}));
  }
  if (failed.size() > kMostRulesTold)
    text += "; " + Say(Situation::kMoreNotLoaded, {{"count", std::to_string(failed.size() - kMostRulesTold)}});
  return text;
}

std::string MindReasons::StateOf(const RuleText& rule) {
  std::string top = "S1", last, worked_on;
  bool is_below = false;  // The rule works on the last operator of the stack so far.
  for (const StackEntry& entry : view_.Stack()) {
    if (!entry.is_state) {
      is_below = rule.works_on.contains(entry.about);
      continue;
    }
    if (last.empty()) top = entry.id;
    last = entry.id;
    if (is_below) worked_on = entry.id;
  }
  if (IsForSubstate(rule)) return !worked_on.empty() ? worked_on : !last.empty() ? last : top;
  const bool is_for_top = std::ranges::any_of(rule.conditions, [](const RuleAttribute& condition) {
    return condition.on_state && condition.attribute == "superstate" && condition.value == "nil";
  });
  const std::string below = is_for_top ? std::string() : SubstateOfSelected(rule);
  return below.empty() ? top : below;
}

std::string MindReasons::WhichStateAboveHas(const std::string& state, const std::vector<std::string>& path) {
  std::vector<std::string> above;  // From the top state down.
  for (const StackEntry& entry : view_.Stack()) {
    if (entry.id == state) break;
    if (entry.is_state) above.push_back(entry.id);
  }
  std::string way;
  for (auto at = above.rbegin(); at != above.rend(); ++at) {
    way += "superstate.";
    if (!view_.ValuesAt(*at, path).empty())
      return state + " is a substate and has none; " + *at + " has it: test ^" + way + path.front();
  }
  return {};
}

std::vector<Reason> MindReasons::UnwrittenAttributes(const std::set<std::string>& given) {
  std::set<std::string> known = given;
  for (const RuleText& rule : rules()) {
    // Attributes that such a rule makes, or that a memory returns, are known only when the rule fires.
    if (MakesAnyAttribute(rule) || TestsWhatWasRecalled(rule)) return {};
    for (const RuleAttribute& action : rule.actions) known.insert(action.attribute);
  }
  std::vector<Reason> found;
  std::set<std::string> told;
  for (const RuleText& rule : rules()) {
    for (const RuleAttribute& condition : rule.conditions) {
      const std::string& attribute = condition.attribute;
      if (!IsConstantAttribute(attribute) || IsArchitectureAttribute(attribute) ||
          vocabulary::IsPerceptAttribute(attribute))
        continue;
      if (known.contains(attribute) || condition.negated || !told.insert(attribute).second) continue;
      if (!view_.ValuesOf(attribute).empty()) continue;
      const std::string hint = DidYouMean(SimilarAttribute(attribute, known));
      found.push_back({Say(Situation::kUnwritten, {{"rule", rule.name}, {"attribute", attribute}}) +
                           (hint.empty() ? "" : ": " + hint),
                       Reason::Kind::kUnmade, rule.name});
    }
  }
  return found;
}

std::string MindReasons::ExplainSelected(const RuleText& rule, const ConditionText& condition) {
  const std::vector<std::string> path = FromTop(condition.path);
  const std::vector<std::string> above(condition.path.begin(),
                                       condition.path.end() - static_cast<std::ptrdiff_t>(path.size()));
  const std::vector<std::string> states = view_.ValuesAt(StateOf(rule), above);
  if (states.empty()) return {};
  const StackEntry* selected = nullptr;
  const std::vector<StackEntry> stack = view_.Stack();
  for (std::size_t i = 0; i + 1 < stack.size(); ++i)
    if (stack[i].is_state && stack[i].id == states.front() && !stack[i + 1].is_state) selected = &stack[i + 1];
  const bool asks_for_name = path.size() == 2 && path.back() == "name";
  const bool is_name =
      asks_for_name && !condition.value.empty() && condition.value.find_first_of(" <>{}") == std::string::npos;
  std::string who_proposes;
  if (is_name && StillFailed().empty()) {
    const auto proposes = [&](const RuleText& other) { return other.proposes.contains(condition.value); };
    const auto proposer = std::ranges::find_if(rules(), proposes);
    if (proposer != rules().end()) {
      who_proposes = Say(Situation::kRuleProposes, {{"rule", proposer->name}, {"name", condition.value}});
    } else if (std::ranges::none_of(rules(), [](const RuleText& other) { return other.proposes.contains(""); })) {
      who_proposes = Say(Situation::kNoRuleProposes, {{"name", condition.value}});
    }
  }
  if (selected == nullptr) return Say(Situation::kNoOperatorSelected, {{"state", states.front()}}) + who_proposes;
  if (asks_for_name && selected->about != condition.value)
    return Say(Situation::kOtherOperator,
               {{"state", states.front()},
                {"op", selected->about.empty() ? selected->id + ", which has no name"
                                               : selected->about + " (" + selected->id + ")"}}) +
           who_proposes;
  return {};
}

RuleWait::Found MindReasons::ExplainAbsence(const RuleText& rule, const ConditionText& condition,
                                            const std::set<std::string>& known) {
  using enum RuleWait::Kind;
  const std::string& attribute = condition.path.back();
  const std::vector<std::string> path = FromTop(condition.path);
  const bool is_percept = (!path.empty() && path.front() == "io") || !FromLink(condition.path).empty();
  const bool is_own = !condition.path.empty() && condition.path.front() != "superstate" &&
                      !IsArchitectureAttribute(condition.path.front());
  if (is_own) {
    if (std::string elsewhere = WhichStateAboveHas(StateOf(rule), condition.path); !elsewhere.empty())
      return {elsewhere};
  }
  if (!is_percept) {
    if (const std::vector<Wait> circle = CircleFrom(rule, condition); !circle.empty()) {
      std::vector<std::string> attributes, makers;
      for (std::size_t i = 0; i + 1 < circle.size(); ++i) {
        const std::string& made = circle[i].condition.path.back();
        attributes.push_back("^" + made);
        makers.push_back(Say(Situation::kOnlyCreates, {{"rule", circle[i + 1].rule->name},
                                                       {"attribute", made},
                                                       {"tested", circle[i + 1].condition.path.back()}}));
      }
      std::string who;
      for (const std::string& maker : makers) who += (who.empty() ? "" : "; ") + maker;
      return {
          attributes.size() == 1
              ? Say(Situation::kWaitForItself, {{"attribute", circle.front().condition.path.back()}, {"makers", who}})
              : Say(Situation::kWaitForEachOther, {{"attributes", Listed(attributes)}, {"makers", who}})};
    }
    const Makers makers = MakersOf(rule, condition);
    if (makers.sure != nullptr)
      return {Say(Situation::kNoneNowMadeBy, {{"maker", makers.sure->name}, {"applying", Applying(*makers.sure)}}),
              kAbsentMade, makers.sure->name};
    if (makers.maybe != nullptr)
      return {Say(Situation::kNoneNowMaybeBy, {{"maker", makers.maybe->name}, {"applying", Applying(*makers.maybe)}})};
    if (makers.all.empty() && makers.is_known && !IsArchitectureAttribute(path.front()) && known.contains(attribute)) {
      std::string text = Say(Situation::kNoRuleMakes);
      if (makers.other != nullptr)
        text += Say(Situation::kMakesOther,
                    {{"maker", makers.other->name}, {"attribute", attribute}, {"value", makers.other_value}});
      return {text};
    }
  }
  if (const vocabulary::PerceptRow* row = RowAt(condition.path))
    return {Say(Situation::kNoneNowPercept, {{"meaning", row->meaning}})};
  if (const std::string related = RelatedPercepts(view_, *MakeInspector(agent_), StateOf(rule), condition.path);
      !related.empty())
    return {Say(Situation::kNoneNow) + "; " + related};
  const auto none_now = [&]() -> RuleWait::Found {
    RuleWait::Found found = WhatIsThere(view_, *MakeInspector(agent_), StateOf(rule), condition);
    found.text = Say(Situation::kNoneNow) + found.text;
    return found;
  };
  if (known.contains(attribute) || IsArchitectureAttribute(attribute)) return none_now();
  if (const std::string places = PlacesOfPercept(attribute); !places.empty())
    return {Say(Situation::kWrongPlace, {{"places", places}})};
  // A rule that did not load may make it, or a rule with attributes that are known only when it fires, or a recall may
  // return it.
  if (!StillFailed().empty() || std::ranges::any_of(rules(), MakesAnyAttribute) ||
      std::ranges::any_of(rules(), TestsWhatWasRecalled)) {
    RuleWait::Found found = none_now();
    if (const std::string failed = WhatFailed(); !failed.empty()) {
      found.text += "; " + failed;
      found.kind = kOther;
    }
    return found;
  }
  const std::string hint = DidYouMean(SimilarAttribute(attribute, known));
  return {Say(Situation::kNothingMakes) + (hint.empty() ? "" : ": " + hint), kUnmade};
}

std::string MindReasons::SubstateOfSelected(const RuleText& rule) {
  std::string state;
  bool is_top = true;
  for (const StackEntry& entry : view_.Stack()) {
    if (entry.is_state) {
      is_top = state.empty();
      state = entry.id;
    } else if (!is_top && rule.applies.contains(entry.about)) {
      return state;
    }
  }
  return {};
}

std::optional<RuleWait> MindReasons::WhatExcludesAbove(const RuleText& rule, const ConditionText& failing) {
  if (!IsForSubstate(rule) || failing.path.size() < 2 || failing.path.front() != "superstate") return std::nullopt;
  const PathMap& paths = rule.paths;
  const std::vector<std::string> above(failing.path.begin(), failing.path.end() - 1);
  for (const RuleAttribute& condition : rule.conditions) {
    const auto path = paths.find(condition.id);
    if (!condition.negated || path == paths.end() || path->second != above) continue;
    if (!IsConstantAttribute(condition.attribute) || condition.value.find(' ') != std::string::npos) continue;
    const bool is_any = condition.value.empty() || IsVariable(condition.value);
    const bool is_group = is_any && std::ranges::any_of(rule.conditions, [&](const RuleAttribute& other) {
                            return other.negated && other.id == condition.value;
                          });
    ConditionText excluded;
    excluded.path = above;
    excluded.path.push_back(condition.attribute);
    if (!is_any) excluded.value = condition.value;
    const std::vector<std::string> values = view_.ValuesAt(StateOf(rule), excluded.path);
    const bool is_met = is_any ? !values.empty() : std::ranges::find(values, condition.value) != values.end();
    if (is_group || !is_met) continue;
    const std::vector<std::string> shown = is_any ? values : std::vector<std::string>{condition.value};
    return RuleWait{.rule = rule.name,
                    .condition = excluded.Text(),
                    .attribute = condition.attribute,
                    .is_excluded = true,
                    .found = {Say(shown.size() == 1 ? Situation::kValueExists : Situation::kValuesExist,
                                  {{"attribute", condition.attribute}, {"values", List(shown)}})}};
  }
  return std::nullopt;
}

std::string RuleWait::Requires() const {
  const Situation situation = is_excluded          ? Situation::kRuleExcluded
                              : found.text.empty() ? Situation::kRuleWaitsFor
                                                   : Situation::kRuleWaits;
  return Say(situation, {{"condition", condition}, {"found", found.text}});
}

std::string RuleWait::Text() const {
  return Say(Situation::kOfRule, {{"rule", rule}, {"waits", Requires()}});
}

std::optional<RuleWait> MindReasons::ExplainRule(const RuleText& rule, const std::set<std::string>& known) {
  using enum RuleWait::Kind;
  const RuleMatch match = view_.Match(rule.name);
  if (match.failing.empty()) return std::nullopt;
  const std::vector<ConditionText> conditions = ReadCondition(rule, match.failing);
  if (conditions.empty()) return RuleWait{.rule = rule.name, .condition = match.failing, .attribute = {}, .found = {}};
  const ConditionText& first = conditions.front();
  const auto waits = [&](RuleWait::Found found) {
    return RuleWait{.rule = rule.name,
                    .condition = first.Text(),
                    .attribute = first.path.back(),
                    .is_of_state = first.path.size() == 1,
                    .found = std::move(found)};
  };
  if (!match.is_group && AsksForSelected(rule, first)) {
    if (const std::string selected = ExplainSelected(rule, first); !selected.empty())
      return waits({selected, kOperator});
  }
  const std::vector<std::string> values = view_.ValuesAt(StateOf(rule), first.path);
  std::vector<std::string> shown;
  for (const std::string& value : values)
    if (!IsIdentifier(value)) shown.push_back(value);

  if (match.is_group || first.negated) {
    std::string excluded;
    for (ConditionText each : conditions) {
      // A condition that only leads to the object of another one is part of its path.
      const bool is_way = each.value.empty() && std::ranges::any_of(conditions, [&](const ConditionText& other) {
                            return other.path.size() > each.path.size() &&
                                   std::equal(each.path.begin(), each.path.end(), other.path.begin());
                          });
      if (is_way) continue;
      each.negated = false;
      excluded += (excluded.empty() ? "" : " with ") + each.Text();
    }
    RuleWait wait =
        waits(shown.empty() || match.is_group
                  ? RuleWait::Found{Say(Situation::kOneExists), kExists}
                  : RuleWait::Found{Say(shown.size() == 1 ? Situation::kValueExists : Situation::kValuesExist,
                                        {{"attribute", first.path.back()}, {"values", List(shown)}})});
    wait.condition = excluded;
    wait.is_excluded = true;
    return wait;
  }
  if (shown.empty() && first.path.front() == "io") {
    if (const std::string state = SubstateOfSelected(rule); !state.empty())
      return waits({Say(Situation::kNoLinks, {{"state", state}})});
  }
  if (values.empty()) {
    RuleWait::Found found = ExplainAbsence(rule, first, known);
    const std::string advice = AdviceForUnequal(first);
    found.text += advice;
    if (found.kind == kAbsent && !advice.empty()) found.kind = kOther;
    return waits(std::move(found));
  }
  std::string bound;
  for (const std::vector<std::string>& path : first.compared) {
    std::vector<std::string> others;
    for (const std::string& value : view_.ValuesAt(StateOf(rule), path))
      if (!IsIdentifier(value)) others.push_back(value);
    if (others.empty()) continue;
    bound += "; ^";
    for (std::size_t i = 0; i < path.size(); ++i) bound += (i == 0 ? "" : ".") + path[i];
    bound += " is " + List(others);
  }
  const std::size_t others = values.size() - shown.size();
  if (shown.empty()) {
    if (std::optional<RuleWait> excluded = WhatExcludesAbove(rule, first)) return excluded;
    // The rule's first conditions may match a state above, but no other conditions. Then its substate lacks an element
    // that the state above has.
    const std::string state = IsForSubstate(rule) ? StateOf(rule) : std::string();
    for (const RuleAttribute& condition : rule.conditions) {
      if (state.empty() || condition.negated || !condition.on_state || !IsConstantAttribute(condition.attribute) ||
          IsArchitectureAttribute(condition.attribute) || !view_.ValuesAt(state, {condition.attribute}).empty())
        continue;
      ConditionText own;
      own.path = {condition.attribute};
      if (!IsVariable(condition.value)) own.value = condition.value;
      if (const std::string above = WhichStateAboveHas(state, own.path); !above.empty())
        return RuleWait{.rule = rule.name,
                        .condition = own.Text(),
                        .attribute = condition.attribute,
                        .is_of_state = true,
                        .found = {above}};
    }
  }
  // The value exists, but for another object, for example for another waypoint than the one of the earlier conditions.
  if (std::find(shown.begin(), shown.end(), first.value) != shown.end())
    return waits({Say(Situation::kElsewhere), kElsewhere});
  if (const std::string below = AttributeWithWord(view_, *MakeInspector(agent_), StateOf(rule), first); !below.empty())
    return waits({"it is an object, and ^" + below + " below it has this word"});
  if (shown.empty())
    return waits(
        {others == 1 ? Say(Situation::kOneDoesNotFit) : Say(Situation::kNoneFits, {{"count", std::to_string(others)}}),
         kElsewhere});
  std::string found = Say(Situation::kOtherValue, {{"values", List(shown)}}) + bound;
  const std::vector<std::string_view> words = WordsOfPercept(first.path.back());
  const bool is_word = !words.empty() && RowAt(first.path) != nullptr &&
                       first.value.find_first_of(" <>{}") == std::string::npos &&
                       std::find(words.begin(), words.end(), first.value) == words.end();
  if (is_word) {
    std::string all;
    for (const std::string_view word : words) all.append(all.empty() ? "" : " ").append(word);
    found += Say(Situation::kOnlyWords, {{"value", first.value}, {"words", all}});
  }
  return waits({found});
}

std::vector<Reason> MindReasons::Nearest(const RuleList& candidates, const std::set<std::string>& known) {
  struct Near {
    double share;
    const RuleText* rule;
  };
  std::vector<Near> found;
  for (std::size_t i = 0; i < candidates.size() && i < kMostRulesAsked; ++i) {
    const RuleMatch match = view_.Match(candidates[i]->name);
    if (match.failing.empty() || match.total == 0) continue;
    found.push_back({static_cast<double>(match.matched) / match.total, candidates[i]});
  }
  std::stable_sort(found.begin(), found.end(), [](const Near& a, const Near& b) { return a.share > b.share; });
  std::vector<Reason> reasons;
  std::set<const RuleText*> told;
  const auto tell = [&](const RuleText& rule) {
    if (!told.insert(&rule).second) return;
    const std::vector<Slip> slips = FindSlipsOfForm({rule});
    const bool has_state = std::any_of(rule.conditions.begin(), rule.conditions.end(),
                                       [](const RuleAttribute& condition) { return condition.on_state; });
    // Without a state, it is not known which object its conditions test.
    if (has_state)
      if (const std::optional<RuleWait> wait = ExplainRule(rule, known)) reasons.push_back(ReasonOf(*wait));
    for (const Slip& slip : slips) reasons.push_back(slip.message + (slip.hint.empty() ? "" : ": " + slip.hint));
  };
  for (std::size_t i = 0; i < found.size() && i < kMostRulesTold; ++i) {
    tell(*found[i].rule);
    // If another rule makes the required element, that rule is the cause.
    const std::optional<ConditionText> wait = WaitOf(*found[i].rule);
    if (!wait || wait->path.front() == "operator" || !CircleFrom(*found[i].rule, *wait).empty()) continue;
    const Makers makers = MakersOf(*found[i].rule, *wait);
    // A rule that applies an operator waits until the operator is selected. The caller already explains why none is.
    if (makers.sure != nullptr && makers.sure->applies.empty()) tell(*makers.sure);
  }
  return reasons;
}

std::vector<Reason> MindReasons::WhyNotApplied(const StackEntry& selected, const std::string& state, bool is_below,
                                               const std::set<std::string>& known) {
  const std::string& name = selected.about;
  const std::string shown = name.empty() ? selected.id : name;
  RuleList candidates, below;
  const RuleText* applied_by = nullptr;
  const RuleText* pending = nullptr;
  const RuleText* answered_by = nullptr;  // A rule that fired and only calls functions: it writes text, for example.
  bool says = false;
  for (const RuleText& rule : rules()) {
    if (IsJustification(rule.name)) continue;  // A result of a substate: an intermediate step.
    if (IsForSubstate(rule) && !rule.proposes.empty()) below.push_back(&rule);
    // A rule that only adds to the operator does not apply it. A rule that names no operator applies any.
    if (!(rule.applies.contains(name) || rule.applies.contains(""))) continue;
    if (!Changes(rule)) {
      const bool only_speaks = rule.acts && rule.actions.empty() && rule.applies.contains(name);
      if (only_speaks && view_.Match(rule.name).failing.empty() && view_.HasFired(rule.name)) answered_by = &rule;
      continue;
    }
    if (rule.applies.contains(name)) candidates.push_back(&rule);
    if (!view_.Match(rule.name).failing.empty()) continue;
    if (view_.IsPending(rule.name)) {
      pending = &rule;
      continue;
    }
    if (!view_.HasFired(rule.name)) continue;
    says |= !rule.says.empty();
    if (applied_by == nullptr) applied_by = &rule;
  }
  std::vector<Reason> reasons;
  const std::initializer_list<wording::Slot> op = {{"op", shown}, {"state", state}};
  if (pending != nullptr) {
    const std::uint64_t firings = view_.Firings(pending->name).value_or(0);
    reasons.push_back(
        firings > 1
            ? Say(Situation::kFiresAgain,
                  {{"op", shown}, {"state", state}, {"rule", pending->name}, {"count", std::to_string(firings)}})
            : Say(Situation::kNotFiredYet, {{"op", shown}, {"state", state}, {"rule", pending->name}}));
  } else if (applied_by != nullptr) {
    for (const Slip& slip : FindSlipsOfUndoing(rules()))
      if (says && slip.undone == applied_by->name)
        reasons.emplace_back(slip.message + ": " + slip.hint, Reason::Kind::kStalled, slip.rule);
    if (reasons.empty())
      reasons.push_back(
          {Say(says ? Situation::kApplied : Situation::kAppliedSilently, {{"op", shown}, {"rule", applied_by->name}}) +
               WhoTestsClock(rules(), name),
           Reason::Kind::kStalled});
  } else if (!candidates.empty()) {
    reasons.push_back(Say(Situation::kNoApplierMatches, op));
    for (Reason& near : Nearest(candidates, known)) reasons.push_back(std::move(near));
    if (std::string failed = WhatFailed(); !failed.empty()) reasons.push_back(std::move(failed));
  } else if (answered_by != nullptr) {
    reasons.push_back(Say(Situation::kAnsweredOnly, {{"op", shown}, {"state", state}, {"rule", answered_by->name}}));
  } else if (is_below && !below.empty()) {
    const std::vector<StackEntry> stack = view_.Stack();
    const auto at = std::ranges::find(stack, selected.id, &StackEntry::id);
    const std::string substate = at == stack.end() || at + 1 == stack.end() ? "" : (at + 1)->id;
    if (const std::string why = WhyAllDropped(view_, substate); !why.empty())
      return {Say(Situation::kDroppedIn, {{"state", substate}, {"why", why}})};
    reasons.push_back(Say(Situation::kNothingBelow, op));
    for (Reason& near : Nearest(below, known)) reasons.push_back(std::move(near));
  } else {
    std::string failed = WhatFailed();
    reasons.push_back(
        Say(Situation::kNoApplier,
            {{"op", shown}, {"state", state}, {"advice", failed.empty() ? HowToApply(rules(), name) : failed}}));
  }
  return reasons;
}

std::vector<Reason> MindReasons::WhyIdle(const std::set<std::string>& known) {
  const std::string failed = WhatFailed();
  if (rules().empty()) return {Say(Situation::kNoRules) + (failed.empty() ? "" : ": " + failed)};
  std::vector<Reason> reasons;
  const std::vector<StackEntry> stack = view_.Stack();
  const StackEntry* selected = nullptr;
  std::string state = "S1", state_of_selected = "S1";
  bool is_below = false;
  for (const StackEntry& entry : stack) {
    if (!entry.is_state) {
      selected = &entry;
      state_of_selected = state;
      is_below = false;
      continue;
    }
    if (entry.about == "operator tie") {
      reasons = ExplainTie(view_, state, entry.id);
    } else if (entry.about == "operator conflict" || entry.about == "operator constraint-failure") {
      reasons = ExplainConflict(view_, state, entry);
    }
    // A substate because of a state no-change gives no new information.
    if (entry.about != "state no-change" || selected == nullptr) {
      is_below = entry.about == "operator no-change";
      if (!is_below) selected = nullptr;
    }
    state = entry.id;
  }
  if (!reasons.empty() && selected == nullptr) return reasons;

  // If rules failed to load, it is not known what they would make.
  if (failed.empty()) reasons = UnwrittenAttributes(known);
  if (reasons.size() > kMostRulesTold) reasons.resize(kMostRulesTold);
  const auto add = [&reasons](std::vector<Reason> more) {
    for (Reason& reason : more) {
      // A misspelt attribute is reported once.
      const bool repeats =
          reason.kind == Reason::Kind::kStopsAtUnmade && std::ranges::any_of(reasons, [&](const Reason& told) {
            return told.kind == Reason::Kind::kUnmade && told.rule == reason.rule;
          });
      if (!repeats) reasons.push_back(std::move(reason));
    }
  };
  if (selected != nullptr) {
    add(WhyNotApplied(*selected, state_of_selected, is_below, known));
    return reasons;
  }
  RuleList candidates;
  const bool in_substate = stack.size() > 1;
  for (const RuleText& rule : rules())
    if (!rule.proposes.empty() && (in_substate || !IsForSubstate(rule))) candidates.push_back(&rule);
  // A proposal that tests ^superstate <any> matches in the top state, too.
  if (candidates.empty())
    for (const RuleText& rule : rules())
      if (!rule.proposes.empty()) candidates.push_back(&rule);
  if (candidates.empty()) {
    reasons.push_back(
        Say(Situation::kNoProposer, {{"advice", failed.empty() ? Say(Situation::kWriteProposer) : failed}}));
    return reasons;
  }
  // The states at the bottom of the stack that follow each other because of state no-changes. In the first of them,
  // something is missing.
  std::vector<std::string> alike;
  for (const StackEntry& entry : stack) {
    if (entry.about != "state no-change") alike.clear();
    if (entry.is_state) alike.push_back(entry.id);
  }
  if (std::string why = WhyAllDropped(view_, alike.empty() ? state : alike.front()); !why.empty()) {
    reasons.push_back(Say(Situation::kDroppedIn, {{"state", alike.empty() ? state : alike.front()}, {"why", why}}));
    return reasons;
  }
  const bool grows = alike.size() > 2;
  reasons.push_back(
      grows ? Say(Situation::kStackGrows, {{"state", alike.front()}, {"first", alike[1]}, {"last", alike.back()}})
            : Say(Situation::kNoneProposed, {{"state", state}}));
  add(Nearest(candidates, known));
  if (!failed.empty()) reasons.push_back(failed);
  return reasons;
}

std::string MindReasons::WhyHalted() {
  std::vector<std::string> callers;
  for (const RuleText& rule : rules())
    if (rule.calls.contains("halt") && view_.HasFired(rule.name)) callers.push_back(rule.name);
  if (callers.empty()) return {};
  return callers.size() == 1 ? Say(Situation::kHaltedBy, {{"rule", callers.front()}})
                             : Say(Situation::kHaltedByOneOf, {{"rules", List(callers)}});
}

}  // namespace soarbox::explain
