// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/operators.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "debugger/facts_text.h"
#include "debugger/recorded_mind.h"
#include "wording/decision_text.h"
#include "wording/number_words.h"
#include "wording/sentences.h"

namespace soarbox::debugger {
namespace {

using explain::PreferenceFact;
using wording::Say;
using wording::Situation;

std::string Who(const OperatorRow& row) {
  return NameAndId(row.name, row.id);
}

/// Fills in a view from a recorded decision: verdicts of the operators, and the sentence.
class Account {
 public:
  Account(const mind::Decision& decision, OperatorsView& view) : decision_(decision), view_(view) {}

  void Write() {
    for (OperatorRow& row : view_.rows) TellRow(row);
    view_.sentence = Sentence();
  }

 private:
  bool IsLeft(std::uint32_t op) const {
    return std::ranges::any_of(decision_.left, [&](const auto& chance) { return chance.op == op; });
  }

  void TellRow(OperatorRow& row) const {
    const std::uint32_t op = decision_.Find(row.id);
    if (op == mind::Decision::kNoOperator) return;
    if (const mind::Decision::Drop* drop = decision_.DropOf(op)) {
      row.verdict = wording::WhyDropped(decision_, op);
      DroppedBy& dropped = row.dropped.emplace();
      dropped.stage = wording::StageName(drop->stage);
      if (drop->decisive != mind::Decisive::kUnknown) dropped.is_decisive = drop->decisive == mind::Decisive::kYes;
      for (std::uint32_t i = drop->first; i < drop->first + drop->count; ++i) {
        const std::string& rule = decision_.preferences[decision_.by[i]].rule;
        if (std::ranges::find(dropped.rules, rule) == dropped.rules.end()) dropped.rules.push_back(rule);
      }
    } else if (!IsLeft(op)) {
      row.verdict = row.proposed ? "" : "not proposed";
    } else if (row.selected) {
      row.verdict = "selected";
    } else if (decision_.is_forced) {
      row.verdict = Say(Situation::kAnotherForced);
    } else if (row.probability == 0.0) {
      row.verdict = Say(Situation::kNoChance);
    } else {
      const bool is_tie = decision_.impasse == mind::Impasse::kTie;
      const bool contradicts = decision_.impasse == mind::Impasse::kConstraintFailure;
      row.verdict = Say(is_tie ? Situation::kIsTied : contradicts ? Situation::kIsContradicted : Situation::kCouldWin);
    }
    if (!decision_.is_forced) return;
    // The command `decide select` forced the selection, so there was no probability.
    row.probability.reset();
    if (row.selected) row.verdict = "selected";
  }

  std::string Sentence() const {
    const auto selected = std::ranges::find_if(view_.rows, [](const OperatorRow& row) { return row.selected; });
    if (selected != view_.rows.end()) return OfSelected(*selected);
    if (!view_.selected.empty()) return Say(Situation::kSelectedUnspoken, {{"op", view_.selected}});
    if (std::ranges::none_of(view_.rows, &OperatorRow::proposed)) {
      return Say(view_.rows.empty() ? Situation::kNoneProposed : Situation::kNoneProposedNow,
                 {{"state", view_.state}}) +
             ".";
    }
    if (decision_.impasse == mind::Impasse::kNone && !decision_.left.empty()) return OfNext();
    std::string text = wording::WhyNothing(decision_) + ".";
    if (decision_.impasse == mind::Impasse::kTie) {
      std::string advice = Say(Situation::kTieAdvice);
      advice[0] = 'I';
      text += " " + advice + ".";
    }
    return text;
  }

  std::string OfSelected(const OperatorRow& row) const {
    const std::uint32_t op = decision_.Find(row.id);
    if (!decision_.is_forced && (decision_.impasse != mind::Impasse::kNone || !IsLeft(op))) {
      std::string why = wording::WhyDropped(decision_, op);
      if (why.empty()) why = row.proposed ? wording::WhyNothing(Undecided()) : Say(Situation::kNoLongerProposed);
      return Say(Situation::kGoesNext, {{"op", Who(row)}, {"why", why}});
    }
    if (decision_.has_changed && !decision_.is_forced) {
      return Say(Situation::kHasChanged, {{"op", Who(row)}, {"why", wording::WhySelected(decision_)}});
    }
    return Say(Situation::kWasSelected, {{"op", Who(row)}, {"why", wording::WhySelected(decision_)}});
  }

  mind::Decision Undecided() const {
    mind::Decision decision = decision_;
    decision.selected = mind::Decision::kNoOperator;
    return decision;
  }

  std::string OfNext() const {
    if (decision_.left.size() > 1)
      return Say(Situation::kOneOfNext, {{"count", std::to_string(decision_.left.size())}});
    mind::Decision decided = decision_;
    decided.selected = decision_.left.front().op;
    return Say(Situation::kNext,
               {{"op", wording::OperatorText(decided, decided.selected)}, {"why", wording::WhySelected(decided)}});
  }

  const mind::Decision& decision_;
  OperatorsView& view_;
};

/// Fills in what is selected, without a reason, because no decision is recorded.
void TellWithout(OperatorsView& view) {
  for (OperatorRow& row : view.rows) {
    row.verdict = row.selected ? "selected" : row.proposed ? "proposed" : "";
    if (row.selected) view.sentence = Say(Situation::kIsSelected, {{"op", Who(row)}});
  }
  if (!view.sentence.empty()) return;
  if (!view.selected.empty()) {
    view.sentence = Say(Situation::kIsSelected, {{"op", view.selected}});
  } else if (view.rows.empty()) {
    view.sentence = Say(Situation::kNoneProposed, {{"state", view.state}}) + ".";
  }
}

/// Values of an operator's attributes except its name: "north", or "W1 (north)" for an object with a name.
using Features = std::map<std::string, std::string>;

Features FeaturesOf(explain::Inspector& mind, const std::string& op) {
  Features features;
  for (const explain::ElementFact& element : mind.ElementsOf(op)) {
    if (element.attribute == "name") continue;
    std::string value = element.value;
    if (element.is_object) {
      for (const explain::ElementFact& below : mind.ElementsOf(element.value))
        if (below.attribute == "name" && !below.is_object) value += " (" + below.value + ")";
    }
    std::string& told = features[element.attribute];
    told += (told.empty() ? "" : " ") + value;
  }
  return features;
}

/// Describes operators of the same name by the attributes in which they differ.
void TellApart(explain::Inspector& mind, OperatorsView& view) {
  constexpr std::size_t kMostOperators = 24, kMostAttributes = 3;
  std::map<std::string, std::vector<OperatorRow*>> by_name;
  for (OperatorRow& row : view.rows)
    if (!row.name.empty()) by_name[row.name].push_back(&row);
  std::size_t looked_at = 0;
  for (const auto& [name, rows] : by_name) {
    looked_at += rows.size();
    if (rows.size() < 2 || looked_at > kMostOperators) continue;
    std::vector<Features> features;
    for (const OperatorRow* row : rows) features.push_back(FeaturesOf(mind, row->id));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      std::size_t told = 0;
      for (const Features::value_type& feature : features[i]) {
        const auto has_the_same = [&](const Features& other) {
          const auto at = other.find(feature.first);
          return at != other.end() && at->second == feature.second;
        };
        if (std::ranges::all_of(features, has_the_same) || ++told > kMostAttributes) continue;
        rows[i]->about += (rows[i]->about.empty() ? "^" : " ^") + feature.first + " " + feature.second;
      }
    }
  }
}

OperatorRow& FindOrAddRow(OperatorsView& view, const std::string& id, const std::string& name) {
  const auto at = std::ranges::find_if(view.rows, [&](const OperatorRow& row) { return row.id == id; });
  if (at != view.rows.end()) return *at;
  OperatorRow& row = view.rows.emplace_back();
  row.id = id;
  row.name = name;
  row.selected = id == view.selected;
  return row;
}

}  // namespace

std::string Title(const OperatorRow& row) {
  return NameAndId(row.name, row.id) + (row.about.empty() ? "" : " " + row.about);
}

std::string Describe(const PreferenceFact& preference) {
  constexpr std::pair<std::string_view, Situation> kKinds[] = {
      {"acceptable", Situation::kProposes}, {"require", Situation::kRequires}, {"reject", Situation::kRejects},
      {"prohibit", Situation::kProhibits},  {"best", Situation::kMakesBest},   {"worst", Situation::kMakesWorst},
      {"better", Situation::kMakesBetter},  {"worse", Situation::kMakesWorse}, {"equal", Situation::kMakesEqual},
      {"numeric", Situation::kGivesValue}};
  const auto kind = std::ranges::find(kKinds, preference.type, &std::pair<std::string_view, Situation>::first);
  std::string text = Say(kind == std::end(kKinds) ? Situation::kMakesIndifferent : kind->second,
                         {{"maker", preference.maker.rule.empty() ? "" : "rule " + preference.maker.rule},
                          {"op", "it"},
                          {"other", NameAndId(preference.other_name, preference.referent)},
                          {"value", wording::WithoutZeros(preference.referent)}});
  return text.substr(text.find_first_not_of(' '));  // The origin may not be reported.
}

OperatorsView View(const explain::OperatorFacts& facts) {
  OperatorsView view;
  view.state = facts.state;
  view.selected = facts.selected;
  // A no-change impasse does not depend on preferences.
  if (facts.impasse != "none" && facts.impasse != "no-change") view.impasse = facts.impasse;
  for (const PreferenceFact& preference : facts.preferences) {
    OperatorRow& row = FindOrAddRow(view, preference.value, preference.name);
    row.proposed = row.proposed || preference.type == "acceptable" || preference.type == "require";
    row.preferences.push_back(preference);
  }
  for (const explain::CandidateFact& candidate : facts.candidates) {
    OperatorRow& row = FindOrAddRow(view, candidate.id, candidate.name);
    const bool has_value =
        std::ranges::any_of(row.preferences, [](const PreferenceFact& p) { return p.type == "numeric"; });
    if (has_value) row.value = candidate.value;
    row.probability = candidate.probability;
  }
  if (facts.decision) {
    Account(*facts.decision, view).Write();
  } else {
    TellWithout(view);
  }
  return view;
}

OperatorsView LookAtOperators(explain::Inspector& mind, std::string_view state) {
  std::string wanted(state);
  explain::OperatorFacts facts;
  if (wanted.empty()) {
    // The lowest state with operators.
    const std::vector<explain::StateFact> stack = mind.Stack();
    if (!stack.empty()) wanted = stack.front().id;
    for (auto at = stack.rbegin(); at != stack.rend(); ++at) {
      facts = mind.Operators(at->id);
      if (facts.preferences.empty() && facts.selected.empty()) continue;
      wanted = at->id;
      break;
    }
  }
  if (facts.state != wanted) facts = mind.Operators(wanted);
  if (facts.state.empty()) {
    OperatorsView none;
    none.state = wanted;
    none.note = "there is no state " + wanted + " now";
    return none;
  }
  OperatorsView view = View(facts);
  TellApart(mind, view);
  if (!mind.TellsAll()) view.note = "what the preferences rest on: " + std::string(Absence(mind));
  if (!facts.decision) view.note += (view.note.empty() ? "" : "; ") + ("why: " + std::string(Absence(mind)));
  TellRecorded(mind, view);
  return view;
}

std::string ToText(const OperatorsView& view) {
  std::string text = "operators of " + view.state + (view.impasse.empty() ? "" : ", impasse: " + view.impasse) + "\n";
  text += view.sentence + (view.sentence.empty() ? "" : "\n");
  for (const OperatorRow& row : view.rows) {
    text += (row.selected ? "* " : "  ") + Title(row) + (row.verdict.empty() ? "" : ": " + row.verdict);
    if (row.value) text += fmt::format(", value {:g}", *row.value);
    if (row.probability) text += fmt::format(", probability {:.3g} %", *row.probability * 100);
    text += "\n";
    for (const PreferenceFact& preference : row.preferences) {
      text += "    " + preference.sign + "  " + Describe(preference) + "\n";
      for (const explain::ElementFact& element : preference.maker.elements)
        text += "         " + Describe(element) + "\n";
    }
  }
  return text + (view.note.empty() ? "" : view.note + "\n");
}

}  // namespace soarbox::debugger
