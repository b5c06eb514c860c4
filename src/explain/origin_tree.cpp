// SPDX-License-Identifier: BSD-2-Clause
#include "explain/origin_tree.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <iterator>
#include <set>
#include <string>
#include <utility>

#include "wording/decision_text.h"
#include "wording/number_words.h"
#include "wording/sentences.h"

namespace soarbox::explain {
namespace {

using mind::OriginElementFact;
using mind::OriginFact;
using wording::Say;
using wording::Situation;

constexpr int kDeepest = 5;
constexpr std::size_t kMostBelow = 12;

std::string OperatorText(const OriginFact& origin) {
  return origin.op_name.empty() ? origin.op : origin.op_name + " (" + origin.op + ")";
}

/// Converts origins to nodes. Each origin is followed once.
class OriginTeller {
 public:
  OriginTeller(const mind::OriginFacts& facts, const DecisionTime& time) : facts_(facts), time_(time) {}

  WhyNode Firing(std::uint32_t place, Situation alone, Situation applying, int depth) {
    const OriginFact& origin = facts_.origins[place];
    // Only elements with o-support are results of an operator; other elements exist as long as their rule matches.
    const bool applies = !origin.op.empty() && origin.o_supported && TestsOperator(origin);
    WhyNode node{{}, WhyKind::kRule, origin.rule, {}, TimeOf(origin)};
    if (followed_.insert(place).second && depth > 0) {
      if (applies && origin.op_origin != mind::kNoOrigin) node.below.push_back(Operator(origin.op_origin, depth - 1));
      AddMatched(origin, depth, node);
    }
    const std::string matched = node.below.empty() ? std::string() : Say(Situation::kWhichMatched);
    node.text =
        Say(applies ? applying : alone,
            {{"rule", origin.rule}, {"when", When(origin)}, {"op", OperatorText(origin)}, {"matched", matched}});
    return node;
  }

  WhyNode Operator(std::uint32_t place, int depth) {
    const OriginFact& origin = facts_.origins[place];
    const std::string why = origin.decided ? wording::WhySelected(*origin.decided) : std::string();
    WhyNode node{Say(why.empty() ? Situation::kSelectedThen : Situation::kSelectedThenBecause,
                     {{"op", OperatorText(origin)}, {"when", When(origin)}, {"why", why}}),
                 WhyKind::kOperator, origin.op};
    node.time_s = TimeOf(origin);
    if (!followed_.insert(place).second || depth <= 0) return node;
    for (const std::uint32_t proposal : origin.proposals)
      node.below.push_back(Firing(proposal, Situation::kProposedThen, Situation::kProposedThen, depth - 1));
    return node;
  }

 private:
  static bool TestsOperator(const OriginFact& origin) {
    return std::ranges::any_of(origin.matched, [](const OriginElementFact& matched) {
      return matched.element.attribute == "operator" && !matched.element.acceptable;
    });
  }

  std::optional<double> TimeOf(const OriginFact& origin) const {
    return time_ && origin.decision > 0 ? time_(origin.decision) : std::nullopt;
  }

  std::string When(const OriginFact& origin) const {
    if (origin.decision == 0) return {};
    const std::string decision = std::to_string(origin.decision);
    if (const std::optional<double> at = TimeOf(origin)) {
      char time[32];
      std::snprintf(time, sizeof time, "%.2f", *at);
      return Say(Situation::kAtTime, {{"time", time}, {"decision", decision}});
    }
    return Say(Situation::kAtDecision, {{"decision", decision}});
  }

  /// Whether a matched element is worth reporting. Not reported: the paths to the links, elements that only lead to
  /// another element, and the operator, which has a separate line.
  static bool Tells(const OriginFact& origin, const OriginElementFact& matched) {
    constexpr std::string_view kWays[] = {"superstate", "io", "input-link", "output-link", "operator", "type"};
    const mind::ElementFact& element = matched.element;
    if (std::ranges::find(kWays, element.attribute) != std::end(kWays)) return false;
    if (element.id == origin.op && element.attribute == "name") return false;
    return !element.is_object || std::ranges::none_of(origin.matched, [&](const OriginElementFact& other) {
      return other.element.id == element.value;
    });
  }

  void AddMatched(const OriginFact& origin, int depth, WhyNode& node) {
    std::size_t more = origin.left_out, told = 0;
    for (const OriginElementFact& matched : origin.matched) {
      if (!Tells(origin, matched)) continue;
      if (told == kMostBelow) {
        ++more;
        continue;
      }
      ++told;
      node.below.push_back(Element(matched, depth - 1));
    }
    if (more > 0) node.below.push_back({Say(Situation::kMatchedMore, {{"count", std::to_string(more)}})});
  }

  WhyNode Element(const OriginElementFact& matched, int depth) {
    const mind::ElementFact& element = matched.element;
    WhyNode node{"^" + element.attribute + " " + wording::WithoutZeros(element.value) +
                     (element.acceptable ? " +" : "") + " of " + element.id,
                 WhyKind::kElement, std::to_string(element.timetag)};
    if (matched.source == OriginElementFact::Source::kInput) {
      node.kind = WhyKind::kPercept;
      node.text += " (perceived)";
    } else if (matched.source == OriginElementFact::Source::kArchitecture) {
      node.text += " (made by the architecture)";
    } else if (matched.origin != mind::kNoOrigin && depth > 0) {
      node.below.push_back(Firing(matched.origin, Situation::kMadeThen, Situation::kMadeApplying, depth));
    }
    return node;
  }

  const mind::OriginFacts& facts_;
  const DecisionTime& time_;
  std::set<std::uint32_t> followed_;
};

}  // namespace

std::vector<WhyNode> OriginTree(const mind::OriginFacts& facts, const DecisionTime& time, bool is_command) {
  std::vector<WhyNode> nodes;
  if (facts.origins.empty()) return nodes;
  OriginTeller teller(facts, time);
  if (facts.origins.front().is_operator) {
    nodes.push_back(teller.Operator(0, kDeepest));
  } else {
    nodes.push_back(teller.Firing(0, is_command ? Situation::kGivenThen : Situation::kMadeThen,
                                  is_command ? Situation::kGivenApplying : Situation::kMadeApplying, kDeepest));
  }
  return nodes;
}

std::vector<WhyNode> PresentReason(const mind::OriginFacts& facts, const std::vector<std::string>& selected) {
  if (facts.origins.empty() || facts.origins.front().op.empty() || !facts.origins.front().o_supported) return {};
  const OriginFact& origin = facts.origins.front();
  const bool is_selected = std::ranges::find(selected, origin.op) != selected.end();
  return {{Say(is_selected ? Situation::kOperatorStays : Situation::kOperatorGone, {{"op", OperatorText(origin)}})}};
}

}  // namespace soarbox::explain
