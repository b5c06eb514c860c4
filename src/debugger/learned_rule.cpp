// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/learned_rule.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace soarbox::debugger {
namespace {

using explain::FiringFact;
using explain::LearnedRuleFact;
using explain::TripleFact;

constexpr std::size_t kMostFirings = 200;  ///< Maximum number of firings reported for one rule.

const FiringFact* FindFiring(const LearnedRuleFact& learned, std::uint32_t serial) {
  const auto found = std::ranges::find(learned.firings, serial, &FiringFact::serial);
  return found == learned.firings.end() ? nullptr : &*found;
}

std::string TripleText(const TripleFact& triple) {
  if (triple.negated) return triple.id;
  std::string text = "(" + triple.id + " ^" + triple.attribute + " " + triple.value;
  if (!triple.sign.empty() && (triple.sign != "+" || triple.attribute == "operator")) text += " " + triple.sign;
  if (!triple.referent.empty()) text += " " + triple.referent;
  return text + ")";
}

std::string FiringName(const FiringFact& firing) {
  return firing.rule + " (firing " + std::to_string(firing.serial) + ")";
}

/// The name of an operator in an action or condition; otherwise its variable.
std::string OperatorCalled(const LearnedRuleFact& learned, const std::string& id) {
  for (const std::vector<TripleFact>* triples : {&learned.actions, &learned.conditions}) {
    for (const TripleFact& triple : *triples) {
      if (!triple.negated && triple.id == id && triple.attribute == "name") return triple.value;
    }
  }
  return "the operator " + id;
}

std::string PreferenceWords(const LearnedRuleFact& learned, const TripleFact& action) {
  const std::string name = OperatorCalled(learned, action.value);
  const bool is_number = !action.referent.empty() && action.referent.front() != '<';
  const std::string other =
      action.referent.empty() || is_number ? action.referent : OperatorCalled(learned, action.referent);
  if (action.sign == "+") return "proposes " + name;
  if (action.sign == "!") return "requires " + name;
  if (action.sign == "-") return "rejects " + name;
  if (action.sign == "~") return "prohibits " + name;
  if (action.sign == ">") return other.empty() ? "makes " + name + " best" : "prefers " + name + " to " + other;
  if (action.sign == "<") return other.empty() ? "makes " + name + " worst" : "prefers " + other + " to " + name;
  if (other.empty()) return "makes " + name + " indifferent";
  return is_number ? "gives " + name + " the value " + other : "makes " + name + " indifferent to " + other;
}

/// Explains the conditions of a firing. Elements of higher states are leaves; others have the firing that made them
/// below.
class FiringTeller {
 public:
  explicit FiringTeller(const LearnedRuleFact& learned) : learned_(learned) {}

  WhyNode Tell(const FiringFact& firing) {
    WhyNode node{FiringName(firing), WhyKind::kRule, firing.rule};
    if (!told_.insert(firing.serial).second) {
      node.text += ", see above";
      return node;
    }
    for (const TripleFact& condition : firing.conditions) {
      if (condition.negated) {
        node.below.push_back({"required no " + condition.id});
        continue;
      }
      const std::string met = condition.met.empty() ? TripleText(condition) : "(" + condition.met + ")";
      if (condition.above) {
        node.below.push_back({met + " of a higher state", WhyKind::kPercept});
        continue;
      }
      const FiringFact* const creator = FindFiring(learned_, condition.creator);
      WhyNode& local = node.below.emplace_back(WhyNode{met + " of the substate", WhyKind::kElement});
      if (creator != nullptr && told_.size() < kMostFirings) {
        local.text += ", made by";
        local.below.push_back(Tell(*creator));
      } else if (condition.creator == 0) {
        local.text += ", made by the architecture";
      }
    }
    return node;
  }

 private:
  const LearnedRuleFact& learned_;
  std::set<std::uint32_t> told_;
};

WhyNode ConditionNode(const LearnedRuleFact& learned, const TripleFact& condition) {
  WhyNode node{TripleText(condition), WhyKind::kCondition};
  if (condition.negated) {
    node.below.push_back({"a rule of the substate required that this is absent"});
    return node;
  }
  if (!condition.met.empty()) node.below.push_back({"it was (" + condition.met + ")", WhyKind::kElement});
  for (std::size_t n = 0; n < condition.path.size(); ++n) {
    const FiringFact* const firing = FindFiring(learned, condition.path[n]);
    if (firing == nullptr) continue;
    std::string text = (n == 0 ? "tested by " : "which led to ") + FiringName(*firing);
    if (firing->made_result) text += ", which gave the result";
    node.below.push_back({std::move(text), WhyKind::kRule, firing->rule});
  }
  if (condition.path.empty()) node.below.push_back({"leads to what other conditions test"});
  return node;
}

std::string DecisionText(const LearnedRuleFact& learned) {
  return "learned in decision " + std::to_string(learned.decision) + " in the substate " + learned.state + " (" +
         ImpasseOf(learned) + ")";
}

std::string Misgivings(const LearnedRuleFact& learned) {
  std::string text;
  const auto add = [&](bool is_so, const char* what) {
    if (is_so) text += (text.empty() ? "" : "; ") + std::string(what);
  };
  add(learned.local_negation, "it rests on what was absent in the substate, so it may be too general");
  add(learned.long_term_memory, "it rests on what long-term memory recalled");
  add(learned.repaired, "conditions were added so that a state leads to all that it tests");
  return text;
}

explain::LearningSource* SourceOf(explain::Inspector& mind) {
  return dynamic_cast<explain::LearningSource*>(&mind);
}

}  // namespace

std::string PurposeOf(const LearnedRuleFact& learned) {
  std::vector<std::string> parts;
  const auto add = [&](std::string part) {
    if (std::ranges::find(parts, part) == parts.end()) parts.push_back(std::move(part));
  };
  std::set<std::string> operators;
  for (const TripleFact& action : learned.actions) {
    if (action.attribute != "operator") continue;
    add(PreferenceWords(learned, action));
    operators.insert(action.value);
  }
  // Actions on a proposed operator are part of the proposal.
  for (const TripleFact& action : learned.actions) {
    if (action.attribute == "operator" || operators.contains(action.id)) continue;
    const bool is_variable = action.value.starts_with('<');
    add((action.sign == "-" ? "removes ^" : "makes ^") + action.attribute + (is_variable ? "" : " " + action.value));
  }
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
  return text;
}

std::string ImpasseOf(const LearnedRuleFact& learned) {
  std::string text = learned.attribute + " " + learned.impasse + " in " + learned.superstate;
  if (!learned.operator_name.empty()) text += ", where " + learned.operator_name + " was selected";
  return text;
}

WhyNode TellOrigin(const LearnedRuleFact& learned) {
  WhyNode node{DecisionText(learned), WhyKind::kLearned, learned.rule};
  if (const FiringFact* const base = FindFiring(learned, learned.base)) {
    node.below.push_back({"from " + FiringName(*base) + ", which gave the result", WhyKind::kRule, base->rule});
  }
  constexpr std::size_t kMostOthers = 8;
  std::size_t others = 0;
  for (auto firing = learned.firings.rbegin(); firing != learned.firings.rend(); ++firing) {
    if (firing->serial == learned.base) continue;
    if (++others <= kMostOthers)
      node.below.push_back({"which rested on " + FiringName(*firing), WhyKind::kRule, firing->rule});
  }
  if (others > kMostOthers) node.below.push_back({"and on " + std::to_string(others - kMostOthers) + " more firings"});
  return node;
}

WhyNode TellLearnedRule(const LearnedRuleFact& learned) {
  WhyNode root{learned.rule + ": " + DecisionText(learned), WhyKind::kLearned, learned.rule};
  if (const std::string misgivings = Misgivings(learned); !misgivings.empty())
    root.below.push_back({"note: " + misgivings});
  WhyNode& conditions = root.below.emplace_back(WhyNode{"why each condition is there"});
  for (const TripleFact& condition : learned.conditions) conditions.below.push_back(ConditionNode(learned, condition));
  WhyNode& actions = root.below.emplace_back(WhyNode{"what it is good for: it " + PurposeOf(learned)});
  for (const TripleFact& action : learned.actions) {
    WhyNode& made = actions.below.emplace_back(WhyNode{TripleText(action), WhyKind::kCondition});
    made.below.push_back({"it was (" + action.met + ")", WhyKind::kElement});
  }
  WhyNode& firings = root.below.emplace_back(WhyNode{"how the substate came to the result, from its last firing back"});
  FiringTeller teller(learned);
  if (const FiringFact* const base = FindFiring(learned, learned.base)) firings.below.push_back(teller.Tell(*base));
  return root;
}

std::optional<WhyNode> WhyLearned(explain::Inspector& mind, std::string_view rule) {
  if (explain::LearningSource* const source = SourceOf(mind)) {
    if (const std::optional<LearnedRuleFact> learned = source->LearnedRule(rule)) return TellLearnedRule(*learned);
  }
  for (const explain::RuleFact& known : mind.Rules()) {
    if (known.name != rule || known.type != "chunk") continue;
    WhyNode root{known.name + ": a learned rule", WhyKind::kLearned, known.name};
    root.below.push_back({mind.TellsAll() ? "how it was learned is not known: it was loaded, or learned before anybody "
                                            "watched, or more than 1,000 rules ago"
                                          : "how it was learned: this kernel does not report it"});
    return root;
  }
  return std::nullopt;
}

std::optional<WhyNode> OriginOf(explain::Inspector& mind, std::string_view rule) {
  explain::LearningSource* const source = SourceOf(mind);
  if (source == nullptr || rule.empty()) return std::nullopt;
  if (const std::optional<LearnedRuleFact> learned = source->LearnedRule(rule)) return TellOrigin(*learned);
  return std::nullopt;
}

}  // namespace soarbox::debugger
