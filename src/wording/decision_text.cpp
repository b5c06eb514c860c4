// SPDX-License-Identifier: BSD-2-Clause
#include "wording/decision_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "diagnostics/name_table.h"
#include "wording/sentences.h"

namespace soarbox::wording {
namespace {

using mind::Decision;
using mind::Decisive;
using mind::Impasse;
using mind::Policy;
using mind::PreferenceKind;
using mind::Stage;

constexpr std::size_t kMostReasons = 4;     ///< Maximum number of reasons in a sentence.
constexpr std::size_t kMostCompared = 300;  ///< With more drops, mutual drops are not searched.

std::string Maker(const Decision::Preference& preference) {
  if (preference.rule.empty() || preference.rule == "|Memory System Recall|") return "the architecture";
  if (preference.rule == "[excised]") return "a rule that has been excised";
  return "rule " + preference.rule;
}

/// The operators that a better or worse preference ranks higher and lower.
std::uint32_t Upper(const Decision::Preference& p) {
  return p.kind == PreferenceKind::kBetter ? p.op : p.referent;
}
std::uint32_t Lower(const Decision::Preference& p) {
  return p.kind == PreferenceKind::kBetter ? p.referent : p.op;
}

class Teller {
 public:
  Teller(const Decision& decision, std::uint32_t subject) : decision_(decision), subject_(subject) {}

  std::string Who(std::uint32_t op) const { return op == subject_ ? "it" : OperatorText(decision_, op); }

  /// "rule R makes it better than turn (O3)".
  std::string Clause(const Decision::Preference& p) const {
    const std::string by = Maker(p), who = Who(p.op);
    const auto say = [&](Situation situation) { return Say(situation, {{"maker", by}, {"op", who}}); };
    switch (p.kind) {
      case PreferenceKind::kAcceptable:
        return say(Situation::kProposes);
      case PreferenceKind::kRequire:
        return say(Situation::kRequires);
      case PreferenceKind::kReject:
        return say(Situation::kRejects);
      case PreferenceKind::kProhibit:
        return say(Situation::kProhibits);
      case PreferenceKind::kBest:
        return say(Situation::kMakesBest);
      case PreferenceKind::kWorst:
        return say(Situation::kMakesWorst);
      case PreferenceKind::kBetter:
      case PreferenceKind::kWorse: {
        // Phrased from the perspective of the sentence's subject.
        const bool from_below = Lower(p) == subject_ || (p.kind == PreferenceKind::kWorse && Upper(p) != subject_);
        const std::uint32_t first = from_below ? Lower(p) : Upper(p), second = from_below ? Upper(p) : Lower(p);
        return Say(from_below ? Situation::kMakesWorse : Situation::kMakesBetter,
                   {{"maker", by}, {"op", Who(first)}, {"other", Who(second)}});
      }
      case PreferenceKind::kIndifferent:
        return say(Situation::kMakesIndifferent);
      case PreferenceKind::kNumeric:
        return Say(Situation::kGivesValue, {{"maker", by}, {"op", who}, {"value", fmt::format("{:g}", p.number)}});
      case PreferenceKind::kEqual:
        return Say(Situation::kMakesEqual, {{"maker", by}, {"op", who}, {"other", Who(p.referent)}});
    }
    return {};
  }

  std::span<const std::uint32_t> By(const Decision::Drop& drop) const {
    return std::span(decision_.by).subspan(drop.first, drop.count);
  }
  const Decision::Preference& At(std::uint32_t place) const { return decision_.preferences[place]; }

  /// The preference by which a sentence explains a drop: one that mentions the subject, otherwise the first one;
  /// prohibit before reject. Null if the drop has none.
  const Decision::Preference* Telling(const Decision::Drop& drop) const {
    const Decision::Preference* first = nullptr;
    for (const std::uint32_t place : By(drop)) {
      const Decision::Preference& p = At(place);
      if (first == nullptr) first = &p;
      const bool compares = p.kind == PreferenceKind::kBetter || p.kind == PreferenceKind::kWorse;
      if (p.op == subject_ || (compares && p.referent == subject_)) return &p;
      if (drop.stage == Stage::kProhibit && p.kind == PreferenceKind::kProhibit &&
          first->kind != PreferenceKind::kProhibit)
        first = &p;
    }
    return first;
  }

  /// The preference by which another dropped candidate is better than this one; null if there is none.
  const Decision::Preference* DominatedBy(const Decision::Drop& drop, std::uint32_t other) const {
    if (drop.stage != Stage::kDominated) return nullptr;
    for (const std::uint32_t place : By(drop))
      if (Upper(At(place)) == other) return &At(place);
    return nullptr;
  }

  /// A sentence about two candidates that were dropped because each is better than the other: "a (O3) and b (O2) are
  /// each better than the other (rules R and S), so both were dropped". `other` becomes the other candidate. Empty if
  /// `drop` has no such counterpart, or if the subject is better than one of the two.
  std::string Mutual(const Decision::Drop& drop, std::uint32_t& other) const {
    if (decision_.drops.size() > kMostCompared || drop.stage != Stage::kDominated) return {};
    if (subject_ != Decision::kNoOperator && DominatedBy(drop, subject_) != nullptr) return {};
    for (const Decision::Drop& second : decision_.drops) {
      const Decision::Preference* below = DominatedBy(drop, second.op);
      const Decision::Preference* above = DominatedBy(second, drop.op);
      if (below == nullptr || above == nullptr || &second == &drop) continue;
      if (subject_ != Decision::kNoOperator && DominatedBy(second, subject_) != nullptr) continue;
      other = second.op;
      const std::string makers = below->rule == above->rule ? Maker(*below)
                                                            : (below->rule.empty() || above->rule.empty()
                                                                   ? Maker(*below) + " and " + Maker(*above)
                                                                   : "rules " + below->rule + " and " + above->rule);
      return Say(Situation::kMutual, {{"op", OperatorText(decision_, drop.op)},
                                      {"other", OperatorText(decision_, second.op)},
                                      {"makers", makers}});
    }
    return {};
  }

  /// Whether a drop's candidate would lose without the preference of a clause: by another sufficient preference, or at
  /// a later stage.
  bool WouldStillLose(const Decision::Drop& drop, const std::string& clause) const {
    return drop.decisive == Decisive::kNo ||
           std::ranges::any_of(By(drop), [&](std::uint32_t place) { return Clause(At(place)) != clause; });
  }

  /// The first few reasons, each once.
  std::vector<std::string> Reasons() const {
    std::vector<std::string> reasons;
    std::set<std::uint32_t> told;
    std::size_t more = 0;
    for (const Decision::Drop& drop : decision_.drops) {
      if (told.contains(drop.op)) continue;
      std::uint32_t other = Decision::kNoOperator;
      std::string reason = Mutual(drop, other);
      if (reason.empty()) {
        const Decision::Preference* p = Telling(drop);
        if (p == nullptr) continue;
        reason = Clause(*p);
        if (WouldStillLose(drop, reason))
          reason += " " + Say(Situation::kWouldStillLose, {{"op", OperatorText(decision_, drop.op)}});
      } else {
        told.insert(other);
      }
      if (std::ranges::find(reasons, reason) != reasons.end()) continue;
      if (reasons.size() < kMostReasons) {
        reasons.push_back(std::move(reason));
      } else {
        ++more;
      }
    }
    if (more == 1) reasons.push_back(Say(Situation::kOneMoreDropped));
    if (more > 1) reasons.push_back(Say(Situation::kMoreDropped, {{"count", std::to_string(more)}}));
    return reasons;
  }

  /// How one of several remaining candidates was chosen; empty if there was only one.
  std::string Choice() const {
    if (decision_.left.size() < 2) return {};
    const std::string count = std::to_string(decision_.left.size());
    if (decision_.policy == Policy::kFirst) return Say(Situation::kNewest, {{"count", count}});
    if (decision_.policy == Policy::kLast) return Say(Situation::kOldest, {{"count", count}});
    const auto chosen = std::ranges::find(decision_.left, decision_.selected, &Decision::Chance::op);
    if (chosen == decision_.left.end()) return {};
    const bool has_value = std::ranges::any_of(decision_.preferences, [&](const Decision::Preference& p) {
      return p.kind == PreferenceKind::kNumeric && p.op == decision_.selected;
    });
    const std::string chance = fmt::format("{:.3g}", chosen->probability * 100);
    return has_value ? Say(Situation::kByChanceOfValue,
                           {{"chance", chance}, {"value", fmt::format("{:g}", chosen->value)}, {"count", count}})
                     : Say(Situation::kByChance, {{"chance", chance}, {"count", count}});
  }

 private:
  const Decision& decision_;
  std::uint32_t subject_;
};

const Decision::Preference* FirstOf(const Decision& decision, PreferenceKind kind, std::uint32_t op) {
  for (const Decision::Preference& p : decision.preferences)
    if (p.kind == kind && p.op == op) return &p;
  return nullptr;
}

std::string Joined(const std::vector<std::string>& parts, std::string_view between = "; ") {
  std::string text;
  for (const std::string& part : parts) text.append(text.empty() ? "" : between).append(part);
  return text;
}

}  // namespace

std::string_view StageName(mind::Stage stage) {
  static constexpr const char* kNames[] = {"forced", "require", "prohibit", "reject", "dominated", "best", "worst"};
  return NameIn(kNames, stage);
}

std::string OperatorText(const mind::Decision& decision, std::uint32_t op) {
  if (op >= decision.operators.size()) return {};
  const mind::Decision::Operator& it = decision.operators[op];
  return it.name.empty() ? it.id : it.name + " (" + it.id + ")";
}

std::string WhySelected(const mind::Decision& decision) {
  if (decision.selected == Decision::kNoOperator) return {};
  if (decision.is_forced) return Say(Situation::kForced);
  const Teller teller(decision, decision.selected);
  const Decision::Preference* proposal = FirstOf(decision, PreferenceKind::kAcceptable, decision.selected);
  if (const Decision::Preference* require = FirstOf(decision, PreferenceKind::kRequire, decision.selected)) {
    std::string clause = teller.Clause(*require);
    // Without it, the only proposed operator would also have been selected.
    if (decision.drops.empty() && proposal != nullptr)
      return Say(Situation::kOnlyOneBy, {{"maker", Maker(*proposal)}}) + "; " + clause;
    std::vector<std::string> parts = {std::move(clause)};
    for (const Decision::Drop& drop : decision.drops) {
      if (drop.decisive == Decisive::kNo && parts.size() <= kMostReasons)
        parts.push_back(Say(Situation::kWouldStillLose, {{"op", OperatorText(decision, drop.op)}}));
    }
    return Joined(parts, " ");
  }
  std::vector<std::string> parts;
  if (std::string choice = teller.Choice(); !choice.empty()) parts.push_back(std::move(choice));
  for (std::string& reason : teller.Reasons()) parts.push_back(std::move(reason));
  if (!parts.empty()) return Joined(parts);
  return proposal == nullptr ? Say(Situation::kOnlyOne) : Say(Situation::kOnlyOneBy, {{"maker", Maker(*proposal)}});
}

std::string WhyDropped(const mind::Decision& decision, std::uint32_t op) {
  const Decision::Drop* drop = decision.DropOf(op);
  if (drop == nullptr) return {};
  if (drop->stage == Stage::kForced) return Say(Situation::kAnotherForced);
  const Teller teller(decision, op);
  std::vector<std::string> parts;
  for (const std::uint32_t place : teller.By(*drop)) {
    std::string clause = teller.Clause(teller.At(place));
    if (std::ranges::find(parts, clause) == parts.end() && parts.size() < kMostReasons)
      parts.push_back(std::move(clause));
  }
  std::string text = Listed(parts);
  if (drop->decisive == Decisive::kNo)
    text += "; " + Say(parts.size() > 1 ? Situation::kLosesWithoutThese : Situation::kLosesWithoutThat);
  return text;
}

std::string WhyNothing(const mind::Decision& decision) {
  if (decision.selected != Decision::kNoOperator) return {};
  const Teller teller(decision, Decision::kNoOperator);
  std::vector<std::string> left;
  for (auto at = decision.left.rbegin(); at != decision.left.rend(); ++at)  // In the order of the slot's list.
    left.push_back(OperatorText(decision, at->op));
  switch (decision.impasse) {
    case Impasse::kTie: {
      std::vector<std::string> parts = {Say(Situation::kTie, {{"operators", Listed(left)}})};
      for (std::string& reason : teller.Reasons()) parts.push_back(std::move(reason));
      return Joined(parts);
    }
    case Impasse::kConflict: {
      std::vector<std::string> parts = {Say(Situation::kConflict, {{"operators", Listed(left)}})};
      for (const Decision::Drop& drop : decision.drops) {
        const Decision::Preference* telling = teller.Telling(drop);
        if (drop.stage != Stage::kDominated || telling == nullptr || parts.size() > kMostReasons) continue;
        std::string clause = teller.Clause(*telling);
        if (std::ranges::find(parts, clause) == parts.end()) parts.push_back(std::move(clause));
      }
      return Joined(parts);
    }
    case Impasse::kConstraintFailure: {
      std::vector<std::string> parts;
      for (const Decision::Preference& p : decision.preferences) {
        const bool is_required = FirstOf(decision, PreferenceKind::kRequire, p.op) != nullptr;
        if (p.kind != PreferenceKind::kRequire && !(p.kind == PreferenceKind::kProhibit && is_required)) continue;
        if (parts.size() < kMostReasons) parts.push_back(teller.Clause(p));
      }
      return Joined(parts);
    }
    case Impasse::kNone:
      break;
  }
  if (!decision.left.empty() || decision.drops.empty()) return {};
  return Say(decision.drops.size() == 1 ? Situation::kOneDropped : Situation::kAllDropped,
             {{"why", Joined(teller.Reasons())}});
}

std::string WhyDecided(const mind::Decision& decision) {
  if (decision.selected == Decision::kNoOperator) return WhyNothing(decision);
  std::string text = WhySelected(decision);
  const Decision::Preference* proposal = FirstOf(decision, PreferenceKind::kAcceptable, decision.selected);
  const bool is_told =
      proposal != nullptr && text.starts_with(Say(Situation::kOnlyOneBy, {{"maker", Maker(*proposal)}}));
  if (proposal != nullptr && !is_told) text += "; " + Say(Situation::kProposedBy, {{"maker", Maker(*proposal)}});
  return text;
}

}  // namespace soarbox::wording
