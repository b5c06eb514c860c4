// SPDX-License-Identifier: BSD-2-Clause
#include "sim/reasons.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <map>
#include <optional>

#include "diagnostics/diagnostic.h"
#include "sim/rule_slips.h"
#include "sim/rule_text.h"
#include "sim/vocabulary.h"

namespace soarbox::sim {
namespace {

constexpr std::size_t kMostRulesAsked = 60;
constexpr std::size_t kMostRulesTold = 3;
constexpr std::size_t kMostValuesShown = 4;

/// Kernels print six decimals.
std::string WithoutZeros(std::string number) {
  const bool is_float =
      number.find('.') != std::string::npos && number.find_first_not_of("-0123456789.") == std::string::npos;
  while (is_float && number.ends_with('0')) number.pop_back();
  if (is_float && number.ends_with('.')) number.pop_back();
  return number;
}

std::string List(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size() && i < kMostValuesShown; ++i)
    text += (i == 0 ? "" : ", ") + WithoutZeros(words[i]);
  if (words.size() > kMostValuesShown) text += " and " + std::to_string(words.size() - kMostValuesShown) + " more";
  return text;
}

/// The same place, said from the top state on.
std::vector<std::string> FromTop(const std::vector<std::string>& path) {
  const auto begin =
      std::find_if(path.begin(), path.end(), [](const std::string& step) { return step != "superstate"; });
  return {begin, path.end()};
}

std::optional<double> NumberIn(const std::string& word) {
  double number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (word.empty() || error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return number;
}

/// Whether a value of an action may pass a test: what is no constant may.
bool MayPass(const std::string& made, const std::string& test) {
  if (made.empty() || made.find_first_of("<({") != std::string::npos || test.empty()) return true;
  const std::size_t blank = test.find(' ');
  const std::string relation = blank == std::string::npos ? "" : test.substr(0, blank);
  const std::string with = blank == std::string::npos ? test : test.substr(blank + 1);
  if (with.find_first_of(" <>{}^") != std::string::npos) return true;
  if (relation == "<>") return made != with;
  if (relation.empty()) return made == with;
  const std::optional<double> a = NumberIn(made), b = NumberIn(with);
  if (!a || !b) return false;
  return relation == "<"    ? *a < *b
         : relation == "<=" ? *a <= *b
         : relation == ">"  ? *a > *b
         : relation == ">=" ? *a >= *b
                            : true;
}

/// Whether a rule itself waits for what lies at this path: it cannot be what makes it.
bool Needs(const RuleText& rule, const std::vector<std::string>& path, const std::string& value) {
  const std::map<std::string, std::vector<std::string>> paths = VariablePaths(rule);
  return std::any_of(rule.conditions.begin(), rule.conditions.end(), [&](const RuleAttribute& condition) {
    const auto at = paths.find(condition.id);
    if (at == paths.end() || condition.negated || condition.attribute != path.back()) return false;
    std::vector<std::string> tested = at->second;
    tested.push_back(condition.attribute);
    return FromTop(tested) == path && (condition.value == value || IsVariable(FirstWord(condition.value)));
  });
}

/// The row of a percept that lies at this path from the state on; null if none does.
const PerceptRow* RowAt(const std::vector<std::string>& path) {
  constexpr std::size_t kLink = 2;  // io.input-link
  if (path.size() <= kLink || path[0] != "io" || path[1] != "input-link") return nullptr;
  std::string dotted;
  for (std::size_t i = kLink; i < path.size(); ++i) dotted += (i == kLink ? "" : ".") + path[i];
  for (const PerceptRow& row : Percepts())
    if (row.path == dotted) return &row;
  return nullptr;
}

}  // namespace

std::string SuggestAttribute(std::string_view attribute, const std::set<std::string>& known) {
  if (attribute.size() < 3) return {};
  const std::vector<std::string> more(known.begin(), known.end());
  const std::string_view near = NearestAttribute(attribute, more);
  return near.empty() ? std::string() : "did you mean ^" + std::string(near) + "?";
}

bool IsForSubstate(const RuleText& rule) {
  return std::any_of(rule.conditions.begin(), rule.conditions.end(), [](const RuleAttribute& condition) {
    return condition.attribute == "superstate" && !condition.negated && condition.value != "nil";
  });
}

const RuleText* MindReasons::MakerOf(const RuleText& rule, const ConditionText& condition) {
  const std::vector<std::string> wanted = FromTop(condition.path);
  for (const RuleText& maker : rules()) {
    if (maker.name == rule.name || Needs(maker, wanted, condition.value)) continue;
    const std::map<std::string, std::vector<std::string>> paths = VariablePaths(maker);
    for (const RuleAttribute& action : maker.actions) {
      if (action.attribute != condition.path.back() || action.value.ends_with("-")) continue;
      if (!MayPass(FirstWord(action.value), condition.value)) continue;
      if (const auto at = paths.find(action.id); at != paths.end()) {
        std::vector<std::string> made = at->second;
        made.push_back(action.attribute);
        if (FromTop(made) != wanted) continue;
      } else if (wanted.size() < 2) {
        continue;  // Below something new: not directly on a state.
      }
      return &maker;
    }
  }
  return nullptr;
}

std::string MindReasons::MadeBy(const RuleText& maker) {
  std::string text = "; rule " + maker.name + " makes it";
  bool is_first = true;
  for (const std::string& name : maker.applies) {
    if (name.empty()) continue;
    text += (is_first ? " when it applies " : " or ") + name;
    is_first = false;
  }
  return text;
}

std::string MindReasons::WhatFailed() const {
  if (failed_.empty()) return {};
  return (failed_.size() == 1 ? "a rule did not load: fix "
                              : std::to_string(failed_.size()) + " rules did not load: fix ") +
         List(failed_) + " first";
}

std::string MindReasons::StateOf(const RuleText& rule) {
  std::string top = "S1", last;
  for (const StackEntry& entry : view_.Stack()) {
    if (!entry.is_state) continue;
    if (last.empty()) top = entry.id;
    last = entry.id;
  }
  return IsForSubstate(rule) && !last.empty() ? last : top;
}

std::vector<std::string> MindReasons::UnwrittenAttributes(const std::set<std::string>& given) {
  std::set<std::string> known = given;
  for (const RuleText& rule : rules()) {
    for (const RuleAttribute& action : rule.actions) known.insert(action.attribute);
  }
  std::vector<std::string> found;
  std::set<std::string> told;
  for (const RuleText& rule : rules()) {
    for (const RuleAttribute& condition : rule.conditions) {
      const std::string& attribute = condition.attribute;
      if (!IsConstantAttribute(attribute) || IsArchitectureAttribute(attribute) || IsPerceptAttribute(attribute))
        continue;
      if (known.contains(attribute) || condition.negated || !told.insert(attribute).second) continue;
      if (!view_.ValuesOf(attribute).empty()) continue;
      const std::string hint = SuggestAttribute(attribute, known);
      found.push_back("rule " + rule.name + " tests ^" + attribute + ", which no percept and no rule makes" +
                      (hint.empty() ? "" : ": " + hint));
    }
  }
  return found;
}

std::string MindReasons::ExplainAbsence(const RuleText& rule, const ConditionText& condition,
                                        const std::set<std::string>& known) {
  const std::string& attribute = condition.path.back();
  std::string text = "there is none now";
  const bool is_percept = !FromTop(condition.path).empty() && FromTop(condition.path).front() == "io";
  if (const RuleText* maker = is_percept ? nullptr : MakerOf(rule, condition)) return text + MadeBy(*maker);
  if (const PerceptRow* row = RowAt(condition.path)) return text + " (" + std::string(row->meaning) + ")";
  if (known.contains(attribute) || IsArchitectureAttribute(attribute)) return text;
  if (const std::string places = PlacesOfPercept(attribute); !places.empty())
    return "no percept is there: it is " + places;
  const std::string hint = SuggestAttribute(attribute, known);
  return "no percept and no rule makes it" + (hint.empty() ? "" : ": " + hint);
}

std::string MindReasons::ExplainRule(const RuleText& rule, const std::set<std::string>& known) {
  const RuleMatch match = view_.Match(rule.name);
  if (match.failing.empty()) return {};
  std::string text = "rule " + rule.name + " requires ";
  const std::vector<ConditionText> conditions = ReadCondition(rule, match.failing);
  if (conditions.empty()) return text + match.failing;
  const ConditionText& first = conditions.front();
  const std::vector<std::string> values = view_.ValuesAt(StateOf(rule), first.path);
  std::vector<std::string> shown;
  for (const std::string& value : values)
    if (!IsIdentifier(value)) shown.push_back(value);

  if (match.is_group || first.negated) {
    text += "no ";
    for (std::size_t i = 0; i < conditions.size(); ++i) {
      ConditionText each = conditions[i];
      each.negated = false;
      text += (i == 0 ? "" : " with ") + each.Text();
    }
    if (shown.empty() || match.is_group) return text + ", but there is one";
    return text + ", but ^" + first.path.back() + " " + List(shown) + (shown.size() == 1 ? " exists" : " exist");
  }
  text += first.Text() + ", but ";
  if (values.empty()) return text + ExplainAbsence(rule, first, known);
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
  if (shown.empty())
    return text +
           (others == 1 ? "the one that is there" : "none of the " + std::to_string(others) + " that are there") +
           (others == 1 ? " does not fit the conditions before it" : " fits the conditions before it");
  // It is there, but elsewhere: another waypoint than the one that the conditions before it are about.
  if (std::find(shown.begin(), shown.end(), first.value) != shown.end())
    return text + "the one that has it does not fit the rule's other conditions";
  text += "it is " + List(shown) + bound;
  const std::vector<std::string_view> words = WordsOfPercept(first.path.back());
  if (words.empty() || RowAt(first.path) == nullptr || first.value.find_first_of(" <>{}") != std::string::npos)
    return text;
  if (std::find(words.begin(), words.end(), first.value) != words.end()) return text;
  text += "; it is never " + first.value + ", only";
  for (const std::string_view word : words) text += " " + std::string(word);
  return text;
}

std::vector<std::string> MindReasons::Nearest(const RuleList& candidates, const std::set<std::string>& known) {
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
  std::vector<std::string> texts;
  std::set<const RuleText*> told;
  const auto tell = [&](const RuleText& rule) {
    if (!told.insert(&rule).second) return;
    const std::vector<Slip> slips = FindSlipsOfForm({rule});
    const bool has_state = std::any_of(rule.conditions.begin(), rule.conditions.end(),
                                       [](const RuleAttribute& condition) { return condition.on_state; });
    // Without a state nothing tells where its conditions look.
    if (std::string text = has_state ? ExplainRule(rule, known) : std::string(); !text.empty())
      texts.push_back(std::move(text));
    for (const Slip& slip : slips) texts.push_back(slip.message + (slip.hint.empty() ? "" : ": " + slip.hint));
  };
  for (std::size_t i = 0; i < found.size() && i < kMostRulesTold; ++i) {
    tell(*found[i].rule);
    // What it waits for may be another rule's to make: then that one is why.
    const RuleMatch match = view_.Match(found[i].rule->name);
    const std::vector<ConditionText> waits = ReadCondition(*found[i].rule, match.failing);
    if (waits.empty() || waits.front().negated || match.is_group || waits.front().path.front() == "io") continue;
    const RuleText* maker = MakerOf(*found[i].rule, waits.front());
    // One that applies an operator waits for just that: no operator is what all this is about.
    if (maker != nullptr && waits.front().path.back() != "operator" && maker->applies.empty()) tell(*maker);
  }
  return texts;
}

std::vector<std::string> MindReasons::ExplainTie(const std::string& state) {
  std::vector<std::string> names, lines;
  std::set<std::string> operators;
  for (const Preference& preference : view_.Preferences(state)) {
    if (preference.section != "acceptable" || !operators.insert(preference.operator_id).second) continue;
    if (std::find(names.begin(), names.end(), preference.name) == names.end()) names.push_back(preference.name);
    if (lines.size() < kMostValuesShown)
      lines.push_back(view_.DescribeOperator(preference.operator_id) + " is proposed by rule " + preference.rule);
  }
  const bool same = names.size() == 1;
  lines.insert(lines.begin(),
               "operator tie in " + state + ": no preference decides between " +
                   (same ? std::to_string(operators.size()) + " " + names.front() + " operators" : List(names)));
  lines.emplace_back(
      "if it does not matter which, add = where they are proposed: (<s> ^operator <o> + =); if one is better, a rule "
      "that says so: (<s> ^operator <better> > <other>)");
  return lines;
}

std::vector<std::string> MindReasons::ExplainConflict(const std::string& state, const std::string& about) {
  std::vector<std::string> lines = {about + " in " + state + ": preferences contradict each other"};
  for (const Preference& preference : view_.Preferences(state)) {
    if (preference.section == "acceptable" || lines.size() > kMostValuesShown) continue;
    lines.push_back("rule " + preference.rule + " says " + preference.text);
  }
  return lines;
}

std::vector<std::string> MindReasons::WhyNotApplied(const StackEntry& selected, const std::string& state, bool is_below,
                                                    const std::set<std::string>& known) {
  const std::string& name = selected.about;
  RuleList candidates, below;
  const RuleText* applied_by = nullptr;
  bool says = false;
  for (const RuleText& rule : rules()) {
    if (IsForSubstate(rule) && !rule.proposes.empty()) below.push_back(&rule);
    if (!rule.applies.contains(name)) continue;
    candidates.push_back(&rule);
    if (!view_.Match(rule.name).failing.empty() || !view_.HasFired(rule.name)) continue;
    says |= !rule.says.empty();
    if (applied_by == nullptr) applied_by = &rule;
  }
  std::vector<std::string> reasons;
  if (applied_by != nullptr) {
    reasons.push_back(
        "operator " + name + " has been applied (rule " + applied_by->name +
        (says ? ")" : "), which said no command,") +
        " and stays selected: its proposal still lasts, and an operator is applied once; let the proposal test "
        "that something is left to do");
  } else if (std::any_of(candidates.begin(), candidates.end(),
                         [&](const RuleText* rule) { return view_.Match(rule->name).failing.empty(); })) {
    reasons.push_back("operator " + name + " is selected in " + state +
                      ", and the rule that applies it has not fired yet");
  } else if (!candidates.empty()) {
    reasons.push_back("operator " + name + " is selected in " + state + " and no rule that applies it matches");
    for (std::string& near : Nearest(candidates, known)) reasons.push_back(std::move(near));
  } else if (is_below && !below.empty()) {
    reasons.push_back("operator " + name + " is selected in " + state +
                      ", and in the state below it no operator is proposed");
    for (std::string& near : Nearest(below, known)) reasons.push_back(std::move(near));
  } else {
    reasons.push_back("operator " + name + " is selected in " + state +
                      " and no rule applies it: " + (failed_.empty() ? HowToApply(rules(), name) : WhatFailed()));
  }
  return reasons;
}

std::vector<std::string> MindReasons::WhyIdle(const std::set<std::string>& known) {
  if (rules().empty()) return {"it has no rules" + (failed_.empty() ? "" : ": " + WhatFailed())};
  std::vector<std::string> reasons;
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
      reasons = ExplainTie(state);
    } else if (entry.about == "operator conflict" || entry.about == "operator constraint-failure") {
      reasons = ExplainConflict(state, entry.about);
    }
    is_below = entry.about == "operator no-change";
    if (!is_below) selected = nullptr;
    state = entry.id;
  }
  if (!reasons.empty() && selected == nullptr) return reasons;

  // What rules that did not load would make is not known.
  if (failed_.empty()) reasons = UnwrittenAttributes(known);
  if (reasons.size() > kMostRulesTold) reasons.resize(kMostRulesTold);
  const auto add = [&reasons](std::vector<std::string> more) {
    for (std::string& reason : more) {
      // A misspelt attribute needs to be told once.
      const bool repeats = reason.find("no percept and no rule makes it") != std::string::npos &&
                           std::any_of(reasons.begin(), reasons.end(), [&](const std::string& told) {
                             return told.starts_with(reason.substr(0, reason.find(" requires ")) + " tests ");
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
  if (candidates.empty()) {
    reasons.push_back("no rule proposes an operator: " +
                      (failed_.empty() ? "write one with (<s> ^operator <o> +)" : WhatFailed()));
    return reasons;
  }
  reasons.push_back("no operator is proposed in " + state);
  add(Nearest(candidates, known));
  return reasons;
}

std::string MindReasons::WhyHalted() {
  std::vector<std::string> callers;
  for (const RuleText& rule : rules())
    if (rule.calls.contains("halt")) callers.push_back(rule.name);
  if (callers.empty()) return {};
  return (callers.size() == 1 ? "rule " : "one of the rules ") + List(callers) + " calls (halt)";
}

}  // namespace soarbox::sim
