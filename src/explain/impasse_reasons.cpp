// SPDX-License-Identifier: BSD-2-Clause
#include "explain/impasse_reasons.h"

#include <algorithm>
#include <set>
#include <utility>

#include "wording/decision_text.h"
#include "wording/number_words.h"
#include "wording/sentences.h"

namespace soarbox::explain {
namespace {

constexpr std::size_t kMostShown = 4;  ///< Maximum number of tied operators that are described.

using wording::Listed;
using wording::Say;
using wording::Situation;

/// Why no preference decides among candidates, as the end of a sentence: they have the same preference, or one rule
/// proposes them because an attribute has several values. Empty if neither is so.
std::string WhyAlike(MindView& view, const std::string& state, const std::vector<PreferenceFact>& proposals) {
  const std::vector<PreferenceFact> preferences = view.Preferences(state);
  // Whether all candidates have the same unary preference.
  const auto have_all = [&](std::string_view type) {
    return proposals.size() > 1 && std::ranges::all_of(proposals, [&](const PreferenceFact& proposal) {
             return std::ranges::any_of(preferences, [&](const PreferenceFact& one) {
               return one.type == type && one.value == proposal.value;
             });
           });
  };
  if (have_all("worst")) return Say(Situation::kTieAllSigned, {{"sign", "<"}});
  if (have_all("best")) return Say(Situation::kTieAllSigned, {{"sign", ">"}});
  // One rule proposes all of them because an attribute that rules make has several values.
  const auto is_same = [&](const PreferenceFact& proposal) {
    return proposal.maker.rule == proposals.front().maker.rule;
  };
  if (proposals.size() < 2 || !std::ranges::all_of(proposals, is_same)) return {};
  const auto proposer = std::ranges::find(view.rules(), proposals.front().maker.rule, &RuleText::name);
  if (proposer == view.rules().end()) return {};
  for (const RuleAttribute& action : proposer->actions) {
    if (action.attribute == "operator" || !IsVariable(action.value)) continue;
    for (const RuleAttribute& source : proposer->conditions) {
      if (source.negated || source.value != action.value || !IsConstantAttribute(source.attribute)) continue;
      const auto path = proposer->paths.find(source.id);
      if (path == proposer->paths.end() || path->second.empty() || path->second.front() == "io") continue;
      const RuleText* maker = nullptr;
      for (const RuleText& rule : view.rules())
        for (const RuleAttribute& made : rule.actions)
          if (maker == nullptr && !rule.name.starts_with("chunk*") && made.attribute == source.attribute &&
              !made.removes && IsVariable(made.value) && !rule.applies.empty())
            maker = &rule;
      std::set<std::string> values;
      for (const PreferenceFact& proposal : proposals)
        for (const std::string& value : view.ValuesAt(proposal.value, {action.attribute})) values.insert(value);
      if (maker == nullptr || values.size() != proposals.size()) continue;
      return Say(Situation::kTieBySeveral, {{"attribute", action.attribute},
                                            {"source", source.attribute},
                                            {"values", Listed(std::vector<std::string>(values.begin(), values.end()))},
                                            {"rule", maker->name}});
    }
  }
  return {};
}

}  // namespace

std::vector<Reason> ExplainTie(MindView& view, const std::string& state, const std::string& below) {
  // The remaining candidates are the items of the impasse; other operators may be proposed and dropped.
  const std::vector<std::string> items = view.ValuesAt(below, {"item"});
  std::vector<PreferenceFact> proposals;
  for (PreferenceFact& preference : view.Preferences(state)) {
    const std::string& op = preference.value;
    if (preference.type != "acceptable") continue;
    if (!items.empty() && std::ranges::find(items, op) == items.end()) continue;
    if (std::ranges::find(proposals, op, &PreferenceFact::value) == proposals.end())
      proposals.push_back(std::move(preference));
  }
  // Sorts "O2" before "O10".
  std::ranges::sort(proposals, {},
                    [](const PreferenceFact& proposal) { return std::pair(proposal.value.size(), proposal.value); });
  std::vector<std::string> names;
  std::vector<Reason> lines;
  for (const PreferenceFact& proposal : proposals) {
    if (std::ranges::find(names, proposal.name) == names.end()) names.push_back(proposal.name);
    if (lines.size() < kMostShown && !proposal.maker.rule.empty())
      lines.push_back(Say(Situation::kIsProposedBy,
                          {{"op", view.DescribeOperator(proposal.value)}, {"rule", proposal.maker.rule}}));
  }
  const std::string alike = WhyAlike(view, state, proposals);
  // A proposed constant is a candidate without a name.
  for (const std::string& item : items)
    if (std::ranges::find(proposals, item, &PreferenceFact::value) == proposals.end()) names.push_back(item);
  const std::string among =
      names.size() == 1
          ? Say(Situation::kTieAlike, {{"count", std::to_string(proposals.size())}, {"name", names.front()}})
          : Listed(names);
  const std::string why = Say(Situation::kTie, {{"operators", among}}) + alike;
  lines.insert(lines.begin(), {Say(Situation::kTieIn, {{"state", state}, {"why", why}}), Reason::Kind::kTorn});
  lines.push_back(Say(Situation::kTieAdvice));
  return lines;
}

std::vector<Reason> ExplainConflict(MindView& view, const std::string& state, const StackEntry& below) {
  const bool is_conflict = below.about == "operator conflict";
  const Situation situation = is_conflict ? Situation::kConflictIn : Situation::kConstraintFailureIn;
  const Reason::Kind kind = is_conflict ? Reason::Kind::kTorn : Reason::Kind::kOther;
  mind::Decision decision = view.DecisionOf(state);
  decision.selected = mind::Decision::kNoOperator;
  if (const std::string why = wording::WhyNothing(decision); !why.empty() && decision.impasse != mind::Impasse::kNone)
    return {{Say(situation, {{"state", state}, {"why", why}}), kind}};
  // For another kernel: the preferences of that kind among the candidates.
  const std::vector<std::string> items = view.ValuesAt(below.id, {"item"});
  std::string said;
  for (const PreferenceFact& preference : view.Preferences(state)) {
    const std::string& type = preference.type;
    const bool may_be_why = is_conflict ? type == "better" || type == "worse" : type == "require" || type == "prohibit";
    if (!may_be_why || std::ranges::find(items, preference.value) == items.end()) continue;
    said += (said.empty() ? "" : "; ") + ("rule " + preference.maker.rule + " says " + PreferenceText(preference));
  }
  return {{Say(situation, {{"state", state}, {"why", said}}), kind}};
}

std::string WhyAllDropped(MindView& view, const std::string& state) {
  if (state.empty()) return {};
  const mind::Decision decision = view.DecisionOf(state);
  if (!decision.empty()) return wording::WhyNothing(decision);
  // For another kernel, the drops are not known. Lists its preferences against operators, if there are proposals.
  std::string against;
  bool is_proposed = false;
  for (const PreferenceFact& preference : view.Preferences(state)) {
    is_proposed |= preference.type == "acceptable";
    if (preference.type != "reject" && preference.type != "prohibit") continue;
    against +=
        (against.empty() ? "" : "; ") +
        Say(preference.type == "reject" ? Situation::kRejects : Situation::kProhibits,
            {{"maker", "rule " + preference.maker.rule}, {"op", preference.name + " (" + preference.value + ")"}});
  }
  return is_proposed && !against.empty() ? Say(Situation::kAllDropped, {{"why", against}}) : std::string();
}

}  // namespace soarbox::explain
