// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/operators.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "debugger/facts_text.h"
#include "debugger/recorded_mind.h"

namespace soarbox::debugger {
namespace {

using sim::PreferenceFact;

/// Weighs preferences the way a decision does, and notes at each step who leaves and why.
class Scale {
 public:
  explicit Scale(OperatorsView& view) : view_(view) {}

  void Weigh() {
    for (std::size_t i = 0; i < view_.rows.size(); ++i)
      if (view_.rows[i].proposed) left_.push_back(i);
    if (left_.empty()) {
      view_.sentence = view_.rows.empty() ? "no operator is proposed in " + view_.state + "."
                                          : "no operator is proposed in " + view_.state + " any more.";
      return Finish();
    }
    if (Require()) return Finish();
    Drop("prohibit", "prohibited");
    Drop("reject", "rejected");
    Compare();
    Best();
    Worst();
    Finish();
  }

 private:
  std::string Who(std::size_t row) const { return NameAndId(view_.rows[row].name, view_.rows[row].id); }

  const PreferenceFact* Get(std::size_t row, std::string_view type) const {
    for (const PreferenceFact& preference : view_.rows[row].preferences)
      if (preference.type == type) return &preference;
    return nullptr;
  }

  static std::string By(const PreferenceFact& preference) {
    return preference.maker.rule.empty() ? std::string() : " by rule " + preference.maker.rule;
  }

  void Leave(std::size_t row, std::string verdict) {
    view_.rows[row].verdict = std::move(verdict);
    std::erase(left_, row);
  }

  /// One that is required is chosen, whatever else is said.
  bool Require() {
    std::vector<std::size_t> required;
    for (const std::size_t row : left_)
      if (Get(row, "require") != nullptr) required.push_back(row);
    if (required.empty()) return false;
    for (const std::size_t row : std::vector<std::size_t>(left_))
      if (std::ranges::find(required, row) == required.end()) Leave(row, "not required");
    reason_ = "it is required" + By(*Get(required.front(), "require"));
    if (required.size() > 1) {
      view_.sentence = fmt::format(
          "{} operators are required, which contradict each other: a rule may require one only.", required.size());
    } else if (const PreferenceFact* prohibit = Get(required.front(), "prohibit")) {
      view_.sentence = Who(required.front()) + " is required and prohibited" + By(*prohibit) + ".";
    }
    return true;
  }

  void Drop(std::string_view type, const std::string& word) {
    for (const std::size_t row : std::vector<std::size_t>(left_)) {
      const PreferenceFact* preference = Get(row, type);
      if (preference == nullptr) continue;
      if (left_.size() == 1) last_gone_ = row;
      Leave(row, word + By(*preference));
      reason_ = Who(row) + " is " + word + By(*preference);
    }
  }

  /// Whether a preference of `row` or of `other` says that `row` is worse.
  const PreferenceFact* WorseThan(std::size_t row, std::size_t other) const {
    for (const PreferenceFact& preference : view_.rows[row].preferences)
      if (preference.type == "worse" && preference.referent == view_.rows[other].id) return &preference;
    for (const PreferenceFact& preference : view_.rows[other].preferences)
      if (preference.type == "better" && preference.referent == view_.rows[row].id) return &preference;
    return nullptr;
  }

  void Compare() {
    const std::vector<std::size_t> all = left_;
    for (const std::size_t row : all) {
      for (const std::size_t other : all) {
        const PreferenceFact* worse = row == other ? nullptr : WorseThan(row, other);
        if (worse == nullptr) continue;
        if (WorseThan(other, row) != nullptr) {
          if (view_.sentence.empty())
            view_.sentence = Who(row) + " and " + Who(other) + " are each better than the other: rules contradict.";
          continue;
        }
        Leave(row, "worse than " + Who(other) + By(*worse));
        reason_ = "it is better than " + Who(row) + By(*worse);
        break;
      }
    }
  }

  void Best() {
    const auto best = std::ranges::find_if(left_, [&](std::size_t row) { return Get(row, "best") != nullptr; });
    if (best == left_.end()) return;
    const std::size_t first = *best;
    for (const std::size_t row : std::vector<std::size_t>(left_))
      if (Get(row, "best") == nullptr) Leave(row, "not best, as " + Who(first) + " is");
    reason_ = "it is best" + By(*Get(first, "best"));
  }

  void Worst() {
    if (std::ranges::all_of(left_, [&](std::size_t row) { return Get(row, "worst") != nullptr; })) return;
    for (const std::size_t row : std::vector<std::size_t>(left_)) {
      const PreferenceFact* worst = Get(row, "worst");
      if (worst == nullptr) continue;
      Leave(row, "worst" + By(*worst));
      reason_ = Who(row) + " is worst" + By(*worst);
    }
  }

  std::string ListLeft() const {
    std::string text;
    for (std::size_t i = 0; i < left_.size(); ++i)
      text += (i == 0 ? "" : i + 1 == left_.size() ? " and " : ", ") + Who(left_[i]);
    return text;
  }

  void Finish() {
    const auto selected =
        std::ranges::find_if(view_.rows, [&](const OperatorRow& row) { return row.id == view_.selected; });
    const bool has_selected = !view_.selected.empty() && selected != view_.rows.end();
    for (const std::size_t row : left_)
      if (view_.rows[row].verdict.empty()) view_.rows[row].verdict = "could win";
    if (!view_.sentence.empty() && !has_selected) return;
    if (has_selected) {
      const auto place = static_cast<std::size_t>(selected - view_.rows.begin());
      if (selected->verdict.empty() || selected->verdict == "could win") selected->verdict = "selected";
      view_.sentence = WonBecause(place);
    } else if (!view_.selected.empty()) {
      view_.sentence = view_.selected + " is selected, and no preference speaks of it any more.";
    } else if (left_.empty()) {
      view_.sentence = "every operator that is proposed has been ruled out: " + reason_ + ".";
    } else if (left_.size() == 1) {
      view_.sentence = Who(left_.front()) + " would be selected at the next decision.";
    } else if (!view_.impasse.empty() || !AllIndifferent()) {
      view_.sentence =
          ListLeft() +
          " tie: no preference decides between them. If it does not matter which, add = where they are "
          "proposed: (<s> ^operator <o> + =); if one is better, a rule (<s> ^operator <better> > <other>).";
    } else {
      view_.sentence = "one of " + ListLeft() + " would be chosen by chance: they are indifferent.";
    }
  }

  bool AllIndifferent() const {
    return std::ranges::all_of(left_, [&](std::size_t row) {
      return Get(row, "indifferent") != nullptr || Get(row, "numeric") != nullptr || Get(row, "equal") != nullptr;
    });
  }

  std::string WonBecause(std::size_t place) const {
    const std::string who = Who(place);
    if (std::ranges::find(left_, place) == left_.end()) {
      return who + " is selected, but by now it is " +
             (view_.rows[place].proposed ? view_.rows[place].verdict : "proposed no more") +
             ": it goes at the next decision.";
    }
    const auto proposed = std::ranges::count_if(view_.rows, [](const OperatorRow& row) { return row.proposed; });
    if (proposed == 1) {
      const PreferenceFact* acceptable = Get(place, "acceptable");
      return who + " won: it is the only operator that is proposed" + (acceptable == nullptr ? "" : By(*acceptable)) +
             ".";
    }
    if (left_.size() == 1) return who + " won: " + reason_ + ".";
    const OperatorRow& row = view_.rows[place];
    std::string text = who + " was chosen by chance among " + std::to_string(left_.size()) + " indifferent operators";
    if (row.probability) text += fmt::format(", with a probability of {:.3g} %", *row.probability * 100);
    return text + ".";
  }

  OperatorsView& view_;
  std::vector<std::size_t> left_;
  std::string reason_;
  std::size_t last_gone_ = 0;
};

OperatorRow& RowOf(OperatorsView& view, const std::string& id, const std::string& name) {
  const auto at = std::ranges::find_if(view.rows, [&](const OperatorRow& row) { return row.id == id; });
  if (at != view.rows.end()) return *at;
  OperatorRow& row = view.rows.emplace_back();
  row.id = id;
  row.name = name;
  row.selected = id == view.selected;
  return row;
}

}  // namespace

std::string Describe(const PreferenceFact& preference) {
  const std::string by = preference.maker.rule.empty() ? "" : "rule " + preference.maker.rule + " ";
  const std::string other = NameAndId(preference.other_name, preference.referent);
  if (preference.type == "acceptable") return by + "proposes it";
  if (preference.type == "require") return by + "requires it";
  if (preference.type == "reject") return by + "rejects it";
  if (preference.type == "prohibit") return by + "prohibits it";
  if (preference.type == "better") return by + "makes it better than " + other;
  if (preference.type == "worse") return by + "makes it worse than " + other;
  if (preference.type == "equal") return by + "makes it indifferent to " + other;
  if (preference.type == "numeric") return by + "gives it the value " + preference.referent;
  return by + "makes it " + preference.type;
}

OperatorsView Weigh(const sim::OperatorFacts& facts) {
  OperatorsView view;
  view.state = facts.state;
  view.selected = facts.selected;
  // A no-change below is no matter of preferences.
  if (facts.impasse != "none" && facts.impasse != "no-change") view.impasse = facts.impasse;
  for (const PreferenceFact& preference : facts.preferences) {
    OperatorRow& row = RowOf(view, preference.value, preference.name);
    row.proposed = row.proposed || preference.type == "acceptable" || preference.type == "require";
    row.preferences.push_back(preference);
  }
  for (const sim::CandidateFact& candidate : facts.candidates) {
    OperatorRow& row = RowOf(view, candidate.id, candidate.name);
    const bool has_value =
        std::ranges::any_of(row.preferences, [](const PreferenceFact& p) { return p.type == "numeric"; });
    if (has_value) row.value = candidate.value;
    row.probability = candidate.probability;
  }
  Scale(view).Weigh();
  return view;
}

OperatorsView LookAtOperators(sim::Inspector& mind, std::string_view state) {
  std::string wanted(state);
  sim::OperatorFacts facts;
  if (wanted.empty()) {
    // The lowest state that has any.
    const std::vector<sim::StateFact> stack = mind.Stack();
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
  OperatorsView view = Weigh(facts);
  if (!mind.TellsAll()) view.note = "what the preferences rest on: " + std::string(Absence(mind));
  TellRecorded(mind, view);
  return view;
}

std::string ToText(const OperatorsView& view) {
  std::string text = "operators of " + view.state + (view.impasse.empty() ? "" : ", impasse: " + view.impasse) + "\n";
  text += view.sentence + (view.sentence.empty() ? "" : "\n");
  for (const OperatorRow& row : view.rows) {
    text +=
        (row.selected ? "* " : "  ") + NameAndId(row.name, row.id) + (row.verdict.empty() ? "" : ": " + row.verdict);
    if (row.value) text += fmt::format(", value {:g}", *row.value);
    if (row.probability) text += fmt::format(", probability {:.3g} %", *row.probability * 100);
    text += "\n";
    for (const PreferenceFact& preference : row.preferences) {
      text += "    " + preference.sign + "  " + Describe(preference) + "\n";
      for (const sim::ElementFact& element : preference.maker.elements) text += "         " + Describe(element) + "\n";
    }
  }
  return text + (view.note.empty() ? "" : view.note + "\n");
}

Json ToJson(const OperatorsView& view) {
  Json json;
  json["state"] = view.state;
  json["selected"] = view.selected;
  json["impasse"] = view.impasse;
  json["why"] = view.sentence;
  if (!view.note.empty()) json["note"] = view.note;
  json["operators"] = Json::array();
  for (const OperatorRow& row : view.rows) {
    Json one;
    one["id"] = row.id;
    one["name"] = row.name;
    one["selected"] = row.selected;
    one["verdict"] = row.verdict;
    if (row.value) one["value"] = *row.value;
    if (row.probability) one["probability"] = *row.probability;
    one["preferences"] = Json::array();
    for (const PreferenceFact& preference : row.preferences) {
      Json told;
      told["type"] = preference.type;
      told["sign"] = preference.sign;
      if (!preference.referent.empty()) told["referent"] = preference.referent;
      told["maker"] = ToJson(preference.maker);
      one["preferences"].push_back(std::move(told));
    }
    json["operators"].push_back(std::move(one));
  }
  return json;
}

}  // namespace soarbox::debugger
